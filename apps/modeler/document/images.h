/// @file images.h
/// The images that a document's symmetry makes of what is drawn. Tools work on what is drawn; the images are
/// ghosts.
#pragma once

#include <vector>

#include "document/selection.h"
#include "sinew/skeleton/document.h"

namespace sinew::modeler {

/// Drawn to shown, one map an image; the first is the identity. All leave the origin where it is.
std::vector<Mat3> images_of(const Symmetry& symmetry);

/// What images share: the mirror's plane, or the axis of rotation. A point there is its own twin.
/// @return the nearest such point; the point itself without symmetry
Vec3 onto_symmetry(const Symmetry& symmetry, const Vec3& point);

/// True for points that lie there, up to a billionth of `size`.
bool is_own_twin(const Symmetry& symmetry, const Vec3& point, double size);

/// For people: "no symmetry", "mirror x", "radial z, 8".
std::string describe(const Symmetry& symmetry);

}  // namespace sinew::modeler

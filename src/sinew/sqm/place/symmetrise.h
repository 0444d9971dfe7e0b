/// @file symmetrise.h
/// Makes the mesh of a symmetric skeleton symmetric to the last bit.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sinew/sqm/bridge/bridge.h"
#include "sinew/sqm/cells/images.h"

namespace sinew::sqm {

/// Vertex -> its image under the generator; no_vertex for those of rings and tubes that cannot have one,
/// since they do not follow the symmetry of the joints at their ends.
std::vector<std::uint32_t> vertex_images(const Parts& parts, const Images& images, const Bridge& bridge);

/// Gives each vertex that is not the first of its orbit the image of the first one's position. Vertices that
/// are their own image go into the mirror or onto the axis.
void make_symmetric(const Images& images, std::span<const std::uint32_t> vertex_image,
                    std::span<Vec3f> positions);

}  // namespace sinew::sqm

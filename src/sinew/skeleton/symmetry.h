/// @file symmetry.h
/// The symmetry of a document, expanded: the images that its drawn nodes stand for become nodes.
#pragma once

#include <cstdint>
#include <vector>

#include "sinew/base/vec.h"
#include "sinew/skeleton/document.h"

namespace sinew {

/// The image-th power of the symmetry's generator: the reflection, or the turn by image / count of a full
/// one. Exact where a turn by 45 degrees or a multiple is meant; always, turns that mirror one another have
/// the same digits.
Mat3 symmetry_transform(const Symmetry& symmetry, int image);

struct ExpandedSymmetry {
    /// Without symmetry. The drawn nodes keep their indices and ids; images follow, with ids of their own,
    /// turn by turn.
    Document document;
    std::vector<std::int32_t>
        source;  ///< the drawn node that each node is an image of: itself for those drawn
    std::vector<std::int32_t>
        power;  ///< its position is symmetry_transform(symmetry, power) * that of its source
    std::vector<std::int32_t> image;  ///< where the generator takes each node
    Mat3 generator = Mat3::Identity();
    std::int32_t order = 1;  ///< generator^order is the identity; 1: the document has no symmetry
};

/// Expands the symmetry of a valid document. Exact: positions of images are those of their sources,
/// transformed, bit for bit.
///
/// A node on the mirror plane or on the axis, to 1e-5 of the model's size, is moved onto it and is its own
/// image. A drawn node at the place of another one's image (to the same tolerance, the lower node counting as
/// the source) becomes that image in everything but id and name. Bones go along with their nodes, and
/// coincide where all their nodes do.
///
/// Cubes, balls, sections that are not round, and what dents are pressed into are turned with their node:
/// roll and rotation of an image are those that give it the transformed frame of its source (frames.h). One
/// on the plane or the axis is turned to the nearest frame that the symmetry maps onto itself, if there is
/// one.
ExpandedSymmetry expand_symmetry(const Document& document);

}  // namespace sinew

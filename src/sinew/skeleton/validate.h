/// @file validate.h
/// What must hold of a document before anything is made of it.
#pragma once

#include <cstddef>
#include <vector>

#include "sinew/base/result.h"
#include "sinew/skeleton/document.h"

namespace sinew {

/// Coordinates and lengths must not exceed this, since meshes store single precision.
inline constexpr double largest_length = 1e30;
/// More images of a radial symmetry than anyone draws.
inline constexpr int largest_symmetry_count = 1000;
/// Of Node::blend and Document::blend: with more, joints are balls that swallow their bones.
inline constexpr double largest_blend = 4;
/// Of Density::aspect: a square.
inline constexpr double least_aspect = 1;

/// Everything that is wrong with a document, each with the JSON pointer in its file, the node's id, and the
/// cure: first what concerns single nodes, in their order, then parent cycles, then links, then the symmetry.
///
/// Wrong are: an id that is negative or not unique; a position, radius, size, scale, roll, rotation or joint
/// that is not finite or out of its range; a parent or link that does not exist or is the node itself; nodes
/// that are their own ancestors; two bones between the same nodes; a cone, hemisphere or negative that is no
/// leaf (no node of exactly one bone); a negative whose only neighbour is one too; a radial symmetry of fewer
/// than 2 images. Linear time, but for the sorting of ids and links.
///
/// @param limit  stop after so many
std::vector<Error> problems(const Document& document, std::size_t limit = static_cast<std::size_t>(-1));

/// The first of them, if any.
Result<void> validate(const Document& document);

}  // namespace sinew

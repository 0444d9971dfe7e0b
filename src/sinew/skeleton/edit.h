/// @file edit.h
/// Operations on documents: document in, document out, nothing else changes.
///
/// Nodes are named by index; node_with_id finds them. What is valid (validate.h) stays valid: a tip that is
/// no leaf any more becomes a sphere, and of bones between the same two nodes one stays. Ids stay with their
/// nodes; new nodes get higher ones. Operations that take a span of nodes mean all of them where it is empty.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sinew/base/result.h"
#include "sinew/skeleton/document.h"

namespace sinew {

/// The index of the node with this id; fails, as the call's fault, where there is none.
Result<std::int32_t> node_with_id(const Document& document, std::int64_t id);

struct Consolidation {
    double distance = 1;  ///< of the new node from the leaf, in radii of the leaf; at most 2/5 of the bone
    double radius_share = 1;  ///< radius of the new node: 0 the leaf's, 1 that of its neighbour
};
/// Puts a node near each leaf (of those named, which need not all be leaves), so that its tip is blunter: the
/// bone keeps the radius of its other end until there. Leaves at no distance from their neighbour, and
/// negatives, stay as they are.
Document consolidate_leaves(const Document& document, const Consolidation& how = {},
                            std::span<const std::int32_t> nodes = {});

/// Merges nodes, usually leaves, so that two bones become one or a cycle closes: each pair becomes one node,
/// the lower of the two, at the mean position with the mean radius, and pairs that share a node become one
/// together. Fails, as the call's fault, for nodes that do not exist and for a pair of a node with itself.
Result<Document> merge_nodes(const Document& document, std::span<const std::array<std::int32_t, 2>> pairs);

/// The pairs of leaves at most so far from one another, the closest first, each leaf in one pair at most: for
/// merge_nodes.
std::vector<std::array<std::int32_t, 2>> close_leaves(const Document& document, double distance);

/// Puts a node on a bone, at the share `along` of it from its first node; position, radius and scale are
/// interpolated, a section that both ends have is kept. The new node is the last one. Fails, as the call's
/// fault, for a bone that does not exist and a share outside [0, 1].
/// @param bone  index into bones_of(document)
Result<Document> insert_on_bone(const Document& document, std::int32_t bone, double along = 0.5);

/// Takes nodes out and joins what they joined: their bones go on to the nearest ancestor that stays or, for
/// roots, to the first descendant that does.
Document dissolve(const Document& document, std::span<const std::int32_t> nodes);

/// Makes a node the root of its tree by turning round the bones on the way to the old root. Shapes stay:
/// frames that turn with their bones are rolled back. (A section that is not round at the old or the new root
/// may turn: roots have the world's axes.)
Document reroot(const Document& document, std::int32_t node);

/// Adds the mirror image in the plane through the origin with the normal x, y or z (0, 1, 2), or the images
/// that make `count` of it round that axis; exact, twins on the plane or axis merged (symmetry.h). A symmetry
/// that the document has is expanded first. The count is from 1 up.
Document mirror(const Document& document, int axis);
Document radial_copy(const Document& document, int axis, int count);

/// Moves nodes to the nearest multiples of `step`, which is above 0.
Document snap_to_grid(const Document& document, double step, std::span<const std::int32_t> nodes = {});

/// Turns the bones from their parents to these nodes so that the angle in the x-y plane and the one above it
/// become multiples of `degrees`; lengths stay, and what hangs at a node moves with it. 45 and 90 degrees are
/// exact. Fails, as the call's fault, where 360 is no multiple of `degrees`.
Result<Document> snap_to_angle(const Document& document, double degrees,
                               std::span<const std::int32_t> nodes = {});

}  // namespace sinew

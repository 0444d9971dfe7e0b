/// @file extend.h
/// From a document's node types to the plain skeleton that the mesher takes.
///
/// M. Mc Donnell, "Skeleton-based and Interactive 3D Modeling", DTU 2012, extended trees: every type becomes
/// a few plain nodes.
///
/// | node | becomes |
/// |---|---|
/// | sphere, cone, hemisphere leaf | itself, with a cap; a form where it is scaled, rectangular or sharp |
/// | cube on a bone or at its end | two rings at its faces, and one each where a narrower tube meets a face |
/// | cube at a root or a branch | a box joint; a plate where a narrower tube leaves; a flat cap on every free
/// face | | ball | a ball joint; a ring where each tube leaves; surface bones where it would be bare | |
/// negative | a pit on its parent, which becomes a joint |
#pragma once

#include <span>

#include "sinew/base/result.h"
#include "sinew/extend/plain.h"
#include "sinew/skeleton/condition.h"
#include "sinew/skeleton/document.h"

namespace sinew {

/// A pure function of the document and of its conditioned graph. What cannot be made as drawn (a pit deeper
/// than its parent) is made as near to it as can be, with a warning that names the node.
Plain extend(const Document& document, const CleanGraph& graph, Warnings& warnings);

/// The symmetry of a document, carried over to the plain skeleton: nodes that an extension made go to those
/// that it made of the image. Order 1 if one of them has no such node (a repair that did not treat both sides
/// alike).
/// @param image  node of the document -> where the generator takes it
Automorphism carry_symmetry(const Plain& skeleton, const Mat3& generator, std::int32_t order,
                            std::span<const std::int32_t> image);

/// The mirror image of the skeleton in the plane x = 0, y = 0 or z = 0, whichever is the first that maps it
/// onto itself exactly, bones, radii and forms included; order 1 if there is none.
Automorphism find_mirror(const Plain& skeleton);

}  // namespace sinew

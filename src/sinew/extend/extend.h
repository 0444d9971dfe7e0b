/// @file extend.h
/// From a document's node types to the plain skeleton that the mesher takes.
///
/// M. Mc Donnell, "Skeleton-based and Interactive 3D Modeling", DTU 2012, extended trees: every type becomes
/// a few plain nodes.
///
/// - A sphere, cone or hemisphere at a leaf becomes itself, with a cap, and has a form where it is scaled,
///   rectangular or sharp. It adds 1 special vertex.
/// - A cube on a bone or at its end becomes two rings at its faces, and one each where a narrower tube
///   meets a face. It adds none on a bone, and at its end 1.
/// - A cube at a root or a branch becomes a box joint, with a plate where a narrower tube leaves and a flat
///   cap on every free face. It adds its 8 corners and 1 for each free face.
/// - A ball becomes a ball joint, with a ring where each tube leaves and surface bones where it would be
///   bare. With d bones and s of those it adds 2 (d + s - 2) + s.
/// - A negative becomes a pit on its parent, which becomes a joint. It adds 3: a bone more, and its bottom.
///
/// Special vertices are those of a valence other than 4 and the poles of fans. A round joint of d bones adds
/// 2 (d - 2); a sphere, ball or cube alone has 8.
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

/// @file plain.h
/// What the mesher takes: a graph of balls and bones in flat arrays, and what must be true of the mesh.
///
/// Most nodes are balls that blend into their bones as round cones. A node with a form is something else: a
/// ring of a given outline, or the body of a joint. extend() turns every node type of a document into these
/// few.
///
/// Invariants, which extend() establishes and the stages of sqm rely on: bones join two different nodes at
/// different places, no two bones join the same two nodes, positions are finite, radii are finite and
/// positive (0 at the tips of cones), a joint with a form has at least three bones.
#pragma once

#include <cstdint>
#include <vector>

#include "sinew/base/vec.h"
#include "sinew/extend/automorphism.h"
#include "sinew/extend/form.h"
#include "sinew/skeleton/graph.h"

namespace sinew {

/// How a tube ends at a leaf.
enum class Cap : std::uint8_t {
    round,    ///< half a ball beyond the node
    point,    ///< a cone: straight to its tip, which is the node's position
    flat,     ///< a flat end: the ring stands at the node, its pole in the middle
    surface,  ///< no tube at all: the joint's own surface goes on over this bone (it was made up to carry
              ///< vertices there)
    pit,      ///< a dent in the joint's surface
};

/// What a bone is, beyond a tube.
enum class BoneKind : std::uint8_t {
    tube,
    body,   ///< inside the body of a ball or box joint: no rings on it
    side,   ///< the sides of a box, from one face to the opposite one
    plate,  ///< flat, between a tube and the larger face that it leaves through
};

struct Plain {
    std::vector<Vec3> position;
    std::vector<double> radius;
    std::vector<Cap> cap;               ///< one a node; means something at leaves only
    std::vector<std::int32_t> form_of;  ///< node -> index in forms; -1: a plain ball
    std::vector<Form> forms;
    /// One a node; for Cap::pit, how deep it is below the surface, and how far above it the node stands.
    std::vector<double> pit_depth;

    /// One a node, or empty: radius of the ball that rolls round a joint there, in radii (Node::blend).
    std::vector<double> blend;

    std::vector<Bone> bones;
    std::vector<BoneKind> bone_kind;

    std::vector<std::int32_t> source_node;  ///< index of each node in the document
    std::vector<std::int32_t>
        source_bone;  ///< index of each bone in bones_of(document); -1 for one that was made up

    Automorphism symmetry;

    std::int32_t node_count() const { return static_cast<std::int32_t>(position.size()); }
    const Form* form(std::int32_t node) const { return form_of[node] < 0 ? nullptr : &forms[form_of[node]]; }
    bool is_body(std::int32_t node) const { return form(node) && form(node)->kind != Form::Kind::ring; }

    /// A round ball without a form or bones; its index.
    std::int32_t add_node(const Vec3& at, double ball, std::int32_t source);
    void add_bone(std::int32_t a, std::int32_t b, BoneKind kind, std::int32_t source);
};

}  // namespace sinew

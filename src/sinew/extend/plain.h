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
#include "sinew/skeleton/document.h"
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

/// The outline of a ring, or the body of a joint.
struct Form {
    enum class Kind : std::uint8_t {
        ring,   ///< an outline in the plane of x and y (or turned into the bisector of a bend)
        box,    ///< a joint whose surface is a box
        ball,   ///< a joint whose surface is an ellipsoid
        blend,  ///< a joint of round cones as usual; it has a form because of what happens on it
    };
    Kind kind = Kind::ring;
    Section section = Section::round;
    Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();  ///< unit, right-handed; z along the bone
    Vec3 half = Vec3::Ones();  ///< half extents along x, y, z (rings: z unused)
    bool fixed = false;        ///< ring: stands at right angles to z, whatever its bones do
    std::int32_t sides = 4;    ///< vertices that its paths have at least
    double sharpness = 0;  ///< of the crease on the ring; on a joint: of the creases where its tubes begin

    /// A vector in the space where a ball is the unit ball and a box the cube from -1 to 1.
    Vec3 local(const Vec3& v) const {
        return {v.dot(x) / half.x(), v.dot(y) / half.y(), v.dot(z) / half.z()};
    }
};

/// An ellipsoid is a round ball in a space of its own, where its cells and points are found as a ball's are:
/// unit directions from there, and there. Great circles stay great circles. Other forms (and none) have no
/// such space: their directions stay.
inline bool is_ellipsoid(const Form* form) {
    return form && form->kind == Form::Kind::ball &&
           !(form->half.x() == form->half.y() && form->half.y() == form->half.z());
}
Vec3 stretched(const Form& form, const Vec3& direction, const Vec3& by);  ///< unit; along the form's axes
inline Vec3 from_ball_space(const Form* form, const Vec3& direction) {
    return is_ellipsoid(form) ? stretched(*form, direction, form->half) : direction;
}
inline Vec3 to_ball_space(const Form* form, const Vec3& direction) {
    return is_ellipsoid(form) ? stretched(*form, direction, form->half.cwiseInverse()) : direction;
}

/// A rotation or reflection about the origin that maps the skeleton onto itself.
struct Automorphism {
    Mat3 generator = Mat3::Identity();
    std::int32_t order = 1;           ///< generator^order is the identity; 1: no symmetry
    std::vector<std::int32_t> image;  ///< node -> its image under the generator; empty without symmetry
};

struct Plain {
    std::vector<Vec3> position;
    std::vector<double> radius;
    std::vector<Cap> cap;               ///< one a node; means something at leaves only
    std::vector<std::int32_t> form_of;  ///< node -> index in forms; -1: a plain ball
    std::vector<Form> forms;
    /// One a node; for Cap::pit, how deep it is below the surface, and how far above it the node stands.
    std::vector<double> pit_depth;

    std::vector<Bone> bones;
    std::vector<BoneKind> bone_kind;

    std::vector<std::int32_t> source_node;  ///< index of each node in the document
    std::vector<std::int32_t>
        source_bone;  ///< index of each bone in bones_of(document); -1 for one that was made up

    Automorphism symmetry;

    std::int32_t node_count() const { return static_cast<std::int32_t>(position.size()); }
    const Form* form(std::int32_t node) const { return form_of[node] < 0 ? nullptr : &forms[form_of[node]]; }
    bool is_body(std::int32_t node) const { return form(node) && form(node)->kind != Form::Kind::ring; }
};

/// Whether the bones, taken to the images of their nodes, are the same bones.
bool bones_follow(const Plain& skeleton, const std::vector<std::int32_t>& image);

}  // namespace sinew

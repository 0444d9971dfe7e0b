#include "sinew/extend/contacts.h"

#include <algorithm>
#include <cmath>

#include "sinew/extend/body_forms.h"

namespace sinew {
namespace {

// How far a face may be from where it would meet the other exactly, in shares of its half extents: what lies
// within is taken for hand-drawn or rounded coordinates, and the ledge that is lost is narrower than anything
// one could want to see.
constexpr double same_size = 0.01;
// Cosine of 0.8 degrees: at the edge of a face that is turned so far the other lies 1.4 % of the half extent
// off, about as much as same_size allows.
constexpr double parallel = 0.9999;
// Of the smaller half extent: faces that near to each other touch. A tube between them would be that long and
// as wide as they are, with quads a thousand times as wide as long.
constexpr double touching = 1e-3;
// Of the larger face: how far the smaller may reach towards its edge, so that the step between them is at
// least twice what same_size takes for none.
constexpr double within = 1 - 2 * same_size;

struct Cube {
    Form box;
    Face face;     // towards the other
    double thick;  // behind that face
    bool joint;
};

Cube cube_towards(const PlainBuilder& b, std::int32_t node, std::int32_t other) {
    Cube cube{body_form(b, node, Form::Kind::box, half_size(b, node)), {}, 0, is_box_joint(b, node)};
    const Vec3 offset = b.position(other) - b.position(node);
    const bool is_before = b.other(b.first_bone(node), node) == other;
    const int index = cube.joint ? face_towards(cube.box, offset) : is_before ? face_behind : face_ahead;
    cube.face = face_of(cube.box, b.position(node), index);
    cube.thick = 2 * cube.box.half[index / 2];
    return cube;
}

/// Half extents and middle of a face in the frame of another one.
struct Outline {
    double x, y, half_x, half_y;
};
Outline outline_in(const Face& face, const Face& frame) {
    const Vec3 offset = face.middle - frame.middle;
    const bool along = std::abs(face.frame.x.dot(frame.frame.x)) > 0.5;  // which is 0 or 1 here
    return {offset.dot(frame.frame.x), offset.dot(frame.frame.y), along ? face.half_x : face.half_y,
            along ? face.half_y : face.half_x};
}
bool is_same(const Outline& o, const Face& face) {
    const double x = same_size * face.half_x, y = same_size * face.half_y;
    return std::abs(o.x) < x && std::abs(o.y) < y && std::abs(o.half_x - face.half_x) < x &&
           std::abs(o.half_y - face.half_y) < y;
}
bool lies_in(const Outline& o, const Face& face) {
    return std::abs(o.x) + o.half_x < within * face.half_x && std::abs(o.y) + o.half_y < within * face.half_y;
}

/// Opposite each other, with edges that are parallel too. Not where a path folds back into its cube.
bool look_at_each_other(const Face& own, const Face& other, const Vec3& offset) {
    if (offset.dot(own.frame.z) <= 0 || own.frame.z.dot(other.frame.z) > -parallel) return false;
    const double cosine = std::abs(own.frame.x.dot(other.frame.x));
    return cosine >= parallel || cosine <= 1 - parallel;
}

/// Of two faces with one outline the ring is that of the cube that comes first: a joint, the parent, the
/// lower index.
bool shares_ring_of(const PlainBuilder& b, std::int32_t node, std::int32_t neighbour, const Cube& own,
                    const Cube& other) {
    if (own.joint || other.joint) return other.joint;
    if (b.is_below(node, neighbour)) return true;
    return !b.is_below(neighbour, node) && node > neighbour;
}

}  // namespace

Contact find_contact(const PlainBuilder& b, std::int32_t node, std::int32_t neighbour) {
    if (b.type(node) != NodeType::cube || b.type(neighbour) != NodeType::cube) return {};
    const Cube own = cube_towards(b, node, neighbour), other = cube_towards(b, neighbour, node);
    if (own.joint && other.joint) return {};
    if (!look_at_each_other(own.face, other.face, b.position(neighbour) - b.position(node))) return {};
    const double gap = (other.face.middle - own.face.middle).dot(own.face.frame.z),
                 touch = touching * std::min(own.face.half_x, own.face.half_y);
    if (gap > touch) return {};
    const bool touches = gap > -touch;
    // The cube that ends in the other's face begins there, wherever its own face would be.
    const auto goes_on = [&](const Cube& cube) { return !cube.joint && cube.thick + gap > touch; };
    const Outline of_other = outline_in(other.face, own.face), of_own = outline_in(own.face, other.face);
    if (is_same(of_other, own.face)) {
        const bool shares = shares_ring_of(b, node, neighbour, own, other);
        if (!goes_on(shares ? own : other)) return {};
        return {Contact::Kind::same, shares, own.face.middle};
    }
    if (lies_in(of_own, other.face) && (touches || goes_on(own)))
        return {Contact::Kind::inside, false, other.face.middle};
    if (lies_in(of_other, own.face) && (touches || goes_on(other)))
        return {Contact::Kind::outside, false, own.face.middle};
    return {};
}

}  // namespace sinew

#include "sinew/extend/contacts.h"

#include <algorithm>
#include <cmath>

#include "sinew/extend/body_forms.h"

namespace sinew {
namespace {

constexpr double parallel = 0.9999;  // cosine
constexpr double touching = 1e-3;    // of the smaller extent: how far apart faces still touch
constexpr double same_size = 0.01;   // of an extent
constexpr double within = 0.98;      // of the larger face: how near to its edge the smaller may reach

struct Cube {
    Form box;
    Face face;     // towards the other
    double thick;  // behind that face
    bool joint;
};

Cube cube_towards(const PlainBuilder& b, std::int32_t node, std::int32_t other) {
    Cube cube{body_form(b, node, Form::Kind::box, half_size(b, node)), {}, 0, is_box_joint(b, node)};
    const Vec3 offset = b.position(other) - b.position(node);
    int index = face_towards(cube.box, offset);
    if (!cube.joint) index = b.other(b.first_bone(node), node) == other ? 5 : 4;
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
    const bool along = std::abs(face.frame.x.dot(frame.frame.x)) > 0.5;
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

}  // namespace

Contact find_contact(const PlainBuilder& b, std::int32_t node, std::int32_t neighbour) {
    if (b.type(node) != NodeType::cube || b.type(neighbour) != NodeType::cube) return {};
    const Cube own = cube_towards(b, node, neighbour), other = cube_towards(b, neighbour, node);
    if (own.joint && other.joint) return {};
    const Vec3& z = own.face.frame.z;
    if ((b.position(neighbour) - b.position(node)).dot(z) <= 0) return {};  // a path that folds back
    if (other.face.frame.z.dot(z) > -parallel) return {};
    const double askew = std::abs(own.face.frame.x.dot(other.face.frame.x));
    if (askew > 1 - parallel && askew < parallel) return {};
    const double gap = (other.face.middle - own.face.middle).dot(z),
                 touch = touching * std::min(own.face.half_x, own.face.half_y);
    if (gap > touch) return {};
    // The cube that ends in the other's face begins there, wherever its own face would be.
    const auto goes_on = [&](const Cube& cube) { return !cube.joint && cube.thick + gap > touch; };
    const Outline of_other = outline_in(other.face, own.face), of_own = outline_in(own.face, other.face);
    if (is_same(of_other, own.face)) {
        const bool below = b.is_below(node, neighbour) || (!b.is_below(neighbour, node) && node > neighbour);
        const bool shares = other.joint || (!own.joint && below);
        return goes_on(shares ? own : other) ? Contact{Contact::Kind::same, shares, own.face.middle}
                                             : Contact{};
    }
    const bool touches = gap > -touch;
    if (lies_in(of_own, other.face) && (goes_on(own) || (touches && !own.joint)))
        return {Contact::Kind::inside, false, other.face.middle};
    if (lies_in(of_other, own.face) && (goes_on(other) || touches))
        return {Contact::Kind::outside, false, own.face.middle};
    if (lies_in(of_own, other.face) && touches) return {Contact::Kind::inside, false, other.face.middle};
    return {};
}

}  // namespace sinew

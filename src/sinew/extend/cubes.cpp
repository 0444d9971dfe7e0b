#include "sinew/extend/cubes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sinew/extend/body_forms.h"
#include "sinew/extend/contacts.h"
#include "sinew/extend/sections.h"

namespace sinew {
namespace {

// Of the face: how far a tube's end stands before it, so that bones have a length; as little as single
// precision holds.
constexpr double plate_gap = 1e-7;

// Of a face's smaller half extent. A beam is straight, and leaves a ledge twice as wide as what is flush is
// off by; a round tube bulges between its vertices, and with 0.9 has its 12 vertices inside the face
// (sides_beside_edge; at 0.93 it takes 16).
constexpr double widest_beam = 0.98, widest_tube = 0.9;

// How far the beam to a neighbour may be from its face and still be flush with it: in size, as a share of the
// face, as contacts.cpp has it for cubes; in direction, as a cosine, 37 degrees. The beam comes from that
// face and no other, and is turned to it: a side that it is nearer to (beyond 45 degrees) would be as good.
constexpr double same_extent = 0.01, same_way = 0.8;

// Of a tube's radius, above the face: where the bones through it part. Their ball is clear of the face by a
// fifth, the least that leaves room for a ring: the higher, the fewer tubes cross beside it (21 of 240 random
// cubes; 17 with 2), and the farther the limbs part from where they were drawn.
constexpr double fork_height = 1.2;

/// Whether the beam to a neighbour is as large as the face that it leaves through, so that there is no
/// shoulder.
bool is_flush(const PlainBuilder& b, std::int32_t neighbour, const Face& face) {
    const Node& drawn = b.drawn(neighbour);
    if (drawn.type == NodeType::cube || drawn.section != Section::rectangular || b.degree(neighbour) > 2)
        return false;
    const Form beam = section_form(b, neighbour);
    if (std::abs(beam.z.dot(face.frame.z)) < same_way) return false;
    const bool along = std::abs(beam.x.dot(face.frame.x)) > std::abs(beam.x.dot(face.frame.y));
    const double x = along ? beam.half.x() : beam.half.y(), y = along ? beam.half.y() : beam.half.x();
    return std::abs(x - face.half_x) < same_extent * face.half_x &&
           std::abs(y - face.half_y) < same_extent * face.half_y;
}

/// Vertices that a circle needs beside an edge. Subdivision moves the middles of its chords out to the
/// circle, by a sagitta at first, by twice that in the end (each level halves the room and quarters the
/// sagitta), and they must not reach the edge.
std::int32_t sides_beside_edge(double radius, double to_edge) {
    constexpr double enough = 0.4;  // of the room: twice that leaves a fifth of it
    for (std::int32_t sides = 4; sides < 16; sides += 4)
        if (radius * (1 - std::cos(M_PI / sides)) <= enough * (to_edge - radius)) return sides;
    return 16;
}

/// A ball inside the cube comes out of the face: at the end of a bone it is a part of the face, or stands out
/// of it; a path goes on from before the face.
void surface_from(PlainBuilder& b, std::int32_t ball, const Face& face, const Vec3& at, double radius) {
    if (b.degree(ball) > 2 || b.type(ball) != NodeType::sphere) return;
    if (b.degree(ball) == 2) return b.move(ball, at + radius * face.frame.z);
    const double below = (face.middle - b.position(ball)).dot(face.frame.z);
    b.move(ball, at);
    b.set_radius(ball, radius);
    if (below >= b.radius(ball)) b.set_cap(ball, Cap::flat);
}

/// The end of a tube on a face: opposite its other end, or as near to that as it fits; in the middle where
/// the other end is not before the face at all.
std::int32_t add_plate(PlainBuilder& b, std::int32_t node, std::int32_t neighbour, const Face& face) {
    const double fits = std::min(face.half_x, face.half_y);
    const Node& other = b.drawn(neighbour);
    Form form = ring_form(face.frame, 0, 0, Section::round, infinitely_sharp);
    if (other.section == Section::rectangular && other.type != NodeType::cube && b.degree(neighbour) <= 2) {
        const Form beam = section_form(b, neighbour);
        const Frame turned =
            turn_frame({beam.x, beam.y, beam.z.dot(face.frame.z) < 0 ? Vec3(-beam.z) : beam.z}, face.frame.z);
        form.section = Section::rectangular;
        form.x = turned.x, form.y = form.z.cross(turned.x);
        form.half = {std::min(beam.half.x(), widest_beam * fits), std::min(beam.half.y(), widest_beam * fits),
                     1};
    } else {
        const double radius = std::min(b.radius(node), widest_tube * fits);
        form.half = {radius, radius, 1};
    }
    const Vec3 offset = b.position(neighbour) - face.middle;
    double x = offset.dot(face.frame.x), y = offset.dot(face.frame.y);
    const double reach = form.half.head<2>().maxCoeff();
    if (std::abs(x) > face.half_x || std::abs(y) > face.half_y) x = y = 0;
    const double room_x = face.half_x - reach / widest_tube, room_y = face.half_y - reach / widest_tube;
    x = room_x > 0 ? std::clamp(x, -room_x, room_x) : 0;
    y = room_y > 0 ? std::clamp(y, -room_y, room_y) : 0;
    if (form.section == Section::round)
        form.sides = sides_beside_edge(reach, std::min(face.half_x - std::abs(x), face.half_y - std::abs(y)));
    const Vec3 at = face.middle + x * face.frame.x + y * face.frame.y + plate_gap * fits * face.frame.z;
    const std::int32_t plate = b.add_node(at, reach, node);
    b.set_form(plate, form);
    if (offset.dot(face.frame.z) <= 0)
        surface_from(b, neighbour, face, at + plate_gap * fits * face.frame.z, reach);
    return plate;
}

/// One end of a cube that a path runs through: its ring, and what is there of a neighbour's.
struct CubeEnd {
    Face face;
    Contact contact;
    std::int32_t node = -1;
};

/// Where a ring stands that lies in a neighbour's face: a hair before that, so that bones have a length.
Vec3 ring_place(const CubeEnd& end) {
    if (end.contact.kind != Contact::Kind::inside) return end.face.middle;
    const double up = (end.contact.middle - end.face.middle).dot(end.face.frame.z);
    return end.face.middle + (up - plate_gap * std::min(end.face.half_x, end.face.half_y)) * end.face.frame.z;
}

/// The rings of both ends, of which one may be the neighbour's; one in the middle, if both are.
void add_end_rings(PlainBuilder& b, std::int32_t node, const Form& outline, CubeEnd& near, CubeEnd& far) {
    const bool shares_near = near.contact.shares_ring(), shares_far = far.contact.shares_ring();
    near.node = far.node = node;
    if (shares_near || shares_far) {
        b.move(node, shares_near && shares_far ? b.position(node) : ring_place(shares_near ? far : near));
        b.set_form(node, outline);
        return;
    }
    far.node = b.add_node(ring_place(far), b.radius(node), node);
    b.move(node, ring_place(near));
    b.set_form(node, outline);
    b.set_form(far.node, outline);
    b.add_bone(near.node, far.node, BoneKind::side);
}

/// Ties a bone to an end of a cube: to its ring if what it leads to is flush with that or touches it, or
/// to a plate.
void tie_end(PlainBuilder& b, std::int32_t node, std::int32_t bone, const CubeEnd& end) {
    const std::int32_t neighbour = b.other(bone, node);
    if (end.contact.kind == Contact::Kind::none && !is_flush(b, neighbour, end.face)) {
        const std::int32_t plate = add_plate(b, node, neighbour, end.face);
        b.add_bone(end.node, plate, BoneKind::plate);
        b.attach(bone, node, plate);
        return;
    }
    b.attach(bone, node, end.node);
    const bool joint = is_box_joint(b, neighbour);
    if (end.contact.kind == Contact::Kind::inside) b.set_kind(bone, joint ? BoneKind::body : BoneKind::plate);
    if (end.contact.shares_ring() && !joint) b.set_kind(bone, BoneKind::side);
}

/// Rings at the two faces of a cube that a path runs through, or ends in.
void add_path_cube(PlainBuilder& b, std::int32_t node) {
    const Vec3 half = half_size(b, node);
    const Frame frame = b.frame(node);
    const Form outline = ring_form(frame, half.x(), half.y(), Section::rectangular, infinitely_sharp);
    const std::int32_t first = b.first_bone(node);
    CubeEnd near{{b.position(node) - half.z() * frame.z, {frame.x, -frame.y, -frame.z}, half.x(), half.y()},
                 {}},
        far{{b.position(node) + half.z() * frame.z, frame, half.x(), half.y()}, {}};
    for (const std::int32_t bone : b.bones(node))
        (bone == first ? near : far).contact = find_contact(b, node, b.other(bone, node));
    add_end_rings(b, node, outline, near, far);
    if (b.degree(node) == 1) b.set_cap(far.node, Cap::flat);
    for (const std::int32_t bone : b.bones(node)) tie_end(b, node, bone, bone == first ? near : far);
}

/// Several bones through one face part at a ball of their own before it.
std::int32_t add_fork(PlainBuilder& b, std::int32_t node, const Face& face) {
    const double radius = widest_tube * std::min(face.half_x, face.half_y);
    Form form = ring_form(face.frame, radius, radius, Section::round, infinitely_sharp);
    form.sides = sides_beside_edge(radius, std::min(face.half_x, face.half_y));
    const std::int32_t plate = b.add_node(face.middle + plate_gap * radius * face.frame.z, radius, node);
    b.set_form(plate, form);
    b.add_bone(node, plate, BoneKind::body);
    const std::int32_t fork = b.add_node(face.middle + fork_height * radius * face.frame.z, radius, node);
    b.add_bone(plate, fork, BoneKind::tube);
    return fork;
}

void add_box_joint(PlainBuilder& b, std::int32_t node) {
    const Form box = body_form(b, node, Form::Kind::box, half_size(b, node));
    b.set_form(node, box);
    if (b.degree(node) == 0) return;
    std::array<std::vector<std::int32_t>, face_count> through;
    for (const std::int32_t bone : b.bones(node)) {
        const std::int32_t neighbour = b.other(bone, node);
        through[face_towards(box, b.position(neighbour) - b.position(node))].push_back(bone);
    }
    for (int i = 0; i < face_count; ++i) {
        const Face face = face_of(box, b.position(node), i);
        if (through[i].empty()) {
            const std::int32_t lid = b.add_node(face.middle, std::min(face.half_x, face.half_y), node);
            b.set_cap(lid, Cap::surface);
            b.add_bone(node, lid, BoneKind::body);
        } else if (through[i].size() > 1) {
            const std::int32_t fork = add_fork(b, node, face);
            for (const std::int32_t bone : through[i]) b.attach(bone, node, fork);
        } else {
            const std::int32_t neighbour = b.other(through[i][0], node);
            if (is_flush(b, neighbour, face) || b.is_pit(neighbour)) continue;
            if (find_contact(b, node, neighbour).kind != Contact::Kind::none) continue;
            const std::int32_t plate = add_plate(b, node, neighbour, face);
            b.add_bone(node, plate, BoneKind::body);
            b.attach(through[i][0], node, plate);
        }
    }
}

}  // namespace

void add_cube(PlainBuilder& b, std::int32_t node) {
    if (is_box_joint(b, node))
        add_box_joint(b, node);
    else
        add_path_cube(b, node);
}

}  // namespace sinew

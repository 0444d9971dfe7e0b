#include "sinew/extend/bodies.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sinew/base/round_cone.h"
#include "sinew/extend/sections.h"

namespace sinew {
namespace {

constexpr double plate_gap =
    1e-7;  // of the face: how far a tube's end stands before the face, so that bones have a length
constexpr double widest_beam = 0.98;  // of a face's smaller half extent
constexpr double widest_tube = 0.9;   // the same for round tubes, which bulge between their vertices
constexpr int pit_sides = 8;  // round a dent: with fewer, the surface beside it is pulled out of shape
constexpr double bare =
    0.643;  // cosine of 50 degrees: an axis with no bone nearer than that gets one of its own

constexpr double beyond_rim = 1.05;

Form ring_form(const Frame& frame, double half_x, double half_y, Section section, double sharpness) {
    Form form;
    form.section = section;
    form.x = frame.x, form.y = frame.y, form.z = frame.z;
    form.half = {half_x, half_y, 1};
    form.fixed = true;
    form.sharpness = sharpness;
    return form;
}

Form body_form(const PlainBuilder& b, std::int32_t node, Form::Kind kind, const Vec3& half) {
    const Frame frame = b.frame(node);
    Form form;
    form.kind = kind;
    form.x = frame.x, form.y = frame.y, form.z = frame.z;
    form.half = half;
    form.sharpness = b.drawn(node).joint;
    return form;
}

Vec3 half_size(const PlainBuilder& b, std::int32_t node) {
    const Node& drawn = b.drawn(node);
    return drawn.size ? Vec3(0.5 * *drawn.size) : Vec3::Constant(b.radius(node));
}

/// A face of a box: its middle, its frame (z outward) and half extents.
struct Face {
    Vec3 middle;
    Frame frame;
    double half_x, half_y;
};

/// Whether the beam to a neighbour is as large as the face that it leaves through, so that there is no
/// shoulder.
bool is_flush(const PlainBuilder& b, std::int32_t neighbour, const Face& face) {
    const Node& drawn = b.drawn(neighbour);
    if (drawn.type == NodeType::cube || drawn.section != Section::rectangular || b.degree(neighbour) > 2)
        return false;
    const Form beam = section_form(b, neighbour);
    if (std::abs(beam.z.dot(face.frame.z)) < 0.8) return false;
    const bool along = std::abs(beam.x.dot(face.frame.x)) > std::abs(beam.x.dot(face.frame.y));
    const double x = along ? beam.half.x() : beam.half.y(), y = along ? beam.half.y() : beam.half.x();
    return std::abs(x - face.half_x) < 0.01 * face.half_x && std::abs(y - face.half_y) < 0.01 * face.half_y;
}

/// Vertices that a circle needs beside an edge. Subdivision moves the middles of its chords out to the
/// circle, by a sagitta at first, by twice that in the end (each level halves the room and quarters the
/// sagitta), and they must not reach the edge.
std::int32_t sides_beside_edge(double radius, double to_edge) {
    constexpr double enough = 0.4;  // of the room
    for (std::int32_t sides = 4; sides < 16; sides += 4)
        if (radius * (1 - std::cos(M_PI / sides)) <= enough * (to_edge - radius)) return sides;
    return 16;
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
    return plate;
}

/// Rings at the two faces of a cube that a path runs through, or ends in.
void add_path_cube(PlainBuilder& b, std::int32_t node) {
    const Vec3 half = half_size(b, node);
    const Frame frame = b.frame(node);
    const Form outline = ring_form(frame, half.x(), half.y(), Section::rectangular, infinitely_sharp);
    const std::int32_t first = b.first_bone(node);
    const std::int32_t near = node,
                       far = b.add_node(b.position(node) + half.z() * frame.z, b.radius(node), node);
    b.move(near, b.position(node) - half.z() * frame.z);
    b.set_form(near, outline);
    b.set_form(far, outline);
    b.add_bone(near, far, BoneKind::side);
    if (b.degree(node) == 1) b.set_cap(far, Cap::flat);
    for (const std::int32_t bone : b.bones(node)) {
        const bool at_near = bone == first;
        const std::int32_t neighbour = b.other(bone, node), at = at_near ? near : far;
        Face face{b.position(node) + (at_near ? -half.z() : half.z()) * frame.z, frame, half.x(), half.y()};
        if (at_near) face.frame = {frame.x, -frame.y, -frame.z};
        if (is_flush(b, neighbour, face)) {
            b.attach(bone, node, at);
            continue;
        }
        const std::int32_t plate = add_plate(b, node, neighbour, face);
        b.add_bone(at, plate, BoneKind::plate);
        b.attach(bone, node, plate);
    }
}

constexpr int face_count = 6;

Face face_of(const Form& box, const Vec3& centre, int index) {
    const std::array<Vec3, 3> axis{box.x, box.y, box.z};
    const int k = index / 2, u = (k + 1) % 3, v = (k + 2) % 3;
    const double sign = index % 2 == 0 ? 1 : -1;
    const Vec3 z = sign * axis[k];
    return {centre + box.half[k] * z, {axis[u], z.cross(axis[u]), z}, box.half[u], box.half[v]};
}

int face_towards(const Form& box, const Vec3& offset) {
    const Vec3 local(offset.dot(box.x) / box.half.x(), offset.dot(box.y) / box.half.y(),
                     offset.dot(box.z) / box.half.z());
    int k = 0;
    local.cwiseAbs().maxCoeff(&k);
    return 2 * k + (local[k] < 0 ? 1 : 0);
}

/// Several bones through one face part at a ball of their own before it.
std::int32_t add_fork(PlainBuilder& b, std::int32_t node, const Face& face) {
    const double radius = widest_tube * std::min(face.half_x, face.half_y);
    Form form = ring_form(face.frame, radius, radius, Section::round, infinitely_sharp);
    form.sides = sides_beside_edge(radius, std::min(face.half_x, face.half_y));
    const std::int32_t plate = b.add_node(face.middle + plate_gap * radius * face.frame.z, radius, node);
    b.set_form(plate, form);
    b.add_bone(node, plate, BoneKind::body);
    const std::int32_t fork = b.add_node(face.middle + 1.2 * radius * face.frame.z, radius, node);
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
            const std::int32_t plate = add_plate(b, node, neighbour, face);
            b.add_bone(node, plate, BoneKind::body);
            b.attach(through[i][0], node, plate);
        }
    }
}

/// The cell of a dent ends halfway to the next bone: if that were not beyond the dent's rim, the joint would
/// fold over it. Turns a ray so far away from the dent, where it can.
Vec3 clear_of_dent(const PlainBuilder& b, std::int32_t node, std::int32_t dent, double reach,
                   const Vec3& ray) {
    const double rim =
        beyond_rim * section_form(b, dent).half.head<2>().maxCoeff() / reach;  // sine of its angle
    const double cosine = std::max(1 - 2 * rim * rim, -bare);
    const Vec3 towards = b.direction(node, dent), across = ray - ray.dot(towards) * towards;
    if (ray.dot(towards) <= cosine) return ray;
    return cosine * towards + std::sqrt(1 - cosine * cosine) * across.normalized();
}

/// Bones of its own for every axis that no drawn bone is near, so that the joint has vertices all round.
void add_surface_bones(PlainBuilder& b, std::int32_t node, const Frame& frame, double reach) {
    std::vector<std::int32_t> drawn;
    for (const std::int32_t bone : b.bones(node)) drawn.push_back(b.other(bone, node));
    const auto near = [&](const Vec3& ray) {
        return std::ranges::any_of(
            drawn, [&](std::int32_t other) { return b.direction(node, other).dot(ray) > bare; });
    };
    for (const Vec3& axis : {frame.x, frame.y, frame.z})
        for (const double sign : {1.0, -1.0}) {
            Vec3 ray = sign * axis;
            if (near(ray)) continue;
            for (const std::int32_t other : drawn)
                if (b.is_pit(other)) ray = clear_of_dent(b, node, other, reach, ray);
            if (near(ray)) continue;
            const std::int32_t tip = b.add_node(b.position(node) + reach * ray, 0.5 * reach, node);
            b.set_cap(tip, Cap::surface);
            b.add_bone(node, tip, BoneKind::body);
        }
}

/// Where a unit ray from the middle of a node leaves its own surface.
double exit_of_node(const PlainBuilder& b, std::int32_t node, const Vec3& ray) {
    if (const Form* form = b.form(node); form && form->kind == Form::Kind::box)
        return exit_of_box(*form, ray);
    if (const Form* form = b.form(node); form && form->kind == Form::Kind::ball)
        return exit_of_ellipsoid(*form, ray);
    double distance = b.radius(node);
    for (const std::int32_t bone : b.bones(node)) {
        const std::int32_t other = b.other(bone, node);
        if (b.is_pit(other)) continue;
        distance = std::max(
            distance,
            ConeFrom(b.position(node), b.radius(node), b.position(other), b.radius(other)).exit(ray));
    }
    return distance;
}

/// A dent as wide as what it is pressed into would leave nothing of it.
bool narrow(double& half, double parent) {
    if (half < parent) return false;
    half = 0.9 * parent;
    return true;
}

}  // namespace

double exit_of_ellipsoid(const Form& form, const Vec3& ray) {
    const Vec3 local(ray.dot(form.x) / form.half.x(), ray.dot(form.y) / form.half.y(),
                     ray.dot(form.z) / form.half.z());
    return 1 / local.norm();
}

double exit_of_box(const Form& form, const Vec3& ray) {
    const Vec3 local(ray.dot(form.x) / form.half.x(), ray.dot(form.y) / form.half.y(),
                     ray.dot(form.z) / form.half.z());
    return 1 / local.cwiseAbs().maxCoeff();
}

void add_cube(PlainBuilder& b, std::int32_t node) {
    bool pitted = false;
    for (const std::int32_t bone : b.bones(node)) pitted = pitted || b.is_pit(b.other(bone, node));
    if (b.is_root(node) || b.degree(node) > 2 || pitted)
        add_box_joint(b, node);
    else
        add_path_cube(b, node);
}

void add_ball(PlainBuilder& b, std::int32_t node) {
    const auto& scale = b.drawn(node).scale;
    const Form ball =
        body_form(b, node, Form::Kind::ball, b.radius(node) * Vec3(scale[0], scale[1], scale[2]));
    b.set_form(node, ball);
    if (b.degree(node) == 0) return;
    for (const std::int32_t bone : b.bones(node)) {
        const std::int32_t neighbour = b.other(bone, node);
        if (b.is_pit(neighbour)) continue;
        const Vec3 ray = b.direction(node, neighbour);
        const double reach = exit_of_ellipsoid(ball, ray),
                     tube = std::min(b.radius(neighbour), 0.9 * ball.half.minCoeff());
        const double height = reach * std::sqrt(1 - (tube / reach) * (tube / reach));
        const double distance = (b.position(neighbour) - b.position(node)).norm();
        if (distance <= height * (1 + 1e-6)) continue;  // the other end is inside the ball
        const std::int32_t ring = b.add_node(b.position(node) + height * ray, tube, node);
        b.set_form(ring, ring_form(frame_along(ray, 0), tube, tube, Section::round, ball.sharpness));
        b.add_bone(node, ring, BoneKind::body);
        b.attach(bone, node, ring);
    }
    add_surface_bones(b, node, {ball.x, ball.y, ball.z}, ball.half.mean());
}

void add_pit(PlainBuilder& b, std::int32_t node) {
    const std::int32_t parent = b.other(b.bones(node)[0], node);
    const Vec3 ray = b.direction(parent, node);
    const double surface = exit_of_node(b, parent, ray), room = surface + exit_of_node(b, parent, -ray);
    double depth = (b.position(node) - b.position(parent)).norm() - surface;
    if (depth <= 0) {
        b.warn(node, "this negative leaf lies inside its parent; its dent is made shallow");
        depth = 0.1 * b.radius(node);
    }
    if (depth > 0.85 * room) {
        b.warn(node,
               "this negative leaf is deeper than its parent is thick; its dent ends before the far side");
        depth = 0.85 * room;
    }
    Form opening = section_form(b, node);
    const auto wide = [&](const Vec3& axis) {
        return std::min(exit_of_node(b, parent, axis), exit_of_node(b, parent, -axis));
    };
    const bool narrowed_x = narrow(opening.half.x(), wide(opening.x));
    const bool narrowed_y = narrow(opening.half.y(), wide(opening.y));
    if (narrowed_x || narrowed_y)
        b.warn(node, "this negative leaf is wider than its parent; its dent leaves a wall round it");
    opening.sides = pit_sides;
    b.set_form(node, opening);
    b.set_pit(node, depth);
    b.move(node, b.position(parent) + (surface + depth) * ray);
    const bool needs_body = !b.form(parent) || b.form(parent)->kind == Form::Kind::ring;
    if (!needs_body) return;
    b.set_cap(parent, Cap::round);  // a leaf of which nothing is left but its dent ends nowhere
    b.set_radius(parent, b.radius(parent));
    Form blend = b.form(parent) ? *b.form(parent) : section_form(b, parent);
    blend.kind = Form::Kind::blend;
    blend.sides = pit_sides;
    b.set_form(parent, blend);
    add_surface_bones(b, parent, b.frame(parent), b.radius(parent));
}

}  // namespace sinew

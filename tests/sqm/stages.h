// Small skeletons, and the stages of sqm run on them one after the other.
#pragma once

#include <gtest/gtest.h>

#include <span>
#include <vector>

#include "property/random.h"
#include "sinew/extend/extend.h"
#include "sinew/skeleton/symmetry.h"
#include "sinew/sqm/bridge/bridge.h"
#include "sinew/sqm/bridge/features.h"
#include "sinew/sqm/counts/refine.h"
#include "sinew/sqm/fit/fit.h"
#include "sinew/sqm/place/place.h"
#include "sinew/sqm/place/symmetrise.h"
#include "sinew/sqm/rings/stations.h"
#include "sinew/sqm/surface/find_surfaces.h"

namespace sinew::sqm {

/// Directions of the corners of a cube.
inline std::vector<Vec3> cube_corners() {
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i)
        corners.push_back(Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1).normalized());
    return corners;
}

inline std::int32_t add(Document& document, std::int32_t parent, const Vec3& position, double radius) {
    Node node;
    node.id = std::ssize(document.nodes);
    node.parent = parent;
    node.position = position;
    node.radius = radius;
    document.nodes.push_back(node);
    return static_cast<std::int32_t>(node.id);
}

struct Ball {
    std::int32_t parent;
    Vec3 position;
    double radius;
};

inline Document tree(std::span<const Ball> balls) {
    Document d;
    for (const Ball& ball : balls) add(d, ball.parent, ball.position, ball.radius);
    return d;
}

/// Balls at the given places, one after the other.
inline Document chain(std::span<const Vec3> places, double radius) {
    Document d;
    for (const Vec3& place : places) add(d, static_cast<std::int32_t>(d.nodes.size()) - 1, place, radius);
    return d;
}

/// A ball in the middle and a bone in each direction.
inline Document star(std::span<const Vec3> directions, double length = 3, double radius = 0.25) {
    Document d;
    add(d, -1, Vec3::Zero(), radius);
    for (const Vec3& direction : directions) add(d, 0, length * direction, radius);
    return d;
}

inline std::vector<Vec3> random_directions(property::Random& random, int count) {
    std::vector<Vec3> directions;
    for (int i = 0; i < count; ++i) directions.push_back(random.direction());
    return directions;
}

/// Directions evenly round z.
inline std::vector<Vec3> fan(int count) {
    std::vector<Vec3> directions;
    for (int i = 0; i < count; ++i)
        directions.push_back({std::cos(2 * M_PI * i / count), std::sin(2 * M_PI * i / count), 0});
    return directions;
}

/// A ball of radius 1, and a dent of this half width and depth at each angle from z towards x.
inline Document dented_ball(std::span<const double> angles, double width, double depth) {
    Document d;
    add(d, -1, Vec3::Zero(), 1);
    d.nodes[0].type = NodeType::ball;
    for (const double angle : angles)
        d.nodes[add(d, 0, (1 + depth) * Vec3(std::sin(angle), 0, std::cos(angle)), width)].type =
            NodeType::negative;
    return d;
}

/// A closed path in space: once round z, and `waves` times round that circle as it goes.
inline Document closed_coil(int nodes, int waves, double radius) {
    std::vector<Vec3> places;
    for (int i = 0; i < nodes; ++i) {
        const double along = 2 * M_PI * i / nodes, out = 6 + 1.5 * std::cos(waves * along);
        places.push_back({out * std::cos(along), out * std::sin(along), 1.5 * std::sin(waves * along)});
    }
    Document d = chain(places, radius);
    d.links = {{0, nodes - 1}};
    return d;
}

/// Eight nodes and twelve bones: a cube of struts.
inline Document cube_of_struts(double size = 4, double radius = 0.3) {
    Document d;
    for (int i = 0; i < 8; ++i) {
        const int parent = i == 0 ? -1 : i & 1 ? i ^ 1 : i & 2 ? i ^ 2 : i ^ 4;
        add(d, parent, size * Vec3(i & 1, (i >> 1) & 1, i >> 2), radius);
    }
    d.links = {{1, 3}, {1, 5}, {3, 7}, {5, 7}, {2, 6}};
    return d;
}

/// A tree whose nodes have enough room: its joints are `levels` deep and part into two or three.
inline Document random_tree(property::Random& random, int levels) {
    Document d;
    add(d, -1, Vec3::Zero(), 0.3);
    std::vector<std::int32_t> tips{0};
    for (int level = 0; level < levels; ++level) {
        std::vector<std::int32_t> next;
        for (const std::int32_t tip : tips)
            for (int i = random.whole(2, 3); i > 0; --i)
                next.push_back(add(d, tip, d.nodes[tip].position + 4.0 * random.direction(), 0.3));
        tips = next;
    }
    return d;
}

inline Document mirrored(const Document& half) {
    Document d = half;
    d.symmetry = {Symmetry::Kind::mirror, 0, 1};
    return d;
}

/// What conditioning and extending make of a document, with the mirror that it has.
inline Plain plain_of(const Document& document) {
    Warnings warnings;
    Plain plain = extend(document, condition(document), warnings);
    plain.symmetry = find_mirror(plain);
    return plain;
}

/// The same with the images of its symmetry, which it keeps.
inline Plain expanded(const Document& document) {
    const ExpandedSymmetry e = expand_symmetry(document);
    Plain plain = plain_of(e.document);
    plain.symmetry = carry_symmetry(plain, e.generator, e.order, e.image);
    return plain;
}

/// An axle along z, and a spoke that the symmetry repeats.
inline Document wheel(int count) {
    Document d;
    add(d, -1, {0, 0, 0}, 0.5);
    add(d, 0, {0, 0, 3}, 0.4);
    add(d, 0, {3, 0.1, -1}, 0.3);
    d.symmetry = {Symmetry::Kind::radial, 2, count};
    return d;
}

/// All stages before the faces.
struct Stages {
    Plain skeleton;
    Network network;
    Polyhedra polyhedra;
    JointSurfaces surfaces;
    Images images;
    Refinement refinement;
    JointPoints points;
    Stations stations;

    explicit Stages(const Document& document, int sides = 0) : Stages(plain_of(document), sides) {}
    explicit Stages(Plain plain, int sides = 0)
        : skeleton(std::move(plain)),
          network(find_network(skeleton)),
          polyhedra(make_polyhedra(skeleton, network).value()),
          surfaces(find_surfaces(skeleton, network)),
          images(find_images(skeleton, network, polyhedra)),
          refinement(refine(skeleton, network, polyhedra, surfaces, images, {.sides = sides}).value()),
          points(make_joint_points(skeleton, network, polyhedra, refinement, surfaces)),
          stations(make_stations(skeleton, network, polyhedra, refinement, surfaces, points)) {}
    Stages(const Stages&) = delete;

    Parts parts() const { return {skeleton, network, polyhedra, refinement, surfaces, points, stations}; }
    std::int32_t ring_count(std::int32_t path) const {
        return stations.first[path + 1] - stations.first[path];
    }
    std::vector<Station> rings(std::int32_t path) const {
        return {stations.stations.begin() + stations.first[path],
                stations.stations.begin() + stations.first[path + 1]};
    }
    /// Vertices round a cell.
    std::int32_t round_cell(std::int32_t cell) const {
        std::int32_t sum = 0;
        for (const CellSide& side : polyhedra.cell(cell)) sum += refinement.pieces[side.arc];
        return sum;
    }
};

/// The rest of the stages: features, places, the fit if it is asked for, and the symmetry.
inline void finish(const Stages& s, bool fit, Bridge& b) {
    place(s.parts(), {}, b);
    add_features(s.parts(), b);
    const auto image = vertex_images(s.parts(), s.images, b);
    if (fit) {
        ASSERT_TRUE(fit_limit(s.parts(), b));
    }
    make_symmetric(s.images, image, b.mesh.positions);
}

}  // namespace sinew::sqm

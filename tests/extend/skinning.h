// Small documents and what is asked of their meshes.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sinew/mesh/validate.h"
#include "sinew/sqm/skin.h"
#include "sinew/subdivide/subdivide.h"

namespace sinew::testing_types {

/// Adds a node; ids are the order.
inline Node& add(Document& document, std::int32_t parent, const Vec3& position, double radius,
                 NodeType type = NodeType::sphere) {
    Node node;
    node.id = static_cast<std::int64_t>(document.nodes.size());
    node.parent = parent;
    node.position = position;
    node.radius = radius;
    node.type = type;
    return document.nodes.emplace_back(node);
}

/// The mesh of a document; the test fails unless it is a solid with the Euler number that the skeleton asks
/// for.
inline Skin solid(const Document& document, const SkinOptions& options = {}) {
    auto skin = sinew::skin(document, options);
    if (!skin) {
        ADD_FAILURE() << skin.error().text();
        return {};
    }
    const Validation v = validate(skin->mesh);
    EXPECT_TRUE(v.finite());
    EXPECT_TRUE(v.closed());
    EXPECT_TRUE(v.manifold());
    EXPECT_TRUE(v.oriented());
    EXPECT_EQ(v.components, skin->components);
    EXPECT_EQ(v.euler, 2 * skin->components - 2 * skin->cycles);
    return std::move(*skin);
}

inline QuadMesh smooth(const Document& document, int levels = 3) {
    const Skin skin = solid(document, {.fit = Fit::limit});
    const auto fine = subdivide(skin.mesh, {.levels = levels});
    if (!fine) ADD_FAILURE() << fine.error().text();
    return fine ? *fine : QuadMesh{};
}

/// Largest distance of a vertex from an ellipsoid, as a share of its radius there.
/// @param keep  which vertices count, seen from its centre
template <class Keep>
inline double farthest_from_ball(const QuadMesh& mesh, const Vec3& centre, const Vec3& half, Keep keep) {
    double worst = 0;
    for (const Vec3f& p : mesh.positions) {
        const Vec3 v = p.cast<double>() - centre;
        if (keep(v)) worst = std::max(worst, std::abs(v.cwiseQuotient(half).norm() - 1));
    }
    return worst;
}

inline double distance_to(const QuadMesh& mesh, const Vec3& place) {
    double nearest = 1e300;
    for (const Vec3f& p : mesh.positions) nearest = std::min(nearest, (p.cast<double>() - place).norm());
    return nearest;
}
inline bool has_vertex(const QuadMesh& mesh, const Vec3& place, double tolerance = 1e-6) {
    return distance_to(mesh, place) <= tolerance;
}

/// Irregular vertices, by valence.
inline std::int64_t irregular(const QuadMesh& mesh) {
    std::vector<int> valence(mesh.vertex_count(), 0);
    for (const std::uint32_t v : mesh.corners) ++valence[v];
    return std::count_if(valence.begin(), valence.end(), [](int n) { return n != 4; });
}

/// The eight corners of a box in a frame.
inline std::vector<Vec3> box_corners(const Vec3& centre, const Mat3& axes, const Vec3& half) {
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i)
        corners.push_back(centre + axes * Vec3(i & 1 ? half.x() : -half.x(), i & 2 ? half.y() : -half.y(),
                                               i & 4 ? half.z() : -half.z()));
    return corners;
}

/// Every vertex of the faces of a plane feature lies in it.
inline void expect_flat(const QuadMesh& mesh, double tolerance) {
    for (const Plane& plane : mesh.features.planes)
        for (const std::uint32_t f : plane.faces)
            for (const std::uint32_t v : mesh.face(f))
                EXPECT_NEAR((mesh.positions[v] - plane.point).dot(plane.normal), 0, tolerance);
}

}  // namespace sinew::testing_types

/// @file open_subdiv.h
/// The same subdivision by OpenSubdiv, in double precision, for comparison.
#pragma once

#include <gtest/gtest.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <algorithm>
#include <memory>

#include "sinew/subdivide/level.h"

namespace sinew::open_subdiv {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

inline double size_of(const QuadMesh& mesh) {
    Eigen::AlignedBox3f box;
    for (const Vec3f& p : mesh.positions) box.extend(p);
    return double{box.diagonal().norm()};
}

inline std::unique_ptr<Far::TopologyRefiner> refiner_of(const QuadMesh& mesh) {
    std::vector<int> sizes, corners(mesh.corners.begin(), mesh.corners.end()), crease_ends, corner_vertices;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) sizes.push_back(int(mesh.face(f).size()));
    std::vector<float> crease_weights, corner_weights;
    for (const Crease& crease : mesh.features.creases) {
        crease_ends.insert(crease_ends.end(), {int(crease.edge[0]), int(crease.edge[1])});
        crease_weights.push_back(std::min(crease.sharpness, 10.0f));
    }
    for (const std::uint32_t v : mesh.features.corners) {
        corner_vertices.push_back(int(v));
        corner_weights.push_back(10);
    }
    Far::TopologyDescriptor descriptor;
    descriptor.numVertices = int(mesh.vertex_count());
    descriptor.numFaces = int(mesh.face_count());
    descriptor.numVertsPerFace = sizes.data();
    descriptor.vertIndicesPerFace = corners.data();
    descriptor.numCreases = int(crease_weights.size());
    descriptor.creaseVertexIndexPairs = crease_ends.data();
    descriptor.creaseWeights = crease_weights.data();
    descriptor.numCorners = int(corner_weights.size());
    descriptor.cornerVertexIndices = corner_vertices.data();
    descriptor.cornerWeights = corner_weights.data();
    Sdc::Options options;
    options.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    return std::unique_ptr<Far::TopologyRefiner>(
        Factory::Create(descriptor, Factory::Options(Sdc::SCHEME_CATMARK, options)));
}

struct Point {
    Vec3 p = Vec3::Zero();
    void Clear(void* = nullptr) { p.setZero(); }
    void AddWithWeight(const Point& other, double weight) { p += weight * other.p; }
};

/// OpenSubdiv's numbers of our vertices and faces, level after level.
struct Numbers {
    std::vector<int> vertices, faces;
};

inline Numbers next_numbers(const Level& level, const Far::TopologyLevel& theirs, const Numbers& numbers) {
    Numbers next;
    for (std::uint32_t v = 0; v < level.vertices; ++v)
        next.vertices.push_back(theirs.GetVertexChildVertex(numbers.vertices[v]));
    with_faces(level, [&](const auto& faces) {
        for (std::uint32_t e = 0; e < level.edge_count(); ++e) {
            const auto [a, b] = ends_of(level, faces, e);
            const int edge = theirs.FindEdge(numbers.vertices[a], numbers.vertices[b]);
            next.vertices.push_back(theirs.GetEdgeChildVertex(edge));
        }
        for (std::uint32_t f = 0; f < level.faces; ++f) {
            const int face = numbers.faces[f];
            next.vertices.push_back(theirs.GetFaceChildVertex(face));
            const auto corners = theirs.GetFaceVertices(face);
            for (std::uint32_t slot = faces.begin(f); slot < faces.end(f); ++slot) {
                const int corner = corners.FindIndex(numbers.vertices[level.corners[slot]]);
                next.faces.push_back(theirs.GetFaceChildFaces(face)[corner]);
            }
        }
    });
    return next;
}

/// Positions of all levels from 0 on, in the order of our vertices. With `limit` the last entry is the limit
/// positions of the last level.
inline std::vector<std::vector<Vec3>> subdivide(const QuadMesh& mesh, int levels, bool limit = false) {
    const auto refiner = refiner_of(mesh);
    Far::TopologyRefiner::UniformOptions uniform(levels);
    uniform.fullTopologyInLastLevel = limit;
    refiner->RefineUniform(uniform);
    const Far::PrimvarRefinerReal<double> primvars(*refiner);

    std::vector<Point> points(mesh.vertex_count());
    for (std::size_t v = 0; v < points.size(); ++v) points[v].p = mesh.positions[v].cast<double>();
    Level level = control_level(mesh, build_topology(mesh), {});
    Numbers numbers;
    for (int v = 0; v < int(level.vertices); ++v) numbers.vertices.push_back(v);
    for (int f = 0; f < int(level.faces); ++f) numbers.faces.push_back(f);

    std::vector<std::vector<Vec3>> result;
    const auto append = [&](const std::vector<Point>& from) {
        result.emplace_back();
        for (const int v : numbers.vertices) result.back().push_back(from[std::size_t(v)].p);
    };
    append(points);
    for (int l = 0; l < levels; ++l) {
        std::vector<Point> finer(std::size_t(refiner->GetLevel(l + 1).GetNumVertices()));
        primvars.Interpolate(l + 1, points, finer);
        points = std::move(finer);
        numbers = next_numbers(level, refiner->GetLevel(l), numbers);
        level = finer_level(level);
        append(points);
    }
    if (limit) {
        std::vector<Point> limits(points.size());
        primvars.Limit(points, limits);
        append(limits);
    }
    return result;
}

/// Our vertices are where theirs are, to a millionth of the size of the control mesh.
inline void expect_same(const QuadMesh& control, const QuadMesh& ours, const std::vector<Vec3>& theirs) {
    ASSERT_EQ(ours.vertex_count(), theirs.size());
    double worst = 0;
    for (std::size_t v = 0; v < theirs.size(); ++v)
        worst = std::max(worst, (ours.positions[v].cast<double>() - theirs[v]).norm());
    EXPECT_LE(worst, 1e-6 * size_of(control));
}

}  // namespace sinew::open_subdiv

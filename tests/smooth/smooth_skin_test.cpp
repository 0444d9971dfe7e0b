/// One call from a skeleton to its smooth surface: which radii it has, and that memory changes no byte.
#include "sinew/smooth/smooth_skin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

#include "sinew/io/skeleton_formats.h"

namespace sinew {
namespace {

/// A stick of radius 1 along z, from 0 to 10.
Document stick(NodeType ends = NodeType::sphere) {
    Document document;
    for (int i = 0; i < 3; ++i)
        document.nodes.push_back({.id = i,
                                  .parent = i - 1,
                                  .position = {0, 0, 5.0 * i},
                                  .radius = 1,
                                  .type = i == 1 ? NodeType::sphere : ends});
    return document;
}

/// Least and largest distance from the axis of the vertices in the middle of the stick.
std::array<double, 2> radii(const QuadMesh& mesh) {
    std::array<double, 2> found{1e9, 0};
    for (const Vec3f& p : mesh.positions)
        if (p.z() > 2 && p.z() < 8) {
            const double radius = std::hypot(p.x(), p.y());
            found = {std::min(found[0], radius), std::max(found[1], radius)};
        }
    return found;
}

void expect_same_bytes(const QuadMesh& a, const QuadMesh& b) {
    EXPECT_EQ(a.positions, b.positions);
    EXPECT_EQ(a.corners, b.corners);
    EXPECT_EQ(a.face_offsets, b.face_offsets);
    EXPECT_EQ(a.vertex_node, b.vertex_node);
    EXPECT_EQ(a.vertex_bone, b.vertex_bone);
    EXPECT_EQ(a.vertex_along, b.vertex_along);
    EXPECT_EQ(a.features.poles, b.features.poles);
    ASSERT_EQ(a.features.circles.size(), b.features.circles.size());
    for (std::size_t c = 0; c < a.features.circles.size(); ++c) {
        EXPECT_EQ(a.features.circles[c].centre, b.features.circles[c].centre);
        EXPECT_EQ(a.features.circles[c].radius, b.features.circles[c].radius);
        EXPECT_EQ(a.features.circles[c].edges, b.features.circles[c].edges);
    }
    ASSERT_EQ(a.features.planes.size(), b.features.planes.size());
    for (std::size_t p = 0; p < a.features.planes.size(); ++p) {
        EXPECT_EQ(a.features.planes[p].point, b.features.planes[p].point);
        EXPECT_EQ(a.features.planes[p].faces, b.features.planes[p].faces);
    }
}

TEST(SmoothSkin, AStickHasItsRadiusAtEveryLevel) {
    for (int levels = 0; levels <= 4; ++levels) {
        SCOPED_TRACE(levels);
        const auto made = smooth_skin(stick(), {.levels = levels});
        ASSERT_TRUE(made) << made.error().text();
        const auto [least, largest] = radii(made->skin.mesh);
        EXPECT_NEAR(least, 1, 0.015);  // what a closed spline through four points is out of round by
        EXPECT_NEAR(largest, 1, 0.015);
    }
}

TEST(SmoothSkin, IsSkinAndSubdivide) {
    const Document document = stick(NodeType::hemisphere);
    const auto control = skin(document, {.fit = Fit::limit});
    expect_same_bytes(smooth_skin(document, {.levels = 2})->skin.mesh,
                      *subdivide(control->mesh, {.levels = 2, .limit = true}));
    expect_same_bytes(smooth_skin(document, {.fit = Fit::limit})->skin.mesh, control->mesh);
    expect_same_bytes(smooth_skin(document)->skin.mesh, skin(document)->mesh);
    expect_same_bytes(smooth_skin(document, {.levels = 1, .fit = Fit::control, .sides = 8})->skin.mesh,
                      *subdivide(skin(document, {.sides = 8})->mesh, {.levels = 1}));
}

TEST(SmoothSkin, FiguresAreThoseOfTheSkeleton) {
    const auto read = read_skeleton(SINEW_EXAMPLES "/goat.sinew");
    ASSERT_TRUE(read);
    const auto control = skin(read->document, {.fit = Fit::limit});
    const auto made = smooth_skin(read->document, {.levels = 1});
    EXPECT_EQ(made->skin.components, control->components);
    EXPECT_EQ(made->skin.cycles, control->cycles);
    EXPECT_EQ(made->skin.irregular, control->irregular);
    EXPECT_EQ(made->skin.warnings.size(), control->warnings.size());
}

TEST(SmoothSkin, FailsAsItsStagesDo) {
    Document document = stick();
    EXPECT_EQ(smooth_skin(document, {.levels = -1}).error().kind, ErrorKind::call);
    EXPECT_EQ(smooth_skin(document, {.levels = 5, .memory = 1000}).error().kind, ErrorKind::call);
    document.nodes[1].radius = -1;
    EXPECT_EQ(smooth_skin(document).error().node, 1);
}

TEST(SmoothSkin, ProgressRunsOnceFromNothingToAll) {
    for (const int levels : {0, 2}) {
        std::vector<double> shares;
        const Progress progress([&](double share, std::string_view) { shares.push_back(share); });
        ASSERT_TRUE(smooth_skin(stick(), {.levels = levels}, progress));
        EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
        EXPECT_EQ(shares.front(), 0);
        EXPECT_EQ(shares.back(), 1);
    }
}

TEST(SmoothSkin, StopsInBothStages) {
    for (const char* where : {"polyhedra", "subdivide"}) {
        std::atomic<bool> stop = false;
        const auto report = [&](double, std::string_view stage) { stop = stop || stage == where; };
        const auto made = smooth_skin(stick(), {.levels = 2}, Progress(report, &stop));
        ASSERT_FALSE(made) << where;
        EXPECT_EQ(made.error().kind, ErrorKind::cancelled);
    }
}

TEST(SmoothSkinner, RemembersAndChangesNoByte) {
    // A drag along the stick moves rings, circles and planes and the bones' parameters; a wider one makes other
    // rings, another type other features, and other options other tables.
    SmoothSkinner skinner;
    for (const NodeType ends : {NodeType::hemisphere, NodeType::cube, NodeType::sphere, NodeType::cone})
        for (const double place : {5.0, 5.01, 5.3, 7.5})
            for (const int levels : {2, 0, 1}) {
                SCOPED_TRACE(testing::Message() << int(ends) << " " << place << " " << levels);
                Document document = stick(ends);
                document.nodes[1].position = {0.1 * place, 0, place};
                const SmoothSkinOptions options{.levels = levels};
                const auto again = skinner(document, options), anew = smooth_skin(document, options);
                ASSERT_TRUE(again && anew);
                expect_same_bytes(again->skin.mesh, anew->skin.mesh);
                expect_same_bytes(skinner(document, options)->skin.mesh, anew->skin.mesh);
            }
}

TEST(SmoothSkinner, SaysWhereVerticesCameFromWhenABoneGrows) {
    // A branch: how far along a bone its rings stand depends on its length.
    SmoothSkinner skinner;
    std::vector<float> along;
    int same_topology = 0;
    for (int step = 0; step < 12; ++step) {
        Document document = stick();
        document.nodes.push_back({.id = 3, .parent = 1, .position = {3 + 0.05 * step, 0, 5}, .radius = 0.5});
        const auto again = skinner(document, {.levels = 1}), anew = smooth_skin(document, {.levels = 1});
        expect_same_bytes(again->skin.mesh, anew->skin.mesh);
        same_topology +=
            anew->skin.mesh.vertex_along.size() == along.size() && anew->skin.mesh.vertex_along != along;
        along = anew->skin.mesh.vertex_along;
    }
    EXPECT_GT(same_topology, 0);  // or else this shows nothing
}

TEST(SmoothSkinner, GoesOnAfterAFailure) {
    SmoothSkinner skinner;
    Document document = stick();
    ASSERT_TRUE(skinner(document, {.levels = 1}));
    EXPECT_FALSE(skinner(document, {.levels = 3, .memory = 1000}));
    document.nodes[1].position.x() = 0.01;
    expect_same_bytes(skinner(document, {.levels = 1})->skin.mesh,
                      smooth_skin(document, {.levels = 1})->skin.mesh);
}

}  // namespace
}  // namespace sinew

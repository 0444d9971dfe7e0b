/// The calls: many positions, threads, room, errors.
#include "sinew/subdivide/subdivide.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "subdivide/feature_shapes.h"
#include "subdivide/random_mesh.h"

namespace sinew {
namespace {

/// Everything at once: creases, holes, poles, circles, discs.
QuadMesh mixture() {
    shapes::RandomMesh random(7);
    QuadMesh mesh = random.make(shapes::torus(40, 30), {.hole = 0.02, .crease = 0.1, .corner = 0.01});
    const std::uint32_t shift = std::uint32_t(mesh.vertex_count()), faces = std::uint32_t(mesh.face_count());
    QuadMesh tube = shapes::flat_tube(6, 9);
    mesh = [&] {
        const Features features = mesh.features;
        QuadMesh both = shapes::together(mesh, tube);
        both.features = features;
        return both;
    }();
    for (Circle circle : tube.features.circles) {
        for (MeshEdge& edge : circle.edges) edge = {edge[0] + shift, edge[1] + shift};
        mesh.features.circles.push_back(circle);
    }
    for (Plane plane : tube.features.planes) {
        for (std::uint32_t& face : plane.faces) face += faces;
        mesh.features.planes.push_back(plane);
    }
    for (const std::uint32_t pole : tube.features.poles) mesh.features.poles.push_back(pole + shift);
    mesh.vertex_node.assign(mesh.vertex_count(), 3);
    return mesh;
}

TEST(Subdivide, MakesTheSameBytesOnAnyNumberOfThreads) {
    const QuadMesh mesh = mixture();
    const auto make = [&](std::size_t threads) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
        auto made = Subdivider::build(mesh, {.levels = 3, .limit = true});
        return std::pair(made->mesh(), made->limit_normals());
    };
    const auto one = make(1);
    for (const std::size_t threads : {2u, 4u}) {
        const auto many = make(threads);
        EXPECT_EQ(many.first.positions, one.first.positions);
        EXPECT_EQ(many.first.corners, one.first.corners);
        EXPECT_EQ(many.first.face_offsets, one.first.face_offsets);
        EXPECT_EQ(many.second, one.second);
    }
}

TEST(Subdivider, RefinesManyPositions) {
    QuadMesh mesh = mixture();
    auto subdivider = Subdivider::build(mesh, {.levels = 2});
    ASSERT_TRUE(subdivider);
    for (int i = 0; i < 3; ++i) {
        for (Vec3f& p : mesh.positions) p = 1.5f * p + Vec3f(1, 0.25f * p.x(), 0);
        for (Circle& circle : mesh.features.circles) {
            circle.radius *= 1.25f;
            circle.centre = 1.5f * circle.centre + Vec3f(1, 0, 0);
        }
        for (Plane& plane : mesh.features.planes) plane.point = 1.5f * plane.point;
        ASSERT_TRUE(subdivider->refine(mesh));
        const QuadMesh expected = *subdivide(mesh, {.levels = 2});
        // What is a disc was decided when the tables were built; away from it all is the same.
        for (std::size_t v = 0; v < 1200; ++v)
            EXPECT_EQ(subdivider->mesh().positions[v], expected.positions[v]);
        EXPECT_EQ(subdivider->mesh().features.circles[1].radius, mesh.features.circles[1].radius);
    }
    EXPECT_FALSE(subdivider->refine(std::vector<Vec3f>(3)));
    EXPECT_EQ(subdivider->refine(shapes::cube()).error().kind, ErrorKind::call);
}

TEST(Subdivider, FollowsMovedCircles) {
    QuadMesh tube = shapes::flat_tube(3, 6);
    auto subdivider = Subdivider::build(tube, {.levels = 2});
    for (Vec3f& p : tube.positions) p = 2 * p + Vec3f(5, 0, 0);
    for (Circle& circle : tube.features.circles) {
        circle.radius *= 2;
        circle.centre = 2 * circle.centre + Vec3f(5, 0, 0);
    }
    for (Plane& plane : tube.features.planes) plane.point = 2 * plane.point + Vec3f(5, 0, 0);
    ASSERT_TRUE(subdivider->refine(tube));
    EXPECT_EQ(subdivider->mesh().positions, subdivide(tube, {.levels = 2})->positions);
}

TEST(Subdivider, FollowsMovedPlanes) {
    QuadMesh box = shapes::box();
    auto subdivider = Subdivider::build(box, {.levels = 2});
    const Eigen::Matrix3f turn = Eigen::AngleAxisf(0.3f, Vec3f(1, 2, 3).normalized()).toRotationMatrix();
    for (Vec3f& p : box.positions) p = turn * p + Vec3f(5, 6, 7);
    for (Plane& plane : box.features.planes)
        plane.point = turn * plane.point + Vec3f(5, 6, 7), plane.normal = turn * plane.normal;
    ASSERT_TRUE(subdivider->refine(box));
    EXPECT_EQ(subdivider->mesh().positions, subdivide(box, {.levels = 2})->positions);
    for (const Plane& plane : subdivider->mesh().features.planes)
        for (const std::uint32_t f : plane.faces)
            for (const std::uint32_t v : subdivider->mesh().face(f))
                EXPECT_NEAR((subdivider->mesh().positions[v] - plane.point).dot(plane.normal), 0, 4e-6);
}

TEST(Subdivide, PutsTheRimsOfTheControlMeshOnTheirCircles) {
    const QuadMesh tube = shapes::flat_tube(3, 6);
    QuadMesh worn = tube;  // the rim is not quite where its circle says
    for (const Circle& circle : worn.features.circles)
        for (const MeshEdge& edge : circle.edges) {
            Vec3f& p = worn.positions[edge[0]];
            p.head<2>() *= edge[0] % 2 ? 1.02f : 0.97f;
        }
    const QuadMesh finer = *subdivide(tube, {.levels = 2}), same = *subdivide(worn, {.levels = 2});
    for (std::size_t v = 0; v < finer.vertex_count(); ++v)
        EXPECT_LT((finer.positions[v] - same.positions[v]).norm(), 1e-5f) << v;
}

TEST(Subdivide, NoLevelGivesTheMeshBack) {
    const QuadMesh mesh = mixture();
    const QuadMesh same = *subdivide(mesh, {.levels = 0});
    EXPECT_EQ(same.positions, mesh.positions);
    EXPECT_EQ(same.corners, mesh.corners);
    EXPECT_EQ(same.features.creases.size(), mesh.features.creases.size());
}

TEST(Subdivide, RefusesWhatDoesNotFitBeforeTryingIt) {
    const QuadMesh cube = shapes::cube();
    const Error many = subdivide(cube, {.levels = 15}).error();
    EXPECT_EQ(many.kind, ErrorKind::call);
    EXPECT_THAT(many.message, testing::HasSubstr("6442450944 faces")) << "6 * 4^15";
    const Error large = subdivide(cube, {.levels = 10, .memory = std::uint64_t{1} << 27}).error();
    EXPECT_EQ(large.kind, ErrorKind::call);
    EXPECT_THAT(large.message, testing::HasSubstr("6291456 faces"));
    EXPECT_TRUE(subdivide(cube, {.levels = 6, .memory = std::uint64_t{1} << 27}));
    EXPECT_THAT(subdivide(cube, {.levels = 100}).error().message, testing::HasSubstr("more than"));
    EXPECT_EQ(subdivide(cube, {.levels = -1}).error().kind, ErrorKind::call);
}

TEST(Subdivide, RefusesBadMeshes) {
    const auto message_of = [](const QuadMesh& mesh) {
        const auto made = subdivide(mesh);
        EXPECT_FALSE(made);
        return made ? std::string() : made.error().message;
    };
    QuadMesh mesh = shapes::cube();
    mesh.corners[2] = 99;
    EXPECT_THAT(message_of(mesh), testing::HasSubstr("names vertices"));
    mesh = shapes::cube();
    mesh.positions[3].y() = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT(message_of(mesh), testing::HasSubstr("vertex 3"));
    mesh = shapes::cube();
    mesh.add_face(std::array{1u, 2u});
    EXPECT_THAT(message_of(mesh), testing::HasSubstr("face 6"));
    mesh = shapes::cube();
    mesh.features.creases = {{{0, 7}, 1}};
    EXPECT_THAT(message_of(mesh), testing::HasSubstr("vertices 0 and 7"));
    mesh = shapes::cube();
    mesh.features.corners = {8};
    EXPECT_THAT(message_of(mesh), testing::HasSubstr("corner 8"));
    mesh.features = {.poles = {20}};
    EXPECT_THAT(message_of(mesh), testing::HasSubstr("pole 20"));
    mesh.features = {.circles = {{.edges = {{0, 3}}}}};
    EXPECT_THAT(message_of(mesh), testing::HasSubstr("0 - 3"));
    mesh.features = {.planes = {{.faces = {6}}}};
    EXPECT_THAT(message_of(mesh), testing::HasSubstr("face 6"));
    mesh.features = {};
    mesh.vertex_node = {1, 2};
    EXPECT_THAT(message_of(mesh), testing::HasSubstr("where they came from"));
}

TEST(Subdivide, TakesWhatIsOdd) {
    // Nothing at all, a loose vertex, a lone triangle, a face of 40 corners.
    EXPECT_EQ(subdivide(QuadMesh{})->face_count(), 0u);
    QuadMesh mesh = shapes::cube();
    mesh.positions.emplace_back(9.0f, 9.0f, 9.0f);
    EXPECT_EQ(subdivide(mesh, {.levels = 2, .limit = true})->positions[8], Vec3f(9, 9, 9));
    QuadMesh triangle = shapes::from_faces({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
    EXPECT_EQ(subdivide(triangle, {.levels = 3})->face_count(), 48u);
    QuadMesh plate;
    std::vector<std::uint32_t> corners;
    for (std::uint32_t j = 0; j < 40; ++j) {
        plate.positions.emplace_back(std::cos(j * 0.157f), std::sin(j * 0.157f), 0.0f);
        corners.push_back(j);
    }
    plate.add_face(corners);
    EXPECT_EQ(subdivide(plate, {.levels = 2})->face_count(), 160u);
}

TEST(Subdivide, StopsAndReports) {
    std::atomic<bool> cancel = true;
    EXPECT_EQ(subdivide(shapes::cube(), {.levels = 3}, Progress({}, &cancel)).error().kind,
              ErrorKind::cancelled);
    std::vector<double> shares;
    ASSERT_TRUE(subdivide(shapes::cube(), {.levels = 3},
                          Progress([&](double share, std::string_view) { shares.push_back(share); })));
    EXPECT_TRUE(std::ranges::is_sorted(shares));
    EXPECT_EQ(shares.back(), 1);
}

}  // namespace
}  // namespace sinew

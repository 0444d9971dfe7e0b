// The files of examples/types: each skins, and shows what it is there to show.
#include <filesystem>

#include "sinew/io/skeleton_formats.h"
#include "sinew/mesh/measure.h"
#include "skinning.h"

namespace sinew {
namespace {

using namespace testing_types;

Document drawn(const std::string& name) {
    auto read = read_skeleton(std::string(SINEW_TYPES) + "/" + name + ".sinew");
    if (!read) ADD_FAILURE() << read.error().text();
    return read ? read->document : Document{};
}
QuadMesh control(const std::string& name) { return solid(drawn(name)).mesh; }
QuadMesh fine(const std::string& name) { return smooth(drawn(name)); }

TEST(TypeExamples, AreSolidAndFlatWhereTheySayOnEveryLevel) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(SINEW_TYPES)) files.push_back(entry.path());
    EXPECT_GE(files.size(), 23u);
    for (const auto& file : files) {
        SCOPED_TRACE(file.filename());
        for (int levels = 0; levels <= 2; ++levels) {
            const QuadMesh mesh = levels == 0 ? control(file.stem()) : smooth(drawn(file.stem()), levels);
            const Validation v = validate(mesh);
            EXPECT_TRUE(v.closed() && v.manifold() && v.oriented() && v.finite());
            EXPECT_GT(measure(mesh).volume, 0);
            expect_flat(mesh, 2e-6);  // single precision, some units from the origin
        }
    }
}

TEST(TypeExamples, ConeEndsInItsTip) { EXPECT_TRUE(has_vertex(fine("cone"), {0, 0, 3})); }

TEST(TypeExamples, HemispheresAreDiscs) {
    const QuadMesh mesh = fine("hemisphere");
    ASSERT_EQ(mesh.features.circles.size(), 2u);
    for (const Circle& circle : mesh.features.circles)
        for (const MeshEdge& edge : circle.edges) {
            const Vec3f& p = mesh.positions[edge[0]];
            EXPECT_NEAR(p.head<2>().norm(), circle.radius, 1e-4 * circle.radius);
            EXPECT_NEAR(p.z(), circle.centre.z(), 1e-6);
        }
}

TEST(TypeExamples, CubesKeepTheirCorners) {
    Mat3 turned;
    turned << std::sqrt(0.5), -std::sqrt(0.5), 0, std::sqrt(0.5), std::sqrt(0.5), 0, 0, 0, 1;
    const struct {
        const char* name;
        Vec3 centre, half;
        Mat3 axes;
    } cubes[] = {{"cube_leaf", {0, 0, 2}, {0.5, 0.4, 0.3}, Mat3::Identity()},
                 {"cube_connection", {0, 0, 0}, {0.5, 0.5, 0.3}, turned},
                 {"cube_branch", {0, 0, 0}, {0.5, 0.6, 0.4}, Mat3::Identity()},
                 {"boxes", {0, 0, 0}, {0.6, 0.6, 0.2}, Mat3::Identity()},
                 {"boxes", {0, 0, 0.9}, {0.4, 0.4, 0.25}, Mat3::Identity()},
                 {"boxes", {0, 0, 1.8}, {0.2, 0.2, 0.3}, turned},
                 {"root_without_branches", {2, 0, 0}, {0.5, 0.5, 0.5}, Mat3::Identity()}};
    for (const auto& cube : cubes)
        for (const Vec3& corner : box_corners(cube.centre, cube.axes, cube.half))
            EXPECT_TRUE(has_vertex(fine(cube.name), corner)) << cube.name;
}

TEST(TypeExamples, TubesLeaveCubesAtRightAngles) {
    for (const Circle& circle : control("cube_branch").features.circles)
        EXPECT_NEAR(circle.axis.cwiseAbs().maxCoeff(), 1, 1e-6);
}

TEST(TypeExamples, BallsAreRoundToOnePercent) {
    const auto outside = [](const Vec3& axis, double width) {
        return [=](const Vec3& v) { return v.dot(axis) < 0 || v.cross(axis).norm() > width; };
    };
    EXPECT_LT(farthest_from_ball(fine("ball"), {0, 0, 0}, Vec3::Constant(0.8),
                                 [&](const Vec3& v) {
                                     return v.norm() < 1 && outside(-Vec3::UnitZ(), 0.16)(v) &&
                                            outside(Vec3(1.5, 0, 1).normalized(), 0.21)(v);
                                 }),
              0.01);
    const Vec3 half(0.6, 0.8, 1);
    EXPECT_LT(farthest_from_ball(fine("ellipsoid"), {0, 0, 0}, half, [](const Vec3& v) { return v.x() < 1; }),
              0.01);
    EXPECT_LT(farthest_from_ball(fine("ellipsoid"), {2, 0, 0}, half,
                                 [](const Vec3& v) { return v.x() > -1 && v.z() > -0.9; }),
              0.01);
    const Document limbs = drawn("ball_with_five_limbs");
    EXPECT_LT(farthest_from_ball(smooth(limbs), {0, 0, 0}, Vec3::Ones(),
                                 [&](const Vec3& v) {
                                     bool bare = v.norm() < 1.4;
                                     for (int i = 1; i <= 5; ++i)
                                         bare =
                                             bare && outside(limbs.nodes[i].position.normalized(), 0.25)(v);
                                     return bare;
                                 }),
              0.01);
}

TEST(TypeExamples, DentsHaveTheirRadiusAndDepth) {
    const QuadMesh mesh = fine("negative");
    double bottom = 1;
    for (const Vec3f& p : mesh.positions)
        if (p.y() < 0 && std::hypot(p.x(), p.z()) < 0.02) bottom = std::min<double>(bottom, -p.y());
    EXPECT_NEAR(1 - bottom, 0.4, 0.05 * 0.4);
    int rim = 0;  // its vertices lie on the ball, as far from the axis as the radius says
    for (const Vec3f& p : control("negative").positions)
        rim += p.y() < 0 && std::abs(p.norm() - 1) < 1e-4 &&
               std::abs(std::hypot(p.x(), p.z()) - 0.35) < 0.05 * 0.35;
    EXPECT_EQ(rim, 8);
}

TEST(TypeExamples, BowlIsHollowed) {
    EXPECT_LT(distance_to(control("bowl"), {0, 0, 1.9}), 1e-5);  // 0.6 below the top at 2.5
}

TEST(TypeExamples, BoreIsAHole) {
    const QuadMesh mesh = control("bore");
    const double sides = 4, area = std::sin(2 * M_PI / sides) * sides / 2;  // of a ring of radius 1
    const auto frustum = [&](double a, double b, double height) {
        return area * height * (a * a + a * b + b * b) / 3;
    };
    EXPECT_NEAR(measure(mesh).volume,
                frustum(0.6, 0.8, 2) + frustum(0.8, 0.7, 0.001) - frustum(0.7, 0.5, 1.701), 1e-4);
    int floors = 0;  // the disc inside looks up, as the one below looks down
    for (const Plane& plane : mesh.features.planes)
        floors += std::abs(plane.point.z() - 0.3) < 1e-6 && plane.normal.z() > 0.999;
    EXPECT_EQ(floors, 1);
}

TEST(TypeExamples, SharpThingsAreCreased) {
    EXPECT_GE(control("sharp_edges").features.creases.size(), 12u + 8u);
    bool soft = false, hard = false;
    for (const Crease& crease : control("sharp_joints").features.creases)
        (crease.sharpness < 10 ? soft : hard) = true;
    EXPECT_TRUE(soft && hard);
}

TEST(TypeExamples, PatternsAreExact) {
    for (const char* name : {"mirror_pattern", "eye_socket"})
        for (const bool limit : {false, true}) {
            const QuadMesh mesh = solid(drawn(name), {.fit = limit ? Fit::limit : Fit::control}).mesh;
            for (const Vec3f& p : mesh.positions)
                EXPECT_EQ(distance_to(mesh, Vec3(-p.x(), p.y(), p.z())), 0) << name;
        }
    const QuadMesh wheel = control("radial_pattern");
    const Mat3 turn = Eigen::AngleAxisd(M_PI / 4, Vec3::UnitZ()).toRotationMatrix();
    for (const Vec3f& p : wheel.positions) EXPECT_LT(distance_to(wheel, turn * p.cast<double>()), 1e-6);
}

TEST(TypeExamples, CycleIsATorus) {
    const Skin skin = solid(drawn("cycle"));
    EXPECT_EQ(skin.cycles, 1);
    EXPECT_EQ(irregular(skin.mesh), 0);
}

TEST(TypeExamples, WidthAndHeightAreApart) {
    Eigen::AlignedBox3f low, high;
    for (const Vec3f& p : fine("width_and_height").positions) {
        if (std::abs(p.z()) < 1e-6) low.extend(p);
        if (std::abs(p.z() - 3) < 1e-6) high.extend(p);
    }
    EXPECT_NEAR(low.sizes().x(), 1.6, 0.025 * 1.6);
    EXPECT_NEAR(low.sizes().y(), 0.5, 0.025 * 0.5);
    EXPECT_NEAR(high.sizes().x(), 0.5, 0.025 * 0.5);
    EXPECT_NEAR(high.sizes().y(), 1.6, 0.025 * 1.6);
}

TEST(TypeExamples, FlatSidesRunFromNodeToNode) {
    const QuadMesh mesh = control("flat_sides");
    for (const double y : {-0.5, 0.5}) EXPECT_TRUE(has_vertex(mesh, {0, y, 0.2}));
    // From the first node to the second, where the beam bends up by atan 0.2: its corners are where the
    // planes of its sides meet the bisector of the bend.
    const double lean = std::tan(std::atan(0.2) / 2);
    for (const double y : {-0.5, 0.5})
        for (const double z : {-0.2, 0.2})
            EXPECT_TRUE(has_vertex(mesh, {1 - lean * z, y, z})) << y << " " << z;
    for (const Vec3f& p : mesh.positions) {
        if (p.x() < 1e-6f || p.x() > 1 - lean * p.z() + 1e-6f) continue;
        const bool on_side = std::abs(std::abs(p.y()) - 0.5f) < 1e-6f,
                   on_top = std::abs(std::abs(p.z()) - 0.2f) < 1e-6f;
        EXPECT_TRUE(on_side || on_top) << p.transpose();
    }
}

}  // namespace
}  // namespace sinew

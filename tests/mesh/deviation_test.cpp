#include "sinew/mesh/deviation.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "mesh/shapes.h"
#include "sinew/io/obj.h"

namespace sinew {
namespace {

RoundCones one_cone(const Vec3& a, double a_radius, const Vec3& b, double b_radius) {
    RoundCones cones;
    cones.add(a, a_radius, b, b_radius);
    return cones;
}

double distance(const Vec3f& point, const RoundCones& cones) {
    return signed_distances(std::array{point}, cones).distance[0];
}

TEST(Deviation, BallsAndTubes) {
    const RoundCones ball = one_cone({1, 2, 3}, 2, {1, 2, 3}, 2);
    EXPECT_DOUBLE_EQ(distance({1, 2, 8}, ball), 3);
    EXPECT_DOUBLE_EQ(distance({1, 2, 3}, ball), -2);
    const RoundCones tube = one_cone({0, 0, 0}, 0.5, {0, 0, 4}, 0.5);
    EXPECT_DOUBLE_EQ(distance({2, 0, 1}, tube), 1.5);
    EXPECT_DOUBLE_EQ(distance({0, 0, 6}, tube), 1.5);
    EXPECT_DOUBLE_EQ(distance({0, 3, -4}, tube), 4.5);
    EXPECT_DOUBLE_EQ(distance({0, 0.25f, 2}, tube), -0.25);
}

TEST(Deviation, TheSideOfAConeIsTheTangentOfBothBalls) {
    // Balls of radius 3 and 1 ten apart: the normal of the side leans by asin(2/10) towards the smaller one.
    const RoundCones cone = one_cone({0, 0, 0}, 3, {10, 0, 0}, 1);
    const double sine = 0.2, cosine = std::sqrt(1 - sine * sine);
    const Vec3 normal(sine, cosine, 0);
    for (const double out : {-0.5, 0.0, 2.0})
        for (const double share : {0.0, 0.3, 1.0}) {
            const Vec3 p = Vec3(10 * share, 0, 0) + (3 - 2 * share + out) * normal;
            EXPECT_NEAR(distance(p.cast<float>(), cone), out, 1e-6);
        }
}

TEST(Deviation, ABallInsideTheOtherAddsNothing) {
    const RoundCones nested = one_cone({0, 0, 0}, 5, {1, 0, 0}, 2);
    EXPECT_DOUBLE_EQ(distance({0, 7, 0}, nested), 2);
    EXPECT_DOUBLE_EQ(distance({9, 0, 0}, nested), 4);
}

TEST(Deviation, ATubeTenPercentTooWide) {
    const Deviation wide =
        measure_deviation(shapes::tube(30, 24, 1.1, 10), one_cone({0, 0, -2}, 1, {0, 0, 12}, 1));
    // All vertices are 10 % out but the two poles, which lie on the axis.
    const double n = 30 * 24 + 2;
    EXPECT_EQ(wide.vertices, 30 * 24 + 2);
    EXPECT_NEAR(wide.mean, (0.1 * (n - 2) - 2) / n, 1e-6);
    EXPECT_NEAR(wide.mean_abs, (0.1 * (n - 2) + 2) / n, 1e-6);
    EXPECT_NEAR(wide.p95_abs, 0.1, 1e-6);
    EXPECT_NEAR(wide.max_abs, 1, 1e-6);
    EXPECT_GE(wide.worst, 30u * 24u);
}

TEST(Deviation, RadiusIsThatOfTheClosestConeAtTheFoot) {
    const RoundCones cone = one_cone({0, 0, 0}, 3, {10, 0, 0}, 1);
    const auto radius =
        signed_distances(std::array{Vec3f(5, 1, 0), Vec3f(-9, 0, 0), Vec3f(19, 0, 0)}, cone).radius;
    EXPECT_DOUBLE_EQ(radius[0], 2);
    EXPECT_DOUBLE_EQ(radius[1], 3);
    EXPECT_DOUBLE_EQ(radius[2], 1);
    const RoundCones needle = one_cone({0, 0, 0}, 1, {0, 0, 10}, 0);
    EXPECT_DOUBLE_EQ(signed_distances(std::array{Vec3f(0, 0, 11)}, needle).radius[0], 1e-3);
}

/// A forest of cones of all sizes, some of them nested or of no length.
RoundCones forest(std::size_t count) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> uniform(-1, 1);
    RoundCones cones;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 at = 5 * Vec3(uniform(random), uniform(random), uniform(random));
        const Vec3 step = i % 17 ? Vec3(uniform(random), uniform(random), uniform(random)) : Vec3::Zero();
        cones.add(at, 0.3 * std::abs(uniform(random)), at + step, std::pow(std::abs(uniform(random)), 4));
    }
    return cones;
}

std::vector<Vec3f> cloud(std::size_t count) {
    std::mt19937 random(12);
    std::uniform_real_distribution<float> uniform(-7, 7);
    std::vector<Vec3f> points(count);
    for (Vec3f& p : points) p = {uniform(random), uniform(random), uniform(random)};
    return points;
}

TEST(Deviation, TheHierarchyFindsTheNearestOfAll) {
    const RoundCones cones = forest(300);
    const std::vector<Vec3f> points = cloud(2000);
    const Distances all = signed_distances(points, cones);
    for (std::size_t i = 0; i < points.size(); ++i) {
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t c = 0; c < cones.size(); ++c)
            nearest = std::min(nearest, distance(points[i], {{cones.from[c]}, {cones.cones[c]}}));
        ASSERT_DOUBLE_EQ(all.distance[i], nearest);
    }
}

TEST(Deviation, AgreesWithTheToolOfTheSharedFolder) {
    const char* shared = std::getenv("SINEW_SHARED");
    const std::filesystem::path folder = shared ? shared : SINEW_SOURCE_FOLDER "/../shared";
    const std::filesystem::path tool = folder / "tools/deviation.py";
    if (!std::filesystem::exists(tool)) GTEST_SKIP() << "there is no " << tool;
    const RoundCones cones = forest(150);
    QuadMesh mesh = shapes::torus(40, 50);
    mesh.positions.emplace_back(99.0f, 0.0f, 0.0f);  // of no face: of no interest
    const std::string stem = testing::TempDir() + "sinew_deviation";
    std::ofstream(stem + ".obj") << obj_text(mesh);
    std::ofstream graph(stem + ".graph");
    graph.precision(17);
    auto node = [&](const Vec3& p, double r) {
        graph << "n " << p.x() << ' ' << p.y() << ' ' << p.z() << ' ' << r << '\n';
    };
    for (std::size_t i = 0; i < cones.size(); ++i) {
        const ConeFrom& cone = cones.cones[i];
        node(cones.from[i], cone.near), node(cones.from[i] + cone.length * cone.axis, cone.far);
    }
    for (std::size_t i = 0; i < cones.size(); ++i) graph << "c " << 2 * i << ' ' << 2 * i + 1 << '\n';
    graph.close();
    const std::string command = "/usr/bin/python3 " + tool.string() + " --nocoverage --json " + stem +
                                ".obj " + stem + ".graph > " + stem + ".json";
    if (std::system(command.c_str()) != 0) GTEST_SKIP() << "python3 with numpy is needed to run it";
    const auto told = nlohmann::json::parse(std::ifstream(stem + ".json"))["vertices"];
    const Deviation found = measure_deviation(mesh, cones);
    const double rounding = 0.5001e-4;  // of the tool's output
    EXPECT_NEAR(found.mean, told["mean"], rounding);
    EXPECT_NEAR(found.mean_abs, told["mean_abs"], rounding);
    EXPECT_NEAR(found.p95_abs, told["p95_abs"], rounding);
    EXPECT_NEAR(found.max_abs, told["max_abs"], rounding);
}

TEST(Deviation, NothingToMeasure) { EXPECT_EQ(measure_deviation(QuadMesh{}, forest(3)).vertices, 0); }

}  // namespace
}  // namespace sinew

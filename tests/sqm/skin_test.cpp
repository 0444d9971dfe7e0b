#include "sinew/sqm/skin.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cstring>

#include "sinew/mesh/measure.h"
#include "sinew/mesh/validate.h"
#include "sqm/stages.h"

namespace sinew {
namespace {

using sqm::add;

std::int64_t formula(const Document& document) {
    std::vector<int> degree(document.nodes.size(), 0);
    for (const Bone& bone : bones_of(document)) ++degree[bone[0]], ++degree[bone[1]];
    std::int64_t sum = 0;
    for (const int d : degree) sum += d > 2 ? 2 * (d - 2) : d == 1 ? 1 : 0;
    return sum;
}

TEST(Skin, OfATreeHasAtMostTheFormulasIrregularVertices) {
    property::Random random(28);
    for (int round = 0; round < 20; ++round) {
        const Document tree = sqm::random_tree(random, 1 + round % 5);
        const Skin skin = sinew::skin(tree).value();
        const Validation v = validate(skin.mesh);
        EXPECT_TRUE(v.solid());
        EXPECT_EQ(v.euler, 2);
        EXPECT_EQ(skin.irregular, formula(tree));
        const Measures m = measure(skin.mesh);
        EXPECT_LE(m.irregular_vertices, skin.irregular);
        EXPECT_EQ(m.stray_triangles, 0);
        EXPECT_LE(m.max_valence, 12);
    }
}

TEST(Skin, CountsComponentsAndCycles) {
    Document d = sqm::cube_of_struts();
    add(d, -1, {20, 0, 0}, 1);
    const Skin skin = sinew::skin(d).value();
    EXPECT_EQ(skin.components, 2);
    EXPECT_EQ(skin.cycles, 5);
    const Validation v = validate(skin.mesh);
    EXPECT_EQ(v.components, 2);
    EXPECT_EQ(v.euler, 2 * 2 - 2 * 5);
}

TEST(Skin, OfNothingIsNothing) {
    for (const SkinOptions& options : {SkinOptions{}, SkinOptions{.fit = Fit::limit}}) {
        const auto skin = sinew::skin(Document{}, options);
        ASSERT_TRUE(skin) << skin.error().text();
        EXPECT_EQ(skin->mesh.vertex_count(), 0u);
        EXPECT_EQ(skin->mesh.face_count(), 0u);
    }
}

TEST(Skin, HasEveryStageAsAMesh) {
    const Document d = sqm::star(sqm::fan(5));
    for (const SkinStage stage :
         {SkinStage::polyhedra, SkinStage::refine, SkinStage::bridge, SkinStage::place}) {
        const auto skin = sinew::skin(d, {.stage = stage});
        ASSERT_TRUE(skin);
        const Validation v = validate(skin->mesh);
        EXPECT_TRUE(v.closed());
        EXPECT_TRUE(v.finite());
        EXPECT_EQ(v.euler, 2);
    }
}

TEST(Skin, IsTheSameBytesAgain) {
    const Document d = sqm::cube_of_struts();
    const QuadMesh a = sinew::skin(d).value().mesh, b = sinew::skin(d).value().mesh;
    ASSERT_EQ(a.positions.size(), b.positions.size());
    EXPECT_EQ(std::memcmp(a.positions.data(), b.positions.data(), a.positions.size() * sizeof(Vec3f)), 0);
    EXPECT_EQ(a.corners, b.corners);
}

TEST(Skin, IsTheSameBytesForAnyNumberOfThreads) {
    property::Random random(11);
    const Document tree = sqm::random_tree(random, 8);  // joints and paths for many chunks
    const auto skin_on = [&](int threads) {
        tbb::task_arena arena(threads);
        return arena.execute([&] { return sinew::skin(tree).value().mesh; });
    };
    const QuadMesh alone = skin_on(1);
    ASSERT_GT(alone.vertex_count(), 10'000u);
    for (const int threads : {2, 3, 8}) {
        const QuadMesh mesh = skin_on(threads);
        EXPECT_EQ(alone.positions, mesh.positions) << threads;
        EXPECT_EQ(alone.corners, mesh.corners) << threads;
        EXPECT_EQ(alone.face_offsets, mesh.face_offsets) << threads;
        EXPECT_EQ(alone.vertex_node, mesh.vertex_node) << threads;
        EXPECT_EQ(alone.vertex_bone, mesh.vertex_bone) << threads;
        EXPECT_EQ(alone.vertex_along, mesh.vertex_along) << threads;
    }
}

TEST(Skin, RefusesWhatMakesNoSense) {
    Document d = sqm::star(sqm::fan(3));
    d.nodes[2].radius = 0;
    const auto skin = sinew::skin(d);
    ASSERT_FALSE(skin);
    EXPECT_EQ(skin.error().kind, ErrorKind::input);
    EXPECT_EQ(skin.error().node, d.nodes[2].id);
}

TEST(Skin, TellsOfItsProgressAndStopsOnRequest) {
    double last = -1;
    const Progress listener([&](double share, std::string_view) {
        EXPECT_GE(share, last);
        last = share;
    });
    ASSERT_TRUE(sinew::skin(sqm::star(sqm::fan(4)), {}, listener));
    EXPECT_EQ(last, 1);
    const std::atomic<bool> stop{true};
    const auto skin = sinew::skin(sqm::star(sqm::fan(4)), {}, Progress({}, &stop));
    ASSERT_FALSE(skin);
    EXPECT_EQ(skin.error().kind, ErrorKind::cancelled);
}

TEST(Skin, IsSymmetricRoundOutlinesInTheMirror) {
    for (const bool cube : {true, false}) {
        Document d;
        add(d, -1, {0, 0, 0}, 0.4);
        add(d, 0, {0, 3, 0}, 0.4);
        add(d, 0, {2, -1, 0}, 0.3);
        d.nodes[1].type = cube ? NodeType::cube : NodeType::sphere;
        d.nodes[1].section = cube ? Section::round : Section::rectangular;
        std::vector<Vec3f> places = sinew::skin(sqm::mirrored(d)).value().mesh.positions, images = places;
        for (Vec3f& p : images) p.x() = 0 - p.x();
        const auto less = [](const Vec3f& a, const Vec3f& b) {
            return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
        };
        std::sort(places.begin(), places.end(), less);
        std::sort(images.begin(), images.end(), less);
        EXPECT_EQ(places, images);
    }
}

TEST(Skin, NamesTheDrawnNodeOfAnImage) {
    Document d;
    add(d, -1, {0, 0, 0}, 0.4);
    add(d, 0, {3, 0, 0}, 0.3);
    add(d, 0, {0, 3, 0}, 0.3);
    const Skin skin = sinew::skin(sqm::mirrored(d)).value();
    EXPECT_EQ(*std::max_element(skin.mesh.vertex_node.begin(), skin.mesh.vertex_node.end()), 2);
    EXPECT_EQ(*std::max_element(skin.mesh.vertex_bone.begin(), skin.mesh.vertex_bone.end()), 1);
    EXPECT_EQ(skin.mesh.features.poles.size(), 3u);  // the limb, its image, and the one in the plane
}

}  // namespace
}  // namespace sinew

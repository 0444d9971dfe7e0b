#include "sinew/mesh/intersect.h"

#include <gmock/gmock.h>

#include <atomic>
#include <limits>
#include <random>

#include "mesh/shapes.h"
#include "sinew/mesh/box_tree.h"

namespace sinew {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

std::vector<FacePair> pairs_of(const QuadMesh& mesh) { return find_self_intersections(mesh).value(); }

QuadMesh rotated(QuadMesh mesh) {
    const Eigen::Matrix3f turn = Eigen::AngleAxisf(0.7f, Vec3f(1, 2, -3).normalized()).toRotationMatrix();
    for (Vec3f& p : mesh.positions) p = turn * p;
    return mesh;
}

TEST(Intersect, CleanShapesHaveNone) {
    for (const QuadMesh& mesh :
         {shapes::cube(), shapes::octahedron(), shapes::tube(20, 7), shapes::tube(2, 1000, 1e-3, 100),
          shapes::torus(60, 30), shapes::sphere(30), shapes::grid_cube(20),
          shapes::together(shapes::cube(), shapes::moved(shapes::cube(), {1.0001f, 0, 0}))}) {
        EXPECT_THAT(pairs_of(mesh), IsEmpty());
        EXPECT_THAT(pairs_of(rotated(mesh)), IsEmpty());  // flat sides are no longer quite flat
    }
}

TEST(Intersect, TwoCubesCrossInSixPairsOfFaces) {
    // Each upper side of the first crosses the two lower sides of the second that are not parallel to it.
    const QuadMesh mesh = shapes::together(shapes::cube(), shapes::moved(shapes::cube(), {0.5f, 0.5f, 0.5f}));
    EXPECT_THAT(pairs_of(mesh), ElementsAre(FacePair{1, 8}, FacePair{1, 10}, FacePair{3, 6}, FacePair{3, 10},
                                            FacePair{5, 6}, FacePair{5, 8}));
}

TEST(Intersect, FacesThatTouchAndShareNothingCount) {
    // Side by side: the touching faces with each other (1) and with the other's four neighbours (8);
    // neighbours with those round the corner from them and opposite (4 x 3).
    const QuadMesh mesh = shapes::together(shapes::cube(), shapes::moved(shapes::cube(), {1, 0, 0}));
    EXPECT_THAT(pairs_of(mesh), SizeIs(21));
}

TEST(Intersect, ASpikeThroughTheOppositeWall) {
    QuadMesh mesh = shapes::sphere(8);
    std::uint32_t top = 0;
    for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v)
        if (mesh.positions[v].z() > mesh.positions[top].z()) top = v;
    mesh.positions[top] = {0.03f, 0.02f, -2};
    const std::vector<FacePair> pairs = pairs_of(mesh);
    EXPECT_FALSE(pairs.empty());
    for (const FacePair& pair : pairs) {
        auto at_spike = [&](std::uint32_t f) {
            return std::ranges::find(mesh.face(f), top) != mesh.face(f).end();
        };
        EXPECT_NE(at_spike(pair[0]), at_spike(pair[1]));
    }
}

TEST(Intersect, TheHierarchyFindsWhatAllPairsHold) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> uniform(-1, 1);
    QuadMesh soup;
    for (int f = 0; f < 90; ++f) {
        const Vec3f centre(uniform(random), uniform(random), uniform(random));
        for (int i = 0; i < 4; ++i)
            soup.positions.push_back(centre +
                                     0.4f * Vec3f(uniform(random), uniform(random), uniform(random)));
        const std::uint32_t v = shapes::index_of(4 * f);
        soup.add_face(std::array{v, v + 1, v + 2, v + 3});
    }
    std::vector<FacePair> expected;
    for (std::uint32_t f = 0; f < 90; ++f)
        for (std::uint32_t g = f + 1; g < 90; ++g) {
            QuadMesh two;
            two.positions = soup.positions;
            two.add_face(soup.face(f));
            two.add_face(soup.face(g));
            if (!pairs_of(two).empty()) expected.push_back({f, g});
        }
    EXPECT_GT(expected.size(), 50u);
    EXPECT_EQ(pairs_of(soup), expected);
}

TEST(Intersect, NeitherScaleNorMirrorNorAxesChangeThePairs) {
    const QuadMesh mesh =
        shapes::together(shapes::tube(9, 8), shapes::moved(rotated(shapes::torus(12, 9)), {1, 2, 0.5f}));
    const std::vector<FacePair> pairs = pairs_of(mesh);
    EXPECT_FALSE(pairs.empty());
    QuadMesh other = mesh;
    for (Vec3f& p : other.positions) p = 0x1p-40f * Vec3f(p.z(), -p.x(), p.y());
    EXPECT_EQ(pairs_of(other), pairs);
}

TEST(Intersect, FacesOfNoAreaAndBrokenVerticesAreLeftOut) {
    QuadMesh mesh = shapes::cube();
    mesh.add_face(std::array{0u, 7u, 7u});
    mesh.positions.emplace_back(0.5f, 0.5f, std::numeric_limits<float>::quiet_NaN());
    mesh.add_face(std::array{0u, 7u, 8u});
    mesh.add_face(std::array{0u, 7u});
    EXPECT_THAT(pairs_of(mesh), IsEmpty());
    EXPECT_THAT(pairs_of(QuadMesh{}), IsEmpty());
}

/// The same triangle many times over, in an order in which all meet all.
QuadMesh pile(int count) {
    QuadMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    for (int i = 0; i < count; ++i) mesh.add_face(std::array{0u, 1u, 2u});
    return mesh;
}

TEST(Intersect, BoundsAreNoneForWhatIsNoPile) {
    const QuadMesh mesh =
        shapes::together(shapes::tube(40, 60), shapes::moved(shapes::torus(40, 60), {1, 2, 0.5f}));
    const SelfIntersections found = find_self_intersections_within_bounds(mesh).value();
    EXPECT_TRUE(found.complete);
    EXPECT_EQ(found.pairs, pairs_of(mesh));
    EXPECT_EQ(find_self_intersections_within_bounds(pile(1000))->pairs.size(), 1000u * 999 / 2);
}

TEST(Intersect, APileIsGivenUpInTime) {
    const int count = 5000;
    const SelfIntersections found = find_self_intersections_within_bounds(pile(count)).value();
    EXPECT_FALSE(found.complete);
    EXPECT_FALSE(found.pairs.empty());
    EXPECT_LE(found.pairs.size(), most_pairs_tested + most_pairs_tested_a_face * count);
    EXPECT_EQ(find_self_intersections_within_bounds(pile(count))->pairs, found.pairs)
        << "whichever thread comes first";
}

TEST(Intersect, StopsOnRequest) {
    const std::atomic<bool> cancel = true;
    const auto pairs = find_self_intersections(shapes::cube(), Progress({}, &cancel));
    ASSERT_FALSE(pairs);
    EXPECT_EQ(pairs.error().kind, ErrorKind::cancelled);
}

TEST(BoxTree, HoldsEveryFiniteBoxOnce) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> uniform(0, 1);
    for (const std::size_t count : {0u, 1u, 4u, 5u, 1000u}) {
        std::vector<Box> boxes(count + 1);  // the last one is empty: no tree holds it
        for (std::size_t i = 0; i < count; ++i) boxes[i].extend(Vec3f(uniform(random), uniform(random), 0));
        const BoxTree tree = build_box_tree(boxes);
        std::vector<std::uint32_t> items = tree.items;
        std::sort(items.begin(), items.end());
        ASSERT_EQ(items.size(), count);
        for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(items[i], i);
    }
}

TEST(BoxTree, FindsEveryPairOfOverlappingBoxesOnce) {
    std::mt19937 random(6);
    std::uniform_real_distribution<float> uniform(0, 1);
    std::vector<Box> boxes(300);
    for (Box& box : boxes) {
        const Vec3f corner(uniform(random), uniform(random), uniform(random));
        box.extend(corner);
        box.extend(Vec3f(corner + 0.2f * Vec3f(uniform(random), uniform(random), uniform(random))));
    }
    const BoxTree tree = build_box_tree(boxes);
    std::vector<FacePair> expected, found;
    for (std::uint32_t a = 0; a < boxes.size(); ++a)
        for (std::uint32_t b = a + 1; b < boxes.size(); ++b)
            if (boxes[a].overlaps(boxes[b])) expected.push_back({a, b});
    for (const std::size_t enough : {1u, 50u, 1000000u}) {
        found.clear();
        for (const BoxTreePair& part : split_overlaps(tree, enough))
            for_each_overlap(tree, part, [&](std::size_t a, std::size_t b) {
                const auto [low, high] = std::minmax({tree.items[a], tree.items[b]});
                found.push_back({low, high});
            });
        std::sort(found.begin(), found.end());
        EXPECT_EQ(found, expected);
    }
}

}  // namespace
}  // namespace sinew

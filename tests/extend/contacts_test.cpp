#include "sinew/extend/contacts.h"

#include "skinning.h"

#include "sinew/mesh/intersect.h"
#include "sinew/mesh/measure.h"

namespace sinew {
namespace {

using namespace testing_types;

Node& cube(Document& d, std::int32_t parent, const Vec3& at, const Vec3& size) {
    Node& node = add(d, parent, at, 0.5 * size.minCoeff(), NodeType::cube);
    node.size = size;
    return node;
}

/// One solid of that volume without faces inside, as drawn and subdivided.
void expect_solid(const Document& d, double volume) {
    for (const QuadMesh& mesh : {solid(d).mesh, smooth(d, 2)}) {
        const Measures m = measure(mesh);
        EXPECT_NEAR(m.volume, volume, 1e-5 * volume);
        EXPECT_EQ(m.folded_quads.count, 0u);
        EXPECT_TRUE(find_self_intersections(mesh)->empty());
    }
}

TEST(Contacts, EqualCubesThatTouchAreOneBeam) {
    Document d;
    cube(d, -1, {0, 0, 0}, {1, 1, 1});
    cube(d, 0, {1, 0, 0}, {1, 1, 1});
    expect_solid(d, 2);
    cube(d, 1, {2, 0, 0}, {1, 1, 1});
    expect_solid(d, 3);
}

TEST(Contacts, DoNotDependOnTheOrderOfTheFile) {
    double volume[2];
    for (const bool reversed : {false, true}) {
        Document d;  // a tube, and two cubes that a path runs through
        add(d, -1, {0, 0, -3}, 0.2);
        const int near = reversed ? 2 : 1;
        for (int i = 1; i <= 2; ++i) cube(d, i == near ? 0 : near, {0, 0, i == near ? 0.0 : 1.0}, {1, 1, 1});
        volume[reversed] = measure(solid(d).mesh).volume;
    }
    EXPECT_GT(volume[0], 2);
    EXPECT_NEAR(volume[0], volume[1], 1e-6);
}

TEST(Contacts, CubesRoundACubeAreOneSolid) {
    Document d;
    cube(d, -1, {0, 0, 0}, {1, 1, 1});
    for (const Vec3& way : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
        cube(d, 0, way, {1, 1, 1});
    expect_solid(d, 5);
}

TEST(Contacts, CubesThatOverlapFaceToFaceCountOnce) {
    Document d;
    cube(d, -1, {0, 0, 0}, {1, 1, 1});
    cube(d, 0, {0, 0, 0.75}, {1, 1, 1});
    cube(d, 1, {0, 0, 1.5}, {1, 1, 1});
    expect_solid(d, 2.5);
    Document thin;
    cube(thin, -1, {0, 0, 0}, {1, 1, 1});
    cube(thin, 0, {0, 0, 0.75}, {0.5, 0.5, 1});
    expect_solid(thin, 1 + 0.25 * 0.75);
}

TEST(Contacts, OfDifferentSizesMakeAStep) {
    for (const double first : {1.0, 0.5}) {
        Document d;
        const double second = 1.5 - first;
        cube(d, -1, {0, 0, 0}, {first, first, first});
        cube(d, 0, {0, 0, 0.5 * (first + second)}, {second, second, second});
        expect_solid(d, 1.125);
        cube(d, 1, {0, 0, 0.5 * first + second + 0.125}, {0.25, 0.25, 0.25});  // up once more
        expect_solid(d, 1.125 + 1.0 / 64);
        cube(d, 2, {0, 0, 0.5 * first + second + 0.75}, {0.75, 0.75, 1});  // and out
        expect_solid(d, 1.125 + 1.0 / 64 + 0.5625);
    }
}

TEST(Contacts, CubesApartAreJoinedByATube) {
    Document d;
    cube(d, -1, {0, 0, 0}, {1, 1, 1});
    cube(d, 0, {2, 0, 0}, {1, 1, 1});
    EXPECT_GT(measure(solid(d).mesh).volume, 2.1);
}

}  // namespace
}  // namespace sinew

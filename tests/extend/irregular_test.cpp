// The vertices that are not regular, as a formula for each type.
#include <random>

#include "skinning.h"

namespace sinew {
namespace {

using namespace testing_types;

/// Vertices of a valence other than 4, and poles of any.
std::int64_t special(const QuadMesh& mesh) {
    std::vector<int> valence(mesh.vertex_count(), 0);
    for (const std::uint32_t v : mesh.corners) ++valence[v];
    for (const std::uint32_t pole : mesh.features.poles) valence[pole] = 0;
    return std::count_if(valence.begin(), valence.end(), [](int n) { return n != 4; });
}

class Sizes {
  public:
    explicit Sizes(unsigned seed) : engine_(seed) {}
    double operator()(double low, double high) { return low + (high - low) * (engine_() / 4294967296.0); }

  private:
    std::mt19937 engine_;
};

class IrregularVertices : public ::testing::TestWithParam<unsigned> {
  protected:
    Sizes size{GetParam()};
    /// A stick of random thickness whose far end is of a type.
    Document stick(NodeType type) {
        Document d;
        add(d, -1, {0, 0, 0}, size(0.1, 0.5));
        add(d, 0, {size(-1, 1), size(-1, 1), size(2, 4)}, size(0.1, 0.5), type);
        return d;
    }
};

TEST_P(IrregularVertices, AreThePoleOfALeaf) {
    for (const NodeType type : {NodeType::sphere, NodeType::cone, NodeType::hemisphere, NodeType::cube})
        EXPECT_EQ(special(solid(stick(type)).mesh), 2);
}

TEST_P(IrregularVertices, AreNoneOfACubeOnABone) {
    Document d = stick(NodeType::cube);
    d.nodes[1].size = Vec3(size(0.5, 1), size(0.5, 1), size(0.5, 1));
    add(d, 1, 2 * d.nodes[1].position, size(0.1, 0.5));
    EXPECT_EQ(special(solid(d).mesh), 2);
}

TEST_P(IrregularVertices, AreTheCornersOfACubeAtABranchAndTheMiddlesOfItsFreeFaces) {
    for (int bones = 3; bones <= 6; ++bones) {
        Document d;
        add(d, -1, {0, 0, 0}, size(0.1, 0.3), NodeType::cube).size =
            Vec3(size(0.8, 2), size(0.8, 2), size(0.8, 2));
        const Vec3 axes[] = {Vec3::UnitX(), -Vec3::UnitX(), Vec3::UnitY(),
                             Vec3::UnitZ(), -Vec3::UnitY(), -Vec3::UnitZ()};
        for (int i = 0; i < bones; ++i) add(d, 0, size(3, 4) * axes[i], size(0.1, 0.3));
        EXPECT_EQ(special(solid(d).mesh), 8 + (6 - bones) + bones);
    }
}

TEST_P(IrregularVertices, AreTheCornersOfABoxOrBallAlone) {
    for (const NodeType type : {NodeType::cube, NodeType::ball, NodeType::sphere}) {
        Document d;
        add(d, -1, {0, 0, 0}, size(0.1, 2), type);
        EXPECT_EQ(special(solid(d).mesh), 8);
    }
}

/// A ball has bones or bare surface towards each of six sides, so 2 (6 - 2) and a pole for each side without
/// a bone.
TEST_P(IrregularVertices, AreAsManyForABallAsForSixBones) {
    for (int bones = 1; bones <= 6; ++bones) {
        Document d;
        add(d, -1, {0, 0, 0}, size(0.8, 1.5), NodeType::ball);
        const Vec3 axes[] = {Vec3::UnitX(), -Vec3::UnitX(), Vec3::UnitY(),
                             Vec3::UnitZ(), -Vec3::UnitY(), -Vec3::UnitZ()};
        for (int i = 0; i < bones; ++i) add(d, 0, size(3, 4) * axes[i], size(0.1, 0.3));
        EXPECT_EQ(special(solid(d).mesh), 8 + (6 - bones) + bones);
    }
}

/// A dent is a bone of its parent like any other, with a pole at its bottom.
TEST_P(IrregularVertices, OfADentAreThoseOfABone) {
    Document d;
    const double radius = size(0.8, 1.5);
    add(d, -1, {0, 0, 0}, radius, NodeType::ball);
    add(d, 0, {0, 0, radius * size(1.2, 1.6)}, size(0.2, 0.4) * radius, NodeType::negative);
    EXPECT_EQ(special(solid(d).mesh), 8 + 6);
}

/// At the end of a limb the dent, the limb and the bare sides are the bones of a joint: 2 for each but two of
/// them, and a pole for each but the limb, whose other end has one.
TEST_P(IrregularVertices, OfADentInALimbAreThoseOfAJointWithBareSides) {
    Document d;
    const double radius = size(0.8, 1.2);
    add(d, -1, {0, 0, 0}, size(0.5, 1) * radius);
    add(d, 0, {0, 0, 4}, radius);
    add(d, 1, {0, 0, 4 + radius * size(1.2, 1.6)}, size(0.2, 0.4) * radius, NodeType::negative);
    constexpr int bare = 4, bones = bare + 2;
    EXPECT_EQ(special(solid(d).mesh), 2 * (bones - 2) + bones);
}

INSTANTIATE_TEST_SUITE_P(RandomSizes, IrregularVertices, ::testing::Range(1u, 11u));

}  // namespace
}  // namespace sinew

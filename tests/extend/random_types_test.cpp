// Random types, sections, scales, rolls and joints on random skeletons: closed, whatever they are.
#include <random>

#include "sinew/skeleton/validate.h"
#include "skinning.h"

namespace sinew {
namespace {

using namespace testing_types;

class RandomDocument {
  public:
    explicit RandomDocument(unsigned seed) : random_(seed) {}

    Document make() {
        Document d;
        const int count = 1 + below(14);
        std::vector<int> children(count, 0);
        for (int i = 0; i < count; ++i) {
            const int parent = i == 0 || below(20) == 0 ? -1 : below(i);
            Vec3 at(between(-4, 4), between(-4, 4), between(-4, 4));
            if (parent >= 0 && below(15) == 0) at = d.nodes[parent].position;
            if (below(4) == 0) at = at.array().round();
            add(d, parent, at, between(0.05, 1));
            if (parent >= 0) ++children[parent];
        }
        for (int i = 0; i < count; ++i)
            dress(d.nodes[i], children[i] + (d.nodes[i].parent >= 0 ? 1 : 0) == 1);
        if (below(5) == 0) d.symmetry = {Symmetry::Kind::mirror, below(3), 1};
        if (below(6) == 0) d.symmetry = {Symmetry::Kind::radial, below(3), 2 + below(5)};
        return d;
    }

  private:
    int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
    double between(double low, double high) { return low + (high - low) * (random_() / 4294967296.0); }

    void dress(Node& n, bool leaf) {
        constexpr NodeType anywhere[] = {NodeType::sphere, NodeType::sphere, NodeType::cube, NodeType::ball};
        constexpr NodeType at_leaves[] = {NodeType::cone, NodeType::hemisphere, NodeType::negative};
        n.type = leaf && below(2) ? at_leaves[below(3)] : anywhere[below(4)];
        if (below(3) == 0) n.section = Section::rectangular;
        if (below(3) == 0) n.scale = {between(0.3, 2.5), between(0.3, 2.5), between(0.3, 2.5)};
        if (below(2) == 0) n.roll = between(-180, 180);
        if (below(3) == 0) n.joint = below(2) ? infinitely_sharp : between(0.1, 3);
        if (n.type == NodeType::cube && below(2))
            n.size = Vec3(between(0.1, 2), between(0.1, 2), between(0.1, 2));
        if ((n.type == NodeType::cube || n.type == NodeType::ball) && below(2))
            n.rotation = Quat(between(-1, 1), between(-1, 1), between(-1, 1), between(0.1, 1)).normalized();
    }

    std::mt19937 random_;
};

TEST(RandomTypes, AreClosedWithTheRightEulerNumber) {
    const char* given = std::getenv("SINEW_PROPERTY_CASES");
    const unsigned cases = given ? static_cast<unsigned>(std::atoi(given)) / 5 : 3000;
    unsigned seen = 0;
    for (unsigned seed = 0; seed < cases && !::testing::Test::HasFailure(); ++seed) {
        SCOPED_TRACE(seed);
        const Document document = RandomDocument(seed).make();
        if (!validate(document)) continue;  // a dent on a dent
        ++seen;
        const Skin skin = solid(document, {.sides = seed % 7 == 0 ? 6 : 0});
        const auto is_pole = [&](std::uint32_t v) {
            return std::find(skin.mesh.features.poles.begin(), skin.mesh.features.poles.end(), v) !=
                   skin.mesh.features.poles.end();
        };
        for (std::size_t f = 0; f < skin.mesh.face_count(); ++f) {
            const auto face = skin.mesh.face(f);
            EXPECT_TRUE(face.size() == 4 ||
                        (face.size() == 3 && std::any_of(face.begin(), face.end(), is_pole)));
        }
        EXPECT_LE(irregular(skin.mesh), skin.irregular);
    }
    EXPECT_GE(seen, cases / 2);
}

TEST(RandomTypes, CanBeFittedAndSubdivided) {
    unsigned seen = 0;
    for (unsigned seed = 0; seed < 100 && !::testing::Test::HasFailure(); ++seed) {
        SCOPED_TRACE(seed);
        const Document document = RandomDocument(seed).make();
        if (!validate(document)) continue;
        ++seen;
        const Validation v = validate(smooth(document, 1));
        EXPECT_TRUE(v.closed() && v.manifold() && v.finite());
    }
    EXPECT_GE(seen, 50u);
}

}  // namespace
}  // namespace sinew

#include <map>

#include "sinew/extend/extend.h"
#include "sinew/skeleton/symmetry.h"
#include "skinning.h"

namespace sinew {
namespace {

using namespace testing_types;

/// A spoke of every type: each arm of a wheel.
Document wheel(Symmetry symmetry) {
    Document d;
    d.symmetry = symmetry;
    add(d, -1, {0, 0, 0}, 0.3);
    add(d, 0, {1.5, 0.2, 0}, 0.2).joint = 3;
    add(d, 1, {3, 0.2, 0.4}, 0.2, NodeType::cube).size = Vec3(0.5, 0.6, 0.7);
    add(d, 2, {4, 0.2, 0.8}, 0.2, NodeType::ball);
    add(d, 3, {5, 0.3, 0.8}, 0.1, NodeType::hemisphere).section = Section::rectangular;
    add(d, 3, {4, 0.3, 1.4}, 0.1, NodeType::negative);
    return d;
}

/// The image of every vertex is a vertex, and faces go with them.
void expect_symmetric(const QuadMesh& mesh, const Mat3& generator, double tolerance) {
    std::vector<Vec3f> sorted = mesh.positions;
    const auto less = [](const Vec3f& a, const Vec3f& b) {
        return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
    };
    std::sort(sorted.begin(), sorted.end(), less);
    for (const Vec3f& p : mesh.positions) {
        const Vec3f image = (generator * p.cast<double>()).cast<float>();
        float nearest = 1e9f;
        if (tolerance == 0) {
            EXPECT_TRUE(std::binary_search(sorted.begin(), sorted.end(), Vec3f(image + Vec3f::Zero()), less))
                << image.transpose();
            continue;
        }
        for (const Vec3f& q : sorted) nearest = std::min(nearest, (q - image).norm());
        EXPECT_LE(nearest, tolerance);
    }
}

TEST(CarrySymmetry, MirrorsEveryTypeExactly) {
    const Document d = wheel({Symmetry::Kind::mirror, 0, 1});
    Mat3 mirror = Mat3::Identity();
    mirror(0, 0) = -1;
    expect_symmetric(solid(d).mesh, mirror, 0);
}

TEST(CarrySymmetry, TurnsEveryTypeExactly) {
    for (const int count : {3, 5, 8}) {
        const Document d = wheel({Symmetry::Kind::radial, 2, count});
        const Skin skin = solid(d);
        expect_symmetric(skin.mesh, symmetry_transform(d.symmetry, 1), 2e-6);
        std::map<std::int32_t, int> of_node;  // images are named after the drawn node
        for (const std::int32_t node : skin.mesh.vertex_node) ++of_node[node];
        EXPECT_LT(of_node.rbegin()->first, std::int32_t(d.nodes.size()));
        EXPECT_EQ(of_node[4] % count, 0);
    }
}

}  // namespace
}  // namespace sinew

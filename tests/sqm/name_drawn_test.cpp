#include "sinew/sqm/name_drawn.h"

#include <cmath>

#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

/// A spine in the mirror x = 0, a limb beside it, and a foot beside that.
Document half() {
    Document d;
    add(d, -1, {0, 0, 0}, 0.4);
    add(d, 0, {0, 4, 0}, 0.4);
    add(d, 0, {3, 0, 0}, 0.3);
    add(d, 2, {6, -1, 0}, 0.2);
    d.links = {{3, 1}};
    return mirrored(d);
}

TEST(NameDrawn, NamesTheNodesAndBonesThatTheirImagesAreDrawnAs) {
    const Document drawn = half();
    const ExpandedSymmetry expanded = expand_symmetry(drawn);
    const std::vector<Bone> bones = bones_of(drawn), all = bones_of(expanded.document);
    ASSERT_GT(all.size(), bones.size());
    // A vertex for each expanded node, and one for each expanded bone.
    QuadMesh mesh;
    for (std::size_t i = 0; i < expanded.document.nodes.size(); ++i)
        mesh.vertex_node.push_back(std::int32_t(i));
    for (std::size_t i = 0; i < all.size(); ++i) mesh.vertex_bone.push_back(std::int32_t(i));
    name_drawn(drawn, expanded, mesh);
    for (std::size_t i = 0; i < mesh.vertex_node.size(); ++i) {
        const Vec3 &at = expanded.document.nodes[i].position, &of = drawn.nodes[mesh.vertex_node[i]].position;
        EXPECT_TRUE(Vec3(std::abs(at.x()), at.y(), at.z()).isApprox(of, 1e-9));
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
        ASSERT_GE(mesh.vertex_bone[i], 0);
        const Bone& named = bones[mesh.vertex_bone[i]];
        EXPECT_EQ(std::minmax(mesh.vertex_node[all[i][0]], mesh.vertex_node[all[i][1]]),
                  std::minmax(named[0], named[1]));
    }
}

TEST(NameDrawn, LeavesVerticesOfNoNodeOrBone) {
    const Document drawn = half();
    QuadMesh mesh;
    mesh.vertex_node = mesh.vertex_bone = {-1};
    name_drawn(drawn, expand_symmetry(drawn), mesh);
    EXPECT_EQ(mesh.vertex_node, std::vector<std::int32_t>{-1});
    EXPECT_EQ(mesh.vertex_bone, std::vector<std::int32_t>{-1});
}

}  // namespace
}  // namespace sinew::sqm

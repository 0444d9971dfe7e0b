#include "live/pipeline.h"

#include <gtest/gtest.h>

#include "document/edits.h"
#include "sinew/sqm/skin.h"
#include "sinew/subdivide/subdivide.h"

namespace sinew::modeler {
namespace {

/// A limb with two branches.
Document body_with_limbs() {
    Document document;
    for (const auto& [parent, place] : {std::pair{-1, Vec3(0, 0, 0)},
                                        {0, Vec3(0, 0, 2)},
                                        {1, Vec3(1, 0, 4)},
                                        {1, Vec3(-1, 0.5, 4)},
                                        {2, Vec3(2, 0, 6)}})
        append_node(document, {.id = -1, .parent = parent, .position = place, .radius = 0.3});
    return document;
}

void expect_same_mesh(const QuadMesh& a, const QuadMesh& b) {
    EXPECT_EQ(a.positions, b.positions);
    EXPECT_EQ(a.corners, b.corners);
    EXPECT_EQ(a.face_offsets, b.face_offsets);
    EXPECT_EQ(a.features.poles, b.features.poles);
}

/// What the command line makes of the same document.
QuadMesh skinned(const Document& document, int level) {
    QuadMesh mesh = skin(document, {.fit = level > 0 ? Fit::limit : Fit::control})->mesh;
    return level == 0 ? mesh : *subdivide(mesh, {.levels = level, .limit = true});
}

TEST(Pipeline, makes_what_skin_and_subdivide_make) {
    Pipeline pipeline;
    for (const int level : {0, 1, 2, 1}) {
        const LiveMesh made = pipeline.run(body_with_limbs(), {.level = level});
        ASSERT_TRUE(made.mesh) << made.error->text();
        expect_same_mesh(*made.mesh, skinned(body_with_limbs(), level));
    }
}

TEST(Pipeline, what_it_remembers_changes_no_byte) {
    // Small steps keep the topology, large ones do not, and a node more never does.
    Pipeline pipeline;
    Document document = body_with_limbs();
    for (int step = 0; step < 12; ++step) {
        const double by = step % 3 == 2 ? 1.5 : 0.01;
        document = translate(document, std::vector<std::int32_t>{2}, Vec3(0, by, 0));
        if (step == 7) document = add_children(document, std::vector<std::int32_t>{3}).document;
        if (step == 8) document = translate(document, std::vector<std::int32_t>{5}, Vec3(0, 0, 2));
        const LiveMesh made = pipeline.run(document, {.level = 1});
        ASSERT_TRUE(made.mesh) << step << ": " << made.error->text();
        expect_same_mesh(*made.mesh, skinned(document, 1));
    }
}

TEST(Pipeline, creases_and_circles_move_with_their_nodes) {
    Pipeline pipeline;
    Document document = body_with_limbs();
    document.nodes[4].type = NodeType::hemisphere;
    document.nodes[3].type = NodeType::cube;
    for (int step = 0; step < 3; ++step) {
        document = translate(document, std::vector<std::int32_t>{3, 4}, Vec3(0.02, 0, 0.01));
        const LiveMesh made = pipeline.run(document, {.level = 2});
        ASSERT_TRUE(made.mesh) << made.error->text();
        expect_same_mesh(*made.mesh, skinned(document, 2));
    }
}

TEST(Pipeline, buffers_are_those_of_the_mesh) {
    const LiveMesh made = Pipeline().run(body_with_limbs(), {.level = 1});
    ASSERT_TRUE(made.buffers);
    EXPECT_EQ(made.buffers->vertices.size(), made.mesh->corners.size());
    EXPECT_FALSE(made.validation || made.measures);
    EXPECT_FALSE(Pipeline().run(body_with_limbs(), {.level = 1}, {}, false).buffers);
}

TEST(Pipeline, says_what_is_wrong) {
    Document document = body_with_limbs();
    document.nodes[1].type = NodeType::cone;
    const LiveMesh made = Pipeline().run(document, {});
    ASSERT_TRUE(made.error);
    EXPECT_EQ(made.error->node, 1);
    EXPECT_FALSE(made.mesh || made.buffers);
}

TEST(Pipeline, stops_on_request) {
    const std::atomic<bool> stop{true};
    const LiveMesh made = Pipeline().run(body_with_limbs(), {}, Progress({}, &stop));
    ASSERT_TRUE(made.error);
    EXPECT_EQ(made.error->kind, ErrorKind::cancelled);
}

TEST(Pipeline, figures_are_those_of_the_surface) {
    Document document = body_with_limbs();
    LiveMesh made = Pipeline().run(document, {.level = 1});
    measure(made);
    EXPECT_TRUE(made.validation->solid());
    EXPECT_EQ(made.components, 1);
    EXPECT_EQ(made.cycles, 0);
    EXPECT_LE(made.measures->irregular_vertices, made.irregular_at_most);
    document.links = {{3, 4}};
    made = Pipeline().run(document, {.level = 1});
    measure(made);
    EXPECT_EQ(made.cycles, 1);
    EXPECT_EQ(made.validation->euler, 0);
}

}  // namespace
}  // namespace sinew::modeler

#include "document/operation.h"

#include <gmock/gmock.h>

#include "document/delta.h"
#include "document/edits.h"
#include "sinew/skeleton/graph.h"
#include "sinew/skeleton/validate.h"

namespace sinew::modeler {
namespace {

/// A trunk with two tips that nearly touch.
Document fork() {
    Document document;
    document.nodes.push_back({.id = 10, .radius = 0.5});
    document.nodes.push_back({.id = 11, .parent = 0, .position = Vec3(0, 0, 2), .radius = 0.5});
    document.nodes.push_back({.id = 12, .parent = 1, .position = Vec3(0.3, 0, 4), .radius = 0.2});
    document.nodes.push_back({.id = 13, .parent = 1, .position = Vec3(-0.1, 0, 4), .radius = 0.2});
    return document;
}

Document outcome(const Operation& operation) {
    const auto document = operation.run(values_of(operation));
    EXPECT_TRUE(document) << document.error().text();
    if (!document) return {};
    EXPECT_TRUE(validate(*document));
    return *document;
}

TEST(Operation, consolidating_means_the_selected_leaves) {
    EXPECT_EQ(outcome(consolidating(fork(), selection_of(2))).nodes.size(), 5u);
}

TEST(Operation, consolidating_means_all_leaves_where_none_is_selected) {
    EXPECT_EQ(outcome(consolidating(fork(), {})).nodes.size(), 7u);
    EXPECT_EQ(outcome(consolidating(fork(), selection_of(1))).nodes.size(), 7u);
}

TEST(Operation, merging_makes_one_node_of_all_that_is_selected) {
    const Document merged = outcome(merging(fork(), selection_of(std::vector<std::int32_t>{3, 2})));
    ASSERT_EQ(merged.nodes.size(), 3u);
    EXPECT_LT((merged.nodes[2].position - Vec3(0.1, 0, 4)).norm(), 1e-12);
}

TEST(Operation, tips_closer_than_their_thickness_merge_without_a_selection) {
    EXPECT_EQ(outcome(merging_close_leaves(fork())).nodes.size(), 3u);
    Document apart = fork();
    apart.nodes[2].position.x() = 3;
    EXPECT_TRUE(same(outcome(merging_close_leaves(apart)), apart));
}

TEST(Operation, a_new_root_keeps_all_bones) {
    const Document turned = outcome(rerooting(fork(), 2));
    EXPECT_EQ(turned.nodes[2].parent, -1);
    EXPECT_EQ(bones_of(turned).size(), 3u);
    EXPECT_TRUE(same(outcome(rerooting(fork(), 0)), fork()));
}

TEST(Operation, copies_are_nodes_of_their_own) {
    Document mirrored = fork();
    mirrored.symmetry = {Symmetry::Kind::mirror, 0, 1};
    const Document real = outcome(making_symmetry_real(mirrored));
    EXPECT_EQ(real.symmetry.kind, Symmetry::Kind::none);
    EXPECT_EQ(real.nodes.size(), 6u);
    EXPECT_TRUE(same(outcome(mirroring(mirrored)), real));
    EXPECT_EQ(outcome(copying_round(fork())).nodes.size(), 2 + 6 * 2u);
}

TEST(Operation, snapping_moves_what_is_selected) {
    Document crooked = fork();
    crooked.nodes[1].position = Vec3(0.02, 0.01, 1.97);
    const Document snapped = outcome(snapping_to_grid(crooked, selection_of(1)));
    EXPECT_EQ(snapped.nodes[1].position, Vec3(0, 0, 2));
    EXPECT_EQ(snapped.nodes[2].position, crooked.nodes[2].position);
    const Document upright = outcome(snapping_to_angles(crooked, selection_of(1)));
    EXPECT_LT(upright.nodes[1].position.head<2>().norm(), 1e-12);
    EXPECT_NEAR(upright.nodes[1].position.z(), crooked.nodes[1].position.norm(), 1e-12);
}

TEST(Operation, a_selection_is_carried_over_by_ids) {
    const Document before = fork();
    const Document after = outcome(merging(before, selection_of(std::vector<std::int32_t>{0, 1})));
    const Selection carried_over = carried(before, selection_of(std::vector<std::int32_t>{1, 3}), after);
    ASSERT_EQ(carried_over.nodes.size(), 1u);
    EXPECT_EQ(after.nodes[carried_over.active].id, 13);
}

TEST(Operation, each_says_why_it_did_nothing) {
    for (const Operation& operation :
         {consolidating(fork(), {}), merging(fork(), {}), merging_close_leaves(fork()), rerooting(fork(), 0),
          mirroring(fork()), copying_round(fork()), snapping_to_grid(fork(), {}),
          snapping_to_angles(fork(), {}), making_symmetry_real(fork())}) {
        EXPECT_FALSE(operation.nothing.empty()) << operation.label;
        for (const Parameter& parameter : operation.parameters) {
            EXPECT_GE(parameter.value, parameter.least) << operation.label;
            EXPECT_LE(parameter.value, parameter.most) << operation.label;
        }
    }
}

}  // namespace
}  // namespace sinew::modeler

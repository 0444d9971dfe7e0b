#include "document/selection.h"

#include <gmock/gmock.h>

#include "document/edits.h"

namespace sinew::modeler {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// 0 - 1 - 2 and 1 - 3; 4 - 5 on their own, joined to nothing; a link 3 - 4 where asked for.
Document two_trees(bool joined) {
    Document document;
    for (std::int32_t parent : {-1, 0, 1, 1, -1, 4}) append_node(document, {.id = -1, .parent = parent});
    if (joined) document.links.push_back({3, 4});
    return document;
}

TEST(Selection, keeps_nodes_in_order_once_and_the_last_one_active) {
    const Selection selection = selection_of(std::vector<std::int32_t>{4, 2, 4, 3});
    EXPECT_THAT(selection.nodes, ElementsAre(2, 3, 4));
    EXPECT_EQ(selection.active, 3);
    EXPECT_TRUE(selection.contains(4));
    EXPECT_FALSE(selection.contains(1));
}

TEST(Selection, toggling_twice_leaves_the_same_nodes) {
    const Selection selection = selection_of(2);
    const Selection both = toggled(selection, 5);
    EXPECT_THAT(both.nodes, ElementsAre(2, 5));
    EXPECT_EQ(both.active, 5);
    EXPECT_EQ(toggled(both, 5), selection);
}

TEST(Selection, inverting_twice_and_inverting_all) {
    const Document document = two_trees(false);
    const Selection selection = selection_of(std::vector<std::int32_t>{1, 4});
    EXPECT_THAT(inverted(document, selection).nodes, ElementsAre(0, 2, 3, 5));
    EXPECT_EQ(inverted(document, inverted(document, selection)).nodes, selection.nodes);
    EXPECT_THAT(inverted(document, all_nodes(document)).nodes, IsEmpty());
}

TEST(Selection, linked_follows_bones_and_links) {
    EXPECT_THAT(linked(two_trees(false), selection_of(2)).nodes, ElementsAre(0, 1, 2, 3));
    EXPECT_THAT(linked(two_trees(true), selection_of(2)).nodes, ElementsAre(0, 1, 2, 3, 4, 5));
}

TEST(Selection, descendants_are_found_in_any_order_of_nodes) {
    Document document = two_trees(false);
    EXPECT_THAT(with_descendants(document, selection_of(1)).nodes, ElementsAre(1, 2, 3));
    document.nodes[0].parent = 5;  // a parent behind its child
    EXPECT_THAT(with_descendants(document, selection_of(4)).nodes, ElementsAre(0, 1, 2, 3, 4, 5));
}

TEST(Selection, steps_along_the_tree) {
    const Document document = two_trees(false);
    EXPECT_EQ(stepped(document, selection_of(2), Step::parent).active, 1);
    EXPECT_EQ(stepped(document, selection_of(1), Step::child).active, 2);
    EXPECT_EQ(stepped(document, selection_of(2), Step::sibling).active, 3);
    EXPECT_EQ(stepped(document, selection_of(3), Step::sibling).active, 2);
    EXPECT_EQ(stepped(document, selection_of(0), Step::parent).active, 0);
    EXPECT_EQ(stepped(document, selection_of(0), Step::sibling).active, 4);
}

TEST(Selection, remapping_drops_what_is_gone) {
    const std::vector<std::int32_t> places{0, -1, 1, 2};
    const Selection selection = remapped(selection_of(std::vector<std::int32_t>{3, 2, 1}), places);
    EXPECT_THAT(selection.nodes, ElementsAre(1, 2));
    EXPECT_TRUE(selection.contains(selection.active));
}

}  // namespace
}  // namespace sinew::modeler

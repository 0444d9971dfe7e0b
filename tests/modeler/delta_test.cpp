#include "document/delta.h"

#include <gtest/gtest.h>

#include "document/edits.h"

namespace sinew::modeler {
namespace {

Document chain(int count) {
    Document document;
    for (int i = 0; i < count; ++i)
        append_node(document, {.id = -1, .parent = i - 1, .position = Vec3(0, 0, i), .radius = 0.25});
    return document;
}

void expect_both_ways(const Document& before, const Document& after) {
    const DocumentDelta delta(before, after);
    EXPECT_TRUE(same(delta.forward(before), after));
    EXPECT_TRUE(same(delta.backward(after), before));
    EXPECT_EQ(delta.empty(), same(before, after));
}

TEST(DocumentDelta, leads_there_and_back_for_every_kind_of_change) {
    const Document document = chain(6);
    Document moved = translate(document, std::vector<std::int32_t>{2, 4}, Vec3(1, 0, 0));
    Document named = rename(document, 3, "knee");
    Document linked = toggle_link(document, 0, 5);
    Document mirrored = document;
    mirrored.symmetry = {Symmetry::Kind::mirror, 1, 1};
    mirrored.unit = "mm";
    mirrored.extra = R"({"author": "me"})";
    Document boxed = document;
    boxed.nodes[5].type = NodeType::cube;
    boxed.nodes[5].size = Vec3(1, 2, 3);
    boxed.nodes[5].rotation = Quat(0.5, 0.5, 0.5, 0.5);
    const Document shorter = erase_nodes(document, selection_of(1)).document;
    for (const Document& other : {document, moved, named, linked, mirrored, boxed, shorter, Document{}}) {
        expect_both_ways(document, other);
        expect_both_ways(other, named);
    }
}

TEST(DocumentDelta, is_as_small_as_the_change) {
    const Document document = chain(1000);
    EXPECT_EQ(DocumentDelta(document, translate(document, std::vector<std::int32_t>{500}, Vec3(0, 1, 0)))
                  .changed_nodes(),
              1u);
    EXPECT_EQ(DocumentDelta(document, add_children(document, std::vector<std::int32_t>{7}).document)
                  .changed_nodes(),
              1u);
}

TEST(DocumentDelta, tells_every_field_apart) {
    const Node node{.id = 1, .size = Vec3(1, 1, 1)};
    EXPECT_TRUE(same(node, node));
    auto differs = [&](auto change) {
        Node other = node;
        change(other);
        return !same(node, other);
    };
    EXPECT_TRUE(differs([](Node& n) { n.id = 2; }));
    EXPECT_TRUE(differs([](Node& n) { n.parent = 0; }));
    EXPECT_TRUE(differs([](Node& n) { n.position.z() = 1; }));
    EXPECT_TRUE(differs([](Node& n) { n.radius = 2; }));
    EXPECT_TRUE(differs([](Node& n) { n.type = NodeType::ball; }));
    EXPECT_TRUE(differs([](Node& n) { n.section = Section::rectangular; }));
    EXPECT_TRUE(differs([](Node& n) { n.scale[2] = 2; }));
    EXPECT_TRUE(differs([](Node& n) { n.size.reset(); }));
    EXPECT_TRUE(differs([](Node& n) { n.roll = 1; }));
    EXPECT_TRUE(differs([](Node& n) { n.rotation = Quat::Identity(); }));
    EXPECT_TRUE(differs([](Node& n) { n.joint = 1; }));
}

}  // namespace
}  // namespace sinew::modeler

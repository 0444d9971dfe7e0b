#include "files/load.h"

#include <gmock/gmock.h>

#include "document/delta.h"
#include "document/edits.h"
#include "document/references.h"
#include "sinew/io/files.h"
#include "sinew/skeleton/validate.h"
#include "temporary_folder.h"

namespace sinew::modeler {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Result<ReadSkeleton> load_text(const std::string& text, const std::string& name = "it.sinew") {
    const TemporaryFolder folder;
    EXPECT_TRUE(write_file(folder.file(name), text));
    return load(folder.file(name));
}

std::string native(const std::string& nodes) {
    return R"({"format": "sinew", "version": 1, "nodes": [)" + nodes + "]}";
}

TEST(Load, what_is_sound_comes_without_remarks) {
    const auto read = load_text(native(R"({"id": 3, "position": [1, 2, 3], "radius": 0.5, "name": "hip"})"));
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_TRUE(read->warnings.empty());
    EXPECT_EQ(read->document.nodes.at(0).position, Vec3(1, 2, 3));
    EXPECT_THAT(read->document.names, ElementsAre("hip"));
}

TEST(Load, what_can_be_edited_is_opened) {
    // A cone in the middle of a limb: no mesh, but one can see it and mend it.
    const auto read = load_text(native(R"(
        {"id": 1, "position": [0, 0, 0], "radius": 1},
        {"id": 2, "parent": 1, "position": [0, 0, 3], "radius": 1, "type": "cone"},
        {"id": 3, "parent": 2, "position": [0, 0, 6], "radius": 1})"));
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->document.nodes.size(), 3u);
    EXPECT_EQ(validate(read->document).error().node, 2);
    EXPECT_TRUE(read->warnings.empty());  // they would outlive the problem
}

TEST(Load, what_no_tool_could_hold_is_refused) {
    for (const char* nodes : {
             R"({"id": 1, "position": [0, 0, 0], "radius": -1})",
             R"({"id": 1, "position": [0, 0, 0], "radius": 0})",
             R"({"id": 1, "parent": 2, "position": [0, 0, 0], "radius": 1},
                {"id": 2, "parent": 1, "position": [0, 0, 1], "radius": 1})",
             R"({"id": 1, "position": [0, 0], "radius": 1})",
         })
        EXPECT_FALSE(load_text(native(nodes))) << nodes;
    EXPECT_FALSE(load_text("{"));
    EXPECT_FALSE(load("/no/such/file.sinew"));
}

TEST(Load, pictures_beside_the_file_are_found) {
    const TemporaryFolder folder;
    const char* const text = R"({"format": "sinew", "version": 1, "nodes": [],
        "modeler": {"references": {"front": {"file": "front.png"}}}})";
    ASSERT_TRUE(write_file(folder.file("it.sinew"), text));
    const auto read = load(folder.file("it.sinew"));
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(references_of(read->document)[1].file, folder.file("front.png"));
}

TEST(Load, tells_what_is_measured) {
    const auto read = load_text("1 1 0 0 0 1 -1\n2 3 0 0 4 0.5 1\n", "cell.swc");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_TRUE(read->measured);
}

TEST(CanBeEdited, names_what_cannot) {
    Document document = starting_document();
    EXPECT_TRUE(can_be_edited(document));
    EXPECT_TRUE(can_be_edited({}));
    document.nodes[0].position.x() = std::nan("");
    EXPECT_THAT(can_be_edited(document).error().message, HasSubstr("not finite"));
    document.nodes[0] = {.id = 7, .radius = std::nan("")};
    EXPECT_EQ(can_be_edited(document).error().node, 7);
    document.nodes = {{.id = 0, .parent = 1}, {.id = 1, .parent = 0}};
    EXPECT_THAT(can_be_edited(document).error().message, HasSubstr("ancestors"));
}

TEST(Added, joins_two_documents_without_mixing_them_up) {
    Document first = starting_document();
    append_node(first, {.id = -1, .parent = 0, .position = Vec3(0, 0, 1)});
    Document second;
    for (int i = 0; i < 4; ++i) append_node(second, {.id = i, .parent = i - 1, .position = Vec3(5, 0, i)});
    second.links = {{0, 3}};
    second.names = {"a", "b", "c", "d"};
    const Document both = added(first, second);
    ASSERT_TRUE(validate(both)) << validate(both).error().text();
    ASSERT_EQ(both.nodes.size(), 6u);
    EXPECT_EQ(both.nodes[2].parent, -1);
    EXPECT_EQ(both.nodes[5].parent, 4);
    EXPECT_THAT(both.links, ElementsAre(std::array{2, 5}));
    EXPECT_THAT(both.names, ElementsAre("", "", "a", "b", "c", "d"));
    EXPECT_EQ(both.symmetry, first.symmetry);
}

TEST(Added, to_nothing_is_the_other) {
    const Document document = starting_document();
    EXPECT_TRUE(same(added({}, document), document));
    EXPECT_TRUE(same(added(document, {}), document));
}

}  // namespace
}  // namespace sinew::modeler

#include "document/references.h"

#include <gtest/gtest.h>

#include "document/delta.h"
#include "document/edits.h"
#include "sinew/io/skeleton_formats.h"

namespace sinew::modeler {
namespace {

References front_and_side() {
    References references;
    references[1] = {"/home/me/goat/front.png", 3.5, 0.25, {0, -1.5}};
    references[0] = {"/pictures/side.jpg", 2, 1, {0.5, 0}};
    return references;
}

TEST(References, a_document_has_none_at_first) {
    EXPECT_EQ(references_of(starting_document()), References{});
    EXPECT_TRUE(same(with_references(starting_document(), {}), starting_document()));
}

TEST(References, are_kept_by_a_file) {
    const Document document = with_references(starting_document(), front_and_side());
    EXPECT_EQ(references_of(document), front_and_side());
    const auto text = print_skeleton(document, "goat.sinew");
    ASSERT_TRUE(text) << text.error().text();
    const auto read = parse_skeleton(text->text, "goat.sinew");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(references_of(read->document), front_and_side());
    EXPECT_TRUE(same(with_references(document, {}), starting_document()));
}

TEST(References, leave_what_others_keep_there) {
    Document document = starting_document();
    document.extra = R"({"author":"me","modeler":{"colour":"red"},"big":12345678901234567890})";
    const Document with = with_references(document, front_and_side());
    EXPECT_NE(with.extra.find(R"("author":"me")"), std::string::npos);
    EXPECT_NE(with.extra.find(R"("colour":"red")"), std::string::npos);
    EXPECT_NE(with.extra.find("12345678901234567890"), std::string::npos);
    EXPECT_EQ(with_references(with, {}).extra, document.extra);
}

TEST(References, what_makes_no_sense_is_left_out) {
    Document document = starting_document();
    for (const char* extra : {"", "{", "[]", R"({"modeler":3})", R"({"modeler":{"references":[1]}})",
                              R"({"modeler":{"references":{"front":"a.png"}}})",
                              R"({"modeler":{"references":{"front":{"file":7}}}})"}) {
        document.extra = extra;
        EXPECT_EQ(references_of(document), References{}) << extra;
    }
    document.extra =
        R"({"modeler":{"references":{"front":{"file":"a","height":-4,"opacity":7,"up":"high"}}}})";
    const Reference read = references_of(document)[1];
    EXPECT_GT(read.height, 0);
    EXPECT_EQ(read.opacity, 1);
    EXPECT_EQ(read.offset[1], 0);
}

TEST(References, beside_the_document_are_named_as_seen_from_it) {
    const Document open = with_references(starting_document(), front_and_side());
    const Document closed = with_relative_files(open, "/home/me/goat");
    EXPECT_EQ(references_of(closed)[1].file, "front.png");
    EXPECT_EQ(references_of(closed)[0].file, "/pictures/side.jpg");  // elsewhere
    EXPECT_EQ(references_of(with_absolute_files(closed, "/home/me/goat")), front_and_side());
    // The folder has moved, and the picture with it.
    EXPECT_EQ(references_of(with_absolute_files(closed, "/mnt/goat"))[1].file, "/mnt/goat/front.png");
    EXPECT_TRUE(same(with_relative_files(starting_document(), "/"), starting_document()));
}

}  // namespace
}  // namespace sinew::modeler

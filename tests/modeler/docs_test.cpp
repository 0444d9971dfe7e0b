// docs/modeler.md beside the program: tools/modeler-docs makes again what is stale.

#include <gtest/gtest.h>

#include <filesystem>

#include "actions/action.h"
#include "actions/mouse.h"
#include "sinew/io/files.h"

namespace sinew::modeler {
namespace {

const std::string docs = SINEW_DOCS;

std::string page() { return read_file(docs + "/modeler.md").value_or(""); }

/// Neither more nor less: an empty line is before them and after them.
bool has_paragraphs(const std::string& text) {
    const std::string all = page();
    const std::size_t at = all.find(text);
    return at != std::string::npos && all.substr(at - 2, 2) == "\n\n" && all[at + text.size()] == '\n';
}

TEST(ModelerDocs, have_the_keys_of_the_program) {
    const char* const cure = "run tools/modeler-docs --keys";
    EXPECT_TRUE(has_paragraphs(keys_as_markdown())) << cure;
    EXPECT_TRUE(has_paragraphs(mouse_as_markdown())) << cure;
}

TEST(ModelerDocs, have_pictures_that_load_fast) {
    int pictures = 0;
    const std::string text = page();
    for (std::size_t at = 0; (at = text.find("](images/", at)) != std::string::npos; ++at, ++pictures) {
        const std::string name = text.substr(at + 2, text.find(')', at) - at - 2);
        std::error_code missing;
        const auto size = std::filesystem::file_size(docs + "/" + name, missing);
        ASSERT_FALSE(missing) << name << ": run tools/modeler-docs";
        EXPECT_LT(size, 120'000u) << name;
    }
    EXPECT_GE(pictures, 6);
}

}  // namespace
}  // namespace sinew::modeler

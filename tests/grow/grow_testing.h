/// @file grow_testing.h
/// Short ways to grow something in a test and to look at it.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "sinew/grow/grow.h"
#include "sinew/skeleton/validate.h"

namespace sinew::testing {

inline Grammar parsed(std::string_view text) {
    auto grammar = parse_grammar(text, "test.lsys");
    EXPECT_TRUE(grammar) << grammar.error().text() << "\nin\n" << text;
    return grammar ? *grammar : Grammar{};
}

inline Document grown(std::string_view text, const GrowOptions& options = {}) {
    const Grammar grammar = parsed(text);
    auto document = grow(grammar, options);
    EXPECT_TRUE(document) << document.error().text() << "\nin\n" << text;
    if (!document) return {};
    const auto valid = validate(*document);
    EXPECT_TRUE(valid) << valid.error().text() << "\nin\n" << text;
    return *document;
}

/// The message of whichever of parse_grammar and grow fails; empty if none does.
inline std::string error_of(std::string_view text, const GrowOptions& options = {}) {
    const auto grammar = parse_grammar(text, "test.lsys");
    if (!grammar) return grammar.error().text();
    const auto document = grow(*grammar, options);
    return document ? "" : document.error().text();
}

/// Lengths of the bones in the order in which they grew. A grammar whose last productions turn each letter
/// into an F of its own length shows the string of modules so.
inline std::vector<double> lengths(const Document& document) {
    std::vector<double> result;
    for (const Node& node : document.nodes)
        if (node.parent >= 0) result.push_back((node.position - document.nodes[node.parent].position).norm());
    return result;
}

}  // namespace sinew::testing

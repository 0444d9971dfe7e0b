/// @file whole_history.h
/// Undo and redo of everything, for tests that have done much.
#pragma once

#include <gtest/gtest.h>

#include "document/model.h"
#include "sinew/io/skeleton_formats.h"

namespace sinew::modeler {

inline std::string bytes_of(const Document& document) { return print_skeleton(document, "it.sinew")->text; }

/// Undoing all gives the beginning's bytes again, and redoing all the end's.
/// @return how many steps there were to take back
inline int expect_whole_history(Model& model, const std::string& beginning) {
    const std::string end = bytes_of(model.document());
    int steps = 0;
    for (; model.history().canUndo(); ++steps) model.undo();
    EXPECT_EQ(bytes_of(model.document()), beginning);
    for (int i = 0; i < steps; ++i) model.redo();
    EXPECT_EQ(bytes_of(model.document()), end);
    return steps;
}

}  // namespace sinew::modeler

/// @file tree.h
/// A small document for panels to show.
#pragma once

#include "document/edits.h"
#include "document/model.h"

namespace sinew::modeler {

/// A root (0) with a spine (1), which has two limbs (2, 3), the second with a hand (4).
inline Document small_tree() {
    Document document;
    document.unit = "m";
    for (const auto& [parent, place] : {std::pair{-1, Vec3(0, 0, 0)},
                                        {0, Vec3(0, 0, 2)},
                                        {1, Vec3(1, 0, 3)},
                                        {1, Vec3(-1, 0, 3)},
                                        {3, Vec3(-2, 0, 3)}})
        append_node(document, {.id = -1, .parent = parent, .position = place, .radius = 0.25});
    return rename(std::move(document), 4, "hand");
}

/// Observers live as long as the model: it is made before the panel, and outlives it.
struct Shown {
    Model model;
    explicit Shown(Document document = small_tree()) { model.replace(std::move(document), true); }
    void select(std::vector<std::int32_t> nodes) { model.select(selection_of(nodes)); }
};

}  // namespace sinew::modeler

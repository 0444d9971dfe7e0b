/// @file view_settings.h
/// What is shown and how: chosen by the person, kept from one day to the next, and no part of the document.
#pragma once

#include "sinew/render/gl_scene.h"

namespace sinew::modeler {

enum class StandardView : std::uint8_t { front, back, right, left, top, bottom };

struct ViewSettings {
    bool live = true;  ///< the mesh is made and shown; otherwise only the skeleton is
    int level = 1;     ///< of subdivision
    int sides = 0;     ///< vertices round every tube; 0: as few as possible
    Shading shading = Shading::lit;
    double opacity = 1;  ///< of the mesh
    bool wire = true;
    bool irregular = false;
    bool creases = false;
    bool bones = true;  ///< nodes and bones
    bool grid = true;
    bool names = false;

    bool operator==(const ViewSettings&) const = default;
};

inline constexpr int most_levels = 5;
inline constexpr double see_through = 0.45;  ///< opacity at which bones are seen well inside

}  // namespace sinew::modeler

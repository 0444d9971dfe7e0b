/// @file pointer.h
/// Mouse, pen or finger, as tools see it.
#pragma once

#include "sinew/base/vec.h"

namespace sinew::modeler {

struct Pointer {
    Vec2 pixel{0, 0};  ///< logical pixels, origin at the top left
    bool shift = false;
    bool ctrl = false;
};

}  // namespace sinew::modeler

/// @file finest.h
/// What the limit needs to know of the finest level.
#pragma once

#include "sinew/subdivide/finer_rules.h"

namespace sinew {

/// Everything but positions that the limit needs.
struct Finest {
    std::span<const Level> levels;  ///< those that are split; the control mesh's also if none is
    std::size_t splits = 0;
    const SurfaceRules& rules;  ///< of the finest level
    const Features& features;   ///< where circles and planes are
};

}  // namespace sinew

/// @file colour.h
/// Colours as people write them.
#pragma once

#include <cstdint>

namespace sinew {

/// sRGB and straight (not premultiplied) alpha, eight bits each.
struct Colour {
    std::uint8_t r = 0, g = 0, b = 0, a = 255;

    bool operator==(const Colour&) const = default;
};
static_assert(sizeof(Colour) == 4);

}  // namespace sinew

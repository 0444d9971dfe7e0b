/// @file picture.h
/// A picture in memory, pictures side by side, and PNG.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sinew/base/result.h"
#include "sinew/render/colour.h"

namespace sinew {

/// Rows from the top down, straight alpha.
struct Picture {
    int width = 0, height = 0;
    std::vector<Colour> pixels;

    Picture() = default;
    Picture(int w, int h, Colour fill = {})
        : width(w), height(h), pixels(std::size_t(w) * std::size_t(h), fill) {}
    Colour& at(int x, int y) { return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
    const Colour& at(int x, int y) const {
        return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)];
    }
};

/// Pictures in rows of `columns`, each in the middle of a cell as large as the largest of them.
/// @param gap         pixels between the cells and round them all
/// @param background  behind the pictures and their transparent parts
Picture contact_sheet(std::span<const Picture> pictures, int columns, int gap = 0,
                      Colour background = {238, 239, 241, 255});

/// The bytes of a PNG file, 8 bits a channel, with alpha only where some pixel is not opaque. The same
/// picture gives the same bytes. Fails (kind call) for an empty picture.
Result<std::string> encode_png(const Picture& picture);
/// The reverse, for any PNG. Fails (kind input) for what is none.
Result<Picture> decode_png(std::string_view bytes);

}  // namespace sinew

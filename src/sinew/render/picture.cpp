#include "sinew/render/picture.h"

#include <png.h>

#include <algorithm>

namespace sinew {
namespace {

Colour over(Colour top, Colour below) {
    const double a = top.a / 255.0, b = below.a / 255.0 * (1 - a), sum = a + b;
    if (sum <= 0) return {0, 0, 0, 0};
    const auto mix = [&](std::uint8_t x, std::uint8_t y) {
        return static_cast<std::uint8_t>((x * a + y * b) / sum + 0.5);
    };
    return {mix(top.r, below.r), mix(top.g, below.g), mix(top.b, below.b),
            static_cast<std::uint8_t>(sum * 255 + 0.5)};
}

void paste(Picture& sheet, const Picture& picture, int left, int top) {
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            Colour& below = sheet.at(left + x, top + y);
            below = over(picture.at(x, y), below);
        }
}

/// libpng's simplified interface: no jumps, no callbacks. Frees what it holds when it goes.
struct PngImage {
    png_image image{};
    PngImage() { image.version = PNG_IMAGE_VERSION; }
    PngImage(const PngImage&) = delete;
    PngImage& operator=(const PngImage&) = delete;
    ~PngImage() { png_image_free(&image); }
    std::string message() const { return image.message; }
};

std::vector<std::uint8_t> opaque_bytes(const Picture& picture) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(picture.pixels.size() * 3);
    for (const Colour c : picture.pixels) bytes.insert(bytes.end(), {c.r, c.g, c.b});
    return bytes;
}

}  // namespace

Picture contact_sheet(std::span<const Picture> pictures, int columns, int gap, Colour background) {
    int width = 0, height = 0;
    for (const Picture& picture : pictures) {
        width = std::max(width, picture.width);
        height = std::max(height, picture.height);
    }
    columns = std::clamp(columns, 1, std::max(1, static_cast<int>(pictures.size())));
    const int rows = (static_cast<int>(pictures.size()) + columns - 1) / columns;
    Picture sheet(columns * (width + gap) + gap, rows * (height + gap) + gap, background);
    for (int i = 0; i < static_cast<int>(pictures.size()); ++i) {
        const Picture& picture = pictures[i];
        paste(sheet, picture, gap + i % columns * (width + gap) + (width - picture.width) / 2,
              gap + i / columns * (height + gap) + (height - picture.height) / 2);
    }
    return sheet;
}

Result<std::string> encode_png(const Picture& picture) {
    if (picture.width <= 0 || picture.height <= 0)
        return fail(ErrorKind::call, "an empty picture cannot be written");
    const bool opaque =
        std::all_of(picture.pixels.begin(), picture.pixels.end(), [](Colour c) { return c.a == 255; });
    std::vector<std::uint8_t> rgb;
    if (opaque) rgb = opaque_bytes(picture);
    const void* pixels = opaque ? static_cast<const void*>(rgb.data()) : picture.pixels.data();
    PngImage png;
    png.image.width = static_cast<unsigned>(picture.width);
    png.image.height = static_cast<unsigned>(picture.height);
    png.image.format = opaque ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png.image);
    std::string bytes(size, '\0');
    if (!png_image_write_to_memory(&png.image, bytes.data(), &size, 0, pixels, 0, nullptr))
        return fail(ErrorKind::program, "libpng cannot write the picture: " + png.message());
    bytes.resize(size);
    return bytes;
}

Result<Picture> decode_png(std::string_view bytes) {
    PngImage png;
    if (!png_image_begin_read_from_memory(&png.image, bytes.data(), bytes.size()))
        return fail(ErrorKind::input, "not a PNG picture: " + png.message());
    png.image.format = PNG_FORMAT_RGBA;
    Picture picture(static_cast<int>(png.image.width), static_cast<int>(png.image.height));
    if (!png_image_finish_read(&png.image, nullptr, picture.pixels.data(), 0, nullptr))
        return fail(ErrorKind::input, "a broken PNG picture: " + png.message());
    return picture;
}

}  // namespace sinew

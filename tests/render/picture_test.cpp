#include "sinew/render/picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>

namespace sinew {
namespace {

Picture colourful(int width, int height, std::uint8_t alpha) {
    Picture picture(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            picture.at(x, y) = {std::uint8_t(7 * x), std::uint8_t(11 * y), std::uint8_t(x * y),
                                std::uint8_t(x ? 255 : alpha)};
    return picture;
}

/// libpng's own reading of the file, whatever the writer thinks it wrote.
Picture read_with_libpng(const std::string& bytes, unsigned expected_format) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    EXPECT_TRUE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()));
    EXPECT_EQ(image.format, expected_format);
    image.format = PNG_FORMAT_RGBA;
    Picture picture(int(image.width), int(image.height));
    EXPECT_TRUE(png_image_finish_read(&image, nullptr, picture.pixels.data(), 0, nullptr));
    return picture;
}

TEST(Png, KeepsEveryPixel) {
    for (const auto& [alpha, format] :
         {std::pair{255, PNG_FORMAT_RGB}, {0, PNG_FORMAT_RGBA}, {77, PNG_FORMAT_RGBA}}) {
        const Picture picture = colourful(33, 17, std::uint8_t(alpha));
        const auto bytes = encode_png(picture);
        ASSERT_TRUE(bytes) << bytes.error().text();
        const Picture read = read_with_libpng(*bytes, unsigned(format));
        EXPECT_EQ(read.width, 33);
        EXPECT_EQ(read.height, 17);
        EXPECT_EQ(read.pixels, picture.pixels);
        const auto decoded = decode_png(*bytes);
        ASSERT_TRUE(decoded);
        EXPECT_EQ(decoded->pixels, picture.pixels);
    }
}

TEST(Png, EveryPrefixIsRefused) {
    const std::string bytes = *encode_png(colourful(9, 9, 255));
    for (std::size_t n = 0; n + 12 < bytes.size(); ++n) {  // the last chunk is empty
        const auto picture = decode_png(std::string_view(bytes).substr(0, n));
        ASSERT_FALSE(picture) << n << " bytes";
        EXPECT_EQ(picture.error().kind, ErrorKind::input);
    }
}

TEST(Png, AnEmptyPictureIsRefused) {
    const auto bytes = encode_png({});
    ASSERT_FALSE(bytes);
    EXPECT_EQ(bytes.error().kind, ErrorKind::call);
}

TEST(ContactSheet, PutsPicturesInRows) {
    const Colour red{255, 0, 0}, green{0, 255, 0}, blue{0, 0, 255}, clear{9, 9, 9, 0}, grey{50, 60, 70};
    const std::vector<Picture> pictures{Picture(4, 2, red), Picture(2, 4, green), Picture(4, 4, blue),
                                        Picture(1, 1, clear)};
    const Picture sheet = contact_sheet(pictures, 3, 1, grey);
    EXPECT_EQ(sheet.width, 3 * 4 + 4);
    EXPECT_EQ(sheet.height, 2 * 4 + 3);
    EXPECT_EQ(sheet.at(0, 0), grey);
    EXPECT_EQ(sheet.at(1, 1), grey) << "a flat picture stands in the middle of its cell";
    EXPECT_EQ(sheet.at(1, 2), red);
    EXPECT_EQ(sheet.at(7, 1), green);
    EXPECT_EQ(sheet.at(11, 1), blue);
    EXPECT_EQ(sheet.at(2, 7), grey) << "seen through what is transparent";
}

TEST(ContactSheet, HalfTransparentPixelsAreMixed) {
    const Picture sheet = contact_sheet(std::vector{Picture(1, 1, {255, 0, 0, 128})}, 1, 0, {0, 0, 255});
    EXPECT_NEAR(sheet.at(0, 0).r, 128, 1);
    EXPECT_NEAR(sheet.at(0, 0).b, 127, 1);
    EXPECT_EQ(sheet.at(0, 0).a, 255);
}

}  // namespace
}  // namespace sinew

#include "sinew/render/render.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <numbers>

#include "render/shapes.h"

namespace sinew {
namespace {

double luminance(Colour c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; }

double mean_luminance(const Picture& picture) {
    double sum = 0;
    for (const Colour c : picture.pixels) sum += luminance(c);
    return sum / double(picture.pixels.size());
}

/// Looks along +y at the origin; the picture shows `height` units from bottom to top.
Camera front_camera(double height) {
    Camera camera = camera_of(View::front);
    camera.distance *= height / visible_height(camera);
    return camera;
}

RenderOptions plain(double height, int width_pixels = 200, int height_pixels = 200) {
    RenderOptions options{.width = width_pixels, .height = height_pixels, .camera = front_camera(height)};
    options.draw.shadows = false;
    return options;
}

ShapeGlyph ball(const Vec3f& centre, float radius, Colour colour) {
    return {radius * Vec3f::UnitX(), radius * Vec3f::UnitY(), radius * Vec3f::UnitZ(), centre, colour};
}

class Render : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        unsetenv("DISPLAY");
        unsetenv("WAYLAND_DISPLAY");
    }
    static Picture take(const Scene& scene, const RenderOptions& options) {
        auto picture = render(scene, options);
        if (!picture) {
            ADD_FAILURE() << picture.error().text();
            return Picture(options.width, options.height);
        }
        return std::move(*picture);
    }
    static Scene of(const QuadMesh& mesh) { return {.mesh = mesh_buffers(mesh)}; }
};

TEST_F(Render, ASphereCoversItsShareOfThePicture) {
    RenderOptions options = plain(4);
    options.background = transparent;
    const Picture picture = take(of(shapes::sphere({0, 0, 0}, 1, 64)), options);
    double covered = 0;
    for (const Colour c : picture.pixels) covered += c.a / 255.0;
    EXPECT_NEAR(covered / double(picture.pixels.size()), std::numbers::pi / 16, 0.002);
    EXPECT_EQ(picture.at(0, 0), transparent);
    EXPECT_EQ(picture.at(100, 100).a, 255);
}

TEST_F(Render, TheKeyLightsTheUpperLeft) {
    const Picture picture = take(of(shapes::sphere({0, 0, 0}, 1, 64)), plain(4));
    EXPECT_GT(luminance(picture.at(75, 70)), luminance(picture.at(100, 100)));
    EXPECT_GT(luminance(picture.at(100, 100)), luminance(picture.at(125, 130)) + 20);
    EXPECT_EQ(picture.at(3, 3), light_grey);
    EXPECT_EQ(picture.at(196, 196), light_grey);
}

TEST_F(Render, AMirroredSceneGivesTheMirroredPicture) {
    const auto scene = [](float side) {
        QuadMesh mesh = shapes::sphere({side * 0.8f, 0, 0.3f}, 0.7f, 32);
        if (side < 0)
            for (Vec3f& p : mesh.positions) p.x() = -1.6f - p.x();  // the same vertices, mirrored
        if (side < 0)
            for (std::size_t f = 0; f < mesh.face_count(); ++f)
                std::reverse(mesh.corners.begin() + mesh.face_offsets[f],
                             mesh.corners.begin() + mesh.face_offsets[f + 1]);
        return of(mesh);
    };
    RenderOptions options = plain(4);
    options.draw.wire = true;
    const Picture right = take(scene(1), options);
    for (Vec3f* light : {&options.draw.lights.key, &options.draw.lights.fill, &options.draw.lights.rim})
        light->x() *= -1;
    const Picture left = take(scene(-1), options);
    double difference = 0;
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 200; ++x)
            difference += std::abs(luminance(right.at(x, y)) - luminance(left.at(199 - x, y)));
    EXPECT_LT(difference / (200 * 200), 0.25);
    EXPECT_LT(mean_luminance(right), luminance(light_grey) - 5) << "there is something to compare";
}

TEST_F(Render, WireDrawsTheEdgesOfQuadsAndNotTheirDiagonals) {
    RenderOptions options = plain(4);
    options.camera->target = {1, 0, 1};
    const Scene scene = of(shapes::grid(2));  // edges at pixels 50, 100 and 150
    const Picture without = take(scene, options);
    options.draw.wire = true;
    const Picture with = take(scene, options);
    EXPECT_LT(mean_luminance(with), mean_luminance(without));
    EXPECT_LT(luminance(with.at(100, 75)), luminance(without.at(100, 75)) - 50);
    EXPECT_LT(luminance(with.at(125, 100)), luminance(without.at(125, 100)) - 50);
    for (const int d : {15, 20, 25, 30, 35}) {
        EXPECT_EQ(with.at(50 + d, 50 + d), without.at(50 + d, 50 + d));
        EXPECT_EQ(with.at(50 + d, 99 - d), without.at(50 + d, 99 - d));
    }
}

TEST_F(Render, WireKeepsItsWidthInPixels) {
    const auto dark_columns = [](double height) {
        RenderOptions options = plain(height, 400, 400);
        options.camera->target = {1, 0, 1.5};
        options.draw.wire = true;
        options.draw.wire_width = 3;
        const Picture picture = take(of(shapes::grid(2)), options);
        double dark = 0;
        for (int x = 190; x < 210; ++x) dark += luminance(picture.at(x, 200)) < 120;
        return dark;
    };
    EXPECT_NEAR(dark_columns(3), 3, 1);
    EXPECT_NEAR(dark_columns(12), 3, 1);
}

TEST_F(Render, TheNearerHidesTheFarther) {
    const Colour red{200, 20, 20}, blue{20, 20, 200};
    for (const float side : {1.f, -1.f}) {
        Scene scene;
        scene.glyphs.of(GlyphShape::sphere) = {ball({0, side, 0}, 0.5f, red),
                                               ball({0, -side, 0}, 0.5f, blue)};
        const Colour seen = take(scene, plain(4)).at(100, 100);
        EXPECT_EQ(seen.b > seen.r, side > 0) << "the eye is at -y";
    }
}

TEST_F(Render, ATransparentMeshShowsTheBonesInside) {
    Scene scene = of(shapes::sphere({0, 0, 0}, 1, 32));
    scene.glyphs.of(GlyphShape::sphere) = {ball({0, 0, 0}, 0.3f, {220, 0, 0})};
    RenderOptions options = plain(4);
    const Colour opaque = take(scene, options).at(100, 100);
    options.draw.opacity = 0.3f;
    const Colour through = take(scene, options).at(100, 100);
    EXPECT_LT(opaque.r - opaque.g, 40);
    EXPECT_GT(through.r - through.g, 60);
}

TEST_F(Render, MarksIrregularVertices) {
    RenderOptions options = plain(4);
    const Scene scene = of(shapes::box({0, 0, 0}, {1, 1, 1}));
    const Picture without = take(scene, options);
    options.draw.irregular = true;
    const Picture with = take(scene, options);
    EXPECT_EQ(with.at(100, 100), without.at(100, 100));
    EXPECT_GT(with.at(50, 50).b - with.at(50, 50).r, 60) << "three edges: blue";
}

TEST_F(Render, ARoundConeIsTheHullOfItsBalls) {
    Scene scene;
    scene.glyphs.bones = {{.from = {-1, 0, 0},
                           .from_radius = 0.8f,
                           .to = {1.2f, 0, 0},
                           .to_radius = 0.2f,
                           .colour = {200, 200, 200}}};
    RenderOptions options = plain(4, 400, 400);
    options.background = transparent;
    const Picture picture = take(scene, options);
    const double sine = 0.6 / 2.2, cosine = std::sqrt(1 - sine * sine);
    double wrong = 0;
    for (int y = 0; y < 400; ++y)
        for (int x = 0; x < 400; ++x) {
            const double px = (x + 0.5) / 100 - 2, py = std::abs(2 - (y + 0.5) / 100);
            const double along =
                (px + 1) - py * sine / cosine;  // foot of the cone's line through the point, on the axis
            const double radius = along <= 0 ? 0.8 : along >= 2.2 ? 0.2 : 0.8 - along * sine;
            const double centre = -1 + std::clamp(along, 0.0, 2.2);
            const bool inside = std::hypot(px - centre, py) < radius;
            wrong += std::abs((inside ? 1.0 : 0.0) - picture.at(x, y).a / 255.0);
        }
    EXPECT_LT(wrong / (400 * 400), 0.003);
}

TEST_F(Render, AShadowLiesUnderTheThingAndNotFarFromIt) {
    RenderOptions options{.width = 240, .height = 180};
    const Scene scene = of(shapes::sphere({0, 0, 1}, 0.8f, 32));
    const Picture with = take(scene, options);
    options.draw.shadows = false;
    const Picture without = take(scene, options);
    double darkest = 0;
    for (std::size_t i = 0; i < with.pixels.size(); ++i)
        if (without.pixels[i] == light_grey)
            darkest = std::max(darkest, luminance(light_grey) - luminance(with.pixels[i]));
    EXPECT_GT(darkest, 30);
    EXPECT_EQ(with.at(2, 2), light_grey);
}

TEST_F(Render, TheSameSceneGivesTheSameBytes) {
    Scene scene = of(shapes::sphere({0, 0, 0}, 1, 24));
    scene.glyphs.of(GlyphShape::sphere) = {ball({1, 0, 0}, 0.5f, {220, 0, 0})};
    RenderOptions options{.width = 160, .height = 120};
    options.draw.wire = true;
    EXPECT_EQ(*encode_png(take(scene, options)), *encode_png(take(scene, options)));
}

TEST_F(Render, OneRendererTakesManyPictures) {
    auto renderer = Renderer::create();
    ASSERT_TRUE(renderer);
    const Scene scene = of(shapes::sphere({0, 0, 0}, 1, 24));
    const RenderOptions small{.width = 64, .height = 64}, large{.width = 128, .height = 96};
    const Picture first = *renderer->render(scene, small);
    ASSERT_TRUE(renderer->render({}, large));
    EXPECT_EQ(renderer->render(scene, small)->pixels, first.pixels);
}

TEST_F(Render, NothingIsJustTheBackground) {
    const Picture picture = take({}, {.width = 32, .height = 16});
    EXPECT_EQ(picture.pixels, std::vector<Colour>(32 * 16, light_grey));
}

TEST_F(Render, ImpossibleSizesAreRefused) {
    for (const auto& [w, h] : {std::pair{0, 10}, {10, -1}, {1 << 20, 10}}) {
        const auto picture = render({}, {.width = w, .height = h});
        ASSERT_FALSE(picture);
        EXPECT_EQ(picture.error().kind, ErrorKind::call);
    }
}

}  // namespace
}  // namespace sinew

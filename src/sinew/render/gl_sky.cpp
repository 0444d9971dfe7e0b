#include "sinew/render/gl_sky.h"

#include <epoxy/gl.h>

#include <cmath>
#include <numbers>

namespace sinew::gl {
namespace {

constexpr int map_size = 512;
constexpr float lowest_sky = -0.15f;  ///< sine of the height above the horizon at which the sky ends
constexpr float key_spread = 0.16f;   ///< tangent of half the angle that the key light is seen under
constexpr double golden_angle = 2.399963229728653;

/// The orthographic view along -direction of a ball, as rows from the world to [-1, 1].
Mat4f view_along(const Vec3f& direction, const Vec3f& centre, float radius) {
    const Vec3f across = direction.unitOrthogonal();
    Mat4f light = Mat4f::Zero();
    light.block<1, 3>(0, 0) = across.transpose() / radius;
    light.block<1, 3>(1, 0) = direction.cross(across).transpose() / radius;
    light.block<1, 3>(2, 0) = -direction.transpose() / radius;
    for (int row = 0; row < 3; ++row) light(row, 3) = -light.block<1, 3>(row, 0).dot(centre);
    light(3, 3) = 1;
    return light;
}

}  // namespace

std::vector<Vec3f> sky_directions(const Vec3f& key, int key_count, int sky_count) {
    std::vector<Vec3f> directions;
    const Vec3f flat = Vec3f::UnitZ().cross(key);
    const Vec3f side = flat.norm() > 1e-3f ? Vec3f(flat.normalized()) : Vec3f::UnitX();
    const Vec3f upward = key.cross(side);
    for (int i = 0; i < key_count; ++i) {  // a disc of pairs on both sides of the key
        const double turn = golden_angle * (i / 2) + 0.3,
                     away = key_spread * std::sqrt((i / 2 + 0.5) / ((key_count + 1) / 2));
        const double x = (i % 2 ? -1 : 1) * std::cos(turn) * away, y = std::sin(turn) * away;
        directions.push_back(
            (key + static_cast<float>(x) * side + static_cast<float>(y) * upward).normalized());
    }
    for (int i = 0; i < sky_count; ++i) {  // a spiral over half the sky, and its mirror image
        const int pair = i / 2, pairs = (sky_count + 1) / 2;
        const double z = 1 - (1 - lowest_sky) * (pair + 0.5) / pairs;
        const double turn = std::fmod(golden_angle / 2 * pair, std::numbers::pi), r = std::sqrt(1 - z * z);
        directions.emplace_back((i % 2 ? -1 : 1) * r * std::sin(turn), r * std::cos(turn), z);
    }
    return directions;
}

SkyMaps SkyMaps::create() {
    SkyMaps maps;
    maps.texture_ = Texture::make();
    maps.framebuffer_ = Framebuffer::make();
    maps.block_ = Buffer::make();
    const SkyBlock nothing{};
    upload(maps.block_, &nothing, sizeof nothing);
    maps.allocate(1);
    return maps;
}

void SkyMaps::allocate(int layers) {
    if (layers == layers_) return;
    layers_ = layers;
    const int size = layers == 1 ? 1 : map_size;
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture_.name());
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT16, size, size, layers, 0, GL_DEPTH_COMPONENT,
                 GL_UNSIGNED_SHORT, nullptr);
    const float lit[] = {1, 1, 1, 1};
    glTexParameterfv(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BORDER_COLOR, lit);
    for (const auto& [name, value] : {std::pair{GL_TEXTURE_MIN_FILTER, GL_LINEAR},
                                      {GL_TEXTURE_MAG_FILTER, GL_LINEAR},
                                      {GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER},
                                      {GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER},
                                      {GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE},
                                      {GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL}})
        glTexParameteri(GL_TEXTURE_2D_ARRAY, static_cast<unsigned>(name), value);
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
}

void SkyMaps::render(const Vec3f& centre, float radius, std::span<const Vec3f> directions, int key_count,
                     const std::function<void(const Mat4f&)>& draw_depth) {
    const int count = static_cast<int>(directions.size());
    allocate(count);
    SkyBlock block{};
    block.key_count = key_count;
    block.count = count;
    block.texel = 2 * radius / map_size;
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    glViewport(0, 0, map_size, map_size);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.5f, 2);
    for (int i = 0; i < count; ++i) {
        const Mat4f view = view_along(directions[i], centre, radius);
        block.direction[i] << directions[i], 0;
        for (int row = 0; row < 3; ++row) {
            block.rows[3 * i + row] = 0.5f * view.row(row).transpose();
            block.rows[3 * i + row].w() += 0.5f;
        }
        glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, texture_.name(), 0, i);
        glClear(GL_DEPTH_BUFFER_BIT);
        draw_depth(view);
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
    upload(block_, &block, sizeof block);
}

void SkyMaps::bind() const {
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture_.name());
    glBindBufferBase(GL_UNIFORM_BUFFER, 1, block_.name());
}

}  // namespace sinew::gl

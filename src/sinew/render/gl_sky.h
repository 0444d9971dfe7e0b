/// @file gl_sky.h
/// Soft shadows and ambient occlusion: the scene seen as depth from many directions of the sky, some of them
/// round the key light.
///
/// A pixel asks all maps how much of each it sees. That is too slow to redo on every frame of a large scene,
/// and looks far better than a guess from the picture's own depth.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "sinew/base/vec.h"
#include "sinew/render/frame_block.h"
#include "sinew/render/gl_object.h"

namespace sinew::gl {

/// Directions towards the light: `key_count` round the key, then `sky_count` over the sky. Where the key is
/// mirrored in the plane x = 0, so are all of them. key_count + sky_count <= max_sky_maps.
std::vector<Vec3f> sky_directions(const Vec3f& key, int key_count, int sky_count);

class SkyMaps {
  public:
    static SkyMaps create();

    /// Draws the maps of a scene within a ball. Leaves another framebuffer and viewport bound than it found.
    /// @param draw_depth  called once a map with what goes for FrameBlock::view, from the world straight to
    /// clip space
    void render(const Vec3f& centre, float radius, std::span<const Vec3f> directions, int key_count,
                const std::function<void(const Mat4f& view)>& draw_depth);
    void bind() const;  ///< the texture to unit 0, the block to binding 1

  private:
    void allocate(int layers);

    Texture texture_;
    Framebuffer framebuffer_;
    Buffer block_;
    int layers_ = 0;
};

}  // namespace sinew::gl

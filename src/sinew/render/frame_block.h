/// @file frame_block.h
/// The uniform block `Frame`: all that the shaders are told about one draw. Laid out as std140 wants it.
#pragma once

#include <Eigen/Core>

namespace sinew::gl {

using Vec4f = Eigen::Matrix<float, 4, 1, Eigen::DontAlign>;
using Mat4f = Eigen::Matrix<float, 4, 4, Eigen::DontAlign>;

struct FrameBlock {
    Mat4f view;        ///< world to eye
    Mat4f projection;  ///< eye to clip
    Vec4f viewport;    ///< width and height in pixels, 1 for a perspective, 1 where the sky's maps are there
    Vec4f up;          ///< the world's z in eye space
    Vec4f key;         ///< direction towards the light in eye space, strength
    Vec4f fill;
    Vec4f rim;
    Vec4f mesh_colour;  ///< sRGB, opacity
    Vec4f wire_colour;  ///< sRGB, opacity; 0: no wire
    Vec4f
        style;  ///< shading (0 lit, 1 matcap, 2 flat), wire width in pixels, height of the ground, its shadow
    Vec4f extent;  ///< centre of the scene, radius round it
};
static_assert(sizeof(FrameBlock) == (2 * 16 + 9 * 4) * 4);

/// As many maps of the sky as a block and an array texture are sure to hold.
inline constexpr int max_sky_maps = 96;

/// The uniform block `Sky`: the maps, first those round the key light.
struct SkyBlock {
    Vec4f direction[max_sky_maps];  ///< world, towards the light
    Vec4f rows[3 * max_sky_maps];   ///< world to map: two texture coordinates and a depth, in 0..1
    int key_count = 0, count = 0;   ///< maps round the key light; all maps
    float texel = 0;                ///< size of a texel in the world
    float unused = 0;
};
static_assert(sizeof(SkyBlock) == (4 * max_sky_maps * 4 + 4) * 4);

}  // namespace sinew::gl

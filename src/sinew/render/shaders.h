/// @file shaders.h
/// The sources of the shaders, in pieces that build_program joins. All colours in them are premultiplied sRGB
/// when written.
#pragma once

#include <string_view>

namespace sinew::gl {

// shaders_light.cpp
extern const std::string_view frame_source;  ///< the uniform block that every stage of every program may read
extern const std::string_view light_source;  ///< fragment: what a lit surface looks like
extern const std::string_view sky_source;    ///< fragment: how much of the sky and of the key light is seen

// shaders_mesh.cpp
extern const std::string_view mesh_vertex;
extern const std::string_view mesh_fragment;
extern const std::string_view mesh_depth_vertex;  ///< the same place, and nothing else

// shaders_glyph.cpp
extern const std::string_view shape_vertex, shape_depth_vertex;
extern const std::string_view bone_vertex, bone_depth_vertex;
extern const std::string_view bone_source;  ///< vertex: the surface of a round cone
extern const std::string_view glyph_fragment;
extern const std::string_view depth_fragment;

// shaders_overlay.cpp
extern const std::string_view nearer_source;  ///< vertex: positions drawn towards the eye
extern const std::string_view point_vertex, point_fragment;
extern const std::string_view line_vertex, line_fragment;
extern const std::string_view plane_vertex, plane_fragment;
extern const std::string_view ground_vertex, ground_fragment;

}  // namespace sinew::gl

#include "sinew/render/shaders.h"

namespace sinew::gl {

const std::string_view shape_vertex = R"glsl(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 x;
layout(location = 3) in vec3 y;
layout(location = 4) in vec3 z;
layout(location = 5) in vec3 origin;
layout(location = 6) in vec4 glyph_colour;
out vec3 world;
out vec3 eye;
out vec3 world_normal;
out vec4 surface_colour;
invariant gl_Position;

void main() {
    mat3 axes = mat3(x, y, z);
    world = axes * position + origin;
    // The inverse transpose but for a factor, which also is right where an axis is short.
    world_normal = normalize(mat3(cross(y, z), cross(z, x), cross(x, y)) * normal);
    surface_colour = glyph_colour;
    eye = (view * vec4(world, 1.0)).xyz;
    gl_Position = projection * vec4(eye, 1.0);
}
)glsl";

const std::string_view shape_depth_vertex = R"glsl(
layout(location = 0) in vec3 position;
layout(location = 2) in vec3 x;
layout(location = 3) in vec3 y;
layout(location = 4) in vec3 z;
layout(location = 5) in vec3 origin;
invariant gl_Position;
void main() {
    mat3 axes = mat3(x, y, z);
    vec3 world = axes * position + origin;
    vec3 eye = (view * vec4(world, 1.0)).xyz;
    gl_Position = projection * vec4(eye, 1.0);
}
)glsl";

// The template of a bone: turn.xy goes round the bone, turn.z along a part of it: 0 the ball at `from`, 1 the
// cone, 2 the ball at `to`. The cone touches both balls where their surface makes the angle `rim` with the
// bone. A flat end has the cone run to its equator and a disc for a ball.
const std::string_view bone_source = R"glsl(
layout(location = 0) in vec4 turn;
layout(location = 1) in vec4 from;
layout(location = 2) in vec4 to;
layout(location = 3) in vec4 glyph_colour;
layout(location = 4) in vec2 flat_end;

void bone_surface(out vec3 position, out vec3 normal) {
    vec3 along = to.xyz - from.xyz;
    float size = length(along);
    vec3 w = size > 0.0 ? along / size : vec3(0.0, 0.0, 1.0);
    vec3 u = normalize(abs(w.z) < 0.9 ? cross(w, vec3(0.0, 0.0, 1.0)) : cross(w, vec3(1.0, 0.0, 0.0)));
    vec3 round = turn.x * u + turn.y * cross(w, u);
    float rim = acos(clamp((from.w - to.w) / max(size, 1e-30), -1.0, 1.0));
    float equator = 1.57079633;
    float start = flat_end.x > 0.5 ? equator : rim;
    float stop = flat_end.y > 0.5 ? equator : rim;
    bool at_from = turn.z < 0.5 || (turn.z < 1.5 && turn.w < 0.5);
    float angle = turn.z < 0.5 ? mix(3.14159265, start, turn.w) : turn.z < 1.5 ? (at_from ? start : stop) : mix(stop, 0.0, turn.w);
    bool disc = turn.z < 0.5 ? flat_end.x > 0.5 : turn.z > 1.5 && flat_end.y > 0.5;
    float height = disc ? 0.0 : cos(angle);
    vec4 end = at_from ? from : to;
    position = end.xyz + end.w * (height * w + sin(angle) * round);
    normal = disc ? (at_from ? -w : w) : cos(angle) * w + sin(angle) * round;
    if (turn.z > 0.5 && turn.z < 1.5) normal = cos(rim) * w + sin(rim) * round;
}
)glsl";

const std::string_view bone_vertex = R"glsl(
out vec3 world;
out vec3 eye;
out vec3 world_normal;
out vec4 surface_colour;
invariant gl_Position;

void main() {
    bone_surface(world, world_normal);
    surface_colour = glyph_colour;
    eye = (view * vec4(world, 1.0)).xyz;
    gl_Position = projection * vec4(eye, 1.0);
}
)glsl";

const std::string_view bone_depth_vertex = R"glsl(
invariant gl_Position;
void main() {
    vec3 world, normal;
    bone_surface(world, normal);
    vec3 eye = (view * vec4(world, 1.0)).xyz;
    gl_Position = projection * vec4(eye, 1.0);
}
)glsl";

const std::string_view glyph_fragment = R"glsl(
in vec3 world;
in vec3 eye;
in vec3 world_normal;
in vec4 surface_colour;
out vec4 colour;

void main() {
    vec3 n = normalize(world_normal);
    vec2 seen = mesh_colour.a < 1.0 ? vec2(1.0) : visibility(world, n, grain(), 1.5);
    vec3 lit = shade(surface_colour.rgb, mat3(view) * n, towards_eye(eye), seen);
    colour = vec4(to_srgb(lit) * surface_colour.a, surface_colour.a);
}
)glsl";

const std::string_view depth_fragment = R"glsl(
void main() {}
)glsl";

}  // namespace sinew::gl

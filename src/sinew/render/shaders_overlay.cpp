#include "sinew/render/shaders.h"

namespace sinew::gl {

// Marks stand on the surface, some pixels nearer to the eye than it, so that it does not hide half of them.
const std::string_view nearer_source = R"glsl(
vec4 nearer(vec3 position, float pixels) {
    vec4 eye = view * vec4(position, 1.0);
    float pixel = 2.0 / (projection[1][1] * viewport.y);
    if (viewport.z > 0.5) eye.xyz *= 1.0 - min(pixels * pixel, 0.5);
    else eye.z += pixels * pixel;
    vec4 clip = projection * eye;
    clip.z = max(clip.z, -0.9999 * clip.w);  // not beyond the near plane
    return clip;
}
)glsl";

const std::string_view point_vertex = R"glsl(
layout(location = 0) in vec3 position;
layout(location = 1) in float size;
layout(location = 2) in vec4 mark_colour;
out vec4 fill_colour;
out float diameter;

void main() {
    fill_colour = mark_colour;
    diameter = size;
    gl_Position = nearer(position, size);
    gl_PointSize = size + 3.0;
}
)glsl";

const std::string_view point_fragment = R"glsl(
in vec4 fill_colour;
in float diameter;
out vec4 colour;

void main() {
    float from_centre = length(gl_PointCoord - 0.5) * (diameter + 3.0);
    float inner = 1.0 - smoothstep(0.5 * diameter - 1.0, 0.5 * diameter, from_centre);
    float outer = 1.0 - smoothstep(0.5 * diameter + 0.5, 0.5 * diameter + 1.5, from_centre);
    if (outer <= 0.0) discard;
    vec3 c = mix(vec3(1.0), fill_colour.rgb, inner);
    float a = outer * fill_colour.a;
    colour = vec4(c * a, a);
}
)glsl";

// A line is a strip of four vertices with a pixel more on each side for its soft edge. An end behind the eye
// is moved to just before it.
const std::string_view line_vertex = R"glsl(
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in float width;
layout(location = 3) in vec4 mark_colour;
out vec4 fill_colour;
out float across;
out float half_width;

void main() {
    fill_colour = mark_colour;
    vec4 a = nearer(from, 2.0 * width), b = nearer(to, 2.0 * width);
    float near = 1e-4 * extent.w;
    if (viewport.z > 0.5 && a.w < near && b.w > near) a = mix(a, b, (near - a.w) / (b.w - a.w));
    if (viewport.z > 0.5 && b.w < near && a.w > near) b = mix(b, a, (near - b.w) / (a.w - b.w));
    vec2 along = (b.xy / b.w - a.xy / a.w) * viewport.xy;
    vec2 side = length(along) > 0.0 ? normalize(vec2(-along.y, along.x)) : vec2(0.0, 1.0);
    half_width = 0.5 * width;
    across = (gl_VertexID % 2 == 0 ? -1.0 : 1.0) * (half_width + 1.0);
    gl_Position = gl_VertexID < 2 ? a : b;
    gl_Position.xy += side * across * 2.0 / viewport.xy * gl_Position.w;
}
)glsl";

const std::string_view line_fragment = R"glsl(
in vec4 fill_colour;
in float across;
in float half_width;
out vec4 colour;

void main() {
    float a = fill_colour.a * (1.0 - smoothstep(half_width - 0.5, half_width + 0.5, abs(across)));
    colour = vec4(fill_colour.rgb * a, a);
}
)glsl";

const std::string_view plane_vertex = R"glsl(
layout(location = 0) in vec3 origin;
layout(location = 1) in vec3 u;
layout(location = 2) in vec3 v;
layout(location = 3) in float cell;
layout(location = 4) in vec4 tint;
layout(location = 5) in vec4 line_colour;
layout(location = 6) in float fade;
out vec2 at;
flat out vec2 size;
flat out vec2 grid;
flat out vec4 plane_tint;
flat out vec4 plane_line;

void main() {
    vec2 corner = vec2(gl_VertexID % 2, gl_VertexID / 2) * 2.0 - 1.0;
    size = vec2(length(u), length(v));
    at = corner * size;
    grid = vec2(cell, fade);
    plane_tint = tint;
    plane_line = line_colour;
    gl_Position = projection * view * vec4(origin + corner.x * u + corner.y * v, 1.0);
}
)glsl";

// Every tenth grid line is stronger; lines fade where they would get denser than the pixels.
const std::string_view plane_fragment = R"glsl(
in vec2 at;
flat in vec2 size;
flat in vec2 grid;
flat in vec4 plane_tint;
flat in vec4 plane_line;
out vec4 colour;

float lines(float cell, float width) {
    vec2 step = fwidth(at) / cell;
    vec2 near = abs(fract(at / cell - 0.5) - 0.5) / max(step, 1e-6);
    vec2 covered = (1.0 - smoothstep(0.5 * width - 0.5, 0.5 * width + 0.5, near)) * (1.0 - smoothstep(0.15, 0.5, step));
    return max(covered.x, covered.y);
}

float border() {
    vec2 near = (size - abs(at)) / max(fwidth(at), 1e-6);
    return 1.0 - smoothstep(1.0, 2.0, min(near.x, near.y));
}

void main() {
    float strength = grid.x > 0.0 ? max(0.5 * lines(grid.x, 1.0), lines(10.0 * grid.x, 1.3)) : 0.0;
    if (grid.y == 0.0) strength = max(strength, border());
    float rim = grid.y > 0.0 ? 1.0 - smoothstep(0.35, 1.0, length(at / size)) : 1.0;
    float line_alpha = strength * plane_line.a * rim;
    float tint_alpha = plane_tint.a * rim * (1.0 - line_alpha);
    colour = vec4(plane_line.rgb * line_alpha + plane_tint.rgb * tint_alpha, line_alpha + tint_alpha);
    if (colour.a <= 0.0) discard;
}
)glsl";

// A ground that is seen by its shadow only: a grid, finest in the middle, so that what the few maps of the
// sky see is blended over its cells.
const std::string_view ground_vertex = R"glsl(
out float dark;

void main() {
    const int points = 129;
    vec2 place = 2.0 * vec2(gl_VertexID % points, gl_VertexID / points) / float(points - 1) - 1.0;
    vec3 world = vec3(extent.xy + 2.5 * extent.w * place * abs(place), style.z);
    gl_Position = projection * view * vec4(world, 1.0);
    vec2 seen = vec2(0.0);
    for (int i = 0; i < 3; ++i) seen += visibility(world, vec3(0.0, 0.0, 1.0), (float(i) + 0.3) / 3.0, 2.5 + float(i)) / 3.0;
    float hidden = 1.0 - (0.5 * seen.x + 0.5 * seen.y);
    dark = style.w * hidden * smoothstep(0.0, 0.25, hidden);  // what only few directions see is left out
    dark *= 1.0 - smoothstep(1.0, 2.4, length(world.xy - extent.xy) / extent.w);
}
)glsl";

const std::string_view ground_fragment = R"glsl(
in float dark;
out vec4 colour;

// The shadow ends before the picture does: pictures can be put side by side.
void main() {
    vec2 from_edge = min(gl_FragCoord.xy, viewport.xy - gl_FragCoord.xy) / min(viewport.x, viewport.y);
    float a = dark * smoothstep(0.0, 0.1, min(from_edge.x, from_edge.y));
    colour = vec4(vec3(0.05, 0.05, 0.07) * a, a);
}
)glsl";

}  // namespace sinew::gl

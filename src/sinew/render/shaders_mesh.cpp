#include "sinew/render/shaders.h"

namespace sinew::gl {

const std::string_view mesh_vertex = R"glsl(
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;
layout(location = 2) in vec4 face_normal;
layout(location = 3) in vec2 place;
layout(location = 4) in float part;
out vec3 world;
out vec3 eye;
out vec3 world_normal;
out vec2 face_place;
flat out int face_part;
flat out int flat_shading;
invariant gl_Position;

void main() {
    flat_shading = style.x > 1.5 ? 1 : 0;
    world = position;
    world_normal = flat_shading == 1 ? face_normal.xyz : normal.xyz;
    face_place = place;
    face_part = int(part + 0.5);
    eye = (view * vec4(position, 1.0)).xyz;
    gl_Position = projection * vec4(eye, 1.0);
}
)glsl";

const std::string_view mesh_depth_vertex = R"glsl(
layout(location = 0) in vec3 position;
invariant gl_Position;
void main() {
    vec3 eye = (view * vec4(position, 1.0)).xyz;
    gl_Position = projection * vec4(eye, 1.0);
}
)glsl";

// The wire: `place` runs linearly over each triangle, so its gradient turns it into a distance in pixels.
// Lines fade where faces get as small as the lines.
const std::string_view mesh_fragment = R"glsl(
in vec3 world;
in vec3 eye;
in vec3 world_normal;
in vec2 face_place;
flat in int face_part;
flat in int flat_shading;
out vec4 colour;

float line(float distance_in_face, float gradient) {
    float pixels = distance_in_face / max(gradient, 1e-6);
    float covered = 1.0 - smoothstep(0.5 * style.y - 0.5, 0.5 * style.y + 0.5, pixels);
    return covered * (1.0 - smoothstep(0.12, 0.40, gradient));
}
float slope(float x) { return length(vec2(dFdx(x), dFdy(x))); }

float wire() {
    float u = face_place.x, v = face_place.y, w = 1.0 - u - v;
    float su = slope(u), sv = slope(v), sw = slope(w);
    if (face_part == 0) return max(line(min(u, 1.0 - u), su), line(min(v, 1.0 - v), sv));
    if (face_part == 1) return max(max(line(u, su), line(v, sv)), line(w, sw));
    return line(u, su);
}

void main() {
    float covered = wire();
    vec3 n = normalize(world_normal);
    vec3 v = towards_eye(eye);
    vec3 n_eye = mat3(view) * n;
    float inside = gl_FrontFacing ? 1.0 : 0.0;
    if (inside == 0.0) { n = -n; n_eye = -n_eye; }
    vec3 base = mix(mesh_colour.rgb * vec3(0.75, 0.55, 0.5), mesh_colour.rgb, inside);
    vec3 lit = style.x > 0.5 && style.x < 1.5 ? matcap(base, n_eye) : shade(base, n_eye, v, visibility(world, n, grain(), 1.5));
    float opacity = mesh_colour.a;
    if (opacity < 1.0) opacity = mix(opacity, 1.0, 0.6 * pow(1.0 - abs(dot(n_eye, v)), 2.0));
    vec3 surface = mix(to_srgb(lit), wire_colour.rgb, covered * wire_colour.a);
    opacity = mix(opacity, max(opacity, wire_colour.a), covered * wire_colour.a);
    colour = vec4(surface * opacity, opacity);
}
)glsl";

}  // namespace sinew::gl

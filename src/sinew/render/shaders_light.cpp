#include "sinew/render/shaders.h"

namespace sinew::gl {

// Must agree with FrameBlock.
const std::string_view frame_source = R"glsl(
layout(std140) uniform Frame {
    mat4 view;
    mat4 projection;
    vec4 viewport;
    vec4 up;
    vec4 key;
    vec4 fill;
    vec4 rim;
    vec4 mesh_colour;
    vec4 wire_colour;
    vec4 style;
    vec4 extent;
};
)glsl";

// Must agree with SkyBlock. A surface sees the share of the maps in which nothing lies before it. The offset
// along the normal keeps a surface from shading itself.
const std::string_view sky_source = R"glsl(
layout(std140) uniform Sky {
    vec4 sky_direction[96];
    vec4 sky_rows[288];
    int sky_key_count;
    int sky_count;
    float sky_texel;
};
uniform sampler2DArrayShadow sky_depth;

float sky_seen(int map, vec3 world, vec3 normal, vec2 shift) {
    vec4 p = vec4(world + normal * (2.5 * sky_texel), 1.0);
    vec3 at = vec3(dot(sky_rows[3 * map], p), dot(sky_rows[3 * map + 1], p), dot(sky_rows[3 * map + 2], p));
    return texture(sky_depth, vec4(at.xy + shift, float(map), at.z));
}

// x: share of the key light, y: share of the sky, both 1 where nothing is in the way.
// `grain` in 0..1 moves the look-ups about by `texels`, so that what few maps see has soft edges.
vec2 visibility(vec3 world, vec3 normal, float grain, float texels) {
    if (viewport.w == 0.0) return vec2(1.0);
    float turn = 6.2831853 * grain;
    vec2 shift = vec2(cos(turn), sin(turn)) * (texels / 512.0);
    float key_sum = 0.0;
    mat2 golden = mat2(-0.7373, 0.6755, -0.6755, -0.7373);
    for (int i = 0; i < sky_key_count; ++i) {
        key_sum += sky_seen(i, world, normal, shift);
        shift = golden * shift;
    }
    float seen = 0.15, all = 0.15;
    for (int i = sky_key_count; i < sky_count; ++i) {
        shift = golden * shift;
        float weight = dot(sky_direction[i].xyz, normal);
        if (weight <= 0.0) continue;
        all += weight;
        seen += weight * sky_seen(i, world, normal, shift);
    }
    return vec2(key_sum / float(max(sky_key_count, 1)), seen / all);
}
)glsl";

const std::string_view light_source = R"glsl(
vec3 to_linear(vec3 c) { return pow(c, vec3(2.2)); }
vec3 to_srgb(vec3 c) { return pow(max(c, 0.0), vec3(1.0 / 2.2)); }

// Leaves dark and middle tones alone and rolls off what is brighter.
vec3 tone(vec3 c) {
    vec3 over = max(c - 0.7, 0.0);
    return min(c, 0.7) + 0.3 * (1.0 - exp(-over / 0.3));
}

// GGX for a dull plastic; a little of it makes the form readable.
float gloss(vec3 n, vec3 l, vec3 v, float roughness) {
    vec3 h = normalize(l + v);
    float a2 = pow(roughness, 4.0);
    float nh = max(dot(n, h), 0.0);
    float d = nh * nh * (a2 - 1.0) + 1.0;
    float fresnel = 0.04 + 0.96 * pow(1.0 - max(dot(v, h), 0.0), 5.0);
    return fresnel * a2 / (4.0 * d * d) * max(dot(n, l), 0.0);
}

// A soft key from the upper left, a weak fill from the right, a rim from behind, the sky above and the ground below.
vec3 shade(vec3 base, vec3 n, vec3 v, vec2 seen) {
    float height = 0.5 + 0.5 * dot(n, up.xyz);
    vec3 ambient = mix(vec3(0.16, 0.145, 0.14), vec3(0.38, 0.41, 0.47), height) * seen.y;
    vec3 key_colour = vec3(1.0, 0.96, 0.90) * key.w * seen.x;
    vec3 fill_colour = vec3(0.80, 0.88, 1.0) * fill.w * mix(0.35, 1.0, seen.y);
    vec3 light = ambient + key_colour * max(dot(n, key.xyz), 0.0) + fill_colour * max(dot(n, fill.xyz), 0.0);
    float edge = pow(1.0 - max(dot(n, v), 0.0), 3.0);
    vec3 rim_light = vec3(0.9, 0.95, 1.0) * rim.w * edge * max(0.3 + dot(n, rim.xyz), 0.0) * seen.y;
    vec3 shine = key_colour * gloss(n, key.xyz, v, 0.5) + fill_colour * gloss(n, fill.xyz, v, 0.6);
    return tone(to_linear(base) * (light + rim_light) + shine);
}

// A ball of light and colour that the normal points into: tells forms apart where lighting is too even.
vec3 matcap(vec3 base, vec3 n) {
    float above = 0.5 + 0.5 * n.y;
    float side = 0.5 + 0.5 * n.x;
    float core = smoothstep(0.0, 1.0, n.z);
    vec3 c = mix(vec3(0.10, 0.09, 0.13), vec3(0.62, 0.57, 0.52), smoothstep(0.05, 0.95, above * 0.75 + (1.0 - side) * 0.25));
    c += vec3(0.30, 0.36, 0.46) * pow(1.0 - core, 2.5) * smoothstep(0.35, 1.0, side);
    c += vec3(0.55, 0.52, 0.48) * pow(max(dot(n, normalize(vec3(-0.45, 0.62, 0.64))), 0.0), 24.0);
    return tone(c * to_linear(base) * 1.9);
}

// Interleaved gradient noise: even, and the same on every run.
float grain() { return fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))); }

vec3 towards_eye(vec3 eye_position) { return viewport.z > 0.5 ? normalize(-eye_position) : vec3(0.0, 0.0, 1.0); }
)glsl";

}  // namespace sinew::gl

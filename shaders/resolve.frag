// From ids, normals and depths to colours: light, ambient occlusion, edges, translucent layers,
// background.
#include "shaders/layout.glsl"
#include "solvers/prelude.glsl"
#include "shaders/camera.glsl"
#include "shaders/normals.glsl"
#include "shaders/shading.glsl"

layout(binding = 0) uniform usampler2D part_picture;
layout(binding = 1) uniform usampler2D normal_picture;
layout(binding = 2) uniform sampler2D depth_picture;
layout(binding = 3) uniform sampler2D translucent_picture;
layout(binding = 4) uniform sampler2D revealed_picture;
layout(std430, binding = binding_part_materials) readonly buffer PartMaterials {
    uint part_materials[];
};
layout(std430, binding = binding_materials) readonly buffer Materials {
    vec4 materials[];
};
layout(location = 0) out vec4 out_colour;

// A pixel's surface: where it is relative to the eye, in view axes (right, up, back).
vec3 position_at(ivec2 pixel) {
    float value = texelFetch(depth_picture, pixel, 0).r;
    vec2 half_size = vec2(camera.half_width, camera.half_height);
    float step = float(camera.step);
    float depth = value > 0.0 ? depth_from_buffer(value) : 1e9;
    float scale = camera.orthographic != 0 ? step : step * depth;
    return vec3((vec2(pixel) + 0.5 - half_size) * scale, -depth);
}

ivec2 inside(ivec2 pixel) {
    return clamp(pixel, ivec2(0), textureSize(depth_picture, 0) - 1);
}

const int occlusion_samples = 12;
const float occlusion_radius_px = 18.0;

// How much of the sky a point sees: neighbours on a spiral that rise above its plane hide some of
// it.
float openness_at(ivec2 pixel, vec3 here, vec3 view_normal) {
    float turn =
        fract(52.9829189 * fract(dot(vec2(pixel), vec2(0.06711056, 0.00583715)))) * 6.2831853;
    float footprint = float(camera.step) * (camera.orthographic != 0 ? 1.0 : -here.z);
    float reach = occlusion_radius_px * footprint;
    float hidden = 0.0;
    for (int i = 0; i < occlusion_samples; ++i) {
        float part = (float(i) + 0.5) / float(occlusion_samples);
        float angle = turn + float(i) * 2.3999632;
        ivec2 offset = ivec2(occlusion_radius_px * part * vec2(cos(angle), sin(angle)));
        vec3 to = position_at(inside(pixel + offset)) - here;
        float distance2 = dot(to, to);
        float rise = dot(to, view_normal) * inversesqrt(distance2 + 1e-12) - 0.08;
        hidden += max(rise, 0.0) / (1.0 + distance2 / (reach * reach));
    }
    return clamp(1.0 - 1.6 * hidden / float(occlusion_samples), 0.0, 1.0);
}

// 0 to 1: how much the picture bends here, by the second difference of depth and the change of
// normals. Parts that join smoothly have neither, whatever their ids.
float edge_at(ivec2 pixel, vec3 here, vec3 normal) {
    float footprint = float(camera.step) * (camera.orthographic != 0 ? 1.0 : -here.z);
    float edge = 0.0;
    for (int axis = 0; axis < 2; ++axis) {
        ivec2 next = axis == 0 ? ivec2(1, 0) : ivec2(0, 1);
        float before = position_at(inside(pixel - next)).z;
        float after = position_at(inside(pixel + next)).z;
        float slope = max(abs(normal.z), 0.15);
        float bend = (2.0 * here.z - before - after) * slope / footprint;
        edge = max(edge, smoothstep(1.5, 4.0, bend));
        vec3 other = normal_from(texelFetch(normal_picture, inside(pixel + next), 0).r);
        vec3 own = normal_from(texelFetch(normal_picture, pixel, 0).r);
        edge = max(edge,
                   0.6 * smoothstep(0.25, 0.7, 1.0 - abs(dot(own, other))) * step(abs(bend), 1e3));
    }
    return edge;
}

vec3 background(ivec2 pixel) {
    float height = (float(pixel.y) + 0.5) / (2.0 * float(camera.half_height));
    return mix(vec3(0.60, 0.63, 0.66), vec3(0.86, 0.88, 0.90), smoothstep(0.0, 1.0, height));
}

vec3 surface_colour(ivec2 pixel, uint part) {
    vec3 normal = normal_from(texelFetch(normal_picture, pixel, 0).r);
    vec3 here = position_at(pixel);
    mat3 world_from_view = mat3(vec3(camera.right.xyz), vec3(camera.up.xyz), vec3(camera.back.xyz));
    vec3 towards =
        camera.orthographic != 0 ? world_from_view[2] : normalize(world_from_view * -here);
    if (dot(normal, towards) < 0.0) {
        normal = -normal;
    }
    vec3 view_normal = normal * world_from_view;
    float openness = camera.occlusion != 0u ? openness_at(pixel, here, view_normal) : 1.0;
    vec3 colour = materials[part_materials[part]].rgb;
    if (part == camera.selected) {
        colour = mix(colour, vec3(1.0, 0.45, 0.05), 0.75);
    }
    colour = lit(colour, normal, towards, openness);
    if (camera.edges != 0u) {
        colour *= 1.0 - 0.55 * edge_at(pixel, here, view_normal);
    }
    return colour;
}

layout(location = 0) uniform bool see_through_background;
layout(location = 1) uniform bool has_translucent;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    uint part = texelFetch(part_picture, pixel, 0).r;
    bool empty = part == no_part;
    vec3 colour = empty ? background(pixel) : surface_colour(pixel, part);
    float alpha = empty && see_through_background ? 0.0 : 1.0;
    float revealed = has_translucent ? texelFetch(revealed_picture, pixel, 0).r : 1.0;
    if (revealed < 1.0) {
        vec4 sum = texelFetch(translucent_picture, pixel, 0);
        colour = mix(sum.rgb / max(sum.a, 1e-6), colour, revealed);
        alpha = max(alpha, 1.0 - revealed);
    }
    out_colour = vec4(srgb(colour), alpha);
}

// The camera block, and the maps between view depth, the depth buffer and clip space.
#include "shaders/picture.glsl"

layout(std140, binding = binding_camera) uniform CameraUniform {
    CameraBlock camera;
};

// Reversed: 1 at the near plane, 0 at infinity. Orthographic depths are counted from the focus:
// before it linear, behind it as in perspective, with the picture's height for a unit, so that
// float keeps its digits where one looks, however far away the eye is. A convex function of depth.
float buffer_depth(float depth) {
    if (camera.orthographic != 0) {
        return focused(depth / camera.height) / focused(camera.near_from_focus / camera.height);
    }
    return camera.near_from_eye / depth;
}

float depth_from_buffer(float value) {
    if (camera.orthographic != 0) {
        float nearest = focused(camera.near_from_focus / camera.height);
        return camera.height * unfocused(value * nearest);
    }
    return camera.near_from_eye / value;
}

// Clip coordinates of a world point given relative to the eye. In orthographic views their depth
// only serves to clip: fragments write buffer_depth(), which is not linear.
vec4 clip_from_eye(dvec3 p) {
    dvec2 half_size = dvec2(camera.half_width, camera.half_height) * camera.step;
    double depth = -dot(camera.back.xyz, p);
    dvec2 xy = dvec2(dot(camera.right.xyz, p), dot(camera.up.xyz, p)) / half_size;
    dvec2 jitter =
        dvec2(camera.jitter_x, camera.jitter_y) / dvec2(camera.half_width, camera.half_height);
    if (camera.orthographic != 0) {
        double z = (camera.far_depth - depth) / (camera.far_depth - camera.near_depth);
        return vec4(xy - jitter, z, 1.0);
    }
    return vec4(xy - depth * jitter, camera.near_depth, depth);
}

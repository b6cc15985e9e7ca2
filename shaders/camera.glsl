// The camera block, and the maps between view depth, the depth buffer and clip space.
layout(std140, binding = binding_camera) uniform CameraUniform {
    CameraBlock camera;
};

// Reversed: 1 at the near plane, 0 at infinity (perspective) or at the far plane (orthographic).
float buffer_depth(float depth) {
    float near_depth = float(camera.near_depth);
    float far_depth = float(camera.far_depth);
    return camera.orthographic != 0 ? (far_depth - depth) / (far_depth - near_depth)
                                    : near_depth / depth;
}

float depth_from_buffer(float value) {
    float near_depth = float(camera.near_depth);
    float far_depth = float(camera.far_depth);
    return camera.orthographic != 0 ? far_depth - value * (far_depth - near_depth)
                                    : near_depth / value;
}

// Clip coordinates of a world point given relative to the eye.
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

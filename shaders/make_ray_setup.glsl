// Makes the rays' set-up in the vertex shader, in double; ray_setup.glsl says what it holds.
dvec3 across_picture(dvec2 offset_px) {
    return offset_px.x * camera.step * camera.right.xyz + offset_px.y * camera.step * camera.up.xyz;
}

// centre is the part's origin relative to the eye; low and high its local box.
RaySetup make_ray_setup(dvec3 centre, dvec4 rotation, dvec3 low, dvec3 high) {
    dvec2 half_size = dvec2(camera.half_width, camera.half_height);
    dvec2 jitter = dvec2(camera.jitter_x, camera.jitter_y);
    bool parallel = camera.orthographic != 0;

    // The part's point nearest to the eye: where the most digits are needed.
    dvec3 eye = turn_back(rotation, -centre);
    dvec3 nearest = centre + turn(rotation, clamp(eye, low, high));
    double depth = -dot(camera.back.xyz, nearest);
    dvec2 in_picture =
        dvec2(dot(camera.right.xyz, nearest), dot(camera.up.xyz, nearest)) / camera.step;
    dvec2 pixel = half_size;
    if (parallel) {
        pixel += in_picture;
    } else if (depth > camera.near_depth) {
        pixel += in_picture / depth;
    } else {
        depth = 0.0;
    }
    pixel = floor(clamp(pixel, dvec2(0.0), 2.0 * half_size - 1.0)) + 0.5;

    dvec3 offset = across_picture(pixel - half_size + jitter);
    dvec3 direction = -camera.back.xyz + (parallel ? dvec3(0.0) : offset);
    dvec3 origin = (parallel ? offset : dvec3(0.0)) + depth * direction;

    RaySetup setup;
    setup.origin = vec3(eye + turn_back(rotation, origin));
    setup.direction = vec3(turn_back(rotation, direction));
    setup.step_x = vec3(turn_back(rotation, across_picture(dvec2(1.0, 0.0))));
    setup.step_y = vec3(turn_back(rotation, across_picture(dvec2(0.0, 1.0))));
    setup.pixel = vec2(pixel);
    setup.depth = float(depth - camera.focus_depth);
    setup.pixel_size = float(camera.step * (parallel ? 1.0 : max(depth, camera.near_depth)));
    return setup;
}

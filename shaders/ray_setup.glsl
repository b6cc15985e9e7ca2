// Rays of a part's pixels, in its local frame, with all of float's digits however far the eye and
// the plant's origin are.
//
// Near the part a reference pixel and a reference depth are chosen, and the ray's point there is
// computed in double, once for each vertex. Every pixel's ray is then that point and direction plus
// its offset in pixels times a step: small numbers times small numbers. The parameter of a ray is
// its view depth.
struct RaySetup {
    vec3 origin;     // of the reference pixel's ray at the reference depth
    vec3 direction;  // for one metre of depth
    vec3 step_x;     // of the direction (perspective) or the origin (orthographic) for one pixel
    vec3 step_y;
    vec2 pixel;        // the reference pixel's centre
    float depth;       // the reference depth, from the focus
    float pixel_size;  // a pixel's width at the reference depth
};

Ray ray_of(RaySetup setup, vec2 pixel) {
    vec2 offset_px = pixel - setup.pixel;
    vec3 offset = offset_px.x * setup.step_x + offset_px.y * setup.step_y;
    bool parallel = camera.orthographic != 0;
    Ray ray;
    ray.origin = setup.origin + (parallel ? offset : setup.depth * offset);
    ray.direction = setup.direction + (parallel ? vec3(0.0) : offset);
    ray.first = camera.near_from_focus - setup.depth;
    ray.pixel = setup.pixel_size;
    return ray;
}

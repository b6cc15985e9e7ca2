// Records what a pixel's rays cost, and one of them, for frames that look inside the solvers.
layout(r32ui, binding = image_counts) uniform uimage2D ray_counts;
layout(rgba32f, binding = image_ray_origins) writeonly uniform image2D ray_origins;
layout(rgba32f, binding = image_ray_directions) writeonly uniform image2D ray_directions;
layout(r32f, binding = image_ray_pixels) writeonly uniform image2D ray_pixels;

// Counted also where it misses. Where several parts' rays cross a pixel, the last of them stays.
void record_ray(Ray ray, Hit found) {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    imageAtomicAdd(ray_counts, pixel, (1u << ray_shift) + uint(found.steps));
    imageStore(ray_origins, pixel, vec4(ray.origin, ray.first));
    imageStore(ray_directions, pixel, vec4(ray.direction, found.found ? found.t : -huge));
    imageStore(ray_pixels, pixel, vec4(ray.pixel));
}

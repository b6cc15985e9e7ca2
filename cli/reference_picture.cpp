// Casts a ray for each pixel on the CPU.
#include "cli/reference_picture.h"

#include "cli/picture.h"
#include "cli/signals.h"
#include "scene/compare.h"
#include "scene/rows.h"

#include <cmath>
#include <limits>

namespace quartic::cli {
namespace {

constexpr glm::vec3 background{0.80f, 0.84f, 0.88f};  // linear
constexpr double ambient = 0.15;

GBuffer empty_picture(PixelSize size) {
    const std::size_t count = pixel_count(size);
    GBuffer picture;
    picture.size = size;
    picture.ids.assign(count, no_index);
    picture.depth_m.assign(count, std::numeric_limits<float>::infinity());
    picture.normals.assign(count, glm::vec3(0.0f));
    picture.colours.assign(4 * count, 255);
    return picture;
}

glm::vec3 lit_colour(const Scene& scene, const ReferenceHit& hit, const f64::Ray& ray) {
    const double facing = std::abs(glm::dot(hit.normal, glm::normalize(ray.direction)));
    const Part& part = scene.parts[hit.part];
    const glm::vec4 colour = part.material < scene.materials.size()
                                 ? scene.materials[part.material].colour
                                 : Material().colour;
    return glm::vec3(colour) * static_cast<float>(ambient + (1.0 - ambient) * facing);
}

void draw_pixel(const Scene& scene, const Reference& reference, const f64::Ray& ray,
                std::size_t pixel, GBuffer& picture) {
    const ReferenceHit hit = reference.trace(ray);
    glm::vec3 colour = background;
    if (hit.part != no_index) {
        picture.ids[pixel] = hit.part;
        picture.depth_m[pixel] = static_cast<float>(hit.t);
        picture.normals[pixel] = glm::vec3(hit.normal);
        colour = lit_colour(scene, hit, ray);
    }
    picture.colours[4 * pixel] = srgb_of(colour.x);
    picture.colours[4 * pixel + 1] = srgb_of(colour.y);
    picture.colours[4 * pixel + 2] = srgb_of(colour.z);
}

}  // namespace

GBuffer draw_reference(const Scene& scene, const Reference& reference, const View& view,
                       glm::dvec2 jitter_px) {
    GBuffer picture = empty_picture(view.size);
    const auto draw_row = [&](int y) {
        for (int x = 0; x < view.size.width; ++x) {
            const f64::Ray ray = pixel_ray(view, x + 0.5 + jitter_px.x, y + 0.5 + jitter_px.y);
            draw_pixel(scene, reference, ray, pixel_index(view.size, x, y), picture);
        }
    };
    for_each_row(view.size.height, draw_row, is_interrupted);
    return picture;
}

}  // namespace quartic::cli

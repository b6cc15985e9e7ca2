// Casts a ray for each pixel on the CPU.
#include "cli/reference_picture.h"

#include "cli/picture.h"
#include "cli/signals.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <thread>
#include <vector>

namespace quartic::cli {
namespace {

constexpr glm::vec3 background{0.80f, 0.84f, 0.88f};  // linear
constexpr double ambient = 0.15;

GBuffer empty_picture(PixelSize size) {
    const std::size_t count =
        static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
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
    std::atomic<int> next_row{0};
    const auto draw_rows = [&] {
        for (int y = next_row++; y < view.size.height && !is_interrupted(); y = next_row++) {
            for (int x = 0; x < view.size.width; ++x) {
                const f64::Ray ray = pixel_ray(view, x + 0.5 + jitter_px.x, y + 0.5 + jitter_px.y);
                const auto pixel =
                    static_cast<std::size_t>(y) * static_cast<std::size_t>(view.size.width) +
                    static_cast<std::size_t>(x);
                draw_pixel(scene, reference, ray, pixel, picture);
            }
        }
    };
    std::vector<std::thread> threads(std::max(1u, std::thread::hardware_concurrency()));
    for (std::thread& thread : threads) {
        thread = std::thread(draw_rows);
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    return picture;
}

}  // namespace quartic::cli

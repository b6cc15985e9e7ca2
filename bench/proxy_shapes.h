// What the benchmark of proxies draws: one of each shape, and pictures full of many.
#pragma once

#include "scene/camera.h"
#include "scene/scene.h"

#include <string>
#include <vector>

namespace quartic {

struct ProxyShape {
    std::string name;
    Scene scene;        // one, unmoved
    glm::dvec3 centre;  // of its box
    double radius;      // of the sphere around that centre that holds it
};

std::vector<ProxyShape> make_proxy_shapes();

// From a random side, turned at random about the line of sight; the same for the same number. The
// eye is so many radii from the centre.
Camera random_camera(const ProxyShape& shape, int number, double distance);

// So that the sphere around the shape just fills the height of the picture.
void zoom_to(const ProxyShape& shape, Camera& camera);

struct ProxyGrid {
    Scene scene;
    Camera camera;
    double seen_px;  // mean of what shaders/cull.comp takes for the parts' sizes
};

// One layer of copies at random angles across the picture: the spheres around them have a diameter
// of so many pixels, and touch.
ProxyGrid make_proxy_grid(const ProxyShape& shape, int diameter_px, PixelSize size);

}  // namespace quartic

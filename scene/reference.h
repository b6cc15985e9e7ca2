// The oracle: a ray caster in double over the scene, on the texts that the GPU runs. Also a
// renderer without a GPU.
#pragma once

#include "scene/camera.h"

#include <memory>

namespace quartic {

struct ReferenceHit {
    std::uint32_t part = no_index;
    double t = 0.0;
    glm::dvec3 normal{0.0};  // world, unit, out of the solid
};

// Keeps a reference to the scene, which must outlive it and not change.
class Reference {
public:
    explicit Reference(const Scene& scene, const std::array<bool, layer_count>& layers,
                       int solver = 0);
    Reference(Reference&&) noexcept;
    ~Reference();

    // The nearest hit at t >= ray.first, or none (part == no_index). World coordinates. Safe from
    // several threads.
    ReferenceHit trace(const f64::Ray& ray) const;

    // The hit with this part alone.
    ReferenceHit trace_part(const f64::Ray& ray, std::uint32_t part) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace quartic

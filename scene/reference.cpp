// The reference ray caster: Embree finds candidate parts by their boxes, the shared texts in double
// decide.
#include "scene/reference.h"

#include "diagnostics/check.h"
#include "solvers/solver_table.h"

#include <embree3/rtcore.h>

#include <cmath>
#include <limits>

namespace quartic {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

glm::dvec3 turn_back(const glm::dquat& rotation, const glm::dvec3& v) {
    return glm::conjugate(rotation) * v;
}

// A triangle's hit by Moeller and Trumbore (1997), from both sides.
ReferenceHit hit_triangle(const f64::Ray& ray, const Mesh& mesh, std::size_t first_index) {
    const std::uint32_t* corner = &mesh.indices[first_index];
    const glm::dvec3 a(mesh.positions[corner[0]]);
    const glm::dvec3 ab = glm::dvec3(mesh.positions[corner[1]]) - a;
    const glm::dvec3 ac = glm::dvec3(mesh.positions[corner[2]]) - a;
    const glm::dvec3 across = glm::cross(ray.direction, ac);
    const double determinant = glm::dot(ab, across);
    ReferenceHit hit;
    hit.t = infinity;
    if (determinant == 0.0) {
        return hit;
    }
    const glm::dvec3 from = ray.origin - a;
    const double u = glm::dot(from, across) / determinant;
    const glm::dvec3 q = glm::cross(from, ab);
    const double v = glm::dot(ray.direction, q) / determinant;
    const double t = glm::dot(ac, q) / determinant;
    if (u < 0.0 || v < 0.0 || u + v > 1.0 || t < ray.first) {
        return hit;
    }
    hit.t = t;
    hit.normal = glm::normalize((1.0 - u - v) * glm::dvec3(mesh.normals[corner[0]]) +
                                u * glm::dvec3(mesh.normals[corner[1]]) +
                                v * glm::dvec3(mesh.normals[corner[2]]));
    return hit;
}

ReferenceHit hit_mesh(const f64::Ray& ray, const Mesh& mesh) {
    ReferenceHit nearest;
    nearest.t = infinity;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const ReferenceHit hit = hit_triangle(ray, mesh, i);
        if (hit.t < nearest.t) {
            nearest = hit;
        }
    }
    return nearest;
}

// What one query carries through Embree, whose own ray is in float and only used to find boxes.
struct Query {
    RTCIntersectContext context;
    f64::Ray ray;  // world
    ReferenceHit nearest;
};

}  // namespace

struct Reference::State {
    const Scene* scene = nullptr;
    int solver = solver_default;
    glm::dvec3 origin{0.0};  // Embree's floats are relative to it
    double slack = 0.0;      // by which boxes are wider, for float's error
    std::vector<std::uint32_t> parts;
    std::vector<Box3> boxes;
    RTCDevice device = nullptr;
    RTCScene bvh = nullptr;

    ~State() {
        rtcReleaseScene(bvh);
        rtcReleaseDevice(device);
    }

    ReferenceHit trace_part(const f64::Ray& world, std::uint32_t id) const {
        const Part& part = scene->parts[id];
        const glm::dquat& rotation = part.placement.rotation;
        f64::Ray ray{turn_back(rotation, world.origin - part.placement.position),
                     turn_back(rotation, world.direction), world.first, world.pixel};
        // Measured from near the part, as the kernel asks.
        const double shift =
            -glm::dot(ray.origin, ray.direction) / glm::dot(ray.direction, ray.direction);
        ray.origin += shift * ray.direction;
        ray.first -= shift;
        ReferenceHit hit;
        if (part.type == ShapeType::mesh) {
            hit = hit_mesh(ray, scene->meshes[part.shape]);
        } else {
            visit_shape(scene->shapes, part.type, part.shape, [&](const auto& shape) {
                const int own = solver_of(*scene, part, solver);
                const f64::Hit found = f64().hit(shape, ray, part.open_ends, own);
                hit.t = found.found ? found.t : infinity;
                hit.normal = found.normal;
            });
        }
        if (hit.t == infinity) {
            return {};
        }
        return {id, hit.t + shift, rotation * hit.normal};
    }

    static void box_callback(const RTCBoundsFunctionArguments* arguments) {
        const State& state = *static_cast<const State*>(arguments->geometryUserPtr);
        const Box3& box = state.boxes[arguments->primID];
        const glm::vec3 low(box.low - state.origin - state.slack);
        const glm::vec3 high(box.high - state.origin + state.slack);
        *arguments->bounds_o = {low.x, low.y, low.z, 0.0f, high.x, high.y, high.z, 0.0f};
    }

    static void hit_callback(const RTCIntersectFunctionNArguments* arguments) {
        if (arguments->valid[0] == 0) {
            return;
        }
        const State& state = *static_cast<const State*>(arguments->geometryUserPtr);
        Query& query = *reinterpret_cast<Query*>(arguments->context);
        const ReferenceHit hit = state.trace_part(query.ray, state.parts[arguments->primID]);
        const bool nearer =
            hit.part != no_index && (query.nearest.part == no_index || hit.t < query.nearest.t ||
                                     (hit.t == query.nearest.t && hit.part < query.nearest.part));
        if (!nearer) {
            return;
        }
        query.nearest = hit;
        // Later candidates must still be seen where float rounds this depth.
        auto* ray_hit = reinterpret_cast<RTCRayHit*>(arguments->rayhit);
        const double from_start = hit.t - query.ray.first;
        ray_hit->ray.tfar = static_cast<float>(from_start * (1.0 + 1e-5) + state.slack);
        ray_hit->hit.geomID = arguments->geomID;
        ray_hit->hit.primID = arguments->primID;
    }
};

Reference::Reference(const Scene& scene, const std::array<bool, layer_count>& layers, int solver)
    : state_(std::make_unique<State>()) {
    State& state = *state_;
    state.scene = &scene;
    state.solver = solver;
    Box3 all;
    for (std::uint32_t id = 0; id < scene.parts.size(); ++id) {
        const Box3 box = world_bounds(scene, scene.parts[id]);
        if (!layers[static_cast<std::size_t>(scene.parts[id].layer)] || box.empty()) {
            continue;
        }
        state.parts.push_back(id);
        state.boxes.push_back(box);
        all.low = glm::min(all.low, box.low);
        all.high = glm::max(all.high, box.high);
    }
    state.origin = all.empty() ? glm::dvec3(0.0) : 0.5 * (all.low + all.high);
    // Eyes may be several extents away; float directions err by 6e-8 of that.
    state.slack =
        all.empty() ? 0.0 : 1e-5 * glm::length(all.high - all.low) + 2.0 * f64().joint_overlap_max;
    state.device = rtcNewDevice(nullptr);
    CHECK(state.device != nullptr);
    state.bvh = rtcNewScene(state.device);
    RTCGeometry geometry = rtcNewGeometry(state.device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(state.parts.size()));
    rtcSetGeometryUserData(geometry, &state);
    rtcSetGeometryBoundsFunction(
        geometry,
        [](const RTCBoundsFunctionArguments* arguments) { State::box_callback(arguments); },
        nullptr);
    rtcSetGeometryIntersectFunction(geometry, [](const RTCIntersectFunctionNArguments* arguments) {
        State::hit_callback(arguments);
    });
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(state.bvh, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(state.bvh);
}

Reference::Reference(Reference&&) noexcept = default;
Reference::~Reference() = default;

ReferenceHit Reference::trace(const f64::Ray& ray) const {
    Query query{};
    rtcInitIntersectContext(&query.context);
    query.ray = ray;
    RTCRayHit ray_hit{};
    // From the near plane on, which in orthographic views may lie behind the eye: Embree's rays
    // start at 0.
    const glm::vec3 start(ray.origin + ray.first * ray.direction - state_->origin);
    const glm::vec3 direction(ray.direction);
    ray_hit.ray.org_x = start.x;
    ray_hit.ray.org_y = start.y;
    ray_hit.ray.org_z = start.z;
    ray_hit.ray.dir_x = direction.x;
    ray_hit.ray.dir_y = direction.y;
    ray_hit.ray.dir_z = direction.z;
    ray_hit.ray.tnear = 0.0f;
    ray_hit.ray.tfar = std::numeric_limits<float>::infinity();
    ray_hit.ray.mask = ~0u;
    ray_hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(state_->bvh, &query.context, &ray_hit);
    return query.nearest;
}

ReferenceHit Reference::trace_part(const f64::Ray& ray, std::uint32_t part) const {
    return state_->trace_part(ray, part);
}

}  // namespace quartic

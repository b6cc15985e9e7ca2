// Rays that solvers dislike: parallel to axes, in end planes, grazing, from far away, of any
// length.
#include "tests/primitives/samples.h"

#include <algorithm>
#include <cmath>

namespace quartic {
namespace {

using test::Numbers;

template <class Shape>
class AwkwardRays : public ::testing::Test {};
TYPED_TEST_SUITE(AwkwardRays, test::AllShapes);

constexpr double everything = -1e17;

// The crossings of a line, in order.
template <class Shape>
std::vector<f64::Hit> crossings(const Shape& shape, f64::Ray ray) {
    f64 kernel;
    std::vector<f64::Hit> all;
    ray.first = everything;
    const double step = 1e-7 * test::size_of(shape) / glm::length(ray.direction);
    while (all.size() < 12) {
        const f64::Hit hit = kernel.hit(shape, ray, 0, 1);
        if (!hit.found) {
            break;
        }
        all.push_back(hit);
        ray.first = hit.t + step;
    }
    return all;
}

// Lines along the axes and diagonals through the corners, faces and centre of the bounds, and
// through the ends' rims.
template <class Shape>
std::vector<f64::Ray> axis_rays(const Shape& shape) {
    f64 kernel;
    const f64::Bounds box = kernel.bounds(shape);
    std::vector<glm::dvec3> places;
    for (const double x : {0.0, 0.25, 0.5, 1.0}) {
        for (const double y : {0.0, 0.5, 0.75, 1.0}) {
            for (const double z : {0.0, 0.5, 1.0}) {
                places.push_back(glm::mix(box.low, box.high, glm::dvec3(x, y, z)));
            }
        }
    }
    places.emplace_back(0.0);
    for (int i = 0; i < kernel.end_count(shape); ++i) {
        const f64::End end = kernel.end(shape, i);
        places.push_back(end.centre);
        places.push_back(end.centre + end.radius * kernel.across(end.normal));
    }
    std::vector<f64::Ray> rays;
    for (const glm::dvec3& place : places) {
        for (int code = 1; code < 27; ++code) {
            f64::Ray ray{};
            ray.direction = glm::dvec3(code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1);
            if (ray.direction == glm::dvec3(0.0)) {
                continue;
            }
            ray.origin = place;
            ray.first = everything;
            rays.push_back(ray);
        }
    }
    return rays;
}

template <class Shape>
void expect_sound(const Shape& shape, const f64::Ray& ray, const f64::Hit& hit) {
    const f64::Bounds box = f64().bounds(shape);
    const double size = test::size_of(shape);
    ASSERT_TRUE(std::isfinite(hit.t));
    EXPECT_GE(hit.t, ray.first);
    EXPECT_NEAR(glm::length(hit.normal), 1.0, 1e-12);
    EXPECT_LT(glm::length(hit.point - (ray.origin + hit.t * ray.direction)),
              1e-9 * (size + glm::length(ray.origin)));
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GE(hit.point[axis], box.low[axis] - 1e-6 * size);
        EXPECT_LE(hit.point[axis], box.high[axis] + 1e-6 * size);
    }
}

TYPED_TEST(AwkwardRays, axis_parallel_rays_give_sound_hits) {
    f64 kernel;
    int index = 0;
    for (const TypeParam& shape : test::samples<TypeParam>()) {
        SCOPED_TRACE(index++);
        int found = 0;
        for (const f64::Ray& ray : axis_rays(shape)) {
            const f64::Hit hit = kernel.hit(shape, ray, 0, 1);
            if (hit.found) {
                expect_sound(shape, ray, hit);
                ++found;
            }
        }
        EXPECT_GT(found, 0);
    }
}

TYPED_TEST(AwkwardRays, axis_parallel_rays_in_float_are_finite) {
    f32 kernel;
    int index = 0;
    for (const TypeParam& shape : test::samples<TypeParam>()) {
        SCOPED_TRACE(index++);
        const auto small = test::to_float(shape);
        for (const f64::Ray& ray : axis_rays(shape)) {
            f32::Ray thin{};
            thin.origin = ray.origin;
            thin.direction = ray.direction;
            thin.first = float(everything);
            const f32::Hit hit = kernel.hit(small, thin, 0, 1);
            if (hit.found) {
                EXPECT_TRUE(std::isfinite(hit.t));
                EXPECT_NEAR(glm::length(hit.normal), 1.0f, 1e-5f);
            }
        }
    }
}

TYPED_TEST(AwkwardRays, a_line_goes_in_and_out_in_turn) {
    Numbers numbers(3);
    int index = 0;
    for (const TypeParam& shape : test::samples<TypeParam>()) {
        SCOPED_TRACE(index++);
        if (test::is_flat(shape) || type_of<TypeParam> == ShapeType::disk) {
            continue;
        }
        const f64::Bounds box = f64().bounds(shape);
        for (int i = 0; i < 400; ++i) {
            const glm::dvec3 place(numbers.between(box.low.x, box.high.x),
                                   numbers.between(box.low.y, box.high.y),
                                   numbers.between(box.low.z, box.high.z));
            f64::Ray ray{};
            ray.direction = numbers.direction();
            ray.origin = place - test::size_of(shape) * ray.direction;
            ray.first = everything;
            const std::vector<f64::Hit> hits = crossings(shape, ray);
            if (std::any_of(hits.begin(), hits.end(), [&](const f64::Hit& hit) {
                    return std::abs(glm::dot(hit.normal, ray.direction)) < 1e-4;
                })) {
                continue;  // grazing: in and out are one
            }
            EXPECT_EQ(hits.size() % 2, 0u);
            for (std::size_t k = 0; k < hits.size(); ++k) {
                const double turn = glm::dot(hits[k].normal, ray.direction);
                EXPECT_EQ(turn < 0.0, k % 2 == 0) << "crossing " << k << " of " << hits.size();
            }
        }
    }
}

TYPED_TEST(AwkwardRays, the_length_of_the_direction_and_the_distance_do_not_matter) {
    f64 kernel;
    Numbers numbers(5);
    int index = 0;
    for (const TypeParam& shape : test::samples<TypeParam>()) {
        SCOPED_TRACE(index++);
        const double size = test::size_of(shape);
        const f64::Bounds box = kernel.bounds(shape);
        for (int i = 0; i < 60; ++i) {
            const glm::dvec3 aim = numbers.direction();
            const glm::dvec3 place = glm::mix(box.low, box.high, 0.5 + 0.3 * numbers.direction());
            f64::Ray ray{};
            ray.origin = place - 2.0 * size * aim;
            ray.direction = aim;
            ray.first = 0.0;
            const f64::Hit near = kernel.hit(shape, ray, 0, 1);
            if (near.found && std::abs(glm::dot(near.normal, aim)) < 1e-2) {
                continue;
            }
            for (const double length : {1e-3, 1e3}) {
                ray.direction = length * aim;
                const f64::Hit scaled = kernel.hit(shape, ray, 0, 1);
                ASSERT_EQ(scaled.found, near.found);
                EXPECT_NEAR(scaled.t * length, near.t, 1e-7 * size);
            }
            ray.origin = place - 1e4 * size * aim;
            ray.direction = aim;
            const f64::Hit far = kernel.hit(shape, ray, 0, 1);
            ASSERT_EQ(far.found, near.found);
            EXPECT_LT(glm::length(far.point - near.point), 1e-6 * size);
        }
    }
}

TYPED_TEST(AwkwardRays, what_lies_before_first_is_not_seen) {
    Numbers numbers(9);
    f64 kernel;
    int index = 0;
    for (const TypeParam& shape : test::samples<TypeParam>()) {
        SCOPED_TRACE(index++);
        const double size = test::size_of(shape);
        for (int i = 0; i < 60; ++i) {
            f64::Ray ray{};
            ray.direction = numbers.direction();
            ray.origin =
                kernel.point(shape, 0, {numbers.next(), numbers.next()}) - size * ray.direction;
            ray.first = 2.0 * size * (1.0 + 1e-6) + size;
            EXPECT_FALSE(kernel.hit(shape, ray, 0, 1).found);
            ray.direction = -ray.direction;
            ray.first = 1e-6 * size;
            const f64::Hit behind = kernel.hit(shape, ray, 0, 1);
            EXPECT_TRUE(!behind.found || behind.t >= ray.first);
        }
    }
}

struct Agreement {
    int hits = 0;
    int different = 0;
    int displaced = 0;
};

// Random lines that start near the shape, where the renderer starts them.
template <class Shape>
Agreement compare_floats(const Shape& exact) {
    const auto shape = test::to_float(exact);
    const Shape rounded = test::to_double(shape);
    const f64::Bounds box = f64().bounds(rounded);
    const double size = test::size_of(rounded);
    Numbers numbers(21);
    Agreement agreement;
    for (int i = 0; i < 4000; ++i) {
        const glm::vec3 aim(numbers.direction());
        const glm::dvec3 place(numbers.between(box.low.x, box.high.x),
                               numbers.between(box.low.y, box.high.y),
                               numbers.between(box.low.z, box.high.z));
        f32::Ray ray{};
        ray.direction = aim;
        ray.origin = glm::vec3(place - 0.7 * size * glm::dvec3(aim));
        ray.first = 0.0f;
        f64::Ray same{};
        same.direction = aim;
        same.origin = ray.origin;
        same.first = 0.0;
        const f32::Hit hit = f32().hit(shape, ray, 0, 1);
        const f64::Hit truth = f64().hit(rounded, same, 0, 1);
        agreement.hits += truth.found;
        agreement.different += truth.found != hit.found;
        agreement.displaced +=
            truth.found && hit.found && std::abs(truth.t - double(hit.t)) > 1e-4 * size;
    }
    return agreement;
}

TYPED_TEST(AwkwardRays, float_agrees_with_double) {
    int index = 0;
    Agreement all;
    for (const TypeParam& shape : test::samples<TypeParam>()) {
        SCOPED_TRACE(index++);
        const Agreement one = compare_floats(shape);
        EXPECT_LE(one.different, 8) << "of " << one.hits;
        EXPECT_LE(one.displaced, 8) << "of " << one.hits;
        all.hits += one.hits;
        all.different += one.different;
        all.displaced += one.displaced;
    }
    ::testing::Test::RecordProperty("hits", all.hits);
    ::testing::Test::RecordProperty("different", all.different);
    ::testing::Test::RecordProperty("displaced", all.displaced);
    std::printf("%d hits, %d with another verdict, %d displaced\n", all.hits, all.different,
                all.displaced);
}

}  // namespace
}  // namespace quartic

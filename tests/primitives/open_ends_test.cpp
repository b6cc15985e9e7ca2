// Ends: discs that close a solid, hidden caps, and walls that go on a little where a neighbour is
// joined.
#include "tests/primitives/samples.h"

#include <cmath>

namespace quartic {
namespace {

template <class Shape>
class OpenEnds : public ::testing::Test {};
TYPED_TEST_SUITE(OpenEnds, test::AllShapes);

// Calls the visitor for every end that has a disc.
template <class Shape, class Visitor>
void visit_ends(Visitor visitor) {
    f64 kernel;
    int sample = 0;
    for (const Shape& shape : test::samples<Shape>()) {
        SCOPED_TRACE(sample++);
        for (int i = 0; i < kernel.end_count(shape); ++i) {
            const f64::End end = kernel.end(shape, i);
            if (end.radius > 0.0) {
                visitor(shape, i, end);
            }
        }
    }
}

TYPED_TEST(OpenEnds, the_disc_of_an_end_is_the_face_of_its_cap) {
    f64 kernel;
    visit_ends<TypeParam>([&](const TypeParam& shape, int i, const f64::End& end) {
        const double size = test::size_of(shape);
        for (const double u : {0.0, 0.2, 0.7}) {
            const glm::dvec3 rim = kernel.point(shape, 1 + i, {u, 0.0});
            EXPECT_NEAR(glm::length(rim - end.centre), end.radius, 1e-9 * size);
            EXPECT_NEAR(glm::dot(rim - end.centre, end.normal), 0.0, 1e-9 * size);
        }
        EXPECT_NEAR(glm::length(kernel.point(shape, 1 + i, {0.3, 1.0}) - end.centre), 0.0,
                    1e-9 * size);
    });
}

TYPED_TEST(OpenEnds, a_cap_is_hit_unless_it_is_hidden) {
    f64 kernel;
    visit_ends<TypeParam>([&](const TypeParam& shape, int i, const f64::End& end) {
        const glm::dvec3 place = end.centre + 0.4 * end.radius * kernel.across(end.normal);
        const double away = 1e-3 * end.radius;
        const f64::Ray ray = test::ray_from(place + away * end.normal, -end.normal);
        const f64::Hit closed = kernel.hit(shape, ray, 0, 1);
        ASSERT_TRUE(closed.found);
        EXPECT_NEAR(closed.t, away, 1e-9 * test::size_of(shape));
        EXPECT_GT(glm::dot(closed.normal, end.normal), 1.0 - 1e-9);
        const f64::Hit open = kernel.hit(shape, ray, 1 << i, 1);
        EXPECT_TRUE(!open.found || open.t > away + 1e-6 * end.radius);
        const f64::Hit other = kernel.hit(shape, ray, 2 >> i, 1);
        EXPECT_TRUE(other.found && other.t == closed.t) << "the other end's bit must not matter";
    });
}

TYPED_TEST(OpenEnds, through_an_open_end_the_inside_of_the_wall_is_seen) {
    f64 kernel;
    visit_ends<TypeParam>([&](const TypeParam& shape, int i, const f64::End& end) {
        const glm::dvec3 aside = kernel.across(end.normal);
        const glm::dvec3 origin =
            end.centre + 0.5 * end.radius * end.normal - 0.3 * end.radius * aside;
        const glm::dvec3 target = end.centre + (0.1 * end.radius) * aside;
        const f64::Ray ray = test::ray_from(origin, target - origin);
        const f64::Hit closed = kernel.hit(shape, ray, 0, 1);
        const f64::Hit hit = kernel.hit(shape, ray, 1 << i, 1);
        const bool cap_is_seen = closed.found && std::abs(closed.t - 1.0) < 1e-9;
        if (hit.found && cap_is_seen) {
            EXPECT_GT(hit.t, 1.0);
            EXPECT_GT(glm::dot(hit.normal, target - origin), 0.0);
        }
    });
}

TYPED_TEST(OpenEnds, an_open_wall_goes_on_by_the_overlap) {
    f64 kernel;
    visit_ends<TypeParam>([&](const TypeParam& shape, int i, const f64::End& end) {
        if (!(std::abs(end.flare) < 0.5)) {
            return;
        }
        const glm::dvec3 aside = kernel.across(end.normal);
        const double overlap = kernel.joint_overlap(end.radius, end.flare);
        const glm::dvec3 beyond = end.centre + 0.5 * overlap * end.normal;
        const f64::Ray ray = test::ray_from(beyond + (end.radius + 2.0 * overlap) * aside, -aside);
        const double reach = 4.0 * overlap;
        const f64::Hit closed = kernel.hit(shape, ray, 0, 1);
        EXPECT_TRUE(!closed.found || closed.t > reach);
        const f64::Hit open = kernel.hit(shape, ray, 1 << i, 1);
        ASSERT_TRUE(open.found);
        EXPECT_LT(open.t, reach);
    });
}

}  // namespace
}  // namespace quartic

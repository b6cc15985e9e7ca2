// Where rays truly meet a torus or an algebraic surface: all real roots, in long double, of the
// polynomial along a ray whose floats are taken as exact.
#pragma once

#include "primitives/kernel.h"

#include <array>
#include <functional>

namespace quartic {

using Long = long double;
using LongVector = glm::vec<3, Long>;

// Ascending; a double root stands once.
struct RealRoots {
    std::array<Long, 4> t{};
    int count = 0;
};

// The roots in [low, high] of c[0] + c[1] t + ... + c[4] t^4, by the chain of derivatives: between
// two neighbouring roots of f' there is at most one of f, and halving with Newton's steps where
// they stay inside finds it to the last digit. An extreme that touches zero within the rounding of
// its own evaluation is a root. Nothing where all coefficients vanish.
RealRoots real_roots(const std::array<Long, 5>& c, Long low, Long high);

struct LongRay {
    LongVector origin;
    LongVector direction;  // of any length
    Long first = 0.0L;
};

// The parameters t >= first at which a ray meets a surface.
using Crossings = std::function<RealRoots(const LongRay&)>;

// A whole ring; its floats are exact.
Crossings crossings_of(const f32::Torus& ring);

// The zero set in the cube of half_size of a polynomial in coordinates measured in half_size. Its
// 35 coefficients in the order of primitives/algebraic.glsl are exact.
Crossings crossings_of(const std::array<float, 35>& coefficients, float half_size);

}  // namespace quartic

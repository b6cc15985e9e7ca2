// The truth about roots, in long double.
#include "bench/truth.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quartic {
namespace {

constexpr Long epsilon = std::numeric_limits<Long>::epsilon();

// Coefficients of rising powers; those beyond the degree are zero.
struct Curve {
    std::array<Long, 5> c{};
    int degree = 0;
};

struct ValueAndSlope {
    Long value;
    Long slope;
};

ValueAndSlope at(const Curve& f, Long t) {
    ValueAndSlope result{0.0L, 0.0L};
    for (int i = f.degree; i >= 0; --i) {
        result.slope = result.slope * t + result.value;
        result.value = result.value * t + f.c[static_cast<std::size_t>(i)];
    }
    return result;
}

// How far a value may be from the true one: Horner's rule rounds twice a step (Higham 2002,
// Accuracy and Stability of Numerical Algorithms, section 5.1).
Long rounding_at(const Curve& f, Long t) {
    Long size = 0.0L;
    for (int i = f.degree; i >= 0; --i) {
        size = size * std::abs(t) + std::abs(f.c[static_cast<std::size_t>(i)]);
    }
    return 4.0L * epsilon * size;
}

Curve derivative(const Curve& f) {
    Curve slope;
    slope.degree = f.degree - 1;
    for (int i = 1; i <= f.degree; ++i) {
        slope.c[static_cast<std::size_t>(i - 1)] =
            static_cast<Long>(i) * f.c[static_cast<std::size_t>(i)];
    }
    return slope;
}

// The root between two places where f has different signs; f is monotone between them.
Long root_between(const Curve& f, Long low, Long high, bool rises) {
    const Long smallest_step = epsilon * std::max(std::abs(low), std::abs(high));
    Long t = 0.5L * (low + high);
    for (int i = 0; i < 200; ++i) {
        const ValueAndSlope here = at(f, t);
        if (here.value == 0.0L) {
            return t;
        }
        ((here.value > 0.0L) == rises ? high : low) = t;
        const Long newton = t - here.value / here.slope;
        const bool inside = newton > low && newton < high;
        if (inside && std::abs(newton - t) <= smallest_step) {
            return newton;
        }
        // Halving every third time keeps slow convergence at clustered roots short.
        const Long next = inside && i % 3 != 2 ? newton : 0.5L * (low + high);
        if (next <= low || next >= high) {
            return next;
        }
        t = next;
    }
    return t;
}

void add(RealRoots& roots, Long t) {
    const bool known = roots.count > 0 && t <= roots.t[static_cast<std::size_t>(roots.count - 1)];
    if (!known && roots.count < 4) {
        roots.t[static_cast<std::size_t>(roots.count++)] = t;
    }
}

// The roots of f between the extremes, which lie in [low, high].
RealRoots roots_between(const Curve& f, const RealRoots& extremes, Long low, Long high) {
    const auto sign_at = [&](Long t) {
        const Long value = at(f, t).value;
        return std::abs(value) <= rounding_at(f, t) ? 0 : value > 0.0L ? 1 : -1;
    };
    RealRoots roots;
    Long left = low;
    int left_sign = sign_at(low);
    if (left_sign == 0) {
        add(roots, low);
    }
    for (int i = 0; i <= extremes.count; ++i) {
        const Long right = i < extremes.count ? extremes.t[static_cast<std::size_t>(i)] : high;
        const int right_sign = sign_at(right);
        if (left_sign * right_sign < 0) {
            add(roots, root_between(f, left, right, right_sign > 0));
        } else if (right_sign == 0) {
            add(roots, right);
        }
        left = right;
        left_sign = right_sign;
    }
    return roots;
}

// Of a curve of degree 2, by the form that does not cancel.
RealRoots quadratic_roots(const Curve& f, Long low, Long high) {
    const Long half_b = 0.5L * f.c[1];
    const Long discriminant = half_b * half_b - f.c[2] * f.c[0];
    RealRoots roots;
    if (discriminant < 0.0L) {
        return roots;
    }
    const Long sum = -(half_b + std::copysign(std::sqrt(discriminant), half_b));
    const Long first = sum / f.c[2];
    const Long second = sum != 0.0L ? f.c[0] / sum : first;
    for (const Long t : {std::min(first, second), std::max(first, second)}) {
        if (t >= low && t <= high) {
            add(roots, t);
        }
    }
    return roots;
}

int degree_of(const std::array<Long, 5>& c) {
    for (int i = 4; i > 0; --i) {
        if (c[static_cast<std::size_t>(i)] != 0.0L) {
            return i;
        }
    }
    return 0;
}

// A ray in units of a size, with a unit direction, measured from its point closest to the centre:
// t = rate * parameter + shift.
struct CentredRay {
    LongVector p;
    LongVector v;
    Long rate;
    Long shift;
    Long low;  // of the ray's first
};

CentredRay centred(const LongRay& ray, Long size) {
    const Long speed = std::sqrt(glm::dot(ray.direction, ray.direction));
    CentredRay line;
    line.v = ray.direction / speed;
    line.rate = speed / size;
    const LongVector o = ray.origin / size;
    line.shift = glm::dot(o, line.v);
    line.p = o - line.shift * line.v;
    line.low = ray.first * line.rate + line.shift;
    return line;
}

RealRoots as_parameters(RealRoots roots, const CentredRay& line) {
    for (int i = 0; i < roots.count; ++i) {
        Long& t = roots.t[static_cast<std::size_t>(i)];
        t = (t - line.shift) / line.rate;
    }
    return roots;
}

using Powers = std::array<Long, 5>;  // coefficients of rising powers of t

// p + v t to the powers 0 to 4.
std::array<Powers, 5> powers_along(Long p, Long v) {
    std::array<Powers, 5> powers{};
    powers[0][0] = 1.0L;
    for (std::size_t n = 1; n < 5; ++n) {
        for (std::size_t i = 0; i < n; ++i) {
            powers[n][i] += p * powers[n - 1][i];
            powers[n][i + 1] += v * powers[n - 1][i];
        }
    }
    return powers;
}

void add_product(Powers& to, const Powers& a, const Powers& b, Long factor) {
    for (std::size_t i = 0; i < 5; ++i) {
        for (std::size_t j = 0; i + j < 5; ++j) {
            to[i + j] += factor * a[i] * b[j];
        }
    }
}

// The polynomial's values along p + t v; terms in lexicographic order, x^4 first, 1 last. For every
// power of x and y the terms in z are summed before they are multiplied out.
Powers along(const std::array<float, 35>& terms, const LongVector& p, const LongVector& v) {
    const auto x = powers_along(p.x, v.x);
    const auto y = powers_along(p.y, v.y);
    const auto z = powers_along(p.z, v.z);
    Powers result{};
    std::size_t term = 0;
    for (std::size_t i = 5; i-- > 0;) {
        Powers in_yz{};
        for (std::size_t j = 5 - i; j-- > 0;) {
            Powers in_z{};
            for (std::size_t k = 5 - i - j; k-- > 0;) {
                const Long factor = Long(terms[term++]);
                for (std::size_t n = 0; n < 5; ++n) {
                    in_z[n] += factor * z[k][n];
                }
            }
            add_product(in_yz, in_z, y[j], 1.0L);
        }
        add_product(result, in_yz, x[i], 1.0L);
    }
    return result;
}

}  // namespace

RealRoots real_roots(const std::array<Long, 5>& c, Long low, Long high) {
    if (!(low <= high)) {
        return {};
    }
    // f, f', f'', ...: each one's roots are the next one's extremes.
    std::array<Curve, 5> chain{Curve{c, degree_of(c)}};
    const int degree = chain[0].degree;
    for (int i = 1; i < degree; ++i) {
        chain[static_cast<std::size_t>(i)] = derivative(chain[static_cast<std::size_t>(i - 1)]);
    }
    // The second derivative of a quartic needs no search. Where its roots nearly meet the square
    // root loses digits, but the curve is straight there, and any place cuts it as well.
    RealRoots roots = degree > 2
                          ? quadratic_roots(chain[static_cast<std::size_t>(degree - 2)], low, high)
                          : RealRoots();
    for (int i = degree > 2 ? degree - 3 : degree - 1; i >= 0; --i) {
        roots = roots_between(chain[static_cast<std::size_t>(i)], roots, low, high);
    }
    return roots;
}

Crossings crossings_of(const f32::Torus& ring) {
    const Long bend = Long(ring.bend_radius);
    const Long radius = Long(ring.radius);
    return [bend, radius](const LongRay& ray) {
        const CentredRay line = centred(ray, 1.0L);
        const Long q = glm::dot(line.p, line.p);
        const Long room = (bend + radius) * (bend + radius) - q;
        if (room < 0.0L) {
            return RealRoots();
        }
        // (|x|^2 - R^2 - r^2)^2 + 4 R^2 (z^2 - r^2), de Toledo, Levy, Paul 2007, equation 1.
        const Long k = q - bend * bend - radius * radius;
        const Long weight = 4.0L * bend * bend;
        const Long pz = line.p.z;
        const Long vz = line.v.z;
        const Long reach = std::sqrt(room) * (1.0L + 16.0L * epsilon);
        return as_parameters(
            real_roots({k * k + weight * (pz * pz - radius * radius), 2.0L * weight * pz * vz,
                        2.0L * k + weight * vz * vz, 0.0L, 1.0L},
                       std::max(-reach, line.low), reach),
            line);
    };
}

Crossings crossings_of(const std::array<float, 35>& coefficients, float half_size) {
    return [coefficients, half_size](const LongRay& ray) {
        const CentredRay line = centred(ray, Long(half_size));
        Long low = line.low;
        Long high = std::numeric_limits<Long>::max();
        for (int axis = 0; axis < 3; ++axis) {
            const Long p = line.p[axis];
            const Long v = line.v[axis];
            if (v == 0.0L && std::abs(p) > 1.0L) {
                return RealRoots();
            }
            if (v != 0.0L) {
                low = std::max(low, (-std::copysign(1.0L, v) - p) / v);
                high = std::min(high, (std::copysign(1.0L, v) - p) / v);
            }
        }
        return as_parameters(real_roots(along(coefficients, line.p, line.v), low, high), line);
    };
}

}  // namespace quartic

// Depressed quartics whose roots are chosen before their coefficients.
#pragma once

#include "solvers/solver.h"
#include "solvers/solver_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <vector>

namespace quartic::test {

using Long = long double;
using Roots = std::array<Long, 4>;

// Repeatable numbers in [-1, 1): 24 bits, so that they are exact in every real type.
template <class Real>
class Sequence {
public:
    explicit Sequence(std::uint32_t seed) : state_(seed) {}
    Real operator()() {
        state_ = state_ * 1664525u + 1013904223u;
        return Real(state_ >> 8) / Real(1 << 23) - Real(1);
    }

private:
    std::uint32_t state_;
};

// Moves the roots so that their sum is zero: a quartic without cubic term.
inline Roots centred(Roots roots) {
    const Long mean = (roots[0] + roots[1] + roots[2] + roots[3]) / 4.0L;
    for (Long& root : roots) {
        root -= mean;
    }
    std::sort(roots.begin(), roots.end());
    return roots;
}

template <class Real>
typename Solver<Real>::Polynomial from_roots(const Roots& r) {
    Long c = 0.0L;
    Long d = 0.0L;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = i + 1; j < 4; ++j) {
            c += r[i] * r[j];
            for (std::size_t k = j + 1; k < 4; ++k) {
                d -= r[i] * r[j] * r[k];
            }
        }
    }
    return Solver<Real>().polynomial(Real(1), Real(0), Real(c), Real(d),
                                     Real(r[0] * r[1] * r[2] * r[3]));
}

// (t^2 + p t + q) (t^2 - p t + s): two of its pairs may be complex.
template <class Real>
typename Solver<Real>::Polynomial from_factors(Long p, Long q, Long s) {
    return Solver<Real>().polynomial(Real(1), Real(0), Real(q + s - p * p), Real(p * (s - q)),
                                     Real(q * s));
}

// Searches as a torus does: half the interval is about its size.
template <class Polynomial, class Real>
auto first_root(const Polynomial& quartic, Real low, Real high, Real tolerance, int solver) {
    const Real scale = std::max(Real(0.5) * (high - low), tolerance);
    return Solver<Real>().first_root(
        quartic, {low, high, tolerance, scale, Real(0.01) * tolerance, false}, solver);
}

inline std::vector<int> ids_of(std::initializer_list<const char*> names) {
    std::vector<int> ids;
    for (const char* name : names) {
        const SolverRow* row = find_solver(name);
        EXPECT_NE(row, nullptr) << name;
        ids.push_back(row == nullptr ? 0 : row->id);
    }
    return ids;
}

// All but those that march by a shape's distance.
inline std::vector<int> all_of_quartics() {
    std::vector<int> ids;
    for (const SolverRow& row : solver_table()) {
        if (!row.name.starts_with("sphere_tracing")) {
            ids.push_back(row.id);
        }
    }
    return ids;
}

}  // namespace quartic::test

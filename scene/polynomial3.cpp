// The algebra of polynomials in three variables, term by term.
#include "scene/polynomial3.h"

#include "diagnostics/check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>

namespace quartic {
namespace {

constexpr int degree_max = Polynomial3::degree_max;
constexpr std::size_t term_count = Polynomial3::term_count;

using Exponents = std::array<int, 3>;

constexpr std::array<Exponents, term_count> make_exponents() {
    std::array<Exponents, term_count> all{};
    std::size_t at = 0;
    for (int i = degree_max; i >= 0; --i) {
        for (int j = degree_max - i; j >= 0; --j) {
            for (int k = degree_max - i - j; k >= 0; --k) {
                all[at++] = {i, j, k};
            }
        }
    }
    return all;
}

constexpr std::array<Exponents, term_count> exponents = make_exponents();

// The place of a term among those of degree 4 at most.
constexpr std::size_t place_of(int i, int j, int k) {
    const int low_x = degree_max - i;  // terms with more x stand before: a tetrahedral number
    const int low_y = low_x - j;
    return static_cast<std::size_t>(low_x * (low_x + 1) * (low_x + 2) / 6 +
                                    low_y * (low_y + 1) / 2 + low_y - k);
}

static_assert(place_of(4, 0, 0) == 0 && place_of(0, 0, 0) == term_count - 1);
static_assert(place_of(2, 1, 0) == 6 && place_of(0, 4, 0) == 20 && place_of(1, 0, 2) == 17);

int degree_of(const Exponents& e) {
    return e[0] + e[1] + e[2];
}

using Powers = std::array<std::array<double, degree_max + 1>, 3>;

Powers powers_of(const glm::dvec3& point) {
    Powers powers;
    for (int axis = 0; axis < 3; ++axis) {
        auto& row = powers[static_cast<std::size_t>(axis)];
        row[0] = 1.0;
        for (std::size_t n = 1; n < row.size(); ++n) {
            row[n] = row[n - 1] * point[axis];
        }
    }
    return powers;
}

double power_at(const Powers& powers, std::size_t axis, int exponent) {
    return powers[axis][static_cast<std::size_t>(exponent)];
}

std::string number_text(double number) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g", number);
    return text.data();
}

std::string monomial_text(const Exponents& e) {
    constexpr std::array<char, 3> names{'x', 'y', 'z'};
    std::string text;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (e[axis] > 0) {
            text += (text.empty() ? "" : " ") + std::string(1, names[axis]);
            text += e[axis] > 1 ? "^" + std::to_string(e[axis]) : "";
        }
    }
    return text;
}

}  // namespace

Polynomial3::Polynomial3(std::span<const double, term_count> terms) {
    std::copy(terms.begin(), terms.end(), terms_.begin());
}

Polynomial3 Polynomial3::from_cubic(std::span<const double, 20> terms) {
    Polynomial3 result;
    std::size_t next = 0;
    for (std::size_t i = 0; i < term_count; ++i) {
        if (degree_of(exponents[i]) <= 3) {
            result.terms_[i] = terms[next++];
        }
    }
    return result;
}

Polynomial3 Polynomial3::variable(int axis) {
    Polynomial3 result;
    result.terms_[place_of(axis == 0, axis == 1, axis == 2)] = 1.0;
    return result;
}

Polynomial3& Polynomial3::operator+=(const Polynomial3& other) {
    for (std::size_t i = 0; i < term_count; ++i) {
        terms_[i] += other.terms_[i];
    }
    return *this;
}

Polynomial3& Polynomial3::operator-=(const Polynomial3& other) {
    for (std::size_t i = 0; i < term_count; ++i) {
        terms_[i] -= other.terms_[i];
    }
    return *this;
}

Polynomial3& Polynomial3::operator*=(double factor) {
    for (double& term : terms_) {
        term *= factor;
    }
    return *this;
}

std::array<double, 20> Polynomial3::cubic_terms() const {
    CHECK(degree() <= 3);
    std::array<double, 20> result{};
    std::size_t next = 0;
    for (std::size_t i = 0; i < term_count; ++i) {
        if (degree_of(exponents[i]) <= 3) {
            result[next++] = terms_[i];
        }
    }
    return result;
}

int Polynomial3::degree() const {
    int degree = 0;
    for (std::size_t i = 0; i < term_count; ++i) {
        if (terms_[i] != 0.0) {
            degree = std::max(degree, degree_of(exponents[i]));
        }
    }
    return degree;
}

double Polynomial3::value(const glm::dvec3& point) const {
    const Powers powers = powers_of(point);
    double sum = 0.0;
    for (std::size_t i = 0; i < term_count; ++i) {
        const Exponents& e = exponents[i];
        sum += terms_[i] * power_at(powers, 0, e[0]) * power_at(powers, 1, e[1]) *
               power_at(powers, 2, e[2]);
    }
    return sum;
}

glm::dvec3 Polynomial3::gradient(const glm::dvec3& point) const {
    const Powers powers = powers_of(point);
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < term_count; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Exponents e = exponents[i];
            if (e[axis] == 0) {
                continue;
            }
            const double factor = terms_[i] * e[axis]--;
            sum[static_cast<int>(axis)] += factor * power_at(powers, 0, e[0]) *
                                           power_at(powers, 1, e[1]) * power_at(powers, 2, e[2]);
        }
    }
    return sum;
}

double Polynomial3::largest_term() const {
    double largest = 0.0;
    for (const double term : terms_) {
        largest = std::max(largest, std::abs(term));
    }
    return largest;
}

Polynomial3 Polynomial3::of(const glm::dmat4x3& map) const {
    std::array<std::array<Polynomial3, degree_max + 1>, 3> powers;
    for (int axis = 0; axis < 3; ++axis) {
        const Polynomial3 line =
            map[0][axis] * x() + map[1][axis] * y() + map[2][axis] * z() + map[3][axis];
        auto& row = powers[static_cast<std::size_t>(axis)];
        row[0] = 1.0;
        for (std::size_t n = 1; n < row.size(); ++n) {
            row[n] = row[n - 1] * line;
        }
    }
    Polynomial3 result;
    for (std::size_t i = 0; i < term_count; ++i) {
        if (terms_[i] != 0.0) {
            const Exponents& e = exponents[i];
            result += terms_[i] * (powers[0][static_cast<std::size_t>(e[0])] *
                                   powers[1][static_cast<std::size_t>(e[1])] *
                                   powers[2][static_cast<std::size_t>(e[2])]);
        }
    }
    return result;
}

std::string Polynomial3::text() const {
    std::string text;
    for (std::size_t i = 0; i < term_count; ++i) {
        const double term = terms_[i];
        if (term == 0.0) {
            continue;
        }
        const std::string_view sign =
            text.empty() ? (term < 0.0 ? "-" : "") : (term < 0.0 ? " - " : " + ");
        const std::string monomial = monomial_text(exponents[i]);
        const bool bare = std::abs(term) == 1.0 && !monomial.empty();
        text += std::string(sign) + (bare ? "" : number_text(std::abs(term)));
        text += (bare || monomial.empty() ? "" : " ") + monomial;
    }
    return text.empty() ? "0" : text;
}

Polynomial3 operator+(Polynomial3 a, const Polynomial3& b) {
    return a += b;
}

Polynomial3 operator-(Polynomial3 a, const Polynomial3& b) {
    return a -= b;
}

Polynomial3 operator-(Polynomial3 a) {
    return a *= -1.0;
}

Polynomial3 operator*(const Polynomial3& a, const Polynomial3& b) {
    Polynomial3 product;
    for (std::size_t i = 0; i < term_count; ++i) {
        for (std::size_t j = 0; a.terms_[i] != 0.0 && j < term_count; ++j) {
            if (b.terms_[j] == 0.0) {
                continue;
            }
            const Exponents& p = exponents[i];
            const Exponents& q = exponents[j];
            CHECK(degree_of(p) + degree_of(q) <= degree_max);
            product.terms_[place_of(p[0] + q[0], p[1] + q[1], p[2] + q[2])] +=
                a.terms_[i] * b.terms_[j];
        }
    }
    return product;
}

Polynomial3 power(const Polynomial3& base, int exponent) {
    Polynomial3 result = 1.0;
    for (int i = 0; i < exponent; ++i) {
        result = result * base;
    }
    return result;
}

}  // namespace quartic

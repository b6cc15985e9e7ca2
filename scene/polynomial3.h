// Polynomials in x, y, z of degree at most 4, so that an algebraic surface is written as its
// formula.
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <string>

namespace quartic {

// The sum of c x^i y^j z^k with i + j + k <= 4. Terms stand as POV-Ray's manual lists them, ordered
// by the power of x, then of y, then of z, each falling: x^4, x^3 y, x^3 z, x^3, ..., z, 1.
class Polynomial3 {
public:
    static constexpr int degree_max = 4;
    static constexpr std::size_t term_count = 35;

    Polynomial3() = default;
    Polynomial3(double constant) { terms_[term_count - 1] = constant; }  // a number is a formula
    explicit Polynomial3(std::span<const double, term_count> terms);
    static Polynomial3 from_cubic(std::span<const double, 20> terms);

    static Polynomial3 x() { return variable(0); }
    static Polynomial3 y() { return variable(1); }
    static Polynomial3 z() { return variable(2); }

    Polynomial3& operator+=(const Polynomial3& other);
    Polynomial3& operator-=(const Polynomial3& other);
    Polynomial3& operator*=(double factor);

    const std::array<double, term_count>& terms() const { return terms_; }
    std::array<double, 20> cubic_terms() const;  // degree() <= 3

    int degree() const;  // of the highest term that is not zero; 0 for a constant
    double value(const glm::dvec3& point) const;
    glm::dvec3 gradient(const glm::dvec3& point) const;
    double largest_term() const;  // the largest absolute value

    // This polynomial of M v: column 3 is the translation.
    Polynomial3 of(const glm::dmat4x3& map) const;

    std::string text() const;  // "x^2 + y^2 - 0.25"

private:
    static Polynomial3 variable(int axis);
    friend Polynomial3 operator*(const Polynomial3& a, const Polynomial3& b);

    std::array<double, term_count> terms_{};
};

Polynomial3 operator+(Polynomial3 a, const Polynomial3& b);
Polynomial3 operator-(Polynomial3 a, const Polynomial3& b);
Polynomial3 operator-(Polynomial3 a);
Polynomial3 operator*(const Polynomial3& a, const Polynomial3& b);  // degrees add up to 4 at most
Polynomial3 power(const Polynomial3& base, int exponent);

}  // namespace quartic

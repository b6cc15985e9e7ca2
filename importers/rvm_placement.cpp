// Judges matrices and makes their rotations exact.
#include "importers/rvm_placement.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace quartic {
namespace {

constexpr double usual_scale = 0.001;  // local millimetres, world metres
constexpr double position_max = 1e9;   // metres; as the largest length of a shape

// Relative departures of the axes that still count as rounding. Real binary files keep 1e-7.
double axis_tolerance(MatrixForm form) {
    return form == MatrixForm::binary ? 1e-5 : 2e-2;
}

// A scale this close to the usual one is the usual one: 0.001 as a float is off by 5e-8, and in the
// text form the axes are rounded.
double scale_tolerance(MatrixForm form) {
    return form == MatrixForm::binary ? 5e-7 : 2e-2;
}

struct Axes {
    glm::dmat3 axes;
    glm::dvec3 squares;  // of their lengths
    double skew = 0.0;   // the largest product of two axes
    double handedness = 0.0;
};

Axes read_axes(std::span<const float, 12> m) {
    Axes read;
    for (int column = 0; column < 3; ++column) {
        const auto at = static_cast<std::size_t>(3 * column);
        read.axes[column] = {static_cast<double>(m[at]), static_cast<double>(m[at + 1]),
                             static_cast<double>(m[at + 2])};
        read.squares[column] = glm::dot(read.axes[column], read.axes[column]);
    }
    const glm::dmat3& a = read.axes;
    read.skew = std::max({std::abs(glm::dot(a[0], a[1])), std::abs(glm::dot(a[0], a[2])),
                          std::abs(glm::dot(a[1], a[2]))});
    read.handedness = glm::dot(glm::cross(a[0], a[1]), a[2]);
    return read;
}

double longest(const Axes& read) {
    return std::max({read.squares.x, read.squares.y, read.squares.z});
}

double shortest(const Axes& read) {
    return std::min({read.squares.x, read.squares.y, read.squares.z});
}

bool is_uniform(const Axes& read, MatrixForm form) {
    return longest(read) - shortest(read) <= 2.0 * axis_tolerance(form) * longest(read);
}

bool is_square(const Axes& read, MatrixForm form) {
    return read.skew <= axis_tolerance(form) * longest(read);
}

bool is_finite(std::span<const float, 12> matrix) {
    bool finite = true;
    for (const float entry : matrix) {
        // An exponent of all ones; without a branch, so that the loop becomes vector instructions.
        const std::uint32_t exponent = std::bit_cast<std::uint32_t>(entry) & 0x7f800000;
        finite &= exponent != 0x7f800000;
    }
    return finite;
}

// The nearest rotation: Newton's iteration for the polar decomposition (Higham 1986, eq. 3.1
// without the inverse, as the start is nearly orthogonal); each step squares the error.
glm::dmat3 nearest_rotation(glm::dmat3 axes, int steps) {
    for (int step = 0; step < steps; ++step) {
        axes = 1.5 * axes - 0.5 * (axes * (glm::transpose(axes) * axes));
    }
    return axes;
}

std::string_view general_reason(const Axes& read, MatrixForm form) {
    if (!is_uniform(read, form)) {
        return "the matrix scales its axes differently";
    }
    return is_square(read, form) ? "the matrix mirrors" : "the matrix shears";
}

}  // namespace

bool is_similar(std::span<const float, 12> matrix, MatrixForm form) {
    if (!is_finite(matrix)) {
        return false;
    }
    const Axes read = read_axes(matrix);
    return longest(read) > 0.0 && is_uniform(read, form) && is_square(read, form);
}

RvmPlacement read_placement(std::span<const float, 12> matrix, MatrixForm form) {
    RvmPlacement result;
    if (!is_finite(matrix)) {
        result.reason = "the matrix is not finite";
        return result;
    }
    glm::dvec3& position = result.placement.position;
    position = {static_cast<double>(matrix[9]), static_cast<double>(matrix[10]),
                static_cast<double>(matrix[11])};
    const double reach =
        std::max({std::abs(position.x), std::abs(position.y), std::abs(position.z)});
    const Axes read = read_axes(matrix);
    const double cube = read.squares.x * read.squares.y * read.squares.z;
    if (reach > position_max || longest(read) > position_max * position_max) {
        result.reason = "the matrix leads over 1e9 m away";
        return result;
    }
    if (!(read.handedness * read.handedness > 1e-12 * cube) || !(shortest(read) > 1e-24)) {
        result.reason = "the matrix flattens the part";
        return result;
    }
    if (!(read.handedness > 0.0) || !is_uniform(read, form) || !is_square(read, form)) {
        result.kind = RvmPlacement::Kind::general;
        result.axes = read.axes;
        result.reason = general_reason(read, form);
        return result;
    }
    result.kind = RvmPlacement::Kind::similar;
    const double measured = std::sqrt((read.squares.x + read.squares.y + read.squares.z) / 3.0);
    const bool usual = std::abs(measured - usual_scale) <= scale_tolerance(form) * usual_scale;
    result.scale = usual ? usual_scale : measured;
    const glm::dmat3 rotation =
        nearest_rotation(read.axes / measured, form == MatrixForm::binary ? 1 : 5);
    result.placement.rotation = glm::normalize(glm::quat_cast(rotation));
    return result;
}

}  // namespace quartic

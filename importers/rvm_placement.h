// An RVM primitive's 3x4 matrix as a rigid motion and a scale, or as what it is where it is not
// that.
#pragma once

#include "scene/scene.h"

#include <span>
#include <string_view>

namespace quartic {

// How exactly a file form writes its matrices.
enum class MatrixForm {
    binary,  // floats
    text,    // five decimals of numbers near 0.001: axes are off by up to 0.5 %
};

struct RvmPlacement {
    enum class Kind { similar, general, unusable };

    Kind kind = Kind::unusable;
    Placement placement;      // similar: metres from local metres
    double scale = 0.0;       // similar: metres for a local unit, normally 0.001
    glm::dmat3 axes{0.0};     // general: metres from local units, without the translation
    std::string_view reason;  // general, unusable: a constant text
};

// Twelve numbers: the columns x axis, y axis, z axis, translation. Axes of equal length at right
// angles that form a right-handed system are similar; other invertible ones are general; the rest
// is unusable.
RvmPlacement read_placement(std::span<const float, 12> matrix, MatrixForm form);

// Whether the axes are plausible for a part: finite, equally long, at right angles. Cheap.
bool is_similar(std::span<const float, 12> matrix, MatrixForm form);

}  // namespace quartic

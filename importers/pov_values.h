// Numbers, vectors and colours of POV-Ray's scene language, and the constant arithmetic on them.
#pragma once

#include "importers/pov_tokens.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

namespace quartic {

// A number (size 1, which acts as a vector of equal components), a vector, or a colour: red, green,
// blue, filter, transmit.
struct PovValue {
    std::array<double, 5> of{};
    std::size_t size = 1;

    static PovValue number(double value) { return {{value, value, value, value, value}, 1}; }
    glm::dvec3 vector() const { return {of[0], of[1], of[2]}; }
};

// Evaluates expressions from the tokens on. A failure leaves its reason, in words that fit after
// "expected".
class PovExpressions {
public:
    using Lookup = std::function<const PovValue*(std::string_view name)>;

    PovExpressions(PovTokens& tokens, Lookup lookup)
        : tokens_(tokens), lookup_(std::move(lookup)) {}

    std::optional<PovValue> value();
    std::optional<double> number();
    std::optional<glm::dvec3> vector();
    // With or without the word colour; red 1 green 0.5; rgb <...>; a name.
    std::optional<PovValue> colour();
    // <a, b, ...> with any count up to most; the values that are there.
    std::optional<std::vector<double>> list(std::size_t most);

    bool starts_value() const;
    bool starts_colour() const;

    // Takes a comma, if there is one.
    void comma() { tokens_.take_if(","); }

private:
    std::optional<PovValue> sum(int depth);
    std::optional<PovValue> product(int depth);
    std::optional<PovValue> factor(int depth);
    std::optional<PovValue> bare_factor(int depth);
    std::optional<PovValue> angle_brackets(int depth);
    std::optional<PovValue> word(int depth);
    std::optional<PovValue> call(std::string_view name, int depth);
    std::optional<PovValue> channels();

    PovTokens& tokens_;
    Lookup lookup_;
};

}  // namespace quartic

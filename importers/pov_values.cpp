// A parser by descent whose depth is bounded.
#include "importers/pov_values.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quartic {
namespace {

constexpr int depth_max = 64;

struct Constant {
    std::string_view name;
    PovValue value;
};

const std::array<Constant, 12> constants{{
    {"x", {{1, 0, 0, 0, 0}, 3}},
    {"y", {{0, 1, 0, 0, 0}, 3}},
    {"z", {{0, 0, 1, 0, 0}, 3}},
    {"pi", PovValue::number(std::numbers::pi)},
    {"tau", PovValue::number(2.0 * std::numbers::pi)},
    {"on", PovValue::number(1.0)},
    {"off", PovValue::number(0.0)},
    {"yes", PovValue::number(1.0)},
    {"no", PovValue::number(0.0)},
    {"true", PovValue::number(1.0)},
    {"false", PovValue::number(0.0)},
    {"version", PovValue::number(3.7)},
}};

struct Function {
    std::string_view name;
    double (*of)(double);
};

constexpr std::array<Function, 13> functions{{
    {"sqrt", [](double a) { return std::sqrt(a); }},
    {"abs", [](double a) { return std::abs(a); }},
    {"sin", [](double a) { return std::sin(a); }},
    {"cos", [](double a) { return std::cos(a); }},
    {"tan", [](double a) { return std::tan(a); }},
    {"asin", [](double a) { return std::asin(a); }},
    {"acos", [](double a) { return std::acos(a); }},
    {"atan", [](double a) { return std::atan(a); }},
    {"exp", [](double a) { return std::exp(a); }},
    {"ln", [](double a) { return std::log(a); }},
    {"radians", [](double a) { return a * std::numbers::pi / 180.0; }},
    {"degrees", [](double a) { return a * 180.0 / std::numbers::pi; }},
    {"int", [](double a) { return std::trunc(a); }},
}};

struct PairFunction {
    std::string_view name;
    double (*of)(double, double);
};

constexpr std::array<PairFunction, 4> pair_functions{{
    {"pow", [](double a, double b) { return std::pow(a, b); }},
    {"min", [](double a, double b) { return std::min(a, b); }},
    {"max", [](double a, double b) { return std::max(a, b); }},
    {"atan2", [](double a, double b) { return std::atan2(a, b); }},
}};

template <class Row, std::size_t count>
const Row* find_row(const std::array<Row, count>& rows, std::string_view name) {
    const auto found =
        std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row.name == name; });
    return found == rows.end() ? nullptr : &*found;
}

// Where the components of rgb, rgbf, rgbt and rgbft go.
struct ColourWord {
    std::string_view name;
    std::array<std::size_t, 5> places;
    bool linear;
};
constexpr std::array<ColourWord, 8> colour_words{{
    {"rgb", {0, 1, 2, 3, 4}, true},
    {"rgbf", {0, 1, 2, 3, 4}, true},
    {"rgbt", {0, 1, 2, 4, 3}, true},
    {"rgbft", {0, 1, 2, 3, 4}, true},
    {"srgb", {0, 1, 2, 3, 4}, false},
    {"srgbf", {0, 1, 2, 3, 4}, false},
    {"srgbt", {0, 1, 2, 4, 3}, false},
    {"srgbft", {0, 1, 2, 3, 4}, false},
}};

constexpr std::array<std::string_view, 7> channel_names{"red",      "green", "blue", "filter",
                                                        "transmit", "gray",  "grey"};

bool is_channel(const PovToken& token) {
    return token.kind == PovTokenKind::word &&
           std::find(channel_names.begin(), channel_names.end(), token.text) != channel_names.end();
}

// IEC 61966-2-1, section 5.2.
double linear_of(double srgb) {
    return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

PovValue as_colour(const ColourWord& word, const PovValue& value) {
    PovValue colour;
    colour.size = 5;
    for (std::size_t i = 0; i < 5; ++i) {
        const bool given = i < 3 || (value.size > 3 && i < value.size);
        colour.of[word.places[i]] = given ? value.of[i] : 0.0;
    }
    for (std::size_t i = 0; i < 3 && !word.linear; ++i) {
        colour.of[i] = linear_of(colour.of[i]);
    }
    return colour;
}

PovValue combined(const PovValue& a, const PovValue& b, char operation) {
    PovValue result;
    result.size = std::max(a.size, b.size);
    for (std::size_t i = 0; i < result.of.size(); ++i) {
        switch (operation) {
            case '+': result.of[i] = a.of[i] + b.of[i]; break;
            case '-': result.of[i] = a.of[i] - b.of[i]; break;
            case '*': result.of[i] = a.of[i] * b.of[i]; break;
            default: result.of[i] = a.of[i] / b.of[i]; break;
        }
    }
    return result;
}

}  // namespace

bool PovExpressions::starts_value() const {
    const PovToken& token = tokens_.peek();
    if (token.kind == PovTokenKind::number || token.is("<") || token.is("(") || token.is("-") ||
        token.is("+")) {
        return true;
    }
    return token.kind == PovTokenKind::word &&
           (find_row(constants, token.text) != nullptr ||
            find_row(functions, token.text) != nullptr ||
            find_row(pair_functions, token.text) != nullptr || lookup_(token.text) != nullptr);
}

bool PovExpressions::starts_colour() const {
    const PovToken& token = tokens_.peek();
    return token.is("color") || token.is("colour") || is_channel(token) ||
           (token.kind == PovTokenKind::word && find_row(colour_words, token.text) != nullptr);
}

std::optional<PovValue> PovExpressions::value() {
    return starts_colour() ? colour() : sum(0);
}

std::optional<double> PovExpressions::number() {
    const std::optional<PovValue> result = sum(0);
    return result && result->size == 1 && std::isfinite(result->of[0])
               ? std::optional(result->of[0])
               : std::nullopt;
}

std::optional<glm::dvec3> PovExpressions::vector() {
    const std::optional<PovValue> result = sum(0);
    const bool finite = result && std::isfinite(result->of[0]) && std::isfinite(result->of[1]) &&
                        std::isfinite(result->of[2]);
    return finite ? std::optional(result->vector()) : std::nullopt;
}

std::optional<PovValue> PovExpressions::colour() {
    if (!tokens_.take_if("color")) {
        tokens_.take_if("colour");
    }
    if (is_channel(tokens_.peek())) {
        return channels();
    }
    std::optional<PovValue> result = sum(0);
    if (result && result->size < 5) {
        result = as_colour(colour_words[0], *result);
    }
    return result;
}

// red 1 green 0.5: what is not said is 0.
std::optional<PovValue> PovExpressions::channels() {
    PovValue colour;
    colour.size = 5;
    while (is_channel(tokens_.peek())) {
        const std::string_view name = tokens_.take().text;
        const std::optional<PovValue> level = product(0);
        if (!level) {
            return std::nullopt;
        }
        const auto place = static_cast<std::size_t>(
            std::find(channel_names.begin(), channel_names.end(), name) - channel_names.begin());
        if (place < 5) {
            colour.of[place] = level->of[0];
        } else {
            colour.of[0] = colour.of[1] = colour.of[2] = level->of[0];
        }
    }
    return colour;
}

std::optional<std::vector<double>> PovExpressions::list(std::size_t most) {
    if (!tokens_.take_if("<")) {
        return std::nullopt;
    }
    std::vector<double> numbers;
    while (!tokens_.take_if(">")) {
        const std::optional<double> next = number();
        if (!next || numbers.size() >= most) {
            return std::nullopt;
        }
        numbers.push_back(*next);
        comma();
    }
    return numbers;
}

std::optional<PovValue> PovExpressions::sum(int depth) {
    std::optional<PovValue> left = product(depth);
    while (left && (tokens_.peek().is("+") || tokens_.peek().is("-"))) {
        const char operation = tokens_.take().text[0];
        const std::optional<PovValue> right = product(depth);
        left = right ? std::optional(combined(*left, *right, operation)) : std::nullopt;
    }
    return left;
}

std::optional<PovValue> PovExpressions::product(int depth) {
    std::optional<PovValue> left = factor(depth);
    while (left && (tokens_.peek().is("*") || tokens_.peek().is("/"))) {
        const char operation = tokens_.take().text[0];
        const std::optional<PovValue> right = factor(depth);
        left = right ? std::optional(combined(*left, *right, operation)) : std::nullopt;
    }
    return left;
}

// A factor with signs before it, and .x or .red behind it.
std::optional<PovValue> PovExpressions::factor(int depth) {
    double sign = 1.0;
    while (tokens_.peek().is("-") || tokens_.peek().is("+")) {
        sign = tokens_.take().is("-") ? -sign : sign;
    }
    std::optional<PovValue> result = bare_factor(depth);
    constexpr std::array<std::string_view, 8> members{"x", "y",   "z",     "t",
                                                      "",  "red", "green", "blue"};
    while (result && result->size > 1 && tokens_.take_if(".")) {
        const auto found = std::find(members.begin(), members.end(), tokens_.take().text);
        if (found == members.end()) {
            return std::nullopt;
        }
        result =
            PovValue::number(result->of[static_cast<std::size_t>(found - members.begin()) % 5]);
    }
    return result && sign < 0.0 ? combined(PovValue::number(0.0), *result, '-') : result;
}

std::optional<PovValue> PovExpressions::bare_factor(int depth) {
    if (depth >= depth_max) {
        return std::nullopt;
    }
    const PovToken& token = tokens_.peek();
    if (token.kind == PovTokenKind::number) {
        return PovValue::number(tokens_.take().number);
    }
    if (token.kind == PovTokenKind::word) {
        return word(depth);
    }
    if (tokens_.take_if("(")) {
        const std::optional<PovValue> inside = sum(depth + 1);
        return tokens_.take_if(")") ? inside : std::nullopt;
    }
    return tokens_.take_if("<") ? angle_brackets(depth) : std::nullopt;
}

std::optional<PovValue> PovExpressions::angle_brackets(int depth) {
    PovValue result;
    result.size = 0;
    while (!tokens_.take_if(">")) {
        const std::optional<PovValue> next = sum(depth + 1);
        if (!next || next->size != 1 || result.size >= 5) {
            return std::nullopt;
        }
        result.of[result.size++] = next->of[0];
        comma();
    }
    return result.size >= 2 ? std::optional(result) : std::nullopt;
}

std::optional<PovValue> PovExpressions::word(int depth) {
    const std::string_view name = tokens_.peek().text;
    if (const ColourWord* colour = find_row(colour_words, name)) {
        tokens_.take();
        const std::optional<PovValue> of = factor(depth + 1);
        return of ? std::optional(as_colour(*colour, *of)) : std::nullopt;
    }
    if (find_row(functions, name) != nullptr || find_row(pair_functions, name) != nullptr) {
        return call(name, depth);
    }
    if (const PovValue* declared = lookup_(name)) {
        tokens_.take();
        return *declared;
    }
    if (const Constant* constant = find_row(constants, name)) {
        tokens_.take();
        return constant->value;
    }
    return std::nullopt;
}

std::optional<PovValue> PovExpressions::call(std::string_view name, int depth) {
    const Function* single = find_row(functions, name);
    const PairFunction* pair = find_row(pair_functions, name);
    tokens_.take();
    if (!tokens_.take_if("(")) {
        return std::nullopt;
    }
    std::optional<PovValue> result = sum(depth + 1);
    if (result && single != nullptr) {
        result = PovValue::number(single->of(result->of[0]));
    }
    while (result && pair != nullptr && tokens_.take_if(",")) {
        const std::optional<PovValue> second = sum(depth + 1);
        result = second ? std::optional(PovValue::number(pair->of(result->of[0], second->of[0])))
                        : std::nullopt;
    }
    return tokens_.take_if(")") ? result : std::nullopt;
}

}  // namespace quartic

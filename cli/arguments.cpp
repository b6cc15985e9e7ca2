// Parses and checks the arguments that verbs share.
#include "cli/arguments.h"

#include "solvers/solver_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

namespace quartic::cli {
namespace {

constexpr int size_max_px = 16384;
constexpr std::array<std::string_view, layer_count> layer_names{"normal", "obstruction",
                                                                "insulation", "line"};

// Reads one number at the start of the text and takes it off.
template <class Number>
bool take_number(std::string_view& text, Number& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc()) {
        return false;
    }
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return true;
}

bool take_sign(std::string_view& text, char sign) {
    if (!text.starts_with(sign)) {
        return false;
    }
    text.remove_prefix(1);
    return true;
}

// "lines" is what people say; the layer's name is "line".
std::optional<std::size_t> find_layer(std::string_view text) {
    for (std::size_t layer = 0; layer < layer_names.size(); ++layer) {
        const bool plural =
            text.ends_with('s') && text.substr(0, text.size() - 1) == layer_names[layer];
        if (text == layer_names[layer] || plural) {
            return layer;
        }
    }
    return {};
}

// How many letters differ: Levenshtein's distance, row by row.
std::size_t distance_between(std::string_view left, std::string_view right) {
    std::vector<std::size_t> row(right.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < left.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < right.size(); ++j) {
            const std::size_t changed = diagonal + (left[i] == right[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({changed, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

// The program itself where no verb has this name.
const CLI::App* find_verb(const CLI::App& program, const std::string& name) {
    const auto named =
        program.get_subcommands([&](const CLI::App* verb) { return verb->check_name(name); });
    return named.empty() ? &program : named.front();
}

std::string complain(const CLI::App& verb, const std::string& option) {
    std::string nearest;
    std::size_t least = 4;  // farther than this is another word
    for (const CLI::Option* known : verb.get_options()) {
        for (const std::string& name : known->get_lnames()) {
            const std::size_t distance = distance_between(option.substr(2), name);
            if (distance < least) {
                least = distance;
                nearest = name;
            }
        }
    }
    std::string text = option + ": expected an option of this verb, found an unknown one";
    text += nearest.empty() ? "" : "; did you mean --" + nearest + "?";
    return text;
}

}  // namespace

void add_reporting(CLI::App& verb, Reporting& reporting) {
    verb.add_flag("--json", reporting.json, "print data as JSON on standard output");
    verb.add_flag("--verbose", reporting.verbose, "print everything that was noticed");
    verb.add_flag("--quiet", reporting.quiet, "print errors and losses only");
    verb.add_flag("--strict", reporting.strict,
                  "elements that were lost are a failure (exit code 1)");
    verb.add_option("--progress", reporting.progress,
                    "auto (a bar on a terminal), json or none, on standard error")
        ->check(CLI::IsMember({"auto", "json", "none"}));
    verb.add_option("--time-limit", reporting.time_limit_s, "give up after so many seconds")
        ->check(CLI::Range(0, 1000000));
}

std::optional<PixelSize> find_size(std::string_view text) {
    PixelSize size;
    bool whole = take_number(text, size.width);
    size.height = size.width;
    if (whole && !text.empty()) {
        whole = take_sign(text, 'x') && take_number(text, size.height) && text.empty();
    }
    const auto [low, high] = std::minmax(size.width, size.height);
    return whole && low >= 1 && high <= size_max_px ? std::optional(size) : std::nullopt;
}

std::optional<glm::dvec3> find_vector(std::string_view text) {
    glm::dvec3 v;
    const bool whole = take_number(text, v.x) && take_sign(text, ',') && take_number(text, v.y) &&
                       take_sign(text, ',') && take_number(text, v.z) && text.empty();
    const bool finite = std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    return whole && finite ? std::optional(v) : std::nullopt;
}

std::string check_size(const std::string& text) {
    return find_size(text) ? std::string()
                           : "expected WIDTHxHEIGHT such as 1600x1000, or one number for a square, "
                             "from 1 to 16384, found '" +
                                 text + "'";
}

std::string check_vector(const std::string& text) {
    return find_vector(text) ? std::string()
                             : "expected x,y,z such as 1,2.5,-3, found '" + text + "'";
}

std::string check_solver(const std::string& text) {
    return find_solver(text) != nullptr
               ? std::string()
               : "no solver is called '" + text + "'; see quartic --list-solvers";
}

std::string check_layer(const std::string& text) {
    return find_layer(text)
               ? std::string()
               : "expected normal, obstruction, insulation or lines, found '" + text + "'";
}

int solver_number(const std::string& name) {
    const SolverRow* row = find_solver(name);
    return row == nullptr ? 0 : row->id;
}

std::array<bool, layer_count> chosen_layers(const std::vector<std::string>& shown,
                                            const std::vector<std::string>& hidden) {
    std::array<bool, layer_count> layers{true, true, true, false};
    for (const std::string& name : shown) {
        layers[find_layer(name).value_or(0)] = true;
    }
    for (const std::string& name : hidden) {
        layers[find_layer(name).value_or(0)] = false;
    }
    return layers;
}

std::string find_unknown_word(const CLI::App& program, int count, const char* const* arguments) {
    const CLI::App* verb = &program;
    for (int i = 1; i < count; ++i) {
        const std::string argument = arguments[i];
        if (argument == "--") {
            break;
        }
        if (verb == &program && !argument.starts_with('-')) {
            verb = find_verb(program, argument);
            if (verb == &program) {
                return argument + ": expected a verb, found an unknown word";
            }
            continue;
        }
        const std::string option = argument.substr(0, argument.find('='));
        if (option.starts_with("--") && verb->get_option_no_throw(option) == nullptr) {
            return complain(*verb, option);
        }
    }
    return {};
}

}  // namespace quartic::cli

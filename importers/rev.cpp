// Loads the text form of AVEVA RVM (.rev): one value or row of values on a line, chunk ids on lines
// of their own.
#include "importers/attributes.h"
#include "importers/formats.h"
#include "importers/rvm_groups.h"
#include "importers/rvm_materials.h"
#include "importers/rvm_primitive.h"
#include "importers/text_encoding.h"
#include "importers/text_lines.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace quartic {
namespace {

constexpr std::size_t placement_count = 18;  // matrix and box

enum class Chunk {
    head,
    model,
    group,
    group_end,
    primitive,
    obstruction,
    insulation,
    colour,
    end,
    none
};

Chunk chunk_of(std::string_view line) {
    constexpr std::array<std::pair<std::string_view, Chunk>, 9> ids{{{"HEAD", Chunk::head},
                                                                     {"MODL", Chunk::model},
                                                                     {"CNTB", Chunk::group},
                                                                     {"CNTE", Chunk::group_end},
                                                                     {"PRIM", Chunk::primitive},
                                                                     {"OBST", Chunk::obstruction},
                                                                     {"INSU", Chunk::insulation},
                                                                     {"COLR", Chunk::colour},
                                                                     {"END:", Chunk::end}}};
    for (const auto& [id, chunk] : ids) {
        if (line == id) {
            return chunk;
        }
    }
    return Chunk::none;
}

// Appends the numbers of a line; false where there is something else. What printf makes of NaN and
// infinity on Windows (1.#QNAN) is NaN.
bool append_numbers(std::string_view line, std::vector<double>& numbers) {
    while (!(line = trimmed(line)).empty()) {
        double value = 0.0;
        const auto [end, failure] = std::from_chars(line.data(), line.data() + line.size(), value);
        if (failure == std::errc::invalid_argument) {
            return false;
        }
        auto used = static_cast<std::size_t>(end - line.data());
        const bool special = used < line.size() && line[used] == '#';
        if (special) {
            used = std::min(line.find_first_of(" \t"), line.size());
        }
        if (special || failure == std::errc::result_out_of_range) {
            value = std::numeric_limits<double>::quiet_NaN();
        }
        numbers.push_back(value);
        line.remove_prefix(used);
    }
    return true;
}

// A number that may be a count: whole and within 32 bits.
std::optional<std::uint32_t> count_of(double number) {
    const bool whole = number >= 0.0 && number <= 4294967295.0 && number == std::floor(number);
    return whole ? std::optional(static_cast<std::uint32_t>(number)) : std::nullopt;
}

class RevReader {
public:
    RevReader(std::string_view text, Scene& scene)
        : scene_(scene), lines_(text), groups_(scene), converter_(scene, tally_) {}

    std::optional<Error> run(Progress& progress);
    void finish();

private:
    bool next_line();
    void skip_to_chunk();
    std::uint32_t read_version();
    std::string read_text();
    void read_numbers();
    void read_head();
    void read_model();
    void begin_group();
    void read_colour();
    void read_primitive(Layer layer);
    std::size_t find_transparency(RvmKind kind, Layer layer) const;
    bool read_facets(std::span<const double> numbers);
    void fill(RvmPrimitive& primitive, std::size_t skipped_at, std::span<const double>& rest) const;
    void skip_primitive(std::uint32_t kind, std::string_view reason, std::size_t place);
    bool step();

    Scene& scene_;
    LineReader lines_;
    RvmGroups groups_;
    RvmTally tally_;
    RvmConverter converter_;
    RvmColours colours_;
    RvmMaterials materials_;
    RvmFacets facets_;
    std::vector<double> numbers_;
    std::string_view line_;  // trimmed; the next to be read
    bool has_line_ = false;
    bool is_whole_ = true;  // false: the text stopped within the last record's last line
    bool has_end_ = false;
};

bool RevReader::next_line() {
    has_line_ = lines_.next(line_);
    line_ = trimmed(line_);
    return has_line_;
}

void RevReader::skip_to_chunk() {
    while (has_line_ && chunk_of(line_) == Chunk::none) {
        next_line();
    }
}

std::uint32_t RevReader::read_version() {
    numbers_.clear();
    const bool sound = has_line_ && append_numbers(line_, numbers_) && !numbers_.empty();
    if (!sound) {
        return 0;
    }
    next_line();
    return count_of(numbers_[0]).value_or(0);
}

std::string RevReader::read_text() {
    std::string text;
    if (has_line_) {
        text = to_utf8(line_, Encoding::guessed);
        next_line();
    }
    return text;
}

// All numbers up to the next chunk's id, or up to a line that is neither.
void RevReader::read_numbers() {
    numbers_.clear();
    while (has_line_ && chunk_of(line_) == Chunk::none && append_numbers(line_, numbers_)) {
        is_whole_ = lines_.ended();
        next_line();
    }
}

void RevReader::read_head() {
    read_version();
    const std::string program = read_text();
    read_text();  // note
    const std::string date = read_text();
    scene_.findings.add(Severity::note, "line 1, HEAD", "written by " + program + ", " + date);
    skip_to_chunk();
}

void RevReader::read_model() {
    read_version();
    const std::string project = chunk_of(line_) == Chunk::none ? read_text() : std::string();
    const std::string name = chunk_of(line_) == Chunk::none ? read_text() : std::string();
    scene_.title = name.empty() ? project : name;
}

void RevReader::begin_group() {
    const std::size_t place = lines_.number();
    const std::uint32_t version = read_version();
    const std::string name = read_text();
    read_numbers();
    glm::dvec3 position(0.0);
    for (std::size_t axis = 0; axis < 3 && axis < numbers_.size(); ++axis) {
        position[static_cast<int>(axis)] = std::isfinite(numbers_[axis]) ? numbers_[axis] : 0.0;
    }
    if (numbers_.size() < 4) {
        tally_.notice(Severity::warning, "a group's header is cut short", place);
    }
    const std::uint32_t colour = numbers_.size() > 3 ? count_of(numbers_[3]).value_or(0) : 0;
    std::optional<std::uint8_t> transparency;
    if (version > 2 && numbers_.size() > 4) {
        transparency = static_cast<std::uint8_t>(std::min(count_of(numbers_[4]).value_or(0), 100u));
    }
    groups_.begin(name, position, colour, transparency);
}

void RevReader::read_colour() {
    const std::size_t place = lines_.number();
    read_version();
    read_numbers();
    if (numbers_.size() < 4) {
        tally_.notice(Severity::warning, "a colour definition is cut short", place);
        return;
    }
    const auto channel = [&](std::size_t i) {
        return static_cast<std::uint8_t>(std::min(count_of(numbers_[i]).value_or(0), 255u));
    };
    colours_.set(count_of(numbers_[0]).value_or(0), channel(1), channel(2), channel(3));
}

void RevReader::skip_primitive(std::uint32_t kind, std::string_view reason, std::size_t place) {
    tally_.add(rvm_kind_name(kind), Became::skipped, reason, Severity::loss, place);
}

// Polygons, contours, corners: counts and coordinates in one row of numbers.
bool RevReader::read_facets(std::span<const double> numbers) {
    facets_.clear();
    std::size_t at = 0;
    const auto count = [&](std::size_t least_each) -> std::optional<std::uint32_t> {
        const std::optional<std::uint32_t> read =
            at < numbers.size() ? count_of(numbers[at]) : std::nullopt;
        ++at;
        const bool fits = read && std::uint64_t{*read} * least_each <= numbers.size() - at;
        return fits ? read : std::nullopt;
    };
    const std::optional<std::uint32_t> polygons = count(1);
    for (std::uint32_t polygon = 0; polygons && polygon < *polygons; ++polygon) {
        const std::optional<std::uint32_t> contours = count(1);
        for (std::uint32_t contour = 0; contours && contour < *contours; ++contour) {
            const std::optional<std::uint32_t> corners = count(6);
            if (!corners) {
                return false;
            }
            for (std::uint32_t corner = 0; corner < *corners; ++corner, at += 6) {
                facets_.positions.emplace_back(numbers[at], numbers[at + 1], numbers[at + 2]);
                facets_.normals.emplace_back(numbers[at + 3], numbers[at + 4], numbers[at + 5]);
            }
            facets_.contour_sizes.push_back(*corners);
        }
        if (!contours) {
            return false;
        }
        facets_.contour_counts.push_back(*contours);
    }
    return polygons.has_value();
}

// The primitive's numbers without the one at skipped_at (a transparency); rest: what follows the
// box.
void RevReader::fill(RvmPrimitive& primitive, std::size_t skipped_at,
                     std::span<const double>& rest) const {
    const auto number = [&](std::size_t i) {
        return static_cast<float>(numbers_[i < skipped_at ? i : i + 1]);
    };
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 4; ++column) {
            primitive.matrix[3 * column + row] = number(4 * row + column);
        }
    }
    for (std::size_t i = 0; i < 6; ++i) {
        primitive.box[i] = number(12 + i);
    }
    rest = std::span(numbers_).subspan(placement_count + (skipped_at <= placement_count ? 1 : 0));
}

// Where a volume's transparency stands: before the matrix or after the box, whichever leaves a
// sound placement.
std::size_t RevReader::find_transparency(RvmKind kind, Layer layer) const {
    constexpr std::size_t nowhere = ~std::size_t{0};
    const std::size_t count =
        placement_count + rvm_parameter_counts[static_cast<std::size_t>(kind)];
    const bool has_one = kind == RvmKind::facet_group || numbers_.size() > count;
    if (layer == Layer::normal || !has_one || numbers_.size() < placement_count + 1) {
        return nowhere;
    }
    for (const std::size_t at : {std::size_t{0}, placement_count}) {
        const std::optional<std::uint32_t> value = count_of(numbers_[at]);
        RvmPrimitive trial;
        std::span<const double> rest;
        fill(trial, at, rest);
        const bool ordered = trial.box[0] <= trial.box[3] && trial.box[1] <= trial.box[4] &&
                             trial.box[2] <= trial.box[5];
        if (value && *value <= 100 && ordered && is_similar(trial.matrix, MatrixForm::text)) {
            return at;
        }
    }
    return kind == RvmKind::facet_group ? nowhere : 0;
}

void RevReader::read_primitive(Layer layer) {
    const std::size_t place = lines_.number();
    read_version();
    read_numbers();
    const std::uint32_t number = numbers_.empty() ? 0 : count_of(numbers_[0]).value_or(0);
    if (number == 0 || number >= rvm_kind_end) {
        skip_primitive(number, "a kind of primitive that is not known", place);
        return;
    }
    numbers_.erase(numbers_.begin());
    RvmPrimitive primitive;
    primitive.kind = static_cast<RvmKind>(number);
    primitive.form = MatrixForm::text;
    const std::size_t skipped_at = find_transparency(primitive.kind, layer);
    const std::size_t parameter_count = rvm_parameter_counts[number];
    const std::size_t least =
        placement_count + parameter_count + (skipped_at <= placement_count ? 1 : 0);
    const bool cut = !has_line_ && !is_whole_;
    if (numbers_.size() < least || cut) {
        skip_primitive(number, "the record is cut short", place);
        return;
    }
    std::span<const double> rest;
    fill(primitive, skipped_at, rest);
    RvmLook look = groups_.look(groups_.current());
    if (skipped_at <= placement_count) {
        look.transparency =
            static_cast<std::uint8_t>(std::min(count_of(numbers_[skipped_at]).value_or(0), 100u));
    }
    Part part;
    part.node = groups_.current();
    part.layer = rvm_layer(primitive.kind, layer);
    part.material = materials_.number_of(look, part.layer);
    if (primitive.kind != RvmKind::facet_group) {
        std::transform(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(parameter_count),
                       primitive.values.begin(),
                       [](double value) { return static_cast<float>(value); });
        converter_.add(primitive, part, place);
    } else if (read_facets(rest)) {
        converter_.add_facets(primitive, facets_, part, place);
    } else {
        skip_primitive(number, "a count of the facet group exceeds the record", place);
    }
}

// One chunk, whose id is the current line; false at the end.
bool RevReader::step() {
    skip_to_chunk();
    if (!has_line_) {
        return false;
    }
    const Chunk chunk = chunk_of(line_);
    const std::size_t place = lines_.number();
    next_line();
    switch (chunk) {
        case Chunk::head: read_head(); break;
        case Chunk::model: read_model(); break;
        case Chunk::group: begin_group(); break;
        case Chunk::group_end:
            read_version();
            if (!groups_.end()) {
                tally_.notice(Severity::warning, "a group ends that never began", place);
            }
            break;
        case Chunk::primitive: read_primitive(Layer::normal); break;
        case Chunk::obstruction: read_primitive(Layer::obstruction); break;
        case Chunk::insulation: read_primitive(Layer::insulation); break;
        case Chunk::colour: read_colour(); break;
        case Chunk::end: has_end_ = true; return false;
        case Chunk::none: break;
    }
    if (has_line_ && chunk_of(line_) == Chunk::none && !line_.empty()) {
        tally_.notice(Severity::warning, "lines that belong to no known record, skipped",
                      lines_.number());
    }
    return true;
}

std::optional<Error> RevReader::run(Progress& progress) {
    next_line();
    for (std::uint64_t count = 0; step(); ++count) {
        if (count % 4096 == 0 && progress.cancelled()) {
            return Error{ErrorKind::interrupted, "", "the import was cancelled"};
        }
    }
    const std::size_t last = lines_.number();
    if (!has_end_ && scene_.nodes.empty()) {
        return Error{
            ErrorKind::bad_data, "line " + std::to_string(last),
            "expected a group or primitive after the header, found none; copy the file again"};
    }
    if (!has_end_) {
        tally_.notice(Severity::loss,
                      "the file ends before its END: line; what stands before it is loaded", last);
    } else if (groups_.is_open()) {
        tally_.notice(Severity::warning, "groups are still open at the end", last);
    }
    return std::nullopt;
}

void RevReader::finish() {
    scene_.materials = materials_.make(colours_);
    tally_.write(scene_, "line");
}

std::string_view as_text(std::span<const std::byte> bytes) {
    std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    text.remove_prefix(text.starts_with("\xef\xbb\xbf") ? 3 : 0);
    return text;
}

bool recognises(std::span<const std::byte> head, std::string_view) {
    const std::string_view text = as_text(head);
    return text.starts_with("HEAD\r\n") || text.starts_with("HEAD\n") ||
           text.starts_with("HEAD \n");
}

Result<Scene> load(const Source& source, const ImportOptions& options, Progress& progress) {
    if (!recognises(source.bytes(), "rev")) {
        return Error{ErrorKind::bad_data, source.path() + ", line 1",
                     "expected HEAD, found something else"};
    }
    Scene scene;
    RevReader reader(as_text(source.bytes()), scene);
    if (const std::optional<Error> error = reader.run(progress)) {
        const std::string where =
            error->where.empty() ? source.path() : source.path() + ", " + error->where;
        return Error{error->kind, where, error->message};
    }
    reader.finish();
    if (Status joined = join_attributes_of(scene, source, options, progress); !joined) {
        return joined.error();
    }
    progress.report(1.0);
    return scene;
}

}  // namespace

Importer rev_importer() {
    static constexpr std::array<std::string_view, 1> extensions{"rev"};
    return {"an AVEVA RVM model in text form (.rev)", extensions, recognises, load};
}

}  // namespace quartic

// Objects of scene files: parameters, children, transformations, limits and colours.
#include "importers/pov_reader.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace quartic {
namespace {

struct KindRow {
    std::string_view word;
    PovKind kind;
    std::string_view pattern;  // of the parameters: v a vector, n a number
};

constexpr std::array<KindRow, 17> kind_rows{{
    {"union", PovKind::group, ""},
    {"merge", PovKind::group, ""},
    {"object", PovKind::group, ""},
    {"intersection", PovKind::intersection, ""},
    {"difference", PovKind::intersection, ""},
    {"cubic", PovKind::algebraic, ""},
    {"quartic", PovKind::algebraic, ""},
    {"poly", PovKind::algebraic, ""},
    {"quadric", PovKind::algebraic, "vvvn"},
    {"sphere", PovKind::sphere, "vn"},
    {"box", PovKind::box, "vv"},
    {"cylinder", PovKind::cylinder, "vvn"},
    {"cone", PovKind::cone, "vnvn"},
    {"torus", PovKind::torus, "nn"},
    {"disc", PovKind::disc, "vvn"},
    {"plane", PovKind::plane, "vn"},
    {"mesh2", PovKind::mesh, ""},
}};

const KindRow* find_kind(std::string_view word) {
    const auto found = std::find_if(kind_rows.begin(), kind_rows.end(),
                                    [&](const KindRow& row) { return row.word == word; });
    return found == kind_rows.end() ? nullptr : &*found;
}

// Words of objects that change nothing of what we draw.
constexpr std::array<std::string_view, 18> flags{
    "sturm",        "hollow",     "no_shadow",     "no_image",          "no_reflection",
    "finish",       "normal",     "interior",      "double_illuminate", "photons",
    "no_radiosity", "material",   "inside_vector", "interior_texture",  "split_union",
    "hierarchy",    "uv_mapping", "no_bump_scale"};

std::string first_line(std::string_view comment) {
    constexpr std::size_t longest = 60;
    const std::string_view line = comment.substr(0, comment.find_first_of("\r\n"));
    return std::string(line.substr(0, line.size() <= longest ? line.size() : 0));
}

std::string counted(std::string_view expected, std::size_t found) {
    return "expected " + std::string(expected) + ", found " + std::to_string(found) +
           "; write zeros for the terms that are absent";
}

}  // namespace

void PovObject::transform(const glm::dmat4& next) {
    matrix = next * matrix;
    for (auto* limits : {&clips, &bounds}) {
        for (PovPlaced& limit : *limits) {
            limit.matrix = next * limit.matrix;
        }
    }
}

bool PovReader::starts_object() const {
    return tokens_.peek().kind == PovTokenKind::word && find_kind(tokens_.peek().text) != nullptr;
}

PovReader::Object PovReader::object() {
    const PovToken token = tokens_.take();
    const KindRow& row = *find_kind(token.text);
    const auto result = std::make_shared<PovObject>();
    result->kind = row.kind;
    result->word = row.word;
    result->line = token.line;
    result->name = first_line(token.comment);
    const int depth = tokens_.depth();
    ++nesting_;
    const std::string outer_reason = std::exchange(reason_, {});
    const bool sound = nesting_ > pov_depth_max ? fail("expected fewer objects within each other")
                       : !tokens_.take_if("{")  ? fail("expected { behind the object's word")
                                                : block(*result);
    --nesting_;
    if (!sound) {
        lose(token.line, std::string(row.word) + ": " + reason_);
        tokens_.skip_to_depth(depth);
    }
    reason_ = outer_reason;
    return sound ? result : nullptr;
}

bool PovReader::block(PovObject& object) {
    if (!parameters(object)) {
        return false;
    }
    while (!tokens_.take_if("}")) {
        if (tokens_.peek().kind == PovTokenKind::end) {
            return fail("expected the object's closing }, found the end of the file");
        }
        if (tokens_.peek().kind == PovTokenKind::directive) {
            directive();
        } else if (!modifier(object)) {
            return false;
        }
    }
    return true;
}

bool PovReader::parameters(PovObject& object) {
    const bool named =
        tokens_.peek().kind == PovTokenKind::word && objects_.contains(tokens_.peek().text);
    if (named) {
        return reference(object);
    }
    if (object.word == "object") {
        return starts_object() ||
               fail("expected a declared object, found '" + std::string(tokens_.peek().text) + "'");
    }
    if (object.word == "cubic" || object.word == "quartic") {
        return coefficients(object);
    }
    if (object.word == "poly") {
        return poly(object);
    }
    if (object.kind == PovKind::mesh) {
        return true;
    }
    if (!numbers(object, find_kind(object.word)->pattern)) {
        return fail("expected its numbers and vectors, found something else");
    }
    if (object.kind == PovKind::disc) {
        expressions_.comma();
        object.numbers.push_back(expressions_.starts_value() ? expressions_.number().value_or(0.0)
                                                             : 0.0);
    }
    return object.word != "quadric" || quadric(object);
}

// A name in place of parameters: the declared object, as a child.
bool PovReader::reference(PovObject& object) {
    const std::string_view name = tokens_.take().text;
    const auto& declared = objects_.find(name)->second;
    object.kind = PovKind::group;
    object.name = object.name.empty() ? std::string(name) : object.name;
    object.children.push_back({declared, glm::dmat4(1.0)});
    object.depth = declared->depth + 1;
    object.count = std::min(pov_count_max, declared->count + 1);
    return object.depth <= pov_depth_max || fail("expected fewer objects within each other");
}

bool PovReader::numbers(PovObject& object, std::string_view pattern) {
    for (const char each : pattern) {
        if (each == 'n') {
            const std::optional<double> number = expressions_.number();
            object.numbers.push_back(number.value_or(0.0));
            if (!number) {
                return false;
            }
        } else {
            const std::optional<glm::dvec3> vector = expressions_.vector();
            const glm::dvec3 v = vector.value_or(glm::dvec3(0.0));
            object.numbers.insert(object.numbers.end(), {v.x, v.y, v.z});
            if (!vector) {
                return false;
            }
        }
        expressions_.comma();
    }
    return true;
}

bool PovReader::coefficients(PovObject& object) {
    const std::size_t expected = object.word == "cubic" ? 20 : 35;
    const auto list = expressions_.list(1000);
    if (!list) {
        return fail("expected coefficients in angle brackets");
    }
    if (list->size() != expected) {
        return fail(counted(std::to_string(expected) + " coefficients", list->size()));
    }
    object.polynomial = expected == 20 ? Polynomial3::from_cubic(std::span<const double, 20>(*list))
                                       : Polynomial3(std::span<const double, 35>(*list));
    return true;
}

bool PovReader::poly(PovObject& object) {
    const std::optional<double> order = expressions_.number();
    expressions_.comma();
    if (!order || *order < 2.0 || *order > 4.0 || *order != std::floor(*order)) {
        return fail("expected a polynomial of degree 2, 3 or 4; others cannot be drawn");
    }
    constexpr std::array<std::size_t, 3> counts{10, 20, 35};
    const std::size_t expected = counts[static_cast<std::size_t>(*order) - 2];
    const auto list = expressions_.list(1000);
    if (!list || list->size() != expected) {
        return fail(counted(std::to_string(expected) + " coefficients", list ? list->size() : 0));
    }
    if (expected == 10) {  // x^2, xy, xz, x, y^2, yz, y, z^2, z, 1
        const auto& c = *list;
        object.numbers = {c[0], c[4], c[7], c[1], c[2], c[5], c[3], c[6], c[8], c[9]};
        return quadric(object);
    }
    object.polynomial = expected == 20 ? Polynomial3::from_cubic(std::span<const double, 20>(*list))
                                       : Polynomial3(std::span<const double, 35>(*list));
    return true;
}

// In the order of the quadric statement: squares, products xy xz yz, x y z, 1.
bool PovReader::quadric(PovObject& object) {
    const Polynomial3 x = Polynomial3::x();
    const Polynomial3 y = Polynomial3::y();
    const Polynomial3 z = Polynomial3::z();
    const std::vector<double>& c = object.numbers;
    object.polynomial = c[0] * (x * x) + c[1] * (y * y) + c[2] * (z * z) + c[3] * (x * y) +
                        c[4] * (x * z) + c[5] * (y * z) + c[6] * x + c[7] * y + c[8] * z + c[9];
    return true;
}

bool PovReader::child(PovObject& object, std::vector<PovPlaced>& into) {
    const Object read = this->object();
    if (!read) {
        return true;  // counted as lost
    }
    into.push_back({read, glm::dmat4(1.0)});
    object.depth = std::max(object.depth, read->depth + 1);
    object.count = std::min(pov_count_max, object.count + read->count);
    return object.depth <= pov_depth_max || fail("expected fewer objects within each other");
}

bool PovReader::modifier(PovObject& object) {
    const PovToken token = tokens_.peek();
    if (token.is("texture") || token.is("pigment") || token.is("material")) {
        look(object);
        return true;
    }
    if (token.is("clipped_by") || token.is("bounded_by")) {
        return limits(object);
    }
    if (transformation(object)) {
        return reason_.empty();
    }
    if (starts_object()) {
        return child(object, object.children);
    }
    if (object.kind == PovKind::mesh && mesh2(object)) {
        return reason_.empty();
    }
    tokens_.take();
    object.open = object.open || token.is("open");
    object.inverse = object.inverse != token.is("inverse");
    const int depth = tokens_.depth();
    if (tokens_.take_if("{")) {
        tokens_.skip_to_depth(depth);
    } else if (token.kind == PovTokenKind::word && expressions_.starts_value()) {
        expressions_.value();
    }
    const bool known = std::find(flags.begin(), flags.end(), token.text) != flags.end() ||
                       token.is("open") || token.is("inverse") || token.is(",") || token.is(";");
    if (!known) {
        note(Severity::warning, token.line,
             "words within objects that are not known (" + std::string(token.text) + "), skipped");
    }
    return true;
}

// False where no transformation stands; a wrong one leaves a reason.
bool PovReader::transformation(PovObject& object) {
    const PovToken token = tokens_.peek();
    glm::dmat4 next(1.0);
    if (token.is("matrix")) {
        tokens_.take();
        if (matrix(next)) {
            object.transform(next);
        }
        return true;
    }
    if (!token.is("scale") && !token.is("rotate") && !token.is("translate")) {
        return false;
    }
    tokens_.take();
    const std::optional<glm::dvec3> vector = expressions_.vector();
    if (!vector) {
        fail("expected a vector behind " + std::string(token.text));
    } else if (token.is("scale")) {
        const glm::dvec3 sound = glm::mix(*vector, glm::dvec3(1.0), glm::equal(*vector, {0, 0, 0}));
        object.transform(glm::scale(next, sound));
    } else if (token.is("translate")) {
        object.transform(glm::translate(next, *vector));
    } else {  // about x, then y, then z
        next = glm::rotate(next, glm::radians(vector->z), {0.0, 0.0, 1.0});
        next = glm::rotate(next, glm::radians(vector->y), {0.0, 1.0, 0.0});
        object.transform(glm::rotate(next, glm::radians(vector->x), {1.0, 0.0, 0.0}));
    }
    return true;
}

bool PovReader::matrix(glm::dmat4& result) {
    const auto list = expressions_.list(12);
    if (!list || list->size() != 12) {
        return fail("expected a matrix of 12 numbers");
    }
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 3; ++row) {
            result[column][row] = (*list)[static_cast<std::size_t>(3 * column + row)];
        }
    }
    return true;
}

bool PovReader::limits(PovObject& object) {
    std::vector<PovPlaced>& into = tokens_.take().is("clipped_by") ? object.clips : object.bounds;
    if (!tokens_.take_if("{")) {
        return fail("expected { behind clipped_by or bounded_by");
    }
    while (!tokens_.take_if("}")) {
        const PovToken token = tokens_.peek();
        if (starts_object()) {
            if (!child(object, into)) {
                return false;
            }
        } else if (token.is("clipped_by") || token.is("bounded_by")) {
            tokens_.take();
            into = token.is("clipped_by") ? object.clips : object.bounds;
        } else {
            return fail("expected a box or a sphere as a limit");
        }
    }
    return true;
}

// The first colour of a texture, material or pigment.
void PovReader::look(PovObject& object) {
    const bool is_pigment = tokens_.peek().is("pigment");
    if (is_pigment) {
        pigment(object);
        return;
    }
    tokens_.take();
    const int depth = tokens_.depth();
    if (!tokens_.take_if("{")) {
        return;
    }
    while (tokens_.depth() > depth && tokens_.peek().kind != PovTokenKind::end) {
        if (tokens_.peek().is("pigment")) {
            pigment(object);
            continue;
        }
        const PovToken token = tokens_.take();
        const auto named = pigments_.find(token.text);
        if (token.kind == PovTokenKind::word && named != pigments_.end()) {
            object.colour = named->second;
        }
    }
}

void PovReader::pigment(PovObject& object) {
    tokens_.take();
    const int depth = tokens_.depth();
    if (!tokens_.take_if("{")) {
        return;
    }
    const auto named = pigments_.find(tokens_.peek().text);
    std::optional<PovValue> colour;
    if (tokens_.peek().kind == PovTokenKind::word && named != pigments_.end()) {
        colour = named->second;
    } else if (expressions_.starts_colour() || expressions_.starts_value()) {
        colour = expressions_.colour();
    } else {
        note(Severity::note, tokens_.peek().line, "patterns are drawn in their first colour");
    }
    while (!colour && tokens_.depth() > depth && tokens_.peek().kind != PovTokenKind::end) {
        if (expressions_.starts_colour()) {
            colour = expressions_.colour();
        } else {
            tokens_.take();
        }
    }
    if (colour) {
        object.colour = colour;
    }
    tokens_.skip_to_depth(depth);
}

bool PovReader::mesh2(PovObject& object) {
    const PovToken token = tokens_.peek();
    const bool faces = token.is("face_indices");
    if (!faces && !token.is("vertex_vectors") && !token.is("normal_vectors")) {
        return false;
    }
    tokens_.take();
    const bool read = faces ? mesh_faces(object.mesh.indices)
                            : mesh_vectors(token.is("vertex_vectors") ? object.mesh.positions
                                                                      : object.mesh.normals);
    if (!read) {
        fail("expected { count, <a, b, c>, ... } behind " + std::string(token.text));
    }
    return true;
}

bool PovReader::mesh_vectors(std::vector<glm::vec3>& into) {
    if (!tokens_.take_if("{") || !expressions_.number()) {
        return false;
    }
    while (!tokens_.take_if("}")) {
        expressions_.comma();
        const std::optional<glm::dvec3> vector = expressions_.vector();
        if (!vector) {
            return false;
        }
        into.emplace_back(*vector);
        expressions_.comma();
    }
    return true;
}

// Textures of single triangles are passed over.
bool PovReader::mesh_faces(std::vector<std::uint32_t>& into) {
    if (!tokens_.take_if("{") || !expressions_.number()) {
        return false;
    }
    while (!tokens_.take_if("}")) {
        expressions_.comma();
        if (tokens_.peek().kind == PovTokenKind::number) {
            tokens_.take();
            continue;
        }
        const auto corners = expressions_.list(3);
        if (!corners || corners->size() != 3) {
            return false;
        }
        for (const double corner : *corners) {
            const bool sound = corner >= 0.0 && corner < 4294967295.0;
            into.push_back(sound ? static_cast<std::uint32_t>(corner) : no_index);
        }
        expressions_.comma();
    }
    return true;
}

}  // namespace quartic

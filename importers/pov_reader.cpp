// Statements of scene files: declarations, included files, and which objects there are.
#include "importers/pov_reader.h"

#include "files/source.h"

#include <array>
#include <utility>

namespace quartic {
namespace {

constexpr int includes_max = 64;
constexpr std::size_t include_bytes_max = std::size_t{1} << 20;

constexpr std::array<std::string_view, 7> opening_directives{"if",  "ifdef",  "ifndef", "while",
                                                             "for", "switch", "macro"};

bool is_one_of(std::span<const std::string_view> words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

PovReader::PovReader(std::string_view text, std::string folder)
    : tokens_(text),
      expressions_(tokens_,
                   [this](std::string_view name) -> const PovValue* {
                       const auto found = values_.find(name);
                       return found == values_.end() ? nullptr : &found->second;
                   }),
      folder_(std::move(folder)) {
    tokens_.push(std::string(pov_prelude()));
}

void PovReader::note(Severity severity, std::size_t line, const std::string& text) {
    file_.findings.add(severity, "line " + std::to_string(line), text);
}

void PovReader::lose(std::size_t line, const std::string& text) {
    note(Severity::loss, line, text);
    if (file_.first_loss.empty()) {
        file_.first_loss = "line " + std::to_string(line) + ", " + text;
    }
}

bool PovReader::fail(std::string reason) {
    if (reason_.empty()) {
        reason_ = std::move(reason);
    }
    return false;
}

bool PovReader::run(Progress& progress) {
    for (std::uint64_t count = 0; tokens_.peek().kind != PovTokenKind::end; ++count) {
        if (count % 1024 == 0 && progress.cancelled()) {
            return false;
        }
        statement();
    }
    if (tokens_.depth() > 0) {
        note(Severity::warning, tokens_.peek().line, "the file ends within braces");
    }
    return true;
}

void PovReader::statement() {
    const PovToken token = tokens_.peek();
    if (token.kind == PovTokenKind::directive) {
        directive();
    } else if (starts_object()) {
        if (const Object read = object()) {
            file_.objects.push_back({read, glm::dmat4(1.0)});
        }
    } else if (token.kind == PovTokenKind::word) {
        skip_unknown();
    } else {
        tokens_.take();
        if (!token.is(";")) {
            note(Severity::warning, token.line, "signs that mean nothing here, skipped");
        }
    }
}

// A word with its block, such as camera { ... }, or alone.
void PovReader::skip_unknown() {
    const PovToken word = tokens_.take();
    if (!tokens_.peek().is("{")) {
        note(Severity::warning, word.line, "words that mean nothing here, skipped");
        return;
    }
    constexpr std::array<std::string_view, 9> surroundings{
        "camera", "light_source", "background", "global_settings", "sky_sphere",
        "fog",    "media",        "rainbow",    "radiosity"};
    const bool scenery = is_one_of(surroundings, word.text);
    const std::string text =
        scenery ? std::string(word.text) + ": not part of a model, skipped"
                : "statements that are not known (" + std::string(word.text) + "), skipped";
    if (scenery) {
        note(Severity::note, word.line, text);
    } else {
        lose(word.line, text);
    }
    const int depth = tokens_.depth();
    tokens_.take();
    tokens_.skip_to_depth(depth);
}

// From behind the opening directive to its #end, or to the #else that belongs to it.
void PovReader::skip_conditional() {
    for (int open = 1; open > 0 && tokens_.peek().kind != PovTokenKind::end;) {
        const PovToken token = tokens_.take();
        if (token.kind != PovTokenKind::directive) {
            continue;
        }
        open += is_one_of(opening_directives, token.text) ? 1 : 0;
        open -= token.text == "end" ? 1 : 0;
        if (open == 1 && token.text == "else") {
            return;
        }
    }
}

void PovReader::directive() {
    const PovToken token = tokens_.take();
    if (token.text == "declare" || token.text == "local") {
        declare();
    } else if (token.text == "include") {
        include();
    } else if (token.text == "ifdef" || token.text == "ifndef") {
        tokens_.take_if("(");
        const std::string_view name = tokens_.take().text;
        tokens_.take_if(")");
        const bool known = values_.contains(name) || objects_.contains(name);
        if (known != (token.text == "ifdef")) {
            skip_conditional();
        }
    } else if (token.text == "else") {
        skip_conditional();
    } else if (is_one_of(opening_directives, token.text)) {
        lose(token.line, "#" + std::string(token.text) +
                             ": macros, loops and conditions are not "
                             "carried out; what they make is skipped");
        skip_conditional();
    } else if (token.text == "version") {
        if (expressions_.starts_value()) {
            expressions_.value();
        }
        tokens_.take_if(";");
    } else if (tokens_.peek().is("{")) {  // #default
        const int depth = tokens_.depth();
        tokens_.take();
        tokens_.skip_to_depth(depth);
    }
}

void PovReader::declare() {
    const PovToken name_token = tokens_.take();
    const std::string name(name_token.text);
    if (name_token.kind != PovTokenKind::word || !tokens_.take_if("=")) {
        note(Severity::warning, name_token.line, "a declaration without a name or value, skipped");
        return;
    }
    const PovToken value = tokens_.peek();
    if (starts_object()) {
        if (const Object read = object()) {
            read->name = name;
            objects_[name] = read;
        }
    } else if (value.is("texture") || value.is("pigment") || value.is("material")) {
        PovObject holder;
        look(holder);
        if (holder.colour) {
            pigments_[name] = *holder.colour;
        }
    } else if (expressions_.starts_colour() || expressions_.starts_value()) {
        const std::optional<PovValue> read = expressions_.value();
        if (read) {
            values_[name] = *read;
        } else {
            note(Severity::warning, value.line, "a declared value that cannot be worked out");
        }
    } else if (value.kind == PovTokenKind::word) {
        tokens_.take();
        const int depth = tokens_.depth();
        if (tokens_.take_if("{")) {
            tokens_.skip_to_depth(depth);
        }
        note(Severity::note, value.line, "declarations of what is no shape, skipped");
    } else if (value.kind == PovTokenKind::text) {
        tokens_.take();
    }
    tokens_.take_if(";");
}

void PovReader::include() {
    const PovToken token = tokens_.peek();
    if (token.kind != PovTokenKind::text) {
        note(Severity::warning, token.line, "an #include without a name in quotes");
        return;
    }
    tokens_.take();
    read_include(std::string(token.text));
}

// Only a plain name in the file's own folder is opened.
void PovReader::read_include(const std::string& name) {
    const std::size_t line = tokens_.peek().line;
    const bool plain = !name.empty() && name.find_first_of("/\\:") == std::string::npos &&
                       name.front() != '.' && !folder_.empty();
    if (plain && ++include_count_ <= includes_max) {
        const Result<Source> source = Source::open(folder_ + "/" + name);
        if (source && source.value().bytes().size() <= include_bytes_max) {
            const auto bytes = source.value().bytes();
            std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
            if (tokens_.push(std::move(text))) {
                return;
            }
        }
    }
    note(Severity::note, line,
         "included files that are not beside the model (the usual names of shapes.inc, "
         "shapesq.inc and colors.inc are built in), such as " +
             name);
}

}  // namespace quartic

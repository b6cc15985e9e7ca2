// Reads attribute files line by line, with the words that their first line declares.
#include "importers/attributes.h"

#include "importers/node_names.h"
#include "importers/text_encoding.h"
#include "importers/text_lines.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <unordered_map>
#include <vector>

namespace quartic {
namespace {

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
constexpr std::string_view magic = "CADC_Attributes_File";

std::string_view as_text(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// What the first line declares: "... , start: NEW , end: END , name_end: := , sep: &end&".
struct Grammar {
    std::string_view start = "NEW";
    std::string_view end = "END";
    std::string_view name_end = ":=";
    std::string_view separator = "&end&";
};

Grammar read_grammar(std::string_view line) {
    Grammar grammar;
    const auto read = [&](std::string_view key, std::string_view& word) {
        const std::size_t at = line.find(key);
        if (at == std::string_view::npos) {
            return;
        }
        std::string_view value = trimmed(line.substr(at + key.size()));
        value = value.substr(0, std::min(value.find_first_of(" \t"), value.size()));
        word = value.empty() ? word : value;
    };
    read(" start:", grammar.start);
    read(" end:", grammar.end);
    read(" name_end:", grammar.name_end);
    read(" sep:", grammar.separator);
    return grammar;
}

std::string_view unquoted(std::string_view value) {
    const bool quoted = value.size() >= 2 && value.front() == '\'' && value.back() == '\'';
    return quoted ? value.substr(1, value.size() - 2) : value;
}

class AttributeReader {
public:
    AttributeReader(Scene& scene, std::string_view text, Encoding encoding)
        : scene_(scene), names_(scene), lines_(text), encoding_(encoding) {}

    Status run(Progress& progress);

private:
    void read_line(std::string_view line);
    void begin(std::string_view name);
    void end();
    void add(std::string_view pair);
    void report();

    struct Found {
        std::uint32_t node = 0;
        Attribute attribute;
    };
    struct Key {
        StringPool::Id id = 0;
        std::string_view last_value;  // values repeat from element to element: they are stored once
        StringPool::Id last_id = 0;
    };

    Scene& scene_;
    NodeNames names_;
    LineReader lines_;
    Encoding encoding_;
    Grammar grammar_;
    std::vector<std::uint32_t> open_;  // nodes; no_index where the element is not in the scene
    std::vector<Found> found_;
    std::unordered_map<std::string_view, Key> keys_;
    std::string scratch_;
    std::uint64_t elements_ = 0;
    std::uint64_t strangers_ = 0;
    std::uint64_t bad_lines_ = 0;
    std::uint64_t surplus_ends_ = 0;
    std::size_t first_stranger_ = 0;
    std::size_t first_bad_line_ = 0;
};

void AttributeReader::begin(std::string_view name) {
    ++elements_;
    to_utf8(name, encoding_, scratch_);
    const bool top = open_.empty();
    const std::uint32_t parent = top ? no_index : open_.back();
    // Below an element that is not in the scene nothing can be: its children would be somewhere
    // else.
    std::uint32_t node = top || parent != no_index ? names_.take(parent, scratch_) : no_index;
    if (node == no_index) {
        const bool header = top && name == "Header Information";
        elements_ -= header ? 1 : 0;
        strangers_ += header ? 0 : 1;
        first_stranger_ = first_stranger_ == 0 && !header ? lines_.number() : first_stranger_;
    }
    open_.push_back(node);
}

void AttributeReader::end() {
    if (open_.empty()) {
        ++surplus_ends_;
        return;
    }
    open_.pop_back();
}

void AttributeReader::add(std::string_view pair) {
    const std::size_t at = pair.find(grammar_.name_end);
    if (at == std::string_view::npos) {
        first_bad_line_ = bad_lines_ == 0 ? lines_.number() : first_bad_line_;
        ++bad_lines_;
        return;
    }
    if (open_.empty() || open_.back() == no_index) {
        return;
    }
    const std::string_view name = trimmed(pair.substr(0, at));
    const std::string_view value = unquoted(trimmed(pair.substr(at + grammar_.name_end.size())));
    const auto [entry, is_new] = keys_.try_emplace(name);
    Key& key = entry->second;
    if (is_new) {
        to_utf8(name, encoding_, scratch_);
        key.id = scene_.strings.add(scratch_);
    }
    if (value != key.last_value) {
        to_utf8(value, encoding_, scratch_);
        key.last_value = value;
        key.last_id = scene_.strings.add(scratch_);
    }
    found_.push_back({open_.back(), {key.id, key.last_id}});
}

void AttributeReader::read_line(std::string_view line) {
    line = trimmed(line);
    if (line.empty()) {
        return;
    }
    if (line == grammar_.end) {
        end();
        return;
    }
    const std::size_t word = grammar_.start.size();
    if (line.starts_with(grammar_.start) && line.size() > word &&
        (line[word] == ' ' || line[word] == '\t')) {
        begin(trimmed(line.substr(word)));
        return;
    }
    while (!line.empty()) {
        const std::size_t separator = line.find(grammar_.separator);
        const std::string_view pair = trimmed(line.substr(0, std::min(separator, line.size())));
        if (!pair.empty()) {
            add(pair);
        }
        line = separator == std::string_view::npos
                   ? std::string_view()
                   : line.substr(separator + grammar_.separator.size());
    }
}

void AttributeReader::report() {
    const auto add = [&](Severity severity, std::size_t line, std::string_view text,
                         std::uint64_t count) {
        if (count > 0) {
            scene_.findings.add(severity, "attributes, line " + std::to_string(line), text, count);
        }
    };
    const auto warn = [&](std::size_t line, std::string_view text, std::uint64_t count) {
        add(Severity::warning, line, text, count);
    };
    // Usual: elements without geometry are left out of models.
    add(Severity::note, first_stranger_, "an element with attributes is not in the model",
        strangers_);
    warn(first_bad_line_, "a line of attributes gives no name", bad_lines_);
    warn(lines_.number(), "an element of the attribute file ends that never began", surplus_ends_);
    warn(lines_.number(), "an element of the attribute file does not end", open_.size());
    scene_.findings.add(Severity::note, "attributes",
                        std::to_string(elements_ - strangers_) + " of " +
                            std::to_string(elements_) + " elements of the attribute file joined, " +
                            std::to_string(found_.size()) + " attributes");
}

Status AttributeReader::run(Progress& progress) {
    std::string_view line;
    lines_.next(line);
    grammar_ = read_grammar(line);
    while (lines_.next(line)) {
        read_line(line);
        if (lines_.number() % 65536 == 0 && progress.cancelled()) {
            return Error{ErrorKind::interrupted, "", "the import was cancelled"};
        }
    }
    // Each node's attributes lie together: a counting sort by node keeps the order of the file.
    for (const Found& found : found_) {
        ++scene_.nodes[found.node].attribute_count;
    }
    std::uint32_t start = 0;
    for (Node& node : scene_.nodes) {
        node.first_attribute = start;
        start += node.attribute_count;
        node.attribute_count = 0;
    }
    scene_.attributes.resize(found_.size());
    for (const Found& found : found_) {
        Node& node = scene_.nodes[found.node];
        scene_.attributes[node.first_attribute + node.attribute_count] = found.attribute;
        ++node.attribute_count;
    }
    report();
    return Done{};
}

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

}  // namespace

bool is_attribute_file(std::span<const std::byte> head) {
    std::string_view text = as_text(head);
    text.remove_prefix(text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0);
    return text.starts_with(magic);
}

std::string find_attribute_file(const std::string& model_path) {
    namespace fs = std::filesystem;
    std::error_code failure;
    const fs::path model(model_path);
    if (!fs::is_regular_file(model, failure)) {
        return {};
    }
    const fs::path folder = model.has_parent_path() ? model.parent_path() : fs::path(".");
    const std::string stem = model.stem().string();
    std::string best;
    int best_rank = 4;
    for (fs::directory_iterator at(folder, failure), end; !failure && at != end;
         at.increment(failure)) {
        const fs::path& path = at->path();
        const std::string extension = lower(path.extension().string());
        const bool fits = extension == ".att" || extension == ".txt";
        if (!fits || lower(path.stem().string()) != lower(stem)) {
            continue;
        }
        // .att before .txt, the exact name before another letter case, then by name: no matter how
        // folders are read.
        const int rank = (extension == ".att" ? 0 : 2) + (path.stem().string() == stem ? 0 : 1);
        if (rank < best_rank || (rank == best_rank && path.string() < best)) {
            best = path.string();
            best_rank = rank;
        }
    }
    return best;
}

Status join_attributes(Scene& scene, const Source& source, Progress& progress) {
    if (!is_attribute_file(source.bytes())) {
        return Error{ErrorKind::bad_data, source.path(),
                     "expected an attribute file that begins with CADC_Attributes_File, found "
                     "something else"};
    }
    std::string_view text = as_text(source.bytes());
    const bool marked = text.starts_with(byte_order_mark);
    text.remove_prefix(marked ? byte_order_mark.size() : 0);
    Status status =
        AttributeReader(scene, text, marked ? Encoding::utf_8 : Encoding::guessed).run(progress);
    return status ? status
                  : Status(Error{status.error().kind, source.path(), status.error().message});
}

Status join_attributes_of(Scene& scene, const Source& model, const ImportOptions& options,
                          Progress& progress) {
    const bool named = options.attributes_path.has_value();
    if (!named && !options.find_attributes) {
        return Done{};
    }
    const std::string path = named ? *options.attributes_path : find_attribute_file(model.path());
    if (path.empty()) {
        return Done{};
    }
    const Result<Source> source = Source::open(path);
    if (!source && named) {
        return source.error();
    }
    if (!source) {
        scene.findings.add(Severity::warning, path,
                           "the attribute file beside the model cannot be read");
        return Done{};
    }
    if (!named && !is_attribute_file(source.value().bytes())) {
        return Done{};
    }
    return join_attributes(scene, source.value(), progress);
}

}  // namespace quartic

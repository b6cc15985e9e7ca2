// Walks chunk headers by their next offsets and builds the tree of groups.
#include "importers/rvm_chunks.h"

#include "importers/big_endian.h"
#include "importers/text_encoding.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace quartic {
namespace {

constexpr std::size_t header_bytes = 24;  // four words of id, next offset, a word that is always 1

constexpr std::uint32_t tag(const char (&id)[5]) {
    return (static_cast<std::uint32_t>(id[0]) << 24) | (static_cast<std::uint32_t>(id[1]) << 16) |
           (static_cast<std::uint32_t>(id[2]) << 8) | static_cast<std::uint32_t>(id[3]);
}

// The id's letters, each the low byte of a word; 0 where the other bytes are not zero.
std::uint32_t tag_at(const std::byte* at) {
    const std::uint32_t a = word_at(at);
    const std::uint32_t b = word_at(at + 4);
    const std::uint32_t c = word_at(at + 8);
    const std::uint32_t d = word_at(at + 12);
    return (a | b | c | d) > 0xff ? 0 : (a << 24) | (b << 16) | (c << 8) | d;
}

// Reads on within a payload; everything after the first failure is empty.
class Payload {
public:
    explicit Payload(std::span<const std::byte> bytes) : rest_(bytes) {}

    std::uint32_t word() { return take(4) ? word_at(rest_.data() - 4) : 0; }
    float number() { return take(4) ? float_at(rest_.data() - 4) : 0.0f; }
    std::uint8_t byte() {
        return take(1) ? static_cast<std::uint8_t>(rest_.data()[-1]) : std::uint8_t{0};
    }
    std::string_view text() {
        const std::uint64_t length = std::uint64_t{4} * word();
        return take(length)
                   ? std::string_view(reinterpret_cast<const char*>(rest_.data()) - length, length)
                   : std::string_view();
    }
    bool ok() const { return ok_; }

private:
    bool take(std::uint64_t count) {
        if (!ok_ || rest_.size() < count) {
            ok_ = false;
            return false;
        }
        rest_ = rest_.subspan(static_cast<std::size_t>(count));
        return true;
    }

    std::span<const std::byte> rest_;
    bool ok_ = true;
};

class Walk {
public:
    Walk(std::span<const std::byte> bytes, const RvmParts& parts, RvmIndex& index)
        : bytes_(bytes), parts_(parts), index_(index) {}

    std::optional<Error> run();

private:
    bool step();
    std::size_t next_offset(std::size_t at);
    void read_chunk(std::uint32_t id, std::size_t at, std::size_t end);
    void read_head(Payload payload);
    void read_model(Payload payload);
    void begin_group(Payload payload, std::size_t at);
    void read_colour(Payload payload, std::size_t at);
    void add_record(std::size_t at, std::size_t end, Layer layer);
    void notice(Severity severity, std::string_view text, std::size_t at) {
        parts_.tally.notice(severity, text, at);
    }

    std::span<const std::byte> bytes_;
    const RvmParts& parts_;
    RvmIndex& index_;
    Encoding encoding_ = Encoding::latin_1;
    std::string name_;
    std::size_t at_ = 0;
    bool has_end_ = false;
};

// Where the chunk ends, or 0 where its offset leads nowhere.
std::size_t Walk::next_offset(std::size_t at) {
    const std::size_t next = word_at(bytes_.data() + at + 16);
    if (next < at + header_bytes) {
        notice(Severity::loss, "a chunk's next offset does not lead forward; the rest is not read",
               at);
        return 0;
    }
    if (next > bytes_.size()) {
        notice(Severity::loss,
               "a chunk's next offset leads beyond the end of the file; it is not read", at);
        return 0;
    }
    return next;
}

void Walk::read_head(Payload payload) {
    const std::uint32_t version = payload.word();
    const std::string_view program = payload.text();
    payload.text();  // note
    const std::string_view date = payload.text();
    payload.text();  // user
    const std::string_view encoding = version >= 2 ? payload.text() : std::string_view();
    encoding_ =
        encoding.find("UTF-8") != std::string_view::npos ? Encoding::utf_8 : Encoding::latin_1;
    parts_.scene.findings.add(
        Severity::note, "byte 0, HEAD",
        "written by " + to_utf8(program, encoding_) + ", " + to_utf8(date, encoding_));
}

void Walk::read_model(Payload payload) {
    payload.word();
    const std::string project = to_utf8(payload.text(), encoding_);
    const std::string name = to_utf8(payload.text(), encoding_);
    parts_.scene.title = name.empty() ? project : name;
}

void Walk::begin_group(Payload payload, std::size_t at) {
    const std::uint32_t version = payload.word();
    to_utf8(payload.text(), encoding_, name_);
    glm::dvec3 position(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        const float coordinate = payload.number();
        position[axis] = std::isfinite(coordinate) ? static_cast<double>(coordinate) : 0.0;
    }
    const std::uint32_t colour = payload.word();
    std::optional<std::uint8_t> transparency;
    if (!payload.ok()) {
        // It opens all the same, so that the end of it closes no other.
        notice(Severity::warning, "a group's header is cut short", at);
    } else if (version > 2) {
        transparency = payload.byte();
        if (*transparency > 100) {
            notice(Severity::warning, "a transparency above 100 %; taken as opaque", at);
            transparency = 0;
        }
    }
    parts_.groups.begin(name_, position, colour, transparency);
}

void Walk::read_colour(Payload payload, std::size_t at) {
    payload.word();
    const std::uint32_t index = payload.word();
    const std::uint8_t red = payload.byte();
    const std::uint8_t green = payload.byte();
    const std::uint8_t blue = payload.byte();
    if (payload.ok()) {
        index_.colours.set(index, red, green, blue);
    } else {
        notice(Severity::warning, "a colour definition is cut short", at);
    }
}

void Walk::add_record(std::size_t at, std::size_t end, Layer layer) {
    const std::uint32_t kind =
        end - at >= header_bytes + 8 ? word_at(bytes_.data() + at + header_bytes + 4) : 0;
    ++index_.kind_counts[kind < rvm_kind_end ? kind : 0];
    index_.records.push_back({static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(end),
                              parts_.groups.current(), layer});
}

void Walk::read_chunk(std::uint32_t id, std::size_t at, std::size_t end) {
    const Payload payload(bytes_.subspan(at + header_bytes, end - at - header_bytes));
    switch (id) {
        case tag("PRIM"): add_record(at, end, Layer::normal); return;
        case tag("OBST"): add_record(at, end, Layer::obstruction); return;
        case tag("INSU"): add_record(at, end, Layer::insulation); return;
        case tag("CNTB"): begin_group(payload, at); return;
        case tag("CNTE"):
            if (!parts_.groups.end()) {
                notice(Severity::warning, "a group ends that never began", at);
            }
            return;
        case tag("COLR"): read_colour(payload, at); return;
        case tag("MODL"): read_model(payload); return;
        case tag("HEAD"): notice(Severity::warning, "a second HEAD chunk, skipped", at); return;
        default: notice(Severity::warning, "an unknown chunk, skipped", at); return;
    }
}

// One chunk; false at the end, or where no next chunk can be found.
bool Walk::step() {
    if (bytes_.size() - at_ < header_bytes) {
        return false;
    }
    const std::uint32_t id = tag_at(bytes_.data() + at_);
    if (id == tag("END:")) {
        has_end_ = true;
        return false;
    }
    if (id == 0) {
        notice(Severity::loss, "expected a chunk, found other bytes; the rest is not read", at_);
        return false;
    }
    const std::size_t next = next_offset(at_);
    if (next == 0) {
        return false;
    }
    read_chunk(id, at_, next);
    at_ = next;
    return true;
}

std::optional<Error> Walk::run() {
    if (!is_rvm(bytes_)) {
        return Error{ErrorKind::bad_data, "byte 0",
                     "expected a HEAD chunk, found other bytes; "
                     "is this a binary RVM file?"};
    }
    const std::size_t next = bytes_.size() < header_bytes ? 0 : next_offset(0);
    if (next == 0) {
        return Error{ErrorKind::bad_data, "byte 0, HEAD",
                     "expected a whole header, found a broken or cut one; copy the file again"};
    }
    read_head(Payload(bytes_.subspan(header_bytes, next - header_bytes)));
    at_ = next;
    // A vector that grows would copy the records again and again; memory that stays unused costs
    // nothing.
    index_.records.reserve(bytes_.size() / 112 + 1);
    while (step()) {
    }
    if (!has_end_ && parts_.scene.nodes.empty()) {
        return Error{
            ErrorKind::bad_data, "byte " + std::to_string(at_),
            "expected a group or primitive after the header, found none; copy the file again"};
    }
    if (!has_end_) {
        notice(Severity::loss,
               "the file ends before its END chunk; what stands before it is loaded", at_);
    } else if (parts_.groups.is_open()) {
        notice(Severity::warning, "groups are still open at the end", at_);
    }
    return std::nullopt;
}

}  // namespace

bool is_rvm(std::span<const std::byte> head) {
    return head.size() >= 16 && tag_at(head.data()) == tag("HEAD");
}

Result<RvmIndex> index_rvm(std::span<const std::byte> bytes, const RvmParts& parts) {
    RvmIndex index;
    std::optional<Error> error = Walk(bytes, parts, index).run();
    if (error) {
        return *std::move(error);
    }
    return index;
}

}  // namespace quartic

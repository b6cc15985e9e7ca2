// Decodes PRIM, OBST and INSU chunks of binary RVM files.
#include "importers/big_endian.h"
#include "importers/rvm_chunks.h"

#include <algorithm>

namespace quartic {
namespace {

constexpr std::size_t header_bytes = 24;
constexpr std::size_t matrix_bytes = 48;
constexpr std::size_t box_bytes = 24;
constexpr std::size_t corner_bytes = 24;
constexpr std::size_t start_bytes = 8;  // version and kind

// Where the parts of a record lie, from the start of its payload.
struct Layout {
    std::size_t matrix = start_bytes;
    std::size_t parameters = start_bytes + matrix_bytes + box_bytes;
    std::optional<std::size_t> transparency;
};

constexpr Layout plain{};
constexpr Layout byte_first{start_bytes + 4, start_bytes + 4 + matrix_bytes + box_bytes,
                            start_bytes};
constexpr Layout byte_last{start_bytes, start_bytes + matrix_bytes + box_bytes + 4,
                           start_bytes + matrix_bytes + box_bytes};

using Bytes = std::span<const std::byte>;

// Reads counts and corners; true where the polygons end within the bytes, with the length they
// take.
bool walk_facets(Bytes bytes, RvmFacets* facets, std::size_t& length) {
    std::size_t at = 0;
    const auto has = [&](std::uint64_t count, std::uint64_t size) {
        return count * size <= bytes.size() - at;
    };
    const auto count = [&]() {
        at += 4;
        return word_at(bytes.data() + at - 4);
    };
    if (!has(1, 4)) {
        return false;
    }
    const std::uint32_t polygons = count();
    if (!has(polygons, 4)) {
        return false;
    }
    for (std::uint32_t polygon = 0; polygon < polygons; ++polygon) {
        if (!has(1, 4)) {
            return false;
        }
        const std::uint32_t contours = count();
        if (!has(contours, 4)) {
            return false;
        }
        for (std::uint32_t contour = 0; contour < contours; ++contour) {
            if (!has(1, 4)) {
                return false;
            }
            const std::uint32_t corners = count();
            if (!has(corners, corner_bytes)) {
                return false;
            }
            for (std::uint32_t corner = 0; facets != nullptr && corner < corners; ++corner) {
                float v[6];
                read_floats(bytes.data() + at + corner * corner_bytes, v, 6);
                facets->positions.emplace_back(v[0], v[1], v[2]);
                facets->normals.emplace_back(v[3], v[4], v[5]);
            }
            at += corners * corner_bytes;
            if (facets != nullptr) {
                facets->contour_sizes.push_back(corners);
            }
        }
        if (facets != nullptr) {
            facets->contour_counts.push_back(contours);
        }
    }
    length = at;
    return true;
}

void read_placement_of(Bytes payload, const Layout& layout, RvmPrimitive& primitive) {
    read_floats(payload.data() + layout.matrix, primitive.matrix.data(), 12);
    read_floats(payload.data() + layout.matrix + matrix_bytes, primitive.box.data(), 6);
}

bool has_ordered_box(const RvmPrimitive& primitive) {
    return primitive.box[0] <= primitive.box[3] && primitive.box[1] <= primitive.box[4] &&
           primitive.box[2] <= primitive.box[5];
}

// Whether parameters, read from there, end exactly where the record does.
bool ends_exactly(Bytes payload, std::size_t parameters, RvmKind kind) {
    if (payload.size() < parameters) {
        return false;
    }
    if (kind != RvmKind::facet_group) {
        return payload.size() ==
               parameters + 4 * std::size_t{rvm_parameter_counts[static_cast<std::size_t>(kind)]};
    }
    std::size_t length = 0;
    return walk_facets(payload.subspan(parameters), nullptr, length) &&
           length == payload.size() - parameters;
}

// How much speaks for a layout with a transparency: 0 nothing, 2 everything.
int plausibility(Bytes payload, const Layout& layout, RvmKind kind) {
    if (payload.size() < layout.parameters ||
        static_cast<std::uint8_t>(payload[*layout.transparency]) > 100) {
        return 0;
    }
    RvmPrimitive primitive;
    read_placement_of(payload, layout, primitive);
    if (!has_ordered_box(primitive)) {
        return 0;
    }
    return is_similar(primitive.matrix, MatrixForm::binary) &&
                   ends_exactly(payload, layout.parameters, kind)
               ? 2
               : 1;
}

// Readers disagree where OBST and INSU keep their transparency, before the matrix or after the box;
// the bytes decide.
Layout layout_of(Bytes payload, RvmKind kind, bool& unclear) {
    const int first = plausibility(payload, byte_first, kind);
    if (first == 2) {
        return byte_first;
    }
    const int last = plausibility(payload, byte_last, kind);
    if (last == 2) {
        return byte_last;
    }
    if (ends_exactly(payload, plain.parameters, kind)) {
        return plain;
    }
    unclear = true;
    return last > first ? byte_last : byte_first;
}

}  // namespace

RvmReading read_rvm_record(std::span<const std::byte> bytes, const RvmRecord& record,
                           RvmPrimitive& primitive, RvmFacets& facets) {
    RvmReading reading;
    const Bytes payload =
        bytes.subspan(record.offset + header_bytes, record.end - record.offset - header_bytes);
    if (payload.size() < start_bytes) {
        reading.fault = "the chunk is cut short";
        return reading;
    }
    reading.kind = word_at(payload.data() + 4);
    if (reading.kind == 0 || reading.kind >= rvm_kind_end) {
        reading.fault = "a kind of primitive that is not known";
        return reading;
    }
    primitive.kind = static_cast<RvmKind>(reading.kind);
    primitive.form = MatrixForm::binary;
    const Layout layout = record.layer == Layer::normal
                              ? plain
                              : layout_of(payload, primitive.kind, reading.unclear_layout);
    const std::size_t count = rvm_parameter_counts[reading.kind];
    if (payload.size() < layout.parameters + 4 * count) {
        reading.fault = "the chunk is cut short";
        return reading;
    }
    read_placement_of(payload, layout, primitive);
    read_floats(payload.data() + layout.parameters, primitive.values.data(), count);
    if (layout.transparency) {
        reading.transparency =
            std::min<std::uint8_t>(static_cast<std::uint8_t>(payload[*layout.transparency]), 100);
    }
    if (primitive.kind == RvmKind::facet_group) {
        facets.clear();
        std::size_t length = 0;
        if (!walk_facets(payload.subspan(layout.parameters), &facets, length)) {
            reading.fault = "a count of the facet group exceeds the chunk";
        }
    }
    return reading;
}

}  // namespace quartic

// The chunks of a binary RVM file: one pass finds the tree and where primitives lie, then each is
// decoded alone.
#pragma once

#include "diagnostics/result.h"
#include "importers/rvm_groups.h"
#include "importers/rvm_materials.h"
#include "importers/rvm_primitive.h"
#include "importers/rvm_tally.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace quartic {

// A PRIM, OBST or INSU chunk. RVM offsets have 32 bits.
struct RvmRecord {
    std::uint32_t offset = 0;  // of the chunk's header
    std::uint32_t end = 0;
    std::uint32_t node = 0;
    Layer layer = Layer::normal;
};

struct RvmIndex {
    std::vector<RvmRecord> records;
    std::array<std::size_t, rvm_kind_end> kind_counts{};  // a hint of what is to come
    RvmColours colours;
};

struct RvmParts {
    Scene& scene;
    RvmGroups& groups;
    RvmTally& tally;
};

bool is_rvm(std::span<const std::byte> head);

// Hops from header to header; fills nodes, names and title. An error only where there is nothing to
// read.
Result<RvmIndex> index_rvm(std::span<const std::byte> bytes, const RvmParts& parts);

// What a record holds besides the primitive. A fault means that nothing else is valid.
struct RvmReading {
    std::string_view fault;
    std::uint32_t kind = 0;  // as in the file, also where it is unknown
    std::optional<std::uint8_t> transparency;
    bool unclear_layout = false;
};

// The facets are filled for facet groups only. Reads nothing outside of the record.
RvmReading read_rvm_record(std::span<const std::byte> bytes, const RvmRecord& record,
                           RvmPrimitive& primitive, RvmFacets& facets);

}  // namespace quartic

// Counts what became of the primitives of an RVM file, by kind and reason.
#pragma once

#include "scene/scene.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace quartic {

// Index in rvm_kind_names: what Part::kind holds for RVM files.
enum class RvmKindName : std::uint8_t {
    pyramid,
    box,
    rectangular_torus,
    torus,
    dish,
    snout,
    cylinder,
    sphere,
    line,
    facet_group,
    unknown,
};
constexpr std::array<std::string_view, 11> rvm_kind_names{
    "pyramid", "box",  "rectangular_torus", "torus",  "dish", "snout", "cylinder",
    "sphere",  "line", "facet_group",       "unknown"};

// From the number in the file.
RvmKindName rvm_kind_name(std::uint32_t kind);

enum class Became : std::uint8_t { analytic, triangles, tessellated, skipped };

class RvmTally {
public:
    // The common case: drawn as it is.
    void add(RvmKindName kind, Became became) {
        ++plain_[static_cast<std::size_t>(kind)][static_cast<std::size_t>(became)];
    }
    // The reason must be a constant text.
    void add(RvmKindName kind, Became became, std::string_view reason, Severity severity,
             std::uint64_t place);

    // Something noticed that is no outcome: an element is counted apart.
    void notice(Severity severity, std::string_view text, std::uint64_t place,
                std::uint64_t count = 1);

    // What was tessellated lies at most so far (metres) from the surface it stands for.
    void deviates(double deviation_m) { deviation_m_ = std::max(deviation_m_, deviation_m); }

    void add_all(const RvmTally& other);

    // Writes kinds, counts, outcomes and findings; a place is printed as "unit N".
    void write(Scene& scene, std::string_view unit) const;

private:
    double deviation_m_ = 0.0;

    struct Entry {
        RvmKindName kind = RvmKindName::unknown;
        Became became = Became::skipped;
        Severity severity = Severity::note;
        std::string_view reason;
        std::uint64_t place = 0;
        std::uint64_t count = 0;
    };
    struct Notice {
        Severity severity = Severity::note;
        std::string_view text;
        std::uint64_t place = 0;
        std::uint64_t count = 0;
    };

    std::array<std::array<std::uint64_t, 4>, rvm_kind_names.size()> plain_{};
    std::vector<Entry> entries_;
    std::vector<Notice> notices_;
};

}  // namespace quartic

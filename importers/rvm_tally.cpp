// Sums up outcomes and turns them into the scene's report.
#include "importers/rvm_tally.h"

#include <algorithm>
#include <string>

namespace quartic {
namespace {

constexpr std::array<std::string_view, 4> became_names{"analytic", "triangles", "tessellated",
                                                       "skipped"};

constexpr std::array<RvmKindName, 12> names_of_numbers{
    RvmKindName::unknown,  RvmKindName::pyramid, RvmKindName::box,  RvmKindName::rectangular_torus,
    RvmKindName::torus,    RvmKindName::dish,    RvmKindName::dish, RvmKindName::snout,
    RvmKindName::cylinder, RvmKindName::sphere,  RvmKindName::line, RvmKindName::facet_group};

std::string place_name(std::string_view unit, std::uint64_t place) {
    return std::string(unit) + ' ' + std::to_string(place);
}

}  // namespace

RvmKindName rvm_kind_name(std::uint32_t kind) {
    return kind < names_of_numbers.size() ? names_of_numbers[kind] : RvmKindName::unknown;
}

void RvmTally::add(RvmKindName kind, Became became, std::string_view reason, Severity severity,
                   std::uint64_t place) {
    const auto same = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
        return entry.kind == kind && entry.became == became && entry.severity == severity &&
               entry.reason == reason;
    });
    if (same != entries_.end()) {
        ++same->count;
        return;
    }
    entries_.push_back({kind, became, severity, reason, place, 1});
}

void RvmTally::notice(Severity severity, std::string_view text, std::uint64_t place,
                      std::uint64_t count) {
    const auto same = std::find_if(notices_.begin(), notices_.end(), [&](const Notice& noticed) {
        return noticed.severity == severity && noticed.text == text;
    });
    if (same != notices_.end()) {
        same->count += count;
        return;
    }
    notices_.push_back({severity, text, place, count});
}

void RvmTally::add_all(const RvmTally& other) {
    deviates(other.deviation_m_);
    for (std::size_t kind = 0; kind < plain_.size(); ++kind) {
        for (std::size_t became = 0; became < plain_[kind].size(); ++became) {
            plain_[kind][became] += other.plain_[kind][became];
        }
    }
    for (const Entry& entry : other.entries_) {
        add(entry.kind, entry.became, entry.reason, entry.severity, entry.place);
        const auto sum = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& mine) {
            return mine.kind == entry.kind && mine.became == entry.became &&
                   mine.severity == entry.severity && mine.reason == entry.reason;
        });
        sum->count += entry.count - 1;
    }
    for (const Notice& noticed : other.notices_) {
        notice(noticed.severity, noticed.text, noticed.place, noticed.count);
    }
}

void RvmTally::write(Scene& scene, std::string_view unit) const {
    scene.max_deviation_m = deviation_m_;
    scene.kind_counts.assign(rvm_kind_names.size(), 0);
    for (std::size_t kind = 0; kind < rvm_kind_names.size(); ++kind) {
        for (std::size_t became = 0; became < became_names.size(); ++became) {
            const std::uint64_t count = plain_[kind][became];
            scene.kind_counts[kind] += count;
            if (count > 0) {
                scene.outcomes.push_back({std::string(rvm_kind_names[kind]),
                                          std::string(became_names[became]), "", count});
            }
        }
    }
    for (const Entry& entry : entries_) {
        const std::string kind(rvm_kind_names[static_cast<std::size_t>(entry.kind)]);
        const std::string_view became = became_names[static_cast<std::size_t>(entry.became)];
        scene.kind_counts[static_cast<std::size_t>(entry.kind)] += entry.count;
        scene.outcomes.push_back(
            {kind, std::string(became), std::string(entry.reason), entry.count});
        scene.findings.add(entry.severity, place_name(unit, entry.place) + ", " + kind,
                           kind + ": " + std::string(entry.reason) + "; " + std::string(became),
                           entry.count);
    }
    for (const Notice& noticed : notices_) {
        scene.findings.add(noticed.severity, place_name(unit, noticed.place), noticed.text,
                           noticed.count);
    }
    const bool has_unknown = scene.kind_counts.back() > 0;
    scene.kinds.assign(rvm_kind_names.begin(), rvm_kind_names.end() - (has_unknown ? 0 : 1));
    scene.kind_counts.resize(scene.kinds.size());
}

}  // namespace quartic

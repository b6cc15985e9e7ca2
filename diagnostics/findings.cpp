// Collects findings, one entry for each text.
#include "diagnostics/findings.h"

#include <algorithm>

namespace quartic {

void Findings::add(Severity severity, std::string_view where, std::string_view text,
                   std::uint64_t count) {
    const auto same = std::find_if(list_.begin(), list_.end(), [&](const Finding& finding) {
        return finding.severity == severity && finding.text == text;
    });
    if (same != list_.end()) {
        same->count += count;
        return;
    }
    list_.push_back({severity, std::string(where), std::string(text), count});
}

void Findings::add_all(const Findings& other) {
    for (const Finding& finding : other.list_) {
        add(finding.severity, finding.where, finding.text, finding.count);
    }
}

std::uint64_t Findings::count(Severity severity) const {
    std::uint64_t total = 0;
    for (const Finding& finding : list_) {
        total += finding.severity == severity ? finding.count : 0;
    }
    return total;
}

std::string_view name(Severity severity) {
    switch (severity) {
        case Severity::note: return "note";
        case Severity::warning: return "warning";
        case Severity::loss: return "loss";
    }
    return "";
}

}  // namespace quartic

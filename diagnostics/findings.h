// What a lenient reader noticed and went on: equal findings are counted, not repeated.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace quartic {

enum class Severity { note, warning, loss };  // loss: something of the file is not in the scene

struct Finding {
    Severity severity = Severity::note;
    std::string where;  // of the first one: "byte 18204, PRIM"
    std::string text;
    std::uint64_t count = 1;
};

class Findings {
public:
    // Adds count findings with this text; the first one's place is kept.
    void add(Severity severity, std::string_view where, std::string_view text,
             std::uint64_t count = 1);
    void add_all(const Findings& other);

    const std::vector<Finding>& list() const { return list_; }
    std::uint64_t count(Severity severity) const;

private:
    std::vector<Finding> list_;
};

std::string_view name(Severity severity);

}  // namespace quartic

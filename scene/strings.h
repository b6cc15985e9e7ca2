// Many strings in one buffer, named by numbers.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace quartic {

class StringPool {
public:
    using Id = std::uint32_t;

    // Id 0 is the empty string.
    StringPool() : starts_{0, 0} {}

    Id add(std::string_view text) {
        if (text.empty()) {
            return 0;
        }
        text_.append(text);
        starts_.push_back(text_.size());
        return static_cast<Id>(starts_.size() - 2);
    }
    std::string_view operator[](Id id) const {
        return std::string_view(text_).substr(starts_[id], starts_[id + 1] - starts_[id]);
    }
    std::size_t size() const { return starts_.size() - 1; }
    std::size_t bytes() const {
        return text_.capacity() + starts_.capacity() * sizeof(std::uint64_t);
    }

private:
    std::string text_;
    std::vector<std::uint64_t> starts_;
};

}  // namespace quartic

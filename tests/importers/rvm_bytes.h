// Writes binary RVM files by hand, chunk by chunk, for tests.
#pragma once

#include "files/source.h"
#include "importers/load.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace quartic {

// The placement that real files have most often: millimetres to metres, not turned.
constexpr std::array<float, 12> plain_matrix{0.001f, 0, 0, 0, 0.001f, 0, 0, 0, 0.001f, 1, 2, 3};
constexpr std::array<float, 6> wide_box{-1000, -1000, -1000, 1000, 1000, 1000};

class RvmBytes {
public:
    RvmBytes& word(std::uint32_t value) {
        for (int shift = 24; shift >= 0; shift -= 8) {
            bytes_.push_back(static_cast<std::byte>((value >> shift) & 0xff));
        }
        return *this;
    }
    RvmBytes& number(float value) { return word(std::bit_cast<std::uint32_t>(value)); }
    template <class Numbers>
    RvmBytes& numbers(const Numbers& values) {
        for (const float value : values) {
            number(value);
        }
        return *this;
    }
    RvmBytes& numbers(std::initializer_list<float> values) {
        for (const float value : values) {
            number(value);
        }
        return *this;
    }
    RvmBytes& text(std::string_view value) {
        const std::size_t words = (value.size() + 3) / 4;
        word(static_cast<std::uint32_t>(words));
        for (std::size_t i = 0; i < 4 * words; ++i) {
            bytes_.push_back(i < value.size() ? static_cast<std::byte>(value[i]) : std::byte{0});
        }
        return *this;
    }

    // Starts a chunk; its next offset is filled in when the next one starts.
    RvmBytes& chunk(std::string_view id, std::uint32_t version = 1) {
        close();
        header_ = bytes_.size();
        for (const char letter : id) {
            word(static_cast<std::uint32_t>(letter));
        }
        word(0).word(1);
        return word(version);
    }

    RvmBytes& head(std::uint32_t version = 2) {
        chunk("HEAD", version).text("tests").text("a note").text("today").text("nobody");
        if (version >= 2) {
            text("Unicode UTF-8");
        }
        return chunk("MODL").text("project").text("/MODEL");
    }
    RvmBytes& group(std::string_view name, std::uint32_t colour = 1) {
        return chunk("CNTB", 2).text(name).numbers({1000, 2000, 3000}).word(colour);
    }
    RvmBytes& group_with_transparency(std::string_view name, std::uint8_t per_cent,
                                      std::uint32_t version = 3) {
        chunk("CNTB", version).text(name).numbers({0, 0, 0}).word(1);
        word(std::uint32_t{per_cent} << 24);
        return version > 3 ? numbers({1, 2, 3, 4, 5, 6, 7}) : *this;
    }
    RvmBytes& end_group() { return chunk("CNTE"); }
    RvmBytes& primitive(std::uint32_t kind, std::initializer_list<float> parameters,
                        const std::array<float, 12>& matrix = plain_matrix,
                        const std::array<float, 6>& box = wide_box) {
        return chunk("PRIM").word(kind).numbers(matrix).numbers(box).numbers(parameters);
    }
    RvmBytes& colour(std::uint32_t index, std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
        chunk("COLR").word(index);
        return word((std::uint32_t{red} << 24) | (std::uint32_t{green} << 16) |
                    (std::uint32_t{blue} << 8));
    }
    std::vector<std::byte> end() {
        chunk("END:");
        close();
        bytes_.resize((bytes_.size() + 479) / 480 * 480);
        return bytes_;
    }
    // Overwrites the next offset of the chunk that is open now; it then stays so.
    RvmBytes& next_offset(std::uint32_t offset) {
        forced_ = offset;
        return *this;
    }
    std::size_t size() const { return bytes_.size(); }
    std::size_t header() const { return header_; }

private:
    void close() {
        if (bytes_.empty()) {
            return;
        }
        const std::uint32_t next = forced_.value_or(static_cast<std::uint32_t>(bytes_.size()));
        for (std::size_t i = 0; i < 4; ++i) {
            bytes_[header_ + 16 + i] = static_cast<std::byte>((next >> (24 - 8 * i)) & 0xff);
        }
        forced_.reset();
    }

    std::vector<std::byte> bytes_;
    std::size_t header_ = 0;
    std::optional<std::uint32_t> forced_;
};

inline Result<Scene> load_bytes(std::vector<std::byte> bytes, int thread_count = 1) {
    ImportOptions options;
    options.thread_count = thread_count;
    options.find_attributes = false;
    Progress progress;
    return load_scene(Source::from_bytes("test", std::move(bytes)), options, progress);
}

inline Result<Scene> load_text(std::string_view text) {
    const auto* first = reinterpret_cast<const std::byte*>(text.data());
    return load_bytes(std::vector<std::byte>(first, first + text.size()));
}

inline std::uint64_t count_of(const Scene& scene, std::string_view kind) {
    for (std::size_t i = 0; i < scene.kinds.size(); ++i) {
        if (scene.kinds[i] == kind) {
            return scene.kind_counts[i];
        }
    }
    return 0;
}

inline std::uint64_t outcome_count(const Scene& scene, std::string_view kind,
                                   std::string_view became) {
    std::uint64_t count = 0;
    for (const Outcome& outcome : scene.outcomes) {
        count += outcome.kind == kind && outcome.became == became ? outcome.count : 0;
    }
    return count;
}

inline bool has_finding(const Scene& scene, Severity severity, std::string_view part_of_text) {
    for (const Finding& finding : scene.findings.list()) {
        if (finding.severity == severity && finding.text.find(part_of_text) != std::string::npos) {
            return true;
        }
    }
    return false;
}

}  // namespace quartic

// Times the importers; makes big RVM files by repeating small ones.
#include "bench/load.h"

#include "bench/timing.h"
#include "importers/big_endian.h"
#include "importers/load.h"
#include "importers/rvm_chunks.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <string_view>
#include <thread>
#include <utility>

namespace quartic {
namespace {

// Decodes every field; the sum keeps the compiler from leaving anything out.
Result<double> parse_rvm(const Source& model, float& sum) {
    const double start = wall_seconds();
    Scene scene;
    RvmGroups groups(scene);
    RvmTally tally;
    const Result<RvmIndex> index = index_rvm(model.bytes(), {scene, groups, tally});
    if (!index) {
        return index.error();
    }
    RvmPrimitive primitive;
    RvmFacets facets;
    for (const RvmRecord& record : index.value().records) {
        const RvmReading reading = read_rvm_record(model.bytes(), record, primitive, facets);
        sum += reading.fault.empty() ? primitive.matrix[0] + primitive.box[0] + primitive.values[0]
                                     : 0.0f;
    }
    return wall_seconds() - start;
}

void put_word(std::vector<std::byte>& bytes, std::size_t at, std::uint32_t word) {
    for (std::size_t i = 0; i < 4; ++i) {
        bytes[at + i] = static_cast<std::byte>(word >> (24 - 8 * i));
    }
}

std::string_view id_at(std::span<const std::byte> bytes, std::size_t at,
                       std::array<char, 4>& letters) {
    for (std::size_t i = 0; i < 4; ++i) {
        letters[i] = static_cast<char>(bytes[at + 4 * i + 3]);
    }
    return {letters.data(), letters.size()};
}

constexpr std::size_t header_bytes = 24;

// The chunks from the first group to the end, and where that is in the file.
struct Body {
    std::size_t start = 0;
    std::size_t end = 0;
    std::vector<std::size_t> chunks;
};

Body find_body(std::span<const std::byte> bytes) {
    Body body;
    std::array<char, 4> letters{};
    std::size_t at = 0;
    while (bytes.size() - at >= header_bytes) {
        const std::string_view id = id_at(bytes, at, letters);
        const std::size_t next = word_at(bytes.data() + at + 16);
        if (id == "END:" || next <= at || next > bytes.size()) {
            break;
        }
        if (id != "HEAD" && id != "MODL") {
            body.start = body.chunks.empty() ? at : body.start;
            body.chunks.push_back(at);
        }
        at = next;
    }
    body.end = at;
    return body;
}

}  // namespace

Result<LoadFigures> measure_load(const Source& model, int rounds, int thread_count) {
    LoadFigures figures;
    figures.bytes = model.bytes().size();
    const auto cores = static_cast<int>(std::thread::hardware_concurrency());
    figures.thread_count = thread_count != 0 ? thread_count : std::max(1, cores);
    float sum = 0.0f;
    for (int round = -1; round < rounds; ++round) {
        if (is_rvm(model.bytes())) {
            const Result<double> time = parse_rvm(model, sum);
            if (!time) {
                return time.error();
            }
            if (round >= 0) {
                figures.parse_s.push_back(time.value() + (sum == 1.5e-38f ? 1e-9 : 0.0));
            }
        }
        ImportOptions options;
        options.thread_count = thread_count;
        options.find_attributes = false;
        Progress progress;
        const double start = wall_seconds();
        const Result<Scene> scene = load_scene(model, options, progress);
        if (!scene) {
            return scene.error();
        }
        if (round >= 0) {
            figures.scene_s.push_back(wall_seconds() - start);
        }
        figures.parts = scene.value().parts.size();
    }
    if (rounds > 0) {
        const double parse = median(figures.parse_s);
        figures.parse_megabytes_per_second =
            parse > 0.0 ? 1e-6 * static_cast<double>(figures.bytes) / parse : 0.0;
        figures.scene_parts_per_second =
            static_cast<double>(figures.parts) / median(figures.scene_s);
    }
    return figures;
}

Result<LoadFigures> measure_load(const std::string& path, int rounds, int thread_count) {
    const Result<Source> source = Source::open(path);
    if (!source) {
        return source.error();
    }
    return measure_load(source.value(), rounds, thread_count);
}

Result<Source> repeat_rvm(const Source& model, std::size_t copies) {
    const std::span<const std::byte> bytes = model.bytes();
    if (!is_rvm(bytes)) {
        return Error{ErrorKind::usage, model.path(),
                     "expected a binary RVM file to repeat, found something else"};
    }
    const Body body = find_body(bytes);
    const std::size_t length = body.end - body.start;
    const std::size_t total = body.start + copies * length + header_bytes + 4;
    if (body.chunks.empty() || total > std::numeric_limits<std::uint32_t>::max()) {
        return Error{ErrorKind::usage, model.path(),
                     "expected groups that fit 4 GB when repeated, found none or more; ask for "
                     "fewer copies"};
    }
    std::vector<std::byte> big(total);
    std::copy_n(bytes.begin(), body.start, big.begin());
    for (std::size_t copy = 0; copy < copies; ++copy) {
        const std::size_t shift = copy * length;
        std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(body.start), length,
                    big.begin() + static_cast<std::ptrdiff_t>(body.start + shift));
        for (const std::size_t chunk : body.chunks) {
            const std::size_t next = word_at(bytes.data() + chunk + 16) + shift;
            put_word(big, chunk + shift + 16, static_cast<std::uint32_t>(next));
        }
    }
    const std::size_t end = body.start + copies * length;
    constexpr std::string_view id = "END:";
    for (std::size_t i = 0; i < id.size(); ++i) {
        put_word(big, end + 4 * i, static_cast<std::uint32_t>(id[i]));
    }
    put_word(big, end + 16, static_cast<std::uint32_t>(total));
    put_word(big, end + 20, 1);
    put_word(big, end + 24, 1);
    return Source::from_bytes(model.path() + " repeated", std::move(big));
}

}  // namespace quartic

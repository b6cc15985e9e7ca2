// Loads AVEVA RVM, binary: finds the records in one pass, converts blocks of them on all threads,
// joins them in order.
#include "importers/attributes.h"
#include "importers/formats.h"
#include "importers/rvm_chunks.h"
#include "scene/append.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace quartic {
namespace {

// Blocks do not depend on the number of threads, so that the scene does not either.
constexpr std::size_t block_records = 8192;
constexpr std::size_t block_bytes = std::size_t{2} << 20;

struct Block {
    Scene scene;  // parts, shapes and meshes alone
    RvmTally tally;
    RvmMaterials materials;
};

std::vector<std::size_t> block_starts(const std::vector<RvmRecord>& records) {
    std::vector<std::size_t> starts{0};
    std::size_t bytes = 0;
    for (std::size_t i = 0; i < records.size(); ++i) {
        if (i - starts.back() >= block_records || bytes >= block_bytes) {
            starts.push_back(i);
            bytes = 0;
        }
        bytes += records[i].end - records[i].offset;
    }
    starts.push_back(records.size());
    return starts;
}

// Threads take blocks by number; whoever finishes the next one due joins it and those that wait
// behind it.
class Conversion {
public:
    Conversion(std::span<const std::byte> bytes, const RvmIndex& index, const RvmParts& parts,
               Progress& progress)
        : bytes_(bytes),
          index_(index),
          parts_(parts),
          progress_(progress),
          starts_(block_starts(index.records)),
          done_(starts_.size() - 1) {}

    void run(int thread_count);
    std::vector<Material> materials() const { return materials_.make(index_.colours); }

private:
    void work();
    void convert(std::size_t first, std::size_t last, Block& block) const;
    void join(std::size_t number, std::unique_ptr<Block> block);
    std::unique_ptr<Block> take_block();
    void reserve();

    std::span<const std::byte> bytes_;
    const RvmIndex& index_;
    const RvmParts& parts_;
    Progress& progress_;
    std::vector<std::size_t> starts_;
    std::vector<std::unique_ptr<Block>> done_;  // converted, not joined
    std::vector<std::unique_ptr<Block>> idle_;  // joined: their memory serves the next ones
    RvmMaterials materials_;
    std::size_t joined_ = 0;
    std::mutex mutex_;
    std::atomic<std::size_t> next_{0};
    std::exception_ptr failure_;
};

// Appending to full arrays would copy them again and again; what stays unused is never touched.
void Conversion::reserve() {
    const auto count = [&](RvmKind kind) {
        return index_.kind_counts[static_cast<std::size_t>(kind)];
    };
    Scene& scene = parts_.scene;
    scene.parts.reserve(index_.records.size());
    scene.shapes.cylinder.reserve(count(RvmKind::cylinder) + count(RvmKind::line) +
                                  count(RvmKind::snout));
    scene.shapes.cone.reserve(count(RvmKind::snout));
    scene.shapes.torus.reserve(count(RvmKind::circular_torus));
    scene.shapes.rectangular_torus.reserve(count(RvmKind::rectangular_torus));
    scene.shapes.box.reserve(count(RvmKind::box));
    scene.shapes.pyramid.reserve(count(RvmKind::pyramid));
    scene.shapes.dish.reserve(count(RvmKind::elliptical_dish) + count(RvmKind::spherical_dish));
    scene.shapes.sphere.reserve(count(RvmKind::sphere));
    scene.meshes.reserve(count(RvmKind::facet_group));
}

void Conversion::convert(std::size_t first, std::size_t last, Block& block) const {
    RvmConverter converter(block.scene, block.tally);
    RvmPrimitive primitive;
    RvmFacets facets;
    block.scene.parts.reserve(last - first);
    for (std::size_t i = first; i < last; ++i) {
        const RvmRecord& record = index_.records[i];
        const RvmReading reading = read_rvm_record(bytes_, record, primitive, facets);
        if (!reading.fault.empty()) {
            block.tally.add(rvm_kind_name(reading.kind), Became::skipped, reading.fault,
                            Severity::loss, record.offset);
            continue;
        }
        if (reading.unclear_layout) {
            block.tally.notice(Severity::warning,
                               "where a volume keeps its transparency is unclear", record.offset);
        }
        RvmLook look = parts_.groups.look(record.node);
        look.transparency = reading.transparency.value_or(look.transparency);
        Part part;
        part.node = record.node;
        part.layer = rvm_layer(primitive.kind, record.layer);
        part.material = block.materials.number_of(look, part.layer);
        if (primitive.kind == RvmKind::facet_group) {
            converter.add_facets(primitive, facets, part, record.offset);
        } else {
            converter.add(primitive, part, record.offset);
        }
    }
}

void Conversion::join(std::size_t number, std::unique_ptr<Block> block) {
    const std::scoped_lock lock(mutex_);
    done_[number] = std::move(block);
    for (; joined_ < done_.size() && done_[joined_] != nullptr; ++joined_) {
        std::unique_ptr<Block> due = std::move(done_[joined_]);
        std::vector<std::uint32_t> numbers;
        for (const RvmMaterials::Key key : due->materials.keys()) {
            numbers.push_back(materials_.number_of(key));
        }
        append_parts(parts_.scene, due->scene, numbers);
        parts_.tally.add_all(due->tally);
        due->tally = RvmTally();
        due->materials = RvmMaterials();
        idle_.push_back(std::move(due));
    }
    progress_.report(0.2 + 0.75 * static_cast<double>(joined_) / static_cast<double>(done_.size()));
}

std::unique_ptr<Block> Conversion::take_block() {
    const std::scoped_lock lock(mutex_);
    if (idle_.empty()) {
        return std::make_unique<Block>();
    }
    std::unique_ptr<Block> block = std::move(idle_.back());
    idle_.pop_back();
    return block;
}

void Conversion::work() {
    try {
        for (;;) {
            const std::size_t number = next_.fetch_add(1);
            if (number >= done_.size() || progress_.cancelled()) {
                return;
            }
            std::unique_ptr<Block> block = take_block();
            convert(starts_[number], starts_[number + 1], *block);
            join(number, std::move(block));
        }
    } catch (...) {
        next_.store(done_.size());  // the others stop too
        const std::scoped_lock lock(mutex_);
        failure_ = std::current_exception();
    }
}

void Conversion::run(int thread_count) {
    reserve();
    const unsigned machine = std::max(1u, std::thread::hardware_concurrency());
    const std::size_t wanted = thread_count > 0 ? static_cast<std::size_t>(thread_count) : machine;
    const std::size_t count = std::min({wanted, done_.size(), std::size_t{256}});
    {
        std::vector<std::jthread> threads;
        for (std::size_t i = 1; i < count; ++i) {
            threads.emplace_back([this] { work(); });
        }
        work();
    }
    if (failure_) {
        std::rethrow_exception(failure_);
    }
}

bool recognises(std::span<const std::byte> head, std::string_view) {
    return is_rvm(head);
}

Result<Scene> load(const Source& source, const ImportOptions& options, Progress& progress) {
    Scene scene;
    RvmGroups groups(scene);
    RvmTally tally;
    const RvmParts parts{scene, groups, tally};
    const Result<RvmIndex> index = index_rvm(source.bytes(), parts);
    if (!index) {
        const Error& error = index.error();
        return Error{error.kind, source.path() + ", " + error.where, error.message};
    }
    progress.report(0.2);
    Conversion conversion(source.bytes(), index.value(), parts, progress);
    conversion.run(options.thread_count);
    if (progress.cancelled()) {
        return Error{ErrorKind::interrupted, source.path(), "the import was cancelled"};
    }
    scene.materials = conversion.materials();
    tally.write(scene, "byte");
    if (Status joined = join_attributes_of(scene, source, options, progress); !joined) {
        return joined.error();
    }
    progress.report(1.0);
    return scene;
}

}  // namespace

Importer rvm_importer() {
    static constexpr std::array<std::string_view, 1> extensions{"rvm"};
    return {"an AVEVA RVM model (.rvm)", extensions, recognises, load};
}

}  // namespace quartic

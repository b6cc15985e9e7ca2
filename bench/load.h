// Measures how fast models load: the parser alone, and with the scene.
#pragma once

#include "diagnostics/result.h"
#include "files/source.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace quartic {

struct LoadFigures {
    std::uint64_t bytes = 0;
    std::uint64_t parts = 0;
    int thread_count = 0;  // of scene_s; parse_s is always one core
    std::vector<double>
        parse_s;  // of each round: headers and records decoded, no scene; empty for other formats
    std::vector<double> scene_s;              // of each round: load_scene(), attributes left out
    double parse_megabytes_per_second = 0.0;  // of the median round, 1 MB = 1e6 bytes
    double scene_parts_per_second = 0.0;      // of the median round
};

// One round more than asked for is run first, to warm the file cache. No threads named: as many as
// the machine has.
Result<LoadFigures> measure_load(const Source& model, int rounds, int thread_count = 0);
Result<LoadFigures> measure_load(const std::string& path, int rounds, int thread_count = 0);

// A valid binary RVM file that holds the groups of another one as often as asked, up to the 4 GB
// that its offsets reach.
Result<Source> repeat_rvm(const Source& model, std::size_t copies);

}  // namespace quartic

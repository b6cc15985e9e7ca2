// The table of benchmarks: their names, and what each is told and answers.
#pragma once

#include "bench/report.h"
#include "diagnostics/result.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace quartic {

struct BenchSettings {
    std::vector<std::string> files;  // models; empty: what the benchmark makes by itself
    PixelSize size;                  // 0: the benchmark's own
    int rounds = 9;
    int threads = 0;                  // of loading; 0: as many as the machine has
    int copies = 1;                   // of RVM files, to make them big
    int views = 0;                    // of models, surfaces and proxies; 0: BenchRow::views
    std::uint64_t count_max = 16384;  // of tori
    std::uint64_t rays = 1'000'000;   // random ones
    bool software = false;            // Mesa's OpenGL, whatever the machine has
    std::function<bool()> is_stopped = [] { return false; };
    std::function<void(const std::string&)> note = [](const std::string&) {};  // what goes on
};

struct BenchRow {
    std::string_view name;
    std::string_view what;
    Result<Report> (*run)(const BenchSettings& settings);
    int views = 3;  // if the settings leave it open
};

std::span<const BenchRow> bench_table();

// The rows of the table; each is told its settings and makes a report.
Result<Report> bench_load(const BenchSettings& settings);
Result<Report> bench_one_torus(const BenchSettings& settings);
Result<Report> bench_many_tori(const BenchSettings& settings);
Result<Report> bench_cubics(const BenchSettings& settings);
Result<Report> bench_quartics(const BenchSettings& settings);
Result<Report> bench_rays(const BenchSettings& settings);
Result<Report> bench_solvers(const BenchSettings& settings);
Result<Report> bench_proxies(const BenchSettings& settings);

}  // namespace quartic

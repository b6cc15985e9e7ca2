// The table of benchmarks.
#include "bench/benches.h"

namespace quartic {
namespace {

constexpr BenchRow rows[] = {
    {"load", "decoding models and making scenes, of files or of a generated plant", bench_load},
    {"one-torus", "every solver on one torus from six angles, and polygons (a paper's table 1)",
     bench_one_torus},
    {"many-tori", "frame rate over the number of tori, rays and polygons (the paper's figure 6)",
     bench_many_tori},
    {"cubics", "every solver on famous cubic surfaces, zooming in on singular points",
     bench_cubics},
    {"quartics", "every solver on famous quartic surfaces, zooming in on singular points",
     bench_quartics},
    {"rays", "the default solver on random and grazing rays, against the truth", bench_rays},
    {"solvers", "every solver on models of yours: time, and wrong pixels", bench_solvers},
    {"proxies", "rays that each proxy wastes, and frame times of each by the size of parts",
     bench_proxies, 48},
};

}  // namespace

std::span<const BenchRow> bench_table() {
    return rows;
}

}  // namespace quartic

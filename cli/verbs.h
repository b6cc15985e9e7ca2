// The verbs: each adds itself to the program and says what to run when it was chosen.
#pragma once

#include "cli/report.h"

#include <CLI/CLI.hpp>

#include <functional>

namespace quartic::cli {

using Run = std::function<ExitCode()>;

void add_view(CLI::App& program, Run& run);
void add_render(CLI::App& program, Run& run);
void add_info(CLI::App& program, Run& run);
void add_convert(CLI::App& program, Run& run);
void add_check(CLI::App& program, Run& run);
void add_bench(CLI::App& program, Run& run);
void add_generate(CLI::App& program, Run& run);

// --version, --list-solvers, --list-formats, --system: options of the program itself.
void add_lists(CLI::App& program, Run& run);

}  // namespace quartic::cli

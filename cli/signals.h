// Signals that end the program without leaving half a file: SIGINT, SIGTERM and the time limit.
#pragma once

#include "cli/report.h"

namespace quartic::cli {

// Call before any thread starts. From then on a signal only asks the work to stop; if it does not
// within two seconds, or if a second signal comes, the process ends. SIGPIPE is ignored: a closed
// pipe is an error of the write.
void watch_signals();

// Ends the work after so many seconds, if more than 0.
void set_time_limit(int seconds);

// Whether somebody asked the work to stop.
bool is_interrupted();

// 130, 143 or 124 if the work was interrupted, else the code given.
ExitCode final_code(ExitCode code);

}  // namespace quartic::cli

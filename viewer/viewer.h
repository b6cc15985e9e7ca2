// The window: shows models, moves around them, picks parts and tells what they are.
#pragma once

#include "diagnostics/result.h"

#include <string>
#include <vector>

namespace quartic {

struct ViewerOptions {
    std::vector<std::string> files;  // shown as one model; none: an empty window
    int solver = 0;                  // overrides the materials' solvers; 0: does not
    std::string camera;              // as find_camera has it; empty: fit
    bool software = false;           // Mesa's software OpenGL, whatever hardware there is
};

// Runs until the user quits; returns the exit code. No display or no OpenGL is an Error of kind
// no_opengl.
Result<int> run_viewer(const ViewerOptions& options);

}  // namespace quartic

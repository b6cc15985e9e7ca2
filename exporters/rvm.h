// Saves a scene as binary AVEVA RVM.
#pragma once

#include "diagnostics/result.h"
#include "files/output.h"
#include "scene/scene.h"

namespace quartic {

// Writes everything; the caller commits. The same scene gives the same bytes. Groups have one
// colour each in RVM: parts of other materials than their group's first one go into groups of their
// own below it. Attributes have no place in this format.
Status export_rvm(const Scene& scene, Output& output);

// Surfaces that are given by an equation become facets.
void remark_rvm(const Scene& scene, Findings& findings);

}  // namespace quartic

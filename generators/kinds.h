// The kinds of models; generate.cpp holds their table.
#pragma once

#include "generators/generate.h"
#include "generators/model.h"

namespace quartic {

Scene make_plant(const GenerateOptions& options);
Scene make_tori(const GenerateOptions& options);
Scene make_elbows(const GenerateOptions& options);
Scene make_sheet(const GenerateOptions& options);
Scene make_surfaces(const GenerateOptions& options);
Scene make_run(const GenerateOptions& options);

}  // namespace quartic

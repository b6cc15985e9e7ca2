// The columns that every benchmark has which judges rays against the truth.
#pragma once

#include "bench/judge.h"
#include "bench/report.h"

#include <string>
#include <vector>

namespace quartic {

// elsewhere: what hits at a wrong place are called: "wrong_lobe", "other".
std::vector<Column> truth_columns(const std::string& elsewhere);
void add_truth(const Judgement& judgement, const std::string& elsewhere,
               nlohmann::ordered_json& row);

}  // namespace quartic

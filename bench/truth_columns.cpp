// Writes judgements into rows.
#include "bench/truth_columns.h"

#include <algorithm>

namespace quartic {

std::vector<Column> truth_columns(const std::string& elsewhere) {
    std::string title = elsewhere;
    std::replace(title.begin(), title.end(), '_', ' ');
    return {{"true_hits", "", {}},
            {"missed_hard", "missed hard", {}},
            {"missed", "missed", {}},
            {"false_hard", "false hard", {}},
            {"false", "false", {}},
            {elsewhere + "_hard", title + " hard", {}},
            {elsewhere, title, {}},
            {"error_median", "error median", {}},
            {"error_p9999", "99.99 %", {}},
            {"error_max", "max", {}},
            {"iterations_mean", "steps", {}},
            {"iterations_block", "8x4 block", {}},
            {"iterations_max", "most", {}}};
}

void add_truth(const Judgement& judgement, const std::string& elsewhere,
               nlohmann::ordered_json& row) {
    std::vector<float> errors = judgement.errors;
    const ErrorFigures error = figures(errors);
    row["true_hits"] = judgement.hits;
    row["missed_hard"] = judgement.missed.hard;
    row["missed"] = judgement.missed.hard + judgement.missed.tie;
    row["false_hard"] = judgement.false_hits.hard;
    row["false"] = judgement.false_hits.hard + judgement.false_hits.tie;
    row[elsewhere + "_hard"] = judgement.elsewhere.hard;
    row[elsewhere] = judgement.elsewhere.hard + judgement.elsewhere.tie;
    row["error_median"] = error.median;
    row["error_p9999"] = error.p9999;
    row["error_max"] = error.max;
    row["iterations_mean"] = judgement.steps_mean();
    row["iterations_block"] = judgement.steps_mean_of_blocks();
    row["iterations_max"] = judgement.steps_max;
}

}  // namespace quartic

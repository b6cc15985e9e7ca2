// Times things in interleaved rounds, so that a machine whose speed drifts is unfair to none.
#pragma once

#include "diagnostics/result.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace quartic {

// What is timed: prepare() is not, run() is.
struct TimedCase {
    std::string name;
    std::function<Status()> prepare;
    std::function<Status()> run;  // returns when the work is done, not when it was asked for
};

double wall_seconds();  // since some start

struct TimingOptions {
    int rounds = 9;
    double batch_s = 0.0;  // a measurement repeats run() for at least so long, at least once
    std::function<double()> clock = wall_seconds;
    std::function<bool()> is_stopped = [] { return false; };
};

using Rounds = std::vector<double>;  // seconds of one run() in each round

// In every round each case is prepared, run once to warm up, and measured; every other round goes
// backwards, so that steady drift cancels. One result for each case, in their order.
Result<std::vector<Rounds>> time_interleaved(std::span<const TimedCase> cases,
                                             const TimingOptions& options);

// The middle one; the mean of both middle ones of an even number; 0 of none.
double median(std::vector<double> values);

// Sums of several cases, round by round: a set of views as one case.
Rounds sum_of(std::span<const Rounds> cases);

// How many times faster `timed` is than `base`: the median of the rounds' ratios. less, where it is
// not empty, is taken off both: what is left when all that is alike is not counted. 0 where nothing
// is left.
double median_ratio(const Rounds& base, const Rounds& timed, const Rounds& base_less = {},
                    const Rounds& timed_less = {});

// From which count on one series of times stays below another: between two counts by a straight
// line in logarithms; nothing if it does not. Of series that end early, the counts that both have
// count.
std::optional<double> crossover(const std::vector<double>& counts, const std::vector<double>& times,
                                const std::vector<double>& other_times);

}  // namespace quartic

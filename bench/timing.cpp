// Interleaved rounds and their medians.
#include "bench/timing.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace quartic {
namespace {

Status measure(const TimedCase& timed, const TimingOptions& options, double& seconds) {
    Status status = timed.prepare();
    status = status ? timed.run() : status;  // to warm up
    const double start = options.clock();
    double now = start;
    int runs = 0;
    while (status && (runs == 0 || now - start < options.batch_s)) {
        status = timed.run();
        now = options.clock();
        ++runs;
    }
    seconds = (now - start) / std::max(1, runs);
    return status;
}

}  // namespace

double wall_seconds() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
}

Result<std::vector<Rounds>> time_interleaved(std::span<const TimedCase> cases,
                                             const TimingOptions& options) {
    std::vector<Rounds> rounds(cases.size());
    for (int round = 0; round < options.rounds; ++round) {
        for (std::size_t i = 0; i < cases.size(); ++i) {
            if (options.is_stopped()) {
                return Error{ErrorKind::interrupted, "", "interrupted"};
            }
            const std::size_t at = round % 2 == 0 ? i : cases.size() - 1 - i;
            double seconds = 0.0;
            const Status measured = measure(cases[at], options, seconds);
            if (!measured) {
                return measured.error();
            }
            rounds[at].push_back(seconds);
        }
    }
    return rounds;
}

double median(std::vector<double> values) {
    if (values.empty()) {
        return 0.0;
    }
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

Rounds sum_of(std::span<const Rounds> cases) {
    Rounds sum(cases.empty() ? 0 : cases[0].size(), 0.0);
    for (const Rounds& rounds : cases) {
        for (std::size_t i = 0; i < sum.size(); ++i) {
            sum[i] += rounds[i];
        }
    }
    return sum;
}

double median_ratio(const Rounds& base, const Rounds& timed, const Rounds& base_less,
                    const Rounds& timed_less) {
    const auto left = [](const Rounds& rounds, const Rounds& less, std::size_t i) {
        return rounds[i] - (i < less.size() ? less[i] : 0.0);
    };
    std::vector<double> ratios;
    for (std::size_t i = 0; i < std::min(base.size(), timed.size()); ++i) {
        const double dividend = left(base, base_less, i);
        const double divisor = left(timed, timed_less, i);
        if (dividend > 0.0 && divisor > 0.0) {
            ratios.push_back(dividend / divisor);
        }
    }
    return median(ratios);
}

std::optional<double> crossover(const std::vector<double>& counts, const std::vector<double>& times,
                                const std::vector<double>& other_times) {
    std::optional<double> found;
    double before = 0.0;
    for (std::size_t i = 0; i < std::min(times.size(), other_times.size()); ++i) {
        const double lead = std::log(other_times[i] / times[i]);  // > 0: faster
        if (lead <= 0.0) {
            found.reset();
        } else if (!found) {
            const double part = i == 0 ? 0.0 : lead / (lead - before);
            const double left = i == 0 ? counts[0] : counts[i - 1];
            found = counts[i] * std::pow(left / counts[i], part);
        }
        before = lead;
    }
    return found;
}

}  // namespace quartic

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace ashimpact::bench {

/// How long to measure.
struct Options {
    int repetitions = 5;   ///< of every measurement; the median counts
    double seconds = 0.3;  ///< least length of a repetition
};

/// One thing to measure: a call does @p items of it.
struct Subject {
    std::string name;
    double items;
    std::function<void()> call;
};

/// Items per second of CPU time of each subject, by name: the median of repetitions, by Google Benchmark.
[[nodiscard]] std::map<std::string, double> rates_of(const std::vector<Subject>& subjects,
                                                     const Options& options);

}  // namespace ashimpact::bench

#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace ashimpact::bench {

/// One thing to measure: a call does @p items of it.
struct Subject {
    std::string name;
    double items;
    std::function<void()> call;
};

/// Items per second of CPU time of each subject, by name: the median of repetitions, by Google Benchmark.
[[nodiscard]] std::map<std::string, double> rates_of(const std::vector<Subject>& subjects, int repetitions,
                                                     double seconds);

}  // namespace ashimpact::bench

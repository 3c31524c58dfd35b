// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/measured.hpp"

#include <benchmark/benchmark.h>

namespace ashimpact::bench {

namespace {

/// Keeps the medians and prints nothing.
class Medians : public benchmark::BenchmarkReporter {
  public:
    bool ReportContext(const Context&) override { return true; }
    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs) {
            if (run.aggregate_name == "median")
                seconds[run.run_name.function_name] = run.GetAdjustedCPUTime();
        }
    }

    std::map<std::string, double> seconds;
};

}  // namespace

std::map<std::string, double> rates_of(const std::vector<Subject>& subjects, const Options& options) {
    benchmark::ClearRegisteredBenchmarks();
    for (const Subject& subject : subjects) {
        subject.call();  // what is computed once is not measured
        benchmark::RegisterBenchmark(subject.name.c_str(),
                                     [&subject](benchmark::State& state) {
                                         for (auto round : state) {
                                             static_cast<void>(round);
                                             subject.call();
                                         }
                                     })
            ->Unit(benchmark::kSecond)
            ->MinTime(options.seconds)
            ->Repetitions(options.repetitions);
    }
    Medians medians;
    benchmark::RunSpecifiedBenchmarks(&medians);
    std::map<std::string, double> rates;
    for (const Subject& subject : subjects)
        rates[subject.name] = subject.items / medians.seconds.at(subject.name);
    return rates;
}

}  // namespace ashimpact::bench

// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/thread_table.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <thread>

#include <fmt/core.h>

#include "bench/machine.hpp"
#include "bench/multiply_add.hpp"
#include "bench/population.hpp"
#include "bench/scaling.hpp"

namespace ashimpact::bench {

namespace {

constexpr std::int64_t multiply_add_rounds = 80'000'000;

/// As many multiply-adds in all on any number of threads: some tenths of a second on one.
ThreadedWork multiply_adds_on_threads() {
    return {"pure multiply-adds", [](int threads) {
                std::vector<std::jthread> crew;
                for (int i = 0; i < threads; ++i)
                    crew.emplace_back([threads] { multiply_adds(multiply_add_rounds / threads); });
            }};
}

/// The command itself, from its start to its end, with all it does beside the impacts.
ThreadedWork sweep_on_threads() {
    const std::string folder = ASHIMPACT_BENCH_WORK;
    std::filesystem::create_directories(folder);
    std::ofstream(folder + "/sweep-spec.json") << R"({
        "impact": {"laws": ["dmt"], "density": "2600 kg/m3", "contact_modulus": "90 GPa",
                   "work_of_adhesion": "0.3 J/m2", "damping": "0.002 kg/s"},
        "variables": {
            "velocity": {"distribution": "uniform", "from": "0.5 m/s", "to": "5 m/s"},
            "radius": {"distribution": "log-normal", "median": "44 um", "geometric_standard_deviation": 1.5}},
        "sampling": {"method": "random", "samples": 4000000, "seed": 1}})";
    return {"ashimpact sweep, 4 million impacts", [](int threads) {
                static_cast<void>(start_up_seconds({ASHIMPACT_PROGRAM, "sweep", "sweep-spec.json", "-o",
                                                    "sweep.json", "--threads", std::to_string(threads)},
                                                   1));
            }};
}

}  // namespace

void print_thread_table(int repetitions) {
    unpin();
    const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    const Population many = population(Law::of<Dmt>(), Detachment::zero_overlap, DampingLaw::constant, 16384);
    std::vector<Eigen::Index> places;
    for (Eigen::Index i = 0; i < 64 * many.impacts.size(); ++i) places.push_back(i % many.impacts.size());
    const test::Impacts more = many.impacts.picked(places);
    const ImpactBatch batch = more.batch();
    ImpactBatchResult result;
    const ThreadedWork impacts{"impacts in a batch", [&](int threads) {
                                   solve_impacts(batch, result, {.threads = threads, .turning_point = false});
                               }};
    const int rounds = 4 * repetitions + 1;
    fmt::print("\n{:<36}{:>10}{:>30}{:>14}\n", fmt::format("{} threads, medians of {} rounds", cores, rounds),
               "speed-up", "/ multiply-adds (quartiles)", "undisturbed");
    for (const Scaling& each :
         measure_scaling(multiply_adds_on_threads(), {impacts, sweep_on_threads()}, cores, rounds))
        fmt::print("{:<36}{:>10.2f}{:>14.2f} ({:.2f} to {:.2f}){:>14.2f}\n", each.name, each.speedup.median,
                   each.ratio.median, each.ratio.lower, each.ratio.upper, each.undisturbed);
}

}  // namespace ashimpact::bench

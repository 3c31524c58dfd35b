// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/scaling.hpp"

#include <algorithm>
#include <chrono>

namespace ashimpact::bench {

namespace {

double wall_seconds(const ThreadedWork& work, int threads) {
    const auto start = std::chrono::steady_clock::now();
    work.run(threads);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Times of one work, a value a round [s].
struct Times {
    std::vector<double> alone;
    std::vector<double> together;

    void measure(const ThreadedWork& work, int threads) {
        alone.push_back(wall_seconds(work, 1));
        together.push_back(wall_seconds(work, threads));
    }
    [[nodiscard]] std::vector<double> speedups() const {
        std::vector<double> speedups;
        for (std::size_t i = 0; i < alone.size(); ++i) speedups.push_back(alone[i] / together[i]);
        return speedups;
    }
    [[nodiscard]] double undisturbed() const {
        return *std::ranges::min_element(alone) / *std::ranges::min_element(together);
    }
};

Quartiles quartiles_of(std::vector<double> values) {
    std::ranges::sort(values);
    const auto at = [&](std::size_t quarters) { return values[(values.size() - 1) * quarters / 4]; };
    return {at(1), at(2), at(3)};
}

Scaling scaling_of(const std::string& name, const Times& times, const Times& yardstick) {
    const std::vector<double> speedups = times.speedups();
    std::vector<double> ratios = yardstick.speedups();
    for (std::size_t i = 0; i < ratios.size(); ++i) ratios[i] = speedups[i] / ratios[i];
    return {name, quartiles_of(speedups), quartiles_of(ratios),
            times.undisturbed() / yardstick.undisturbed()};
}

}  // namespace

std::vector<Scaling> measure_scaling(const ThreadedWork& yardstick, const std::vector<ThreadedWork>& works,
                                     int threads, int rounds) {
    std::vector<ThreadedWork> all{yardstick};
    all.insert(all.end(), works.begin(), works.end());
    for (const ThreadedWork& work : all) work.run(threads);  // what is done once is not measured
    std::vector<Times> times(all.size());
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < all.size(); ++i) {
            const std::size_t next = round % 2 == 0 ? i : all.size() - 1 - i;
            times[next].measure(all[next], threads);
        }
    }
    std::vector<Scaling> scalings;
    for (std::size_t i = 0; i < all.size(); ++i)
        scalings.push_back(scaling_of(all[i].name, times[i], times.front()));
    return scalings;
}

}  // namespace ashimpact::bench

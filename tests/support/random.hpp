// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string_view>

#include "solver/numeric/gsl/statistics.hpp"
#include "solver/statistics/design.hpp"

namespace ashimpact::test {

/// The same numbers on every machine, unlike the distributions of the standard library.
class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    [[nodiscard]] double uniform(double lower, double upper) {
        const double unit = static_cast<double>(engine_() >> 11U) * 0x1p-53;
        return lower + (upper - lower) * unit;
    }
    [[nodiscard]] double log_uniform(double lower, double upper) {
        return std::exp(uniform(std::log(lower), std::log(upper)));
    }
    /// A normal number of mean zero.
    [[nodiscard]] double normal(double deviation) {
        return deviation * gsl::normal_quantile(unit_interval(engine_()));
    }
    /// One of 0 ... count - 1.
    [[nodiscard]] std::size_t below(std::size_t count) {
        return static_cast<std::size_t>(uniform(0.0, static_cast<double>(count)));
    }

  private:
    std::mt19937_64 engine_;
};

/// Random numbers of a name, so that a new name shifts no other's. @param seed of the test
[[nodiscard]] inline Random random_of(std::string_view name, std::uint64_t seed) {
    std::uint64_t hash = 0xcbf29ce484222325U ^ seed;  // FNV-1a
    for (const char letter : name) hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3U;
    return Random(hash);
}

/// How often to repeat what costs time: as often as asked, but less under sanitizers.
[[nodiscard]] constexpr int repetitions(int in_release) {
#ifdef ASHIMPACT_FEWER_REPETITIONS
    return in_release / 20 + 1;
#else
    return in_release;
#endif
}

}  // namespace ashimpact::test

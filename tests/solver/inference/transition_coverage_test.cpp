// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdio>
#include <utility>

#include <doctest/doctest.h>

#include "solver/inference/measured_critical_velocity.hpp"
#include "solver/numeric/gsl/statistics.hpp"
#include "tests/support/random.hpp"

using namespace ashimpact;
using ashimpact::test::Random;

namespace {

constexpr double truth = 1.27;         // mean v_c, 96 um [m/s]
constexpr double uncertainty = 0.058;  // of v_in [m/s]
constexpr unsigned long seed = 11;

/// An impact aimed at @p velocity of a particle that rebounds from @p critical on, as measured.
Measurement measured_impact(double velocity, double critical, Random& random) {
    return {.velocity = velocity + random.normal(uncertainty),
            .rebound = velocity < critical ? 0.0 : 0.3 * velocity,
            .noise = VelocityNoise::of_velocities(uncertainty, uncertainty)};
}

/// Impacts of one outcome.
struct OneSided {
    int impacts;
    double farthest;  ///< v_in are drawn evenly between truth and here; below it all are captured [m/s]
};

/// In how many series of @p repetitions the one bound there is excludes the truth.
int wrong_bounds(const OneSided& laboratory, int repetitions) {
    Random random(seed);
    const bool captures = laboratory.farthest < truth;
    int wrong = 0;
    for (int i = 0; i < repetitions; ++i) {
        MeasurementSet set{.source = "one outcome", .points = {}};
        for (int j = 0; j < laboratory.impacts; ++j) {
            const double velocity = truth + random.uniform(0.0, 1.0) * (laboratory.farthest - truth);
            set.points.push_back(measured_impact(velocity, captures ? 2.0 * truth : 0.0, random));
        }
        const MeasuredCriticalVelocity measured = measured_critical_velocity(set);
        CHECK(measured.lower.has_value() == captures);
        CHECK(measured.upper.has_value() != captures);
        if (captures ? measured.lower > truth : measured.upper < truth) ++wrong;
    }
    return wrong;
}

/// Whether so many miss that a bound which holds in 95 % of cases would give them once in 1000 times.
bool too_many(int wrong, int repetitions) {
    return wrong > 0 && 1.0 - gsl::binomial_probability(static_cast<unsigned>(wrong - 1), 1.0 - confidence,
                                                        static_cast<unsigned>(repetitions)) <
                            1e-3;
}

/// Particles whose critical velocities differ.
struct Mixture {
    int impacts;
    double spread;  ///< standard deviation of v_c between particles [m/s]
};

struct MixtureCoverage {
    int covered = 0;
    double width = 0.0;  ///< mean half width [m/s]
};

MixtureCoverage coverage_of(const Mixture& mixture, int repetitions) {
    Random random(seed);
    MixtureCoverage result;
    for (int i = 0; i < repetitions; ++i) {
        MeasurementSet set{.source = "mixture", .points = {}};
        for (int j = 0; j < mixture.impacts; ++j) {
            const double velocity = random.uniform(0.5 * truth, 1.5 * truth);
            set.points.push_back(measured_impact(velocity, truth + random.normal(mixture.spread), random));
        }
        const MeasuredCriticalVelocity measured = measured_critical_velocity(set);
        if (!measured.lower || !measured.upper) continue;  // counts as missed
        if (*measured.lower < truth && truth < *measured.upper) ++result.covered;
        result.width += 0.5 * (*measured.upper - *measured.lower) / repetitions;
    }
    return result;
}

}  // namespace

TEST_CASE("a bound from one outcome holds in 95 % of cases, however many impacts there are") {
    constexpr int repetitions = 300;
    for (const double farthest : {0.6 * truth, 0.9999 * truth, 1.0001 * truth, 1.4 * truth}) {
        for (const int impacts : {1, 20, 200}) {
            CAPTURE(farthest);
            CAPTURE(impacts);
            CHECK_FALSE(too_many(wrong_bounds({impacts, farthest}, repetitions), repetitions));
        }
    }
    CHECK(too_many(30, repetitions));
    CHECK_FALSE(too_many(15, repetitions));
}

TEST_CASE("a bound from one outcome takes each impact's own uncertainty") {
    const auto impact = [](double velocity, double u) {
        return Measurement{.velocity = velocity, .rebound = 0.0, .noise = VelocityNoise::of_velocities(u, u)};
    };
    const MeasuredCriticalVelocity measured =
        measured_critical_velocity({.source = "two", .points = {impact(1.0, 0.3), impact(0.9, 0.01)}});
    const double quantile = gsl::normal_quantile(1.0 - 0.025);
    REQUIRE(measured.lower);
    CHECK(std::abs(*measured.lower - (0.9 - 0.01 * quantile)) < 1e-12);
}

TEST_CASE("the measured v_c of particles that differ is covered: few repetitions") {
    constexpr int repetitions = 300;
    int covered = 0;
    for (const double spread : {0.1, 0.2}) covered += coverage_of({20, spread}, repetitions).covered;
    const double probability =
        gsl::binomial_probability(static_cast<unsigned>(covered), 0.92, 2 * repetitions);
    CAPTURE(covered);
    CHECK(probability > 1e-3);
}

// test_uncertainty --no-skip --test-case="coverage study: outcomes*"; docs/uncertainty.md has its numbers.
TEST_CASE("coverage study: outcomes alone" * doctest::skip()) {
    constexpr int repetitions = 4000;
    std::puts("impacts  v_in/v_c from  wrong");
    for (const double farthest : {0.6, 0.9999, 1.0001, 1.4}) {
        for (const int impacts : {1, 5, 20, 60, 200, 1000}) {
            const int wrong = wrong_bounds({impacts, farthest * truth}, repetitions);
            std::printf("%-8d %-14.4f %.2f %%\n", impacts, farthest, 100.0 * wrong / repetitions);
            CHECK_FALSE(too_many(wrong, repetitions));
        }
    }
    std::puts("impacts  spread  covered  half width");
    for (const auto& [impacts, spread] :
         {std::pair{20, 0.0}, {60, 0.0}, {20, 0.1}, {60, 0.1}, {20, 0.2}, {60, 0.2}, {200, 0.2}}) {
        const MixtureCoverage found = coverage_of({impacts, spread}, repetitions);
        std::printf("%-8d %-7.2f %.1f %%   %.3f\n", impacts, spread, 100.0 * found.covered / repetitions,
                    found.width);
        std::fflush(stdout);
        CHECK(found.covered > 0.9 * repetitions);
        CHECK(found.covered < 0.98 * repetitions);
    }
}

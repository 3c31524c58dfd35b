// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdio>
#include <tuple>
#include <utility>

#include <doctest/doctest.h>

#include "core/text/error.hpp"
#include "solver/inference/critical_velocity_uncertainty.hpp"
#include "solver/inference/impacts/inverted_impacts.hpp"
#include "solver/inference/impacts/measurement.hpp"
#include "solver/numeric/gsl/interpolation.hpp"
#include "solver/numeric/gsl/solvers.hpp"
#include "solver/numeric/gsl/statistics.hpp"
#include "solver/statistics/moments.hpp"
#include "tests/solver/inference/ash_laboratory.hpp"
#include "tests/support/checks.hpp"
#include "tests/support/random.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

Measurement impact(double velocity, double rebound, double uncertainty = 0.0) {
    Measurement point{.velocity = velocity, .rebound = rebound};
    if (uncertainty > 0.0) point.noise = VelocityNoise::of_velocities(uncertainty, uncertainty);
    return point;
}

MeasurementSet series_of(std::vector<Measurement> points) {
    return {.source = "lab", .points = std::move(points)};
}

MeasuredCriticalVelocity measured_from(std::vector<Measurement> points) {
    return measured_critical_velocity(series_of(std::move(points)));
}

/// Captures and rebounds that mix over far more than their noise.
std::vector<Measurement> mixed_outcomes() {
    std::vector<Measurement> points;
    for (int i = 0; i < 20; ++i)
        points.push_back(impact(0.8 + 0.04 * i, i > 9 || i % 3 == 0 ? 0.1 : 0.0, 0.01));
    return points;
}

/// -2 ln L of each single impact, with a transition of this centre and width.
double misfit(const std::vector<Measurement>& points, double center, double width) {
    double sum = 0.0;
    for (const Measurement& point : points) {
        const double z = (center - point.velocity) / width;
        sum -= 2.0 * gsl::normal_log_probability(point.captured() ? z : -z);
    }
    return sum;
}

/// The same with the likeliest centre [m/s] of mixed_outcomes().
double least_misfit(const std::vector<Measurement>& points, double width) {
    const auto at = [&](double center) { return misfit(points, center, width); };
    return at(gsl::minimise_between(at, 0.8, 1.1, 1.6, 1e-7));
}

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

TEST_CASE("outcomes without noise bound v_c by the gap between them") {
    const auto measured =
        measured_from({impact(0.8, 0.0), impact(1.0, 0.0), impact(1.4, 0.2), impact(1.2, 0.1)});
    CHECK(measured.fastest_capture == 1.0);
    CHECK(measured.slowest_rebound == 1.2);
    CHECK(relative_difference(*measured.value, 1.1) < 1e-12);
    CHECK(relative_difference(*measured.standard_uncertainty, 0.2 / std::sqrt(12.0)) < 1e-12);
}

TEST_CASE("outcomes without stated noise get that of their scatter") {
    // Rebounds of v_r = (v_in - 1.1)/2 that scatter by 0.03 m/s, as v_in does.
    Random random(3);
    int covered = 0;
    constexpr int laboratories = 200;
    for (int laboratory = 0; laboratory < laboratories; ++laboratory) {
        std::vector<Measurement> points;
        for (int i = 0; i < 30; ++i) {
            const double v = random.uniform(0.7, 2.5);
            const double rebound = v > 1.1 ? std::max(1e-3, 0.5 * (v - 1.1) + random.normal(0.03)) : 0.0;
            points.push_back(impact(v + random.normal(0.03), rebound));
        }
        const auto measured = measured_from(points);
        REQUIRE(measured.value);
        covered += *measured.lower <= 1.1 && *measured.upper >= 1.1 ? 1 : 0;
    }
    CHECK(covered >= 180);
}

TEST_CASE("outcomes with noise: symmetric ones put v_c in the middle, wider than the gap") {
    const auto measured = measured_critical_velocity(series_of(
        {impact(0.9, 0.0, 0.05), impact(1.0, 0.0, 0.05), impact(1.1, 0.1, 0.05), impact(1.2, 0.2, 0.05)}));
    REQUIRE(measured.value);
    CHECK(std::abs(*measured.value - 1.05) < 1e-4);
    CHECK(*measured.lower < 1.0);
    CHECK(*measured.upper > 1.1);
    CHECK(std::abs((*measured.lower + *measured.upper) / 2 - 1.05) < 1e-3);
}

TEST_CASE("where noise does not reach across the gap between outcomes, v_c is its middle") {
    const auto measured =
        measured_from({impact(0.4, 0.0, 1e-3), impact(1.0, 0.0, 1e-3), impact(3.0, 0.5, 1e-3)});
    REQUIRE(measured.value);
    CHECK(relative_difference(*measured.value, 2.0) < 1e-9);
}

TEST_CASE("captures that may be slow rebounds leave the measured v_c without a lower end") {
    // v_r grows from 0 at 1 m/s, so slowly that the slowest rebounds read zero as often as not.
    Random random(6);
    std::vector<Measurement> points;
    for (int i = 0; i < 60; ++i) {
        const double v = 0.5 + 0.04 * i;
        const double rebound = v > 1.0 ? std::max(0.0, 0.03 * (v - 1.0) + random.normal(0.05)) : 0.0;
        points.push_back(impact(v, rebound, 0.05));
    }
    const auto blurred = measured_from(points);
    REQUIRE(blurred.value);
    CHECK_FALSE(blurred.lower);
    CHECK(*blurred.upper > 1.0);
    CHECK(contains(blurred.note, "may be rebounds"));
    CHECK(check({0.5 * *blurred.value, 0.01, 0.1, 0.6}, blurred).verdict ==
          CriticalVelocityVerdict::not_comparable);
    CHECK(check({4.0 * *blurred.value, 0.01, 5.0, 6.0}, blurred).verdict ==
          CriticalVelocityVerdict::model_too_high);
    for (Measurement& point : points)  // seen to stick
        if (point.captured()) point.outcome = NotedOutcome::capture;
    CHECK(measured_from(points).lower);
}

TEST_CASE("mixed outcomes widen the transition") {
    const auto measured = measured_from(mixed_outcomes());
    REQUIRE(measured.width);
    CHECK(*measured.width > 0.05);
    CHECK(contains(measured.note, "mix"));
    CHECK(*measured.lower < *measured.value);
    CHECK(*measured.value < *measured.upper);
}

TEST_CASE("a mean counts as often as it has impacts") {
    std::vector<Measurement> means = mixed_outcomes();
    std::vector<Measurement> each = means;
    for (std::size_t i = 0; i < means.size(); i += 3) {
        means[i].count = 4;
        each.insert(each.end(), 3, mixed_outcomes()[i]);
    }
    const auto of_means = measured_from(means);
    const auto of_each = measured_from(each);
    CHECK(relative_difference(*of_means.value, *of_each.value) < 1e-6);
    CHECK(relative_difference(*of_means.width, *of_each.width) < 1e-6);
    CHECK(relative_difference(*of_means.lower, *of_each.lower) < 1e-6);
    CHECK(relative_difference(*of_means.value, *measured_from(mixed_outcomes()).value) > 1e-3);
}

TEST_CASE("captures and rebounds that overlap by about their noise: always a v_c, never far off") {
    constexpr double truth = 1.2;
    constexpr double noise = 0.058;
    Random random(11);
    int mixed = 0;
    int covered = 0;
    constexpr int laboratories = 300;
    for (int laboratory = 0; laboratory < laboratories; ++laboratory) {
        std::vector<Measurement> points;
        for (int i = 0; i < 60; ++i) {
            const double v = truth * (0.6 + 2.4 * i / 59.0);
            points.push_back(impact(v + random.normal(noise), v < truth ? 0.0 : 0.1, noise));
        }
        const auto measured = measured_from(points);
        REQUIRE(measured.value);
        CHECK(std::abs(*measured.value - truth) < 0.15);
        CHECK(*measured.width >= noise * (1.0 - 1e-12));
        CHECK(*measured.width < 3.0 * noise);
        REQUIRE(measured.lower);
        REQUIRE(measured.upper);
        if (*measured.lower < truth && truth < *measured.upper) ++covered;
        if (contains(measured.note, "mix")) ++mixed;
    }
    CHECK(mixed > 20);
    CHECK(covered > 0.9 * laboratories);
}

TEST_CASE("the most likely transition is where neither its centre nor its width can be bettered") {
    const std::vector<Measurement> points = mixed_outcomes();
    const auto measured = measured_from(points);
    const double center = measured.value.value();
    const double width = measured.width.value();
    const double least = misfit(points, center, width);
    CHECK(width > 0.01);  // the noise
    for (const double change : {0.9, 0.99, 1.01, 1.1}) {
        CAPTURE(change);
        CHECK(misfit(points, center * change, width) > least);
        CHECK(least_misfit(points, width * change) > least - 1e-6);
    }
    CHECK(least_misfit(points, 0.01) > least);
}

TEST_CASE("captures faster than the rebounds are no threshold") {
    for (const double noise : {0.0, 0.05}) {
        CAPTURE(noise);
        const auto measured =
            measured_from({impact(8.0, 0.0, noise), impact(9.0, 0.0, noise), impact(2.0, 1.0, noise),
                           impact(3.0, 1.5, noise), impact(4.0, 2.0, noise), impact(5.0, 2.5, noise)});
        CHECK_FALSE(measured.value);
        CHECK_FALSE(measured.lower);
        CHECK_FALSE(measured.upper);
        CHECK(contains(measured.note, "captures are faster than rebounds"));
        CHECK(check({1.0, 0.1, 0.8, 1.2}, measured).verdict == CriticalVelocityVerdict::not_comparable);
    }
    // Within the noise a reversal is none.
    const auto near = measured_from({impact(1.02, 0.0, 0.05), impact(1.0, 0.1, 0.05)});
    REQUIRE(near.value);
    CHECK(std::abs(*near.value - 1.01) < 1e-6);
}

TEST_CASE("both outcomes at one velocity") {
    const auto exact = measured_from({impact(1.0, 0.0), impact(1.0, 0.1)});
    CHECK(exact.value == 1.0);
    CHECK_FALSE(exact.lower);
    CHECK(contains(exact.note, "one velocity"));
    const auto noisy = measured_from({impact(1.0, 0.0, 0.1), impact(1.0, 0.1, 0.1)});
    REQUIRE(noisy.value);
    CHECK(std::abs(*noisy.value - 1.0) < 1e-6);
    CHECK(*noisy.lower < 0.95);
}

TEST_CASE("a lone capture slower than its noise bounds nothing") {
    const auto measured = measured_from({impact(0.05, 0.0, 0.1)});
    CHECK_FALSE(measured.lower);
    CHECK(contains(measured.note, "every impact was captured"));
}

TEST_CASE("a verdict on a modelled v_c") {
    const auto measured = measured_from({impact(1.0, 0.0, 0.02), impact(1.1, 0.1, 0.02)});
    CHECK(check({1.05, 0.05, 0.95, 1.15}, measured).verdict == CriticalVelocityVerdict::agrees);
    CHECK(check({0.6, 0.05, 0.5, 0.7}, measured).verdict == CriticalVelocityVerdict::model_too_low);
    CHECK(check({1.6, 0.05, 1.5, 1.7}, measured).verdict == CriticalVelocityVerdict::model_too_high);
    const auto captured = measured_from({impact(1.0, 0.0)});
    CHECK(check({0.6, 0.05, 0.5, 0.7}, captured).verdict == CriticalVelocityVerdict::model_too_low);
    CHECK(check({1.6, 0.05, 1.5, 1.7}, captured).verdict == CriticalVelocityVerdict::not_comparable);
}

TEST_CASE("the camera's resolution: the slope of a line through whole pixels") {
    const Camera two{.frame_rate = 80e3, .pixel_size = 8e-6};
    CHECK(relative_difference(two.velocity_uncertainty(), 8e-6 / std::sqrt(12.0) * std::sqrt(2.0) * 80e3) <
          1e-5);
    const Camera five{.frame_rate = 80e3, .pixel_size = 8e-6, .frames = 5};
    CHECK(relative_difference(five.velocity_uncertainty(), 8e-6 / std::sqrt(12.0) * 80e3 / std::sqrt(10.0)) <
          1e-5);
    const auto refused = [](const Camera& camera) {
        return input_error_of([&] { return camera.velocity_uncertainty(); });
    };
    CHECK(contains(refused({80e3, 8e-6, 1}), "1 frames"));
    CHECK(contains(refused({0.0, 8e-6}), "frame rate"));
}

TEST_CASE("bins hold the mean of their impacts and its uncertainty; captures stay") {
    const MeasurementSet set =
        series_of({impact(2.0, 0.6, 0.04), impact(2.2, 0.8, 0.04), impact(3.0, 1.2, 0.04),
                   impact(3.2, 1.4, 0.04), impact(1.0, 0.0, 0.04)});
    const MeasurementSet pairs = binned(set, {.impacts_per_bin = 2});
    CHECK(pairs.captures() == 1);
    REQUIRE(pairs.rebounds() == 2);
    for (const Measurement& point : pairs.points) {
        if (point.captured()) continue;
        CHECK(point.count == 2);
        CHECK(point.noise->incident >= 0.04 * 0.04 / 2.0 * (1.0 - 1e-12));
        const bool slow = point.velocity < 2.5;
        CHECK(relative_difference(point.velocity, slow ? 2.1 : 3.1) < 1e-12);
        CHECK(relative_difference(point.rebound, slow ? 0.7 : 1.3) < 1e-12);
    }
    CHECK_THROWS_AS(static_cast<void>(binned(set, {})), InputError);
    MeasurementSet means = series_of({impact(2.0, 0.6), impact(2.3, 0.9)});
    means.points[0].count = 2;
    means.points[0].tangential = 0.3;
    means.points[1].tangential = 0.6;
    const Measurement mean = binned(means, {.impacts_per_bin = 2}).points.front();
    CHECK(mean.count == 3);
    CHECK(relative_difference(mean.velocity, 2.1) < 1e-12);
    CHECK(relative_difference(mean.rebound, 0.7) < 1e-12);
    CHECK(relative_difference(*mean.tangential, 0.4) < 1e-12);
}

TEST_CASE("the uncertainty of a bin is that of its weighted mean, with what both velocities share") {
    const VelocityNoise good{.incident = 1e-4, .rebound = 2e-4, .covariance = 0.5e-4};
    const VelocityNoise poor{.incident = 4e-4, .rebound = 5e-4, .covariance = -2e-4};
    const MeasurementSet pair = binned(series_of({{.velocity = 2.0, .rebound = 0.6, .noise = good},
                                                  {.velocity = 2.2, .rebound = 0.8, .noise = poor}}),
                                       {.impacts_per_bin = 2});
    REQUIRE(pair.points.size() == 1);
    const double first = 1 / 3e-4;  // weights
    const double second = 1 / 9e-4;
    const auto of_mean = [&](double x, double y) {
        return (first * first * x + second * second * y) / ((first + second) * (first + second));
    };
    const Measurement& mean = pair.points[0];
    CHECK(relative_difference(mean.velocity, (first * 2.0 + second * 2.2) / (first + second)) < 1e-14);
    CHECK(relative_difference(mean.noise->incident, of_mean(1e-4, 4e-4)) < 1e-14);
    CHECK(relative_difference(mean.noise->rebound, of_mean(2e-4, 5e-4)) < 1e-14);
    CHECK(relative_difference(mean.noise->covariance, of_mean(0.5e-4, -2e-4)) < 1e-14);
}

TEST_CASE("three parts of eta(v_in): falling, flat, rising") {
    const ContactModel model = ash_model(Law::of<BrachDunn>());
    // eta falls as v^-1 to 2 m/s, is flat, and rises as v from 5 m/s on.
    const auto eta = [](double v) { return v < 2.0 ? 0.010 * 2.0 / v : v < 5.0 ? 0.010 : 0.010 * v / 5.0; };
    MeasurementSet set = {.source = "lab", .points = {}};
    for (int i = 0; i < 91; ++i) {
        const double v = 1.5 * std::pow(1.02, i);
        const double e = model.restitution(v, eta(v));
        REQUIRE(e > 0.0);
        set.points.push_back(impact(v, e * v, 0.01));
    }
    const auto smoothing = DampingSmoothing::of(invert(model, set));
    REQUIRE(smoothing);
    const DampingParts parts = find_parts(smoothing);
    REQUIRE(parts.parts.size() == 3);
    CHECK(parts.parts[0] == DampingPart::falling);
    CHECK(parts.parts[1] == DampingPart::flat);
    CHECK(parts.parts[2] == DampingPart::rising);
    CHECK(std::abs(parts.boundaries[0].velocity - 2.0) < 0.2);
    CHECK(std::abs(parts.boundaries[1].velocity - 5.0) < 0.5);
}

TEST_CASE("a critical velocity below every capture or above every rebound contradicts them") {
    MeasurementSet set{.source = "lab", .points = {}};
    for (const double v : {1.40, 1.55, 2.20}) set.points.push_back(impact(v, 0, 0.01));
    for (const double v : {1.72, 1.95, 3.10}) set.points.push_back(impact(v, 0.2 * v, 0.01));
    CHECK(contradiction_of(set, 0.5) == "is below every capture, from 1.4 m/s on");
    CHECK(contradiction_of(set, 1.38).empty());  // within the noise
    CHECK(contradiction_of(set, 1.6).empty());
    CHECK(contradiction_of(set, 4) == "is above every rebound, up to 3.1 m/s");
    set.points.erase(set.points.begin(), set.points.begin() + 3);
    CHECK(contradiction_of(set, 0.5).empty());  // no capture was seen
}

TEST_CASE("readings of one digit, most of them equal, leave borders with an uncertainty") {
    std::vector<InvertedImpact> impacts;
    for (const auto& [v, eta, count] : {std::tuple{0.3, 0.004416, 1},
                                        {0.4, 0.003187, 4},
                                        {0.8, 0.002585, 3},
                                        {1.3, 0.003681, 1},
                                        {1.3, 0.002943, 1}})
        for (int i = 0; i < count; ++i)
            impacts.push_back({.index = impacts.size(),
                               .velocity = v,
                               .restitution = 0.5,
                               .greatest_restitution = 1.0,
                               .damping = eta,
                               .standard_uncertainty = {},
                               .contact_time = {}});
    const DampingParts parts = find_parts(DampingSmoothing::of(impacts));
    REQUIRE_FALSE(parts.boundaries.empty());
    for (const PartBoundary& border : parts.boundaries) {
        CHECK(std::isfinite(border.standard_uncertainty));
        CHECK(border.standard_uncertainty > 0);
    }
}

TEST_CASE("damping that falls all along has one part, and none of no length") {
    std::vector<InvertedImpact> impacts;
    for (int i = 0; i < 40; ++i) {
        const double v = 1.0 + 0.1 * i;
        impacts.push_back({.index = static_cast<std::size_t>(i),
                           .velocity = v,
                           .restitution = 0.3,
                           .greatest_restitution = 1.0,
                           .damping = 0.01 / v,
                           .standard_uncertainty = 1e-5,
                           .contact_time = {}});
    }
    const DampingParts parts = find_parts(DampingSmoothing::of(impacts));
    REQUIRE(parts.parts.size() == 1);
    CHECK(parts.parts[0] == DampingPart::falling);
    CHECK(parts.boundaries.empty());
    CHECK(parts.outliers.empty());  // nearly without scatter: the spline's own misfit is no outlier
}

TEST_CASE("outcomes whose noise reaches below zero give no measured v_c") {
    MeasurementSet set{.source = "lab", .points = {}};
    for (int i = 0; i < 20; ++i) {
        const double v = 0.5 + 0.1 * i;
        set.points.push_back({.velocity = v,
                              .rebound = i % 4 == 0 ? 0.0 : 0.3 * v,
                              .noise = VelocityNoise::of_velocities(2.0, 2.0)});
    }
    const MeasuredCriticalVelocity measured = measured_critical_velocity(set);
    CHECK(measured.value.value_or(1.0) > 0.0);
    CHECK(measured.lower.value_or(0.0) >= 0.0);
}

TEST_CASE("the slope of ln Phi, up to where the density is too small for a number") {
    for (const double x : {-30.0, -1.0, 0.0, 2.0}) {
        CAPTURE(x);
        const double h = 1e-5;
        const double difference =
            (gsl::normal_log_probability(x + h) - gsl::normal_log_probability(x - h)) / (2.0 * h);
        CHECK(relative_difference(gsl::normal_log_probability_slope(x), difference) < 1e-7);
    }
    CHECK(gsl::normal_log_probability_slope(36.9) > 0.0);
    CHECK(gsl::normal_log_probability_slope(1e3) == 0.0);
}

TEST_CASE("Gauss-Legendre nodes integrate polynomials exactly") {
    double sum = 0.0;
    for (const auto& [position, weight] : gsl::gauss_legendre(6, -1.0, 3.0))
        sum += weight * std::pow(position, 11);
    CHECK(relative_difference(sum, (std::pow(3.0, 12) - 1.0) / 12.0) < 1e-13);
}

TEST_CASE("the outcomes of many impacts are merged without a loss") {
    Random random(8);
    constexpr double u = 0.05;
    std::vector<Measurement> points;
    for (int i = 0; i < 6000; ++i) {
        const double v = random.uniform(0.8, 2.0);
        points.push_back(impact(v + random.normal(u), v > 1.4 ? 0.3 : 0.0, u));
    }
    const auto measured = measured_from(points);
    REQUIRE(measured.value);
    const auto at = [&](double center) { return misfit(points, center, *measured.width); };
    const double center = gsl::minimise_between(at, 1.3, *measured.value + 1e-4, 1.5);
    CHECK(std::abs(*measured.value - center) < 0.03 * *measured.standard_uncertainty);
    CHECK(std::abs(at(*measured.upper) - at(center) - 3.84) < 0.1);
    CHECK(std::abs(at(*measured.lower) - at(center) - 3.84) < 0.1);
}

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

TEST_CASE("the noise of a velocity and a restitution is that of simulated pairs") {
    Random random(5);
    std::vector<double> incident;
    std::vector<double> rebound;
    std::vector<double> difference;
    for (int i = 0; i < 200'000; ++i) {
        const double v = 2.0 + random.normal(0.08);
        const double r = v * (0.4 + random.normal(0.02));
        incident.push_back(v);
        rebound.push_back(r);
        difference.push_back(v - r);
    }
    const VelocityNoise noise = VelocityNoise::of_restitution(2.0, 0.4, 0.08, 0.02);
    CHECK(relative_difference(noise.incident, Moments::of(incident).variance()) < 0.02);
    CHECK(relative_difference(noise.rebound, Moments::of(rebound).variance()) < 0.02);
    CHECK(relative_difference(noise.incident + noise.rebound - 2.0 * noise.covariance,
                              Moments::of(difference).variance()) < 0.02);
}

TEST_CASE("a camera resolves one pixel between the first and the last of its frames") {
    const Camera camera{.frame_rate = 80e3, .pixel_size = 2e-6, .frames = 5};
    const MeasurementSet set = with_camera(series_of({impact(2.0, 0.6)}), camera);
    const double between = 4 / 80e3;  // s
    CHECK(relative_difference(set.points[0].resolution, 2e-6 / between) < 1e-14);
}

TEST_CASE("the camera of a mean of several impacts has its uncertainty, as that of a bin") {
    const Camera camera{.frame_rate = 80e3, .pixel_size = 2e-6, .frames = 5};
    MeasurementSet set = series_of({impact(2.0, 0.6), impact(2.0, 0.6)});
    const MeasurementSet bin = binned(with_camera(set, camera), {.impacts_per_bin = 2});
    set.points.pop_back();
    set.points.front().count = 2;
    const Measurement mean = with_camera(set, camera).points.front();
    CHECK(relative_difference(mean.noise->incident, bin.points.front().noise->incident) < 1e-14);
    CHECK(mean.resolution == bin.points.front().resolution);
}

TEST_CASE("bins of a width begin at its multiples") {
    const MeasurementSet bins = binned(series_of({impact(1.02, 0.2), impact(1.18, 0.3), impact(1.22, 0.4),
                                                  impact(1.39, 0.5), impact(1.41, 0.6)}),
                                       {.width = 0.2});
    REQUIRE(bins.points.size() == 3);
    CHECK(bins.points[0].count == 2);
    CHECK(bins.points[1].count == 2);
    CHECK(bins.points[2].velocity == 1.41);
}

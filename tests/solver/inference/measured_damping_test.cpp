// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/measured_damping.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "core/text/text.hpp"
#include "solver/statistics/moments.hpp"
#include "tests/solver/inference/ash_laboratory.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

MeasuredDamping analysed(const MeasurementSet& set, Law law = Law::of<BrachDunn>(),
                         const MeasuredDampingOptions& options = {}) {
    return analyse_impacts(law, law.default_detachment(), ash_pair, set, options);
}

const ContactModel& brach_dunn() {
    static const ContactModel model = ash_model(Law::of<BrachDunn>());
    return model;
}

/// What a laboratory of the 96 um sample measures, Brach-Dunn with its row of Table 2.
MeasurementSet measured(int impacts, int frames = 20, unsigned long seed = 7) {
    SyntheticLaboratory laboratory = ash_laboratory(brach_dunn(), TrueDamping::quadratic);
    laboratory.impacts = impacts;
    laboratory.camera.frames = frames;
    Random random(seed);
    return laboratory.measure(random);
}

/// Within four standard uncertainties; intervals are the matter of the coverage tests.
bool is_near(const Interval& interval, double truth) {
    return std::abs(interval.value - truth) < 4.0 * interval.standard_uncertainty;
}

/// @param sought a code, or a part of the text
bool has_finding(const MeasuredDamping& result, const std::string& sought) {
    return std::any_of(result.findings.begin(), result.findings.end(), [&](const Finding& finding) {
        return finding.code == sought || contains(finding.text, sought);
    });
}

/// No number of a result may be anything but finite.
void check_finite(const MeasuredDamping& result) {
    for (const InvertedImpact& impact : result.impacts) {
        CHECK(std::isfinite(impact.damping.value_or(0.0)));
        CHECK(std::isfinite(impact.standard_uncertainty.value_or(0.0)));
        CHECK(std::isfinite(impact.contact_time.value_or(0.0)));
    }
    if (result.estimate) {
        for (const Interval& interval :
             {result.estimate->curve.critical_velocity, result.estimate->curve.critical_damping}) {
            CHECK(std::isfinite(interval.standard_uncertainty));
            CHECK(*interval.lower > 0.0);
            CHECK(*interval.lower <= interval.value);
            CHECK(*interval.upper >= interval.value);
        }
    }
    if (result.extrapolated) {
        const DampingCurveFit& fit = *result.extrapolated;
        CHECK(fit.damping.coefficients.allFinite());
        CHECK(fit.covariance.allFinite());
        CHECK(std::isfinite(fit.chi_squared));
        CHECK(std::isfinite(fit.prediction_error));
        CHECK(std::isfinite(fit.extrapolation));
        for (const FittedRebound& rebound : fit.rebounds) {
            CHECK(std::isfinite(rebound.distance));
            CHECK(std::isfinite(rebound.influence));
        }
        for (const Interval& interval : {fit.critical_damping, fit.critical_velocity}) {
            CHECK(interval.value > 0.0);
            CHECK(std::isfinite(interval.standard_uncertainty));
            CHECK(interval.lower.value_or(0.0) <= interval.value);
            CHECK(interval.upper.value_or(interval.value) >= interval.value);
        }
    }
}

/// 300 impacts, read to 2 um a pixel, of a truth that is none of the laws: e rises as the root of the
/// velocity over 1.6 m/s.
MeasurementSet sharp_impacts() {
    constexpr double critical = 1.6;
    Random random(11);
    MeasurementSet set{.source = "lab", .points = {}};
    for (int i = 0; i < 300; ++i) {
        const double v = 1.4 + 6.6 * i / 299;
        const double e = v > critical ? 0.62 * std::sqrt(1.0 - critical / v) * (1.0 - 0.015 * v) : 0.0;
        const double rebound = e > 0.0 ? std::max(1e-6, e * v + random.normal(0.01)) : 0.0;
        set.points.push_back({.velocity = v + random.normal(0.01), .rebound = rebound});
    }
    return with_camera(set, {.frame_rate = 80e3, .pixel_size = 2e-6, .frames = 5});
}

}  // namespace

TEST_CASE("the whole analysis of a good series") {
    const MeasurementSet set = measured(80);
    const MeasuredDamping result = analysed(set);
    check_finite(result);
    CHECK(result.impacts.size() == 80);
    CHECK(result.accuracy < 1e-4);
    REQUIRE(result.rising);
    CHECK_FALSE(result.rising->falls_beyond);
    REQUIRE(result.extrapolated);
    REQUIRE(result.estimate);
    REQUIRE(result.comparison);
    CHECK(result.comparison->consistent);
    CHECK(is_near(result.extrapolated->critical_damping, 0.0149));
    CHECK(is_near(result.estimate->curve.critical_damping, 0.0149));
    CHECK(result.estimate->captures == set.captures());
    REQUIRE(result.measured.value);
    CHECK(std::abs(*result.measured.value - 1.27) < 0.05);
    const CurveEstimate& curve = result.estimate->curve;
    CHECK(check(curve.critical_velocity, result.measured, true).verdict == CriticalVelocityVerdict::agrees);

    // The first part of eta(v_in) falls, with the boundary within the data.
    REQUIRE_FALSE(result.parts.parts.empty());
    CHECK(result.parts.parts.front() == DampingPart::falling);
    for (const PartBoundary& boundary : result.parts.boundaries) {
        CHECK(boundary.velocity > 1.2);
        CHECK(boundary.velocity < 3.9);
    }
}

TEST_CASE("uncertainties of inverted impacts are the scatter of repeated ones") {
    const Camera camera{.frame_rate = 80e3, .pixel_size = 8e-6, .frames = 20};
    Random random(3);
    const double u = camera.velocity_uncertainty();
    MeasurementSet set{.source = "lab", .points = {}};
    for (int i = 0; i < 2000; ++i)
        set.points.push_back({.velocity = 2.5 + random.normal(u), .rebound = 0.9 + random.normal(u)});
    set = with_camera(set, camera);
    const std::vector<InvertedImpact> inverted = invert(brach_dunn(), set);
    std::vector<double> damping;
    damping.reserve(inverted.size());
    for (const InvertedImpact& impact : inverted) damping.push_back(impact.damping.value());
    CHECK(relative_difference(std::sqrt(Moments::of(damping).variance()),
                              *inverted.front().standard_uncertainty) < 0.06);
}

TEST_CASE("the fit's leverage and influence are those of fits without a point") {
    const MeasurementSet set = measured(30);
    const DampingCurveFit whole = fit_damping_curve(brach_dunn(), set);
    double leverage = 0.0;
    for (const FittedRebound& point : whole.rebounds) {
        CHECK(point.leverage > 0.0);
        CHECK(point.leverage < 1.0);
        leverage += point.leverage;
    }
    CHECK(std::abs(leverage - 3.0) < 1e-6);
    const auto strongest = std::max_element(
        whole.rebounds.begin(), whole.rebounds.end(),
        [](const auto& a, const auto& b) { return std::abs(a.influence) < std::abs(b.influence); });
    MeasurementSet without = set;
    without.points.erase(without.points.begin() + static_cast<std::ptrdiff_t>(strongest->index));
    const DampingCurveFit other = fit_damping_curve(brach_dunn(), without);
    const double change = other.critical_damping.value - whole.critical_damping.value;
    CHECK(std::abs(change - strongest->influence) < 0.3 * std::abs(change));
}

TEST_CASE("the fitted v_c is as uncertain, as a part of its interval, as the damping it comes from") {
    const DampingCurveFit fit = fit_damping_curve(brach_dunn(), measured(80));
    const auto part = [](const Interval& interval) {
        return interval.standard_uncertainty / (interval.upper.value() - interval.lower.value());
    };
    CHECK(relative_difference(part(fit.critical_velocity), part(fit.critical_damping)) < 0.03);
}

TEST_CASE("one wild impact is flagged, stays in, and a robust fit takes it back") {
    MeasurementSet set = measured(60);
    auto& wild = *std::find_if(set.points.begin(), set.points.end(), [](const Measurement& m) {
        return m.velocity > 2.4 && m.velocity < 2.8 && m.rebound > 0.0;
    });
    const auto index = static_cast<std::size_t>(&wild - set.points.data());
    wild.rebound += 0.4;
    const MeasuredDamping result = analysed(set);
    CHECK(std::find(result.parts.outliers.begin(), result.parts.outliers.end(), index) !=
          result.parts.outliers.end());
    CHECK(has_finding(result, "outliers"));
    // Impacts that come from no file are counted from 1 on.
    std::vector<std::size_t> counted = result.parts.outliers;
    for (std::size_t& each : counted) ++each;
    CHECK(has_finding(result, numbered("impact", counted)));
    CHECK(result.rising->set.points.size() == set.points.size());

    const DampingCurveFit robust = fit_damping_curve(brach_dunn(), set, {.order = 2, .robust = true});
    const auto fitted = std::find_if(robust.rebounds.begin(), robust.rebounds.end(),
                                     [&](const FittedRebound& point) { return point.index == index; });
    REQUIRE(fitted != robust.rebounds.end());
    CHECK(fitted->weight < 0.05);
    CHECK(is_near(robust.critical_damping, 0.0149));
}

TEST_CASE("a robust extrapolation finds the truth among outliers, also where they hide the rising branch") {
    MeasuredDampingOptions options;
    options.extrapolated.robust = true;
    unsigned near = 0;
    unsigned hidden = 0;
    constexpr unsigned laboratories = sanitized ? 3 : 20;
    for (unsigned long seed = 1; seed <= laboratories; ++seed) {
        MeasurementSet set = measured(30, 20, seed);
        Random random(1000 + seed);
        for (Measurement& point : set.points)
            if (random.uniform(0.0, 1.0) < 0.07) point.rebound = random.uniform(0.0, point.velocity);
        const MeasuredDamping result = analysed(set, Law::of<BrachDunn>(), options);
        CAPTURE(seed);
        REQUIRE(result.extrapolated);
        near += is_near(result.extrapolated->critical_damping, 0.0149) ? 1U : 0U;
        hidden += has_finding(result, "rising-branch-hidden") ? 1U : 0U;
    }
    CHECK(near >= laboratories - 1);
    CHECK(2 * hidden < laboratories);

    // Two slow impacts that hardly lose energy: the restitution falls from the first on.
    MeasurementSet set = measured(12);
    for (Measurement& point : set.points)
        if (point.rebound > 0.0 && point.velocity < 1.8) point.rebound = 0.95 * point.velocity;
    const MeasuredDamping result = analysed(set, Law::of<BrachDunn>(), options);
    CHECK(has_finding(result, "rising-branch-hidden"));
}

TEST_CASE(
    "a robust extrapolation of few impacts that ends where there is no curve is refused with a reason") {
    const MeasurementSet set = set_of({{0.5275, 0.0},
                                       {0.34465, 0.0},
                                       {0.77887, 0.020484},
                                       {0.86817, 0.078318},
                                       {4.4816, 2.5958},
                                       {1.1271, 0.060131},
                                       {4.0528, 2.2132},
                                       {0.50833, 0.0}},
                                      0.03);
    MeasuredDampingOptions options;
    options.extrapolated.robust = true;
    const Law law = Law::of<Hertz>();
    const ContactModel model = make_contact_model(law, law.default_detachment(), ash_pair, {0.0142, 28.4});
    const MeasuredDamping result = analyse_impacts(model, set, options);
    check_finite(result);
    // Which of the two depends on the last digits.
    CHECK((result.extrapolated || has_finding(result, "no-extrapolation")));
}

TEST_CASE("a robust extrapolation of few rebounds with outliers is finite or refused") {
    MeasuredDampingOptions options;
    options.extrapolated.robust = true;
    const auto check = [&](const MeasurementSet& set, Law law) {
        const MeasuredDamping result = analysed(set, law, options);
        check_finite(result);
        CHECK((result.extrapolated || has_finding(result, "no-extrapolation")));
    };
    const MeasurementSet eight = set_of(
        {{2.8, 0.64}, {1.0, 0.72}, {3.9, 1.2}, {8.8, 4.0}, {8.3, 3.7}, {2.1, 0.29}, {6.1, 4.0}, {0.97, 0.67}},
        0.03);
    for (const Law law : fitted_laws) check(eight, law);
    const MeasuredDamping scattered = analysed(eight, Law::of<Dmt>());
    REQUIRE(scattered.estimate);
    CHECK(has_finding(scattered, "no-extrapolation"));                 // at 88 m/s
    CHECK(*scattered.estimate->curve.critical_velocity.lower < 0.97);  // the slowest rebound
    CHECK(has_finding(scattered, "no-captures"));
    CHECK_FALSE(has_finding(scattered, "means"));
    MeasurementSet means = eight;
    means.points.front().count = 3;
    CHECK(has_finding(analysed(means, Law::of<Dmt>()), "means"));
    for (unsigned long seed = 1; seed <= static_cast<unsigned long>(repetitions(15)); ++seed) {
        CAPTURE(seed);
        MeasurementSet set = measured(4 + static_cast<int>(seed % 5), 20, seed);
        Random random(1000 + seed);
        for (Measurement& point : set.points)
            if (random.uniform(0.0, 1.0) < 0.3) point.rebound = random.uniform(0.0, point.velocity);
        check(set, Law::of<BrachDunn>());
    }
}

TEST_CASE("rebounds alone: an extrapolated v_c above the slowest of them is refused, however uncertain") {
    // Damping that grows with velocity, as that of Hunt and Crossley: e falls from 0.9 to 0.5.
    MeasurementSet set{.source = "lab", .points = {}};
    Random random(3);
    for (int i = 0; i < 30; ++i) {
        const double v = random.log_uniform(0.15, 4.0);
        const double e = 1.0 / (1.0 + 0.25 * v);
        set.points.push_back({.velocity = v,
                              .rebound = e * v + random.normal(0.01),
                              .noise = VelocityNoise::of_velocities(0.01, 0.01)});
    }
    for (const Law law : fitted_laws) {
        CAPTURE(law.name());
        const MeasuredDamping result = analysed(set, law);
        if (result.estimate)
            CHECK(*result.estimate->curve.critical_velocity.lower < 0.2);
        else if (result.extrapolated)
            CHECK(result.extrapolated->critical_velocity.value < 0.2);
        CHECK((result.estimate || !result.extrapolated ||
               result.extrapolated->critical_velocity.value <= *result.measured.slowest_rebound));
    }
}

// e = sqrt(1 - v_c/v) is no law's threshold; forced on it, Hertz's lies 6 % too low, whatever the priors. A
// false mode of the posterior would be off by a third or more.
TEST_CASE("sharp impacts of another truth: the estimate is near it, and the fit has more than their noise") {
    const MeasurementSet set = sharp_impacts();
    for (const Law law : fitted_laws) {
        CAPTURE(law.name());
        const MeasuredDamping result = analysed(set, law);
        check_finite(result);
        REQUIRE(result.extrapolated);
        CHECK(result.extrapolated->scatter > 1.0);
        CHECK(has_finding(result, "extrapolation-scatter"));
        REQUIRE(result.estimate);
        CHECK(std::abs(result.estimate->curve.critical_velocity.value - 1.6) < 0.1 * 1.6);
    }
}

TEST_CASE(
    "an error that all velocities share widens the extrapolated v_c; a scatter of sizes is said not to") {
    const MeasurementSet set = measured(40);
    MeasuredDampingOptions options;
    options.estimate = {.size_scatter = 0.05, .scale_uncertainty = 0.04};
    MeasurementSet faster = set;
    for (Measurement& point : faster.points) {
        point.velocity *= 1.04;
        point.rebound *= 1.04;
        point.noise = point.noise->scaled(1.04 * 1.04);
    }
    const DampingCurveFit plain = analysed(set).extrapolated.value();
    const DampingCurveFit scaled = analysed(faster).extrapolated.value();
    const MeasuredDamping result = analysed(set, Law::of<BrachDunn>(), options);
    const DampingCurveFit& fit = result.extrapolated.value();
    const double change = scaled.critical_velocity.value - plain.critical_velocity.value;
    CHECK(fit.critical_velocity.value == plain.critical_velocity.value);
    CHECK(std::abs(change) > 0.02 * plain.critical_velocity.value);
    CHECK(fit.critical_velocity.standard_uncertainty ==
          doctest::Approx(std::hypot(plain.critical_velocity.standard_uncertainty, change)).epsilon(0.05));
    CHECK(fit.critical_velocity.upper.value() > plain.critical_velocity.upper.value());
    CHECK(fit.critical_damping.standard_uncertainty ==
          doctest::Approx(std::sqrt(fit.covariance(0, 0))).epsilon(1e-6));
    CHECK(has_finding(result, "extrapolation-sizes"));
    // So does that of the outcomes alone: 1.96 times 4 % beside its own.
    const MeasuredCriticalVelocity own = measured_critical_velocity(set);
    const MeasuredCriticalVelocity shared = result.measured;
    CHECK(*shared.value == *own.value);
    CHECK(std::log(*shared.upper / *shared.value) ==
          doctest::Approx(std::hypot(std::log(*own.upper / *own.value), 1.959964 * 0.04)).epsilon(1e-6));
    CHECK(std::log(*shared.value / *shared.lower) ==
          doctest::Approx(std::hypot(std::log(*own.value / *own.lower), 1.959964 * 0.04)).epsilon(1e-6));
}

TEST_CASE("impacts without scatter give the damping behind them") {
    const ContactModel model = ash_model(Law::of<Dmt>());
    const SyntheticLaboratory laboratory = ash_laboratory(model, TrueDamping::quadratic);
    MeasurementSet set{.source = "exact", .points = {}};
    for (int i = 0; i < 13; ++i) {
        const double v = 1.2 + 0.15 * i;
        set.points.push_back({.velocity = v, .rebound = v * laboratory.restitution(v)});
    }
    const MeasuredDamping result = analysed(set, Law::of<Dmt>());
    REQUIRE(result.extrapolated);
    const Eigen::VectorXd& c = result.extrapolated->damping.coefficients;
    CHECK(relative_difference(c[0], 0.0156) < 1e-5);
    CHECK(relative_difference(c[1], -0.0235) < 1e-4);
    CHECK(relative_difference(c[2], 0.0115) < 1e-3);
    CHECK(result.extrapolated->critical_damping.standard_uncertainty < 1e-5 * c[0]);
}

TEST_CASE("degenerate series are analysed as far as they go, with the reason why no further") {
    const auto every = [](int count, double step, const auto& restitution) {
        std::vector<std::pair<double, double>> impacts;
        for (int i = 0; i < count; ++i) {
            const double v = 1.5 + step * i;
            impacts.emplace_back(v, v * restitution(v));
        }
        return impacts;
    };
    const auto falling = every(20, 0.2, [](double v) { return 0.6 - 0.06 * v; });
    const std::vector<std::pair<double, double>> few_falling{{2.0, 1.0},  {3.0, 1.35}, {4.0, 1.6},
                                                             {5.0, 1.75}, {6.0, 1.8},  {7.0, 1.75}};
    struct Degenerate {
        std::vector<std::pair<double, double>> impacts;
        Law law;
        std::string finding;
    };
    const Law brach_dunn = Law::of<BrachDunn>();
    for (const Degenerate& each :
         {Degenerate{{{0.2, 0.0}, {0.5, 0.0}, {0.8, 0.0}}, brach_dunn, "no-rebounds"},
          Degenerate{{{1e-4, 0.0}, {2e-4, 0.0}}, Law::of<Jkr>(), "no-rebounds"},
          Degenerate{{{2.0, 0.6}}, brach_dunn, "no extrapolated fit: 1 distinct restitutions"},
          Degenerate{every(20, 0.0, [](double) { return 0.35; }), brach_dunn, "1 distinct restitutions"},
          Degenerate{falling, brach_dunn, "no extrapolated fit: there is no rising branch"},
          Degenerate{few_falling, brach_dunn, "there is no rising branch"},
          Degenerate{few_falling, Law::of<Hertz>(), "there is no rising branch"},
          Degenerate{few_falling, Law::of<Dmt>(), "there is no rising branch"}}) {
        CAPTURE(each.law.name());
        CAPTURE(each.finding);
        const MeasuredDamping result = analysed(set_of(each.impacts), each.law);
        check_finite(result);
        CHECK_FALSE(result.extrapolated);
        CHECK(has_finding(result, each.finding));
        if (contains(each.finding, "rising")) CHECK_FALSE(result.rising);
    }
    check_finite(analysed(set_of(every(13, 0.2, [](double) { return 0.4; }))));
    // Two that scatter downwards in a series that rises do not make it fall.
    CHECK(analysed(set_of({{1.5, 0.3}, {2.0, 0.6}, {2.5, 0.95}, {3.0, 1.1}, {3.5, 1.5}, {4.0, 1.7}})).rising);
}

TEST_CASE("captures alone bound v_c from below, a rebound from above, and each has its damping") {
    const MeasuredDamping captured = analysed(set_of({{0.2, 0.0}, {0.5, 0.0}, {0.8, 0.0}}));
    CHECK_FALSE(captured.estimate);
    CHECK_FALSE(captured.measured.value);
    CHECK(captured.measured.lower == 0.8);
    CHECK_FALSE(captured.measured.upper);
    CHECK(captured.impacts[2].damping);  // the least that captures
    // At velocities at which nothing can rebound no damping is the least.
    const MeasuredDamping slow = analysed(set_of({{1e-4, 0.0}, {2e-4, 0.0}}), Law::of<Jkr>());
    CHECK_FALSE(slow.impacts[0].damping);
    const MeasuredDamping one = analysed(set_of({{2.0, 0.6}}));
    REQUIRE(one.impacts.size() == 1);
    CHECK(one.impacts[0].damping.value_or(0.0) > 0.0);
    CHECK(one.impacts[0].contact_time);
    CHECK(contains(one.parts.note, "fewer than 8 rebounds"));
    CHECK(one.measured.upper == 2.0);
}

TEST_CASE("a fitted v_c above clear rebounds is refused, and which rebound contradicts it is said") {
    const MeasurementSet set = measured(40);
    const DampingCurveFit fit = fit_damping_curve(brach_dunn(), set);
    CHECK_NOTHROW(require_rebounds_above(fit, set));
    MeasurementSet other = set;
    other.points.push_back({.velocity = 0.4, .rebound = 0.3, .noise = set.points.front().noise});
    const std::string problem = input_error_of([&] { require_rebounds_above(fit, other); });
    CHECK(contains(problem, "lies above clear rebounds, the slowest at 0.4 m/s"));
    // Within its noise such a rebound can be a capture.
    other.points.back().rebound = 2.0 * std::sqrt(set.points.front().noise->rebound);
    CHECK_NOTHROW(require_rebounds_above(fit, other));
}

TEST_CASE("degenerate: outcomes that contradict a threshold leave the analysis whole") {
    MeasurementSet set = measured(40);
    for (Measurement& point : set.points)
        if (point.captured()) point.velocity += 8.0;
    const MeasuredDamping result = analysed(set);
    check_finite(result);
    CHECK_FALSE(result.measured.value);
    CHECK(contains(result.measured.note, "contradict a threshold"));
    CHECK(result.extrapolated);
}

TEST_CASE("degenerate: restitution above one is set aside and counted") {
    MeasurementSet set = measured(40);
    for (Measurement& point : set.points) point.noise.reset();
    set.points.push_back({.velocity = 2.0, .rebound = 2.4});
    const MeasuredDamping result = analysed(set);
    check_finite(result);
    CHECK_FALSE(result.impacts.back().damping);
    CHECK(has_finding(result, "faster-than-undamped"));
    REQUIRE(result.extrapolated);
    REQUIRE(result.extrapolated->excluded.size() == 1);
    CHECK(result.extrapolated->excluded[0].index == set.points.size() - 1);
}

TEST_CASE("a rebound faster than its impact is excluded beyond three uncertainties of their difference") {
    // Both velocities err alike: their difference is known better than each.
    const VelocityNoise noise{.incident = 1e-4, .rebound = 1e-4, .covariance = 0.9e-4};
    for (const double uncertainties : {2.95, 3.05}) {
        CAPTURE(uncertainties);
        MeasurementSet set = measured(40);
        set.points.push_back(
            {.velocity = 2.0, .rebound = 2.0 + uncertainties * std::sqrt(0.2e-4), .noise = noise});
        const DampingCurveFit fit = fit_damping_curve(brach_dunn(), set, {.robust = true});
        CHECK(fit.excluded.size() == (uncertainties > 3 ? 1 : 0));
    }
}

TEST_CASE("degenerate: order does not matter, duplicates count as what they are") {
    const MeasurementSet set = measured(40);
    MeasurementSet turned = set;
    std::reverse(turned.points.begin(), turned.points.end());
    const Interval a = analysed(set).extrapolated.value().critical_damping;
    CHECK(analysed(turned).extrapolated.value().critical_damping.value == a.value);

    MeasurementSet doubled = set;
    doubled.points.insert(doubled.points.end(), set.points.begin(), set.points.end());
    const MeasuredDamping twice = analysed(doubled);
    REQUIRE(twice.extrapolated);
    const Interval& c = twice.extrapolated->critical_damping;
    CHECK(std::abs(c.value - a.value) < 0.02 * a.standard_uncertainty);
    CHECK(c.standard_uncertainty < 0.9 * a.standard_uncertainty);
    check_finite(twice);
}

TEST_CASE("degenerate: numbers that are none are refused with their line") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto refused = [](const MeasurementSet& set) {
        return input_error_of([&] { return analysed(set); });
    };
    for (const auto& [impact, message] : {std::pair{std::pair{nan, 0.5}, "line 3: v_in is nan"},
                                          {{2.0, nan}, "line 3: v_r is nan"},
                                          {{2.0, -0.5}, "line 3: v_r is -0.5"}}) {
        MeasurementSet set = set_of({{2.0, 0.5}, impact});
        set.points[1].line = 3;
        CHECK(contains(refused(set), message));
    }
    CHECK(contains(refused(set_of({})), "no measurement"));
}

TEST_CASE("a contact that yields is inverted and not fitted") {
    ContactPair yielding = ash_pair;
    yielding.yield_pressure = 6e9;
    const Law law = Law::of<ThorntonNing>();
    const MeasuredDamping result =
        analyse_impacts(law, law.default_detachment(), yielding, set_of({{2.0, 0.7}, {3.0, 1.2}}));
    check_finite(result);
    CHECK(result.impacts[1].damping.value_or(0.0) > 0.0);
    CHECK_FALSE(result.extrapolated);
    CHECK(has_finding(result, "no-fit-yielding"));
}

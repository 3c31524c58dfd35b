// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/calibration/calibration.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <doctest/doctest.h>

#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/inference/calibration/published_damping.hpp"
#include "solver/motion/explicit_scheme.hpp"
#include "solver/numeric/gsl/statistics.hpp"
#include "tests/support/checks.hpp"
#include "tests/support/published.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

const double root12 = std::sqrt(12.0);
constexpr ElasticBody steel{193e9, 0.29};

/// Tables 3 and 4 and the contact times, with the rounding of the printed digits as their uncertainty, and
/// "about 2 m/s" as anything from 1.95 to 2.05.
CalibrationProblem paper_problem(std::vector<FreeConstant> free = {}) {
    CalibrationProblem problem;
    problem.free = std::move(free);
    const auto published = published_samples();
    for (std::size_t i = 0; i < published.size(); ++i) {
        problem.samples.push_back({.diameter = published[i].diameter,
                                   .density = 2200.0,
                                   .work_of_adhesion = 0.3,
                                   .particle = {published[i].young_modulus, 0.2},
                                   .wall = steel,
                                   .contact_modulus = std::nullopt});
        for (const PublishedLaw& law : published[i].laws) {
            problem.critical_velocities.push_back({.sample = i,
                                                   .law = law.law,
                                                   .critical_damping = law.critical_damping,
                                                   .critical_damping_uncertainty = 1e-4 / root12,
                                                   .value = law.critical_velocity,
                                                   .standard_uncertainty = 0.01 / root12});
        }
        problem.contact_times.push_back({.sample = i,
                                         .law = Law::of<BrachDunn>(),
                                         .damping_fit = published[i].of(Law::of<BrachDunn>()).damping_fit,
                                         .velocity = 2.0,
                                         .velocity_uncertainty = 0.05 / std::sqrt(3.0),
                                         .value = published[i].contact_time,
                                         .standard_uncertainty = 1e-9 / root12,
                                         .damping_fit_uncertainty = 1e-4 / root12});
    }
    return problem;
}

double critical_velocity_of(const CalibrationSample& sample, Law law, double damping) {
    return critical_velocity(
               {law, law.default_detachment(), {DampingLaw::constant, damping}, sample.contact()})
        .value.value();
}

/// Replaces every observation by what the samples as they stand would give.
void observe_exactly(CalibrationProblem& problem) {
    for (CriticalVelocityObservation& o : problem.critical_velocities)
        o.value = critical_velocity_of(problem.samples[o.sample], o.law, o.critical_damping);
    for (ContactTimeObservation& o : problem.contact_times) {
        const PublishedDamping published{.law = o.law,
                                         .detachment = o.law.default_detachment(),
                                         .contact = problem.samples[o.sample].contact(),
                                         .damping = o.damping_fit};
        const double e = reconstructed_restitution(published, o.velocity);
        o.value = solve_impact({o.law,
                                published.detachment,
                                {DampingLaw::constant, published.damping(e)},
                                published.contact,
                                o.velocity})
                      .contact_time.value();
    }
}

double worst_of(const std::vector<CalibrationResidual>& residuals) {
    double worst = 0.0;
    for (const CalibrationResidual& r : residuals) worst = std::max(worst, std::abs(r.relative_difference()));
    return worst;
}

/// One work of adhesion, a density for each size.
const std::vector<FreeConstant> paper_constants{{CalibrationQuantity::work_of_adhesion, false},
                                                {CalibrationQuantity::density, true}};
/// One of each, of which density and contact modulus can stand for each other.
const std::vector<FreeConstant> traded_constants{{CalibrationQuantity::work_of_adhesion, false},
                                                 {CalibrationQuantity::contact_modulus, false},
                                                 {CalibrationQuantity::density, false}};

/// The paper's tables with its constants, calibrated once.
const CalibrationSummary& paper_calibration() {
    static const CalibrationSummary summary = calibrate(paper_problem(paper_constants));
    return summary;
}

/// The same with damping fits that are not rounded, calibrated once.
const CalibrationSummary& unrounded_calibration() {
    static const CalibrationSummary summary = [] {
        CalibrationProblem problem = paper_problem(paper_constants);
        for (ContactTimeObservation& o : problem.contact_times) o.damping_fit_uncertainty = 0.0;
        return calibrate(problem);
    }();
    return summary;
}

/// The paper's critical velocities alone, which leave a trade, calibrated once.
CalibrationProblem traded_problem() {
    CalibrationProblem problem = paper_problem(traded_constants);
    problem.contact_times.clear();
    return problem;
}
const CalibrationSummary& traded_calibration() {
    static const CalibrationSummary summary = calibrate(traded_problem());
    return summary;
}

}  // namespace

TEST_CASE("the paper's constants: moduli from XRD, one work of adhesion, a density for each size") {
    const CalibrationSummary& summary = paper_calibration();

    CHECK(summary.degrees_of_freedom == 8);
    CHECK(std::abs(summary.chi_squared - 6.95) < 0.01);
    CHECK(relative_difference(summary.probability, gsl::chi_squared_exceedance(summary.chi_squared, 8)) <
          1e-14);
    CHECK(relative_difference(summary.akaike, summary.chi_squared + 8.0) < 1e-14);
    CHECK(worst_of(summary.critical_velocities) < 0.01);
    CHECK(worst_of(summary.contact_times) < 0.03);
    CHECK(summary.critical_velocities.size() == 9);
    CHECK(summary.contact_times.size() == 3);

    REQUIRE(summary.constants.size() == 4);
    CHECK(std::abs(summary.constants[0].value - 0.2984) < 1e-4);
    CHECK(std::abs(summary.constants[1].value - 2179.5) < 0.5);
    CHECK(std::abs(summary.constants[2].value - 2157.4) < 0.5);
    CHECK(std::abs(summary.constants[3].value - 2073.9) < 0.5);
    CHECK(!summary.constants[0].sample);
    CHECK(summary.constants[3].sample == 2);
    for (const CalibratedConstant& c : summary.constants) {
        CHECK(c.standard_uncertainty > 0.0);
        CHECK(c.standard_uncertainty < 0.05 * c.value);
        // 95 % in the logarithm.
        CHECK(relative_difference(std::log(c.upper / c.lower),
                                  2.0 * 1.959963984540054 * c.standard_uncertainty / c.value) < 1e-12);
        CHECK(relative_difference(c.upper * c.lower, c.value * c.value) < 1e-12);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(summary.samples[i].density == summary.constants[i + 1].value);
        CHECK(summary.samples[i].work_of_adhesion == summary.constants[0].value);
    }
    CHECK(std::abs(summary.correlation(0, 0) - 1.0) < 1e-12);
    CHECK(std::abs(summary.correlation(0, 1) - summary.correlation(1, 0)) < 1e-12);
    CHECK(std::abs(summary.correlation(0, 1)) < 1.0);
}

TEST_CASE("the alternative, one contact modulus and one density, is worse: 2.5 % in critical velocity") {
    const CalibrationProblem problem = paper_problem(traded_constants);
    const CalibrationSummary summary = calibrate(problem);
    CHECK(summary.degrees_of_freedom == 9);
    CHECK(std::abs(worst_of(summary.critical_velocities) - 0.025) < 0.001);
    CHECK(worst_of(summary.contact_times) < 0.025);
    CHECK(summary.chi_squared > 12.0);
    CHECK(summary.akaike > 6.95 + 8.0);
}

TEST_CASE("chi^2 is that of the residuals it reports, where no rounding is shared") {
    const CalibrationProblem problem = paper_problem();
    const CalibrationSummary& summary = unrounded_calibration();
    double sum = 0.0;
    for (const auto* residuals : {&summary.critical_velocities, &summary.contact_times})
        for (const CalibrationResidual& r : *residuals)
            sum += std::pow(std::log(r.predicted / r.observed) / r.relative_uncertainty, 2);
    CHECK(relative_difference(sum, summary.chi_squared) < 1e-4);  // the weights follow, weakly
    // Hertz: v_c goes with eta^5, so a rounding of eta counts five times.
    for (std::size_t i = 0; i < problem.critical_velocities.size(); ++i) {
        const CriticalVelocityObservation& o = problem.critical_velocities[i];
        if (o.law != Law::of<Hertz>()) continue;
        const double expected = std::hypot(o.standard_uncertainty / o.value,
                                           5.0 * o.critical_damping_uncertainty / o.critical_damping);
        CHECK(relative_difference(summary.critical_velocities[i].relative_uncertainty, expected) < 1e-6);
    }
}

TEST_CASE("constants behind exact observations are recovered from a start well off") {
    CalibrationProblem problem = paper_problem(paper_constants);
    const double truth_w = 0.27;
    const double truth_density[] = {2300.0, 2150.0, 1990.0};
    for (std::size_t i = 0; i < 3; ++i) {
        problem.samples[i].work_of_adhesion = truth_w;
        problem.samples[i].density = truth_density[i];
    }
    observe_exactly(problem);
    for (CalibrationSample& sample : problem.samples) {
        sample.work_of_adhesion = 0.4;
        sample.density = 2000.0;
    }
    const CalibrationSummary summary = calibrate(problem);
    CHECK(summary.chi_squared < 1e-8);
    CHECK(relative_difference(summary.constants[0].value, truth_w) < 1e-6);
    for (std::size_t i = 0; i < 3; ++i)
        CHECK(relative_difference(summary.constants[i + 1].value, truth_density[i]) < 1e-6);
    CHECK(worst_of(summary.critical_velocities) < 1e-6);
    CHECK(worst_of(summary.contact_times) < 1e-6);
}

TEST_CASE("the wall's modulus, or the contact modulus, can be the unknown") {
    CalibrationProblem problem = paper_problem();
    for (CalibrationSample& sample : problem.samples) sample.wall.young_modulus = 185e9;
    observe_exactly(problem);
    for (CalibrationSample& sample : problem.samples) sample.wall.young_modulus = 210e9;
    problem.free = {{CalibrationQuantity::wall_young_modulus, false}};
    const CalibrationSummary wall = calibrate(problem);
    CHECK(relative_difference(wall.constants[0].value, 185e9) < 1e-6);
    CHECK(wall.samples[1].wall.young_modulus == wall.constants[0].value);

    problem.free = {{CalibrationQuantity::contact_modulus, true}};
    const CalibrationSummary contact = calibrate(problem);
    REQUIRE(contact.constants.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
        const double expected = contact_modulus(problem.samples[i].particle, ElasticBody{185e9, 0.29});
        CHECK(relative_difference(contact.constants[i].value, expected) < 1e-6);
    }
}

TEST_CASE(
    "without contact times density and contact modulus cannot be told apart, and their intervals say so") {
    CalibrationProblem problem = traded_problem();
    const CalibrationSummary& light = traded_calibration();
    for (CalibrationSample& sample : problem.samples) sample.density = 2600.0;
    const CalibrationSummary dense = calibrate(problem);
    const auto invariant = [](const CalibrationSummary& summary) {
        return std::pow(summary.constants[2].value, 3) * std::pow(summary.constants[1].value, 2);
    };
    CHECK(relative_difference(light.chi_squared, dense.chi_squared) < 1e-6);
    CHECK(relative_difference(light.constants[0].value, dense.constants[0].value) < 1e-5);
    CHECK(relative_difference(invariant(light), invariant(dense)) < 1e-5);  // rho^3 E*^2
    CHECK(relative_difference(light.constants[1].value, dense.constants[1].value) > 0.05);
    for (const CalibrationSummary* summary : {&light, &dense}) {
        for (const std::size_t i : {1, 2}) {
            CHECK(summary->constants[i].upper > 100.0 * summary->constants[i].value);
            CHECK(summary->constants[i].lower < 0.01 * summary->constants[i].value);
        }
        CHECK(summary->constants[0].upper < 1.1 * summary->constants[0].value);
    }
}

TEST_CASE("a contact time's impact is captured up to the velocity from which the curve rebounds, below v_c") {
    CalibrationProblem problem = paper_problem();
    problem.contact_times.erase(problem.contact_times.begin() + 1, problem.contact_times.end());
    ContactTimeObservation& observed = problem.contact_times[0];
    const CalibrationSample& sample = problem.samples[0];
    const Law law = observed.law;
    const double critical = critical_velocity_of(sample, law, observed.damping_fit.critical_damping());
    const double fold =
        least_rebound({law, law.default_detachment(), sample.contact(), observed.damping_fit}).velocity;
    REQUIRE(fold < 0.995 * critical);
    const auto captured_up_to = [&](double velocity) {
        observed.velocity = velocity;
        return calibration_residuals(problem, problem.samples).contact_times[0].captured_up_to;
    };
    CHECK_FALSE(captured_up_to(critical));
    CHECK_FALSE(captured_up_to(fold * (1.0 + 1e-6)));
    for (const double share : {1.0 - 1e-6, 0.95}) {
        const std::optional<double> up_to = captured_up_to(share * fold);
        REQUIRE(up_to);
        CHECK(relative_difference(*up_to, fold) < 1e-9);
    }
}

TEST_CASE("profiles close around what the paper's tables fix, close to the curvature's intervals") {
    const CalibrationProblem problem = paper_problem(paper_constants);
    const CalibrationSummary& summary = paper_calibration();
    const std::vector<ConstantProfile> profiles = profile_constants(problem, summary);
    REQUIRE(profiles.size() == 4);
    for (std::size_t i = 0; i < profiles.size(); ++i) {
        CAPTURE(i);
        CHECK(profiles[i].identifiable);
        CHECK(profiles[i].statement.empty());
        const CalibratedConstant& constant = summary.constants[i];
        const double width = constant.upper - constant.lower;
        CHECK(std::abs(profiles[i].interval.lower.value() - constant.lower) < 0.15 * width);
        CHECK(std::abs(profiles[i].interval.upper.value() - constant.upper) < 0.15 * width);
    }
}

TEST_CASE("what the observations do not fix is called not identifiable") {
    const std::vector<ConstantProfile> profiles = profile_constants(traded_problem(), traded_calibration());
    REQUIRE(profiles.size() == 3);
    CHECK(profiles[0].identifiable);
    for (const std::size_t i : {1, 2}) {
        CHECK_FALSE(profiles[i].identifiable);
        CHECK_FALSE(profiles[i].interval.lower);
        CHECK_FALSE(profiles[i].interval.upper);
        CHECK(profiles[i].traded_with == std::vector<std::size_t>{3 - i});
    }
    CHECK(profiles[2].statement ==
          "density is not identifiable: the observations bound it not at all; it is traded with "
          "contact_modulus");
}

TEST_CASE("the rounding of Table 2 widens a contact time, most where the impact is close to capture") {
    const CalibrationSummary& with = paper_calibration();
    const CalibrationSummary& without = unrounded_calibration();
    std::array<double, 3> added{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double a = with.contact_times[i].relative_uncertainty;
        const double b = without.contact_times[i].relative_uncertainty;
        added[i] = std::sqrt(std::max(0.0, a * a - b * b));
    }
    // Half a digit of c is about 4, 0.7 and 0.3 %; a standard uncertainty is 1/sqrt(3) of that.
    CHECK(added[0] > 0.04 / std::sqrt(3.0) * 0.7);
    CHECK(added[0] < 0.04 / std::sqrt(3.0) * 1.6);
    CHECK(added[1] < 0.01);
    CHECK(added[2] < added[1]);
    CHECK(with.chi_squared < without.chi_squared);
}

TEST_CASE("a sample's contact: sphere on a wall, Eq. 7 unless the contact modulus is given") {
    CalibrationSample sample = paper_problem().samples[0];
    const ContactPair pair = sample.contact();
    CHECK(relative_difference(pair.mass, 2200.0 * 4.0 / 3.0 * std::acos(-1.0) * std::pow(44e-6, 3)) < 1e-14);
    CHECK(pair.effective_radius == 44e-6);
    CHECK(relative_difference(1.0 / pair.contact_modulus,
                              (1 - 0.04) / 148.126e9 + (1 - 0.29 * 0.29) / 193e9) < 1e-14);
    sample.contact_modulus = 95e9;
    CHECK(sample.contact().contact_modulus == 95e9);
}

TEST_CASE("problems that cannot be solved are refused") {
    const auto message = [](const CalibrationProblem& problem) {
        return input_error_of([&] { return calibrate(problem); });
    };
    CalibrationProblem problem = paper_problem();
    CHECK(message(problem) ==
          "the calibration has 12 observations for 0 free constants; allowed: at least one free constant and "
          "as many observations");
    problem.free = {{CalibrationQuantity::density, true}};
    problem.contact_times.clear();
    problem.critical_velocities.erase(problem.critical_velocities.begin() + 2,
                                      problem.critical_velocities.end());
    CHECK(contains(message(problem), "has 2 observations for 3 free constants"));
    const std::vector<FreeConstant> one_density{{CalibrationQuantity::density, false}};
    problem = paper_problem(one_density);
    problem.critical_velocities[0].sample = 3;
    CHECK(message(problem) == "an observation names a sample that does not exist");
    problem = paper_problem(one_density);
    problem.contact_times[0].sample = 7;
    CHECK(message(problem) == "an observation names a sample that does not exist");
    problem = paper_problem(one_density);
    problem.critical_velocities[0].critical_damping = -0.01;
    CHECK(contains(message(problem), "damping is -0.01"));
}

TEST_CASE("calibrated constants follow the contact modulus: the linear response against recalibrations") {
    CalibrationProblem problem = paper_problem(paper_constants);
    problem.samples = paper_calibration().samples;
    const auto responses = response_to_contact_modulus(problem);
    // Contact times fix density^3 modulus^2 (see ContactTimeObservation): the density goes nearly with the
    // power -2/3.
    for (const CalibrationResponse& response : responses)
        CHECK(std::abs(response.density + 2.0 / 3.0) < 0.05);

    const auto velocities_of = [&](const std::vector<CalibrationSample>& samples) {
        std::vector<double> velocities;
        for (const CriticalVelocityObservation& o : problem.critical_velocities)
            velocities.push_back(critical_velocity_of(samples[o.sample], o.law, o.critical_damping));
        return velocities;
    };
    const std::vector<double> nominal = velocities_of(problem.samples);
    constexpr int draws = 4;                   // 50 gave the same
    constexpr double deviation = 0.047;        // of ln E*, from the range of mullite's modulus
    std::vector<double> full(nominal.size());  // sums of squares
    std::vector<double> apart(nominal.size());
    for (int k = 0; k < draws; ++k) {
        const double ratio = std::exp(deviation * gsl::normal_quantile((k + 0.5) / draws));
        CalibrationProblem moved = problem;
        for (CalibrationSample& sample : moved.samples)
            sample.contact_modulus = ratio * sample.contact().contact_modulus;
        std::vector<CalibrationSample> linear = moved.samples;
        for (std::size_t s = 0; s < linear.size(); ++s) {
            linear[s].density *= std::pow(ratio, responses[s].density);
            linear[s].work_of_adhesion *= std::pow(ratio, responses[s].work_of_adhesion);
        }
        const std::vector<double> recalibrated = velocities_of(calibrate(moved).samples);
        const std::vector<double> responded = velocities_of(linear);
        for (std::size_t i = 0; i < nominal.size(); ++i) {
            full[i] += std::pow(std::log(recalibrated[i] / nominal[i]), 2);
            apart[i] += std::pow(std::log(responded[i] / recalibrated[i]), 2);
        }
    }
    for (std::size_t i = 0; i < nominal.size(); ++i) {
        CAPTURE(i);
        CHECK(std::sqrt(full[i] / draws) < 0.0065);
        CHECK(std::sqrt(apart[i] / draws) < 0.02 * std::sqrt(full[i] / draws) + 2e-5);
    }
}

namespace {

/// v_c of Eq. 31 at a finite step, by halving: the greatest velocity that its scheme captures [m/s].
double critical_velocity_of_scheme(const ContactPair& contact, Law law, double damping, double time_step) {
    double captured = 0.5;
    double rebounds = 4;
    for (int i = 0; i < 40; ++i) {
        const double velocity = 0.5 * (captured + rebounds);
        const ImpactResult impact = solve_impact_explicit(
            {law, Detachment::zero_overlap, {DampingLaw::constant, damping}, contact, velocity},
            {.time_step = time_step});
        (impact.outcome == Outcome::rebound ? rebounds : captured) = velocity;
    }
    return rebounds;
}

}  // namespace

TEST_CASE("a finite step shifts critical velocities as the paper's scheme does") {
    CalibrationProblem problem = paper_problem();
    constexpr double time_step = 3e-9;
    const auto predicted = [&](std::size_t i) {
        return calibration_residuals(problem, problem.samples).critical_velocities.at(i).predicted;
    };
    for (const std::size_t i : {0, 1, 2}) {  // the laws of the first sample
        const CriticalVelocityObservation& of = problem.critical_velocities[i];
        CAPTURE(of.law.name());
        problem.samples[0].step = {};
        const double exact = predicted(i);
        CHECK(exact == critical_velocity_of(problem.samples[0], of.law, of.critical_damping));
        problem.samples[0].step = {time_step};
        const double scheme =
            critical_velocity_of_scheme(problem.samples[0].contact(), of.law, of.critical_damping, time_step);
        CHECK(std::abs(scheme / exact - 1) > 0.03);
        CHECK(relative_difference(predicted(i), scheme) < 0.1 * std::abs(scheme / exact - 1));
    }
}

TEST_CASE("the paper's tables with the step of Eq. 31 free: a shorter chi^2, other densities") {
    std::vector<FreeConstant> free = paper_constants;
    free.push_back({CalibrationQuantity::time_step, false});
    const CalibrationSummary summary = calibrate(paper_problem(free));
    const CalibratedConstant& step = summary.constants.back();
    CHECK(step.quantity == CalibrationQuantity::time_step);
    CHECK(step.value == doctest::Approx(3.2e-9).epsilon(0.3));
    CHECK(summary.chi_squared < paper_calibration().chi_squared - 2);
    CHECK(summary.degrees_of_freedom == paper_calibration().degrees_of_freedom - 1);
    for (std::size_t i = 0; i < 3; ++i)
        CHECK(summary.samples[i].density > 1.01 * paper_calibration().samples[i].density);
}

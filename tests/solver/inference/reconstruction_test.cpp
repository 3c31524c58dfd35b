// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Dense>
#include <doctest/doctest.h>

#include "materials/contact_properties.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/inference/calibration/published_damping.hpp"
#include "tests/support/checks.hpp"
#include "tests/support/contact_cases.hpp"
#include "tests/support/published.hpp"
#include "tests/support/random.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

/// Densities and work of adhesion that the calibration finds for the three samples.
constexpr double densities[] = {2178.29, 2158.52, 2072.50};
constexpr double work_of_adhesion = 0.295917;

PublishedDamping published_damping(std::size_t sample, Law law) {
    const PublishedSample data = published_samples()[sample];
    const double radius = data.diameter / 2;
    return {
        .law = law,
        .detachment = law.default_detachment(),
        .contact = {.mass = sphere_mass(radius, densities[sample]),
                    .effective_radius = radius,
                    .contact_modulus = contact_modulus({data.young_modulus, 0.2}, ElasticBody{193e9, 0.29}),
                    .work_of_adhesion = work_of_adhesion},
        .damping = data.of(law).damping_fit};
}

template <class Action>
void for_each_published(Action&& action) {
    for (std::size_t sample = 0; sample < 3; ++sample)
        for (const Law law : {Law::of<Hertz>(), Law::of<Dmt>(), Law::of<BrachDunn>()})
            action(published_damping(sample, law));
}

using LongMatrix = Eigen::Matrix<long double, 3, 3>;
using LongVector = Eigen::Matrix<long double, 3, 1>;

/// Fit and covariance by the normal equations in extended precision, which share nothing with the SVD of the
/// fit; of the coefficients in ascending powers.
struct NormalEquations {
    LongVector coefficients = LongVector::Zero();
    LongMatrix inverse = LongMatrix::Zero();
    long double chi_squared = 0;

    explicit NormalEquations(const std::vector<DampingPoint>& points) {
        const auto weight = [](const DampingPoint& p) {
            const long double u = p.standard_uncertainty;
            return u > 0 ? 1 / (u * u) : 1.0L;
        };
        const auto row = [](const DampingPoint& p) {
            const long double e = p.restitution;
            return LongVector(1, e, e * e);
        };
        LongMatrix normal = LongMatrix::Zero();
        LongVector right = LongVector::Zero();
        for (const DampingPoint& p : points) {
            normal += weight(p) * row(p) * row(p).transpose();
            right += weight(p) * p.damping * row(p);
        }
        inverse = normal.inverse();
        coefficients = inverse * right;
        for (const DampingPoint& p : points)
            chi_squared += weight(p) * std::pow(p.damping - row(p).dot(coefficients), 2.0L);
    }
};

/// Noisy points on the 88 um Hertz row of Table 2.
std::vector<DampingPoint> noisy_points(bool weighted) {
    Random random(42);
    std::vector<DampingPoint> points;
    for (int i = 0; i < 12; ++i) {
        const double e = 0.05 + 0.05 * i;
        const double u = weighted ? 1e-4 * (1.0 + 0.3 * i) : 0.0;
        const double noise = random.uniform(-2e-4, 2e-4);
        points.push_back({e, 0.0238 * e * e - 0.0291 * e + 0.0153 + noise, u});
    }
    return points;
}

void check_against_normal_equations(const DampingFit& fit, const NormalEquations& expected,
                                    long double scatter) {
    for (Eigen::Index i = 0; i < 3; ++i) {
        CHECK(relative_difference(fit.damping.coefficients[i],
                                  static_cast<double>(expected.coefficients[i])) < 1e-12);
        for (Eigen::Index j = 0; j < 3; ++j) {
            CAPTURE(i);
            CAPTURE(j);
            CHECK(relative_difference(fit.covariance(i, j),
                                      static_cast<double>(scatter * expected.inverse(i, j))) < 1e-11);
        }
    }
    CHECK(relative_difference(fit.chi_squared, static_cast<double>(expected.chi_squared)) < 1e-11);
}

}  // namespace

TEST_CASE("the velocity of a restitution gives that restitution, for every case with a critical velocity") {
    Worst worst;
    for (const ContactCase& c : elastic_cases()) {
        if (c.damping_law != DampingLaw::constant || c.detachment == Detachment::zero_force) continue;
        for (const double e : {0.001, 0.1, 0.5, 0.9, 0.99}) {
            Impact impact = impact_of(c, ash(0.3), 0.3, 2.0);
            impact.velocity = velocity_of_restitution(impact, e);
            worst.see(std::abs(solve_impact(impact).restitution - e), describe(impact));
        }
    }
    CHECK(worst.count() >= 30);
    CHECK_MESSAGE(worst.deviation() < 1e-12, worst.where());
}

TEST_CASE("small restitutions belong to velocities just above the critical one") {
    const Impact impact =
        impact_of({Law::of<Dmt>(), DampingLaw::constant, Detachment::zero_overlap}, ash(0.3), 0.5, 2.0);
    const double critical =
        *critical_velocity({impact.law, impact.detachment, impact.damping, impact.contact}).value;
    CHECK(velocity_of_restitution(impact, 1e-3) > critical);
    CHECK(velocity_of_restitution(impact, 1e-3) < 1.001 * critical);
    CHECK(velocity_of_restitution(impact, 0.3) > velocity_of_restitution(impact, 0.2));
}

TEST_CASE("restitutions down to rounding have a velocity, which is v_c to rounding") {
    const Impact impact =
        impact_of({Law::of<Jkr>(), DampingLaw::constant, Detachment::zero_overlap}, ash(0.3), 0.5, 2.0);
    Worst worst;
    for (int i = 0; i < 60; ++i) {
        Impact at = impact;
        at.damping.coefficient *= 1.0 + 1e-3 * i;
        const double critical = *critical_velocity({at.law, at.detachment, at.damping, at.contact}).value;
        for (const double e : {1e-8, 1e-10, 1e-12}) {
            double velocity = 0.0;
            CHECK_NOTHROW(velocity = velocity_of_restitution(at, e));
            worst.see(relative_difference(velocity, critical), describe(at));
        }
    }
    CHECK_MESSAGE(worst.deviation() < 1e-12, worst.where());
}

TEST_CASE("a reconstructed point of the paper's curves gives its own restitution back") {
    Worst worst;
    for_each_published([&](const PublishedDamping& published) {
        for (const double e : {0.05, 0.2, 0.4, 0.6}) {
            const Impact impact{.law = published.law,
                                .detachment = published.detachment,
                                .damping = {DampingLaw::constant, published.damping(e)},
                                .contact = published.contact,
                                .velocity = reconstructed_velocity(published, e)};
            worst.see(std::abs(solve_impact(impact).restitution - e), describe(impact));
        }
    });
    CHECK(worst.count() == 36);
    CHECK_MESSAGE(worst.deviation() < 1e-12, worst.where());
}

TEST_CASE("the curve as velocity over restitution and as restitution over velocity is one curve") {
    Worst worst;
    for_each_published([&](const PublishedDamping& published) {
        const CurvePoint least = least_rebound(published);
        double before = least.velocity;
        const double first = least.restitution + 0.002;
        for (int i = 0; i < (0.5 - first) / 0.01; ++i) {
            const double e = first + 0.01 * i;
            const double velocity = reconstructed_velocity(published, e);
            if (velocity <= before) break;  // the end of the rising branch
            before = velocity;
            worst.see(std::abs(reconstructed_restitution(published, velocity) - e),
                      std::string(published.law.name()) + " " + std::to_string(e));
        }
    });
    CHECK(worst.count() > 300);
    CHECK_MESSAGE(worst.deviation() < 1e-11, worst.where());
}

TEST_CASE("the curve of an adhesive law folds back from v_c; below the fold there is no rebound") {
    for_each_published([&](const PublishedDamping& published) {
        const double critical = *critical_velocity({published.law,
                                                    published.detachment,
                                                    {DampingLaw::constant, published.damping(0.0)},
                                                    published.contact})
                                     .value;
        const CurvePoint least = least_rebound(published);
        CAPTURE(published.law.name());
        CAPTURE(critical);
        CAPTURE(least.velocity);
        CAPTURE(least.restitution);
        CHECK(reconstructed_restitution(published, least.velocity * (1.0 - 1e-6)) == 0.0);
        CHECK(reconstructed_restitution(published, 1.1 * critical) > least.restitution);
        const bool folds = published.law != Law::of<Hertz>();
        CHECK((least.restitution > 0.0) == folds);
        CHECK((least.velocity < critical) == folds);
        if (!folds) return;
        // Both branches rebound with their own damping; the curve takes the upper one.
        CHECK(reconstructed_velocity(published, 0.9 * least.restitution) > least.velocity);
        CHECK(reconstructed_velocity(published, 1.1 * least.restitution) > least.velocity);
        for (const double share : {0.01, 0.5, 0.99}) {
            const double velocity = least.velocity + share * (critical - least.velocity);
            const double e = reconstructed_restitution(published, velocity);
            CHECK(e > least.restitution);
            CHECK(relative_difference(reconstructed_velocity(published, e), velocity) < 1e-11);
        }
        // It joins on smoothly where the damping of e = 0 rebounds too.
        const double below = reconstructed_restitution(published, critical * (1.0 - 1e-9));
        const double above = reconstructed_restitution(published, critical * (1.0 + 1e-9));
        CHECK(std::abs(above - below) < 1e-6);
    });
    const CurvePoint least = least_rebound(published_damping(0, Law::of<BrachDunn>()));
    const double critical = reconstructed_velocity(published_damping(0, Law::of<BrachDunn>()), 1e-9);
    CHECK(std::abs(1.0 - least.velocity / critical - 0.0085) < 1e-4);
    CHECK(std::abs(least.restitution - 0.00570) < 5e-5);
}

TEST_CASE(
    "Hertz needs 21.415 e more than v_c, so that a damping which falls by 4.283 of itself folds its curve") {
    const ContactPair pair = published_damping(0, Law::of<Hertz>()).contact;
    constexpr double damping = 0.0153;  // [kg/s]
    const Impact impact{
        Law::of<Hertz>(), Detachment::zero_overlap, {DampingLaw::constant, damping}, pair, 1.0};
    const double critical =
        *critical_velocity({impact.law, impact.detachment, impact.damping, impact.contact}).value;
    constexpr double e = 1e-5;
    const double share = velocity_of_restitution(impact, e) / critical - 1.0;
    CHECK(std::abs(share / e - (21.415 - 50.0 * std::sqrt(e))) < 0.01);
    for (const double fall : {1.9, 4.2, 4.4}) {
        const PublishedDamping published{impact.law, impact.detachment, pair,
                                         DampingPolynomial::quadratic(0.0, -fall * damping, damping)};
        CAPTURE(fall);
        CHECK((reconstructed_velocity(published, e) < critical) == (fall > 4.283));
    }
}

TEST_CASE("how well the three laws agree on one measurement: 11 % in velocity, for the 96 um sample 26 %") {
    for (std::size_t sample = 0; sample < 3; ++sample) {
        for (const double e : {0.1, 0.2, 0.3, 0.4, 0.5}) {
            double least = 1e9;
            double greatest = 0.0;
            for (const Law law : {Law::of<Hertz>(), Law::of<Dmt>(), Law::of<BrachDunn>()}) {
                const double velocity = reconstructed_velocity(published_damping(sample, law), e);
                least = std::min(least, velocity);
                greatest = std::max(greatest, velocity);
            }
            CAPTURE(sample);
            CAPTURE(e);
            CHECK(greatest < (sample == 1 ? 1.26 : 1.11) * least);
        }
    }
}

TEST_CASE("restitutions that no velocity has are refused") {
    const Impact impact =
        impact_of({Law::of<Dmt>(), DampingLaw::constant, Detachment::zero_overlap}, ash(0.3), 0.3, 2.0);
    const auto message = [](const Impact& i, double e) {
        return input_error_of([&] { return velocity_of_restitution(i, e); });
    };
    for (const double e : {0.0, 1.0, -0.2, 1.7, std::nan("")})
        CHECK(contains(message(impact, e), "is not reached at any velocity; allowed: 0 < e < 1"));
    Impact never =
        impact_of({Law::of<Hertz>(), DampingLaw::constant, Detachment::zero_force}, ash(0.0), 0.3, 2.0);
    CHECK(contains(message(never, 0.5), "never-captured"));
    // With contact-radius damping restitution rises from capture and falls again: two velocities share it.
    const Impact falling =
        impact_of({Law::of<Dmt>(), DampingLaw::contact_radius, Detachment::zero_overlap}, ash(0.3), 0.5, 2.0);
    CHECK(message(falling, 0.5) ==
          "restitution need not rise with velocity for damping law 'contact-radius'; allowed: constant");
    Impact yielding = impact;
    yielding.law = Law::of<ThorntonNing>();
    yielding.detachment = Detachment::pull_off;
    yielding.contact.yield_pressure = 2e9;
    CHECK(
        message(yielding, 0.5) ==
        "restitution need not rise with velocity where the contact yields; allowed: a contact without yield "
        "pressure");
}

TEST_CASE("an exact quadratic is recovered, with its critical damping") {
    std::vector<DampingPoint> points;
    for (int i = 0; i < 13; ++i) {
        const double e = 0.1 + 0.05 * i;
        points.push_back({e, (0.0193 * e - 0.0247) * e + 0.0141, 0.0});
    }
    const DampingFit fit = fit_damping(points);
    CHECK(relative_difference(fit.damping.coefficients[2], 0.0193) < 1e-12);
    CHECK(relative_difference(fit.damping.coefficients[1], -0.0247) < 1e-12);
    CHECK(relative_difference(fit.damping.coefficients[0], 0.0141) < 1e-12);
    CHECK(fit.damping.critical_damping() == fit.damping.coefficients[0]);
    CHECK(relative_difference(fit.damping(0.4), 0.0193 * 0.16 - 0.0247 * 0.4 + 0.0141) < 1e-12);
    CHECK(fit.degrees_of_freedom == static_cast<int>(points.size()) - 3);
    CHECK(fit.residual_deviation < 1e-16);
}

TEST_CASE("with uncertainties: parameters, covariance and chi^2 are those of the normal equations") {
    const auto points = noisy_points(true);
    const DampingFit fit = fit_damping(points);
    check_against_normal_equations(fit, NormalEquations(points), 1.0L);
    CHECK(fit.degrees_of_freedom == 9);
    CHECK(fit.chi_squared > 1.0);
}

TEST_CASE("without uncertainties the covariance is scaled by the scatter of the residuals") {
    const auto points = noisy_points(false);
    const DampingFit fit = fit_damping(points);
    const NormalEquations expected(points);
    check_against_normal_equations(fit, expected, expected.chi_squared / 9);
    CHECK(relative_difference(fit.residual_deviation,
                              static_cast<double>(std::sqrt(expected.chi_squared / 9))) < 1e-12);
}

TEST_CASE("three points are interpolated and leave no scatter") {
    const std::vector<DampingPoint> points{{0.1, 0.013, 0.0}, {0.3, 0.009, 0.0}, {0.6, 0.0065, 0.0}};
    const DampingFit fit = fit_damping(points);
    CHECK(fit.degrees_of_freedom == 0);
    for (const DampingPoint& p : points)
        CHECK(relative_difference(fit.damping(p.restitution), p.damping) < 1e-13);
    CHECK(fit.covariance.cwiseAbs().maxCoeff() < 1e-30);
}

TEST_CASE("too few, unequal or impossible points are refused") {
    const auto message = [](std::vector<DampingPoint> points) {
        return input_error_of([&] { return fit_damping(points); });
    };
    CHECK(message({}) == "the damping fit has 0 distinct restitutions; allowed: at least 3 for a quadratic");
    CHECK(contains(message({{0.1, 0.01, 0}, {0.2, 0.01, 0}}), "has 2 distinct restitutions"));
    CHECK(contains(message({{0.1, 0.01, 0}, {0.2, 0.01, 0}, {0.2, 0.011, 0}, {0.1, 0.012, 0}}),
                   "has 2 distinct restitutions"));
    CHECK(message({{0.1, 0.01, 1e-4}, {0.2, 0.01, 0}, {0.3, 0.01, 1e-4}}) ==
          "only some points of the damping fit have an uncertainty; allowed: all of them or none");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const DampingPoint& wrong : {DampingPoint{nan, 0.01, 0}, DampingPoint{0.3, infinity, 0},
                                      DampingPoint{0.3, 0.01, -1e-4}, DampingPoint{0.3, 0.01, nan}}) {
        CHECK(contains(message({{0.1, 0.01, 0}, {0.2, 0.01, 0}, {0.4, 0.01, 0}, wrong}),
                       "is not finite or has a negative uncertainty"));
    }
}

// SPDX-License-Identifier: GPL-3.0-or-later
// The curves of the report: impacts that have wanted restitutions.
#include <cmath>

#include <doctest/doctest.h>

#include "pipeline/run/curves/model_curve.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/contact/pair.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/motion/impact.hpp"
#include "tests/relative_difference.hpp"

namespace ashimpact::curves {

TEST_CASE("impacts of wanted restitutions have their velocities, and the contact times of those velocities") {
    const ContactPair pair{
        .mass = 9.3e-10, .effective_radius = 44e-6, .contact_modulus = 90e9, .work_of_adhesion = 0.3};
    const Eigen::ArrayXd velocity = Eigen::ArrayXd::LinSpaced(6, 1.5, 9.0);
    for (const LawChoice& choice : {LawChoice{Law::of<Dmt>(), Detachment::zero_overlap},
                                    LawChoice{Law::of<Jkr>(), Detachment::pull_off}}) {
        CAPTURE(choice.law.name());
        Impact impact{.law = choice.law,
                      .detachment = choice.detachment,
                      .damping = {DampingLaw::tsuji, 0.0},
                      .contact = pair,
                      .velocity = 1.0};
        // A damping that falls with velocity, as measured ones do: restitution rises by it and by less
        // adhesion.
        const Eigen::ArrayXd damping = 0.3 * velocity.pow(-0.5);
        Eigen::ArrayXd e(velocity.size());
        for (Eigen::Index i = 0; i < e.size(); ++i) {
            impact.damping.coefficient = damping[i];
            impact.velocity = velocity[i];
            e[i] = solve_impact(impact).restitution;
        }
        for (const double from : {1.4, 1.003})  // the second one is found at the first impact
            for (Eigen::Index i = 0; i < e.size(); ++i) {
                CAPTURE(from);
                CAPTURE(i);
                const FoundImpacts found =
                    impacts_with(e, {choice, DampingLaw::tsuji, pair}, damping, from * velocity, 1e-2);
                CHECK(test::relative_difference(found.velocity[i], velocity[i]) < 4e-3);
                impact.damping.coefficient = damping[i];
                impact.velocity = found.velocity[i];
                CHECK(test::relative_difference(found.contact_time[i], *solve_impact(impact).contact_time) <
                      1e-3);
            }
    }
}

TEST_CASE("impacts of small restitutions are found, with contact times, though the search meets captures") {
    const ContactPair pair{
        .mass = 9.3e-10, .effective_radius = 44e-6, .contact_modulus = 90e9, .work_of_adhesion = 0.3};
    Impact impact{.law = Law::of<Dmt>(),
                  .detachment = Detachment::zero_overlap,
                  .damping = {DampingLaw::constant, 0.012},
                  .contact = pair,
                  .velocity = 1.0};
    const double critical =
        critical_velocity({impact.law, impact.detachment, impact.damping, pair}).value.value();
    const Eigen::ArrayXd velocity = critical * (1 + Eigen::ArrayXd::LinSpaced(12, 0.01, 0.5).square());
    Eigen::ArrayXd e(velocity.size());
    for (Eigen::Index i = 0; i < e.size(); ++i) {
        impact.velocity = velocity[i];
        e[i] = solve_impact(impact).restitution;
    }
    const Eigen::ArrayXd damping = Eigen::ArrayXd::Constant(e.size(), 0.012);
    for (const double from : {0.9, 1.1, 1.4, 2.0})
        for (Eigen::Index i = 0; i < e.size(); ++i) {
            CAPTURE(from);
            CAPTURE(i);
            const FoundImpacts found =
                impacts_with(e, {{impact.law, impact.detachment}, DampingLaw::constant, pair}, damping,
                             from * velocity, 1e-4);
            CHECK(test::relative_difference(found.velocity[i], velocity[i]) < 1e-4);
            impact.velocity = velocity[i];
            CHECK(test::relative_difference(found.contact_time[i], *solve_impact(impact).contact_time) <
                  1e-2);
        }
}

namespace {

/// A curve of a fly-ash particle by one law, with a damping that falls as the restitution rises.
CurveProblem curve_problem(Law law) {
    CurveProblem problem{.choice = {law, law.default_detachment()},
                         .damping_law = DampingLaw::constant,
                         .contact = {.mass = 7.7e-10,
                                     .effective_radius = 44e-6,
                                     .contact_modulus = 90e9,
                                     .work_of_adhesion = law == Law::of<Hertz>() ? 0.0 : 0.3,
                                     .parameters = typical_parameters(law)},
                         .damping_fit = {},
                         .covariance = 1e-8 * Eigen::MatrixXd::Identity(3, 3),
                         .greatest_restitution = 0.4,
                         .greatest_velocity = 100.0,
                         .knots = {{0.4, 3.0}}};
    problem.damping_fit.coefficients = Eigen::Vector3d(0.014, -0.008, -0.001);
    if (law == Law::of<ThorntonNing>()) problem.contact.yield_pressure = 3e9;
    return problem;
}

}  // namespace

TEST_CASE("each impact on a model's curve is that of the solver, by every law, with all of its energy") {
    for (std::size_t index = 0; index < Law::count(); ++index) {
        const Law law = Law::at(index);
        CAPTURE(law.name());
        const CurveProblem problem = curve_problem(law);
        const ModelCurve curve = model_curve(problem);
        const bool yields = std::isfinite(problem.contact.yield_pressure);
        REQUIRE(curve.size() > 10);
        for (const CurveImpact& impact : curve) {
            CAPTURE(impact.restitution);
            Impact exact{problem.choice.law,
                         problem.choice.detachment,
                         {DampingLaw::constant, impact.damping},
                         problem.contact,
                         impact.velocity};
            const ImpactResult result = solve_impact(exact);
            const double whole = result.energy.incident;
            CHECK(result.restitution == doctest::Approx(impact.restitution).epsilon(1e-8));
            REQUIRE(result.contact_time);
            CHECK(*result.contact_time == doctest::Approx(impact.contact_time).epsilon(1e-7));
            CHECK(result.energy.dissipated / whole == doctest::Approx(impact.dissipated).epsilon(1e-8));
            CHECK(result.energy.plastic / whole == doctest::Approx(impact.plastic).epsilon(1e-8));
            CHECK(impact.lower < impact.velocity);
            if (!yields || std::isfinite(impact.upper)) CHECK(impact.upper > impact.velocity);
        }
        CHECK((curve.back().plastic > 0.01) == yields);
        if (yields) continue;
        CurveProblem from_elsewhere = problem;
        from_elsewhere.knots = {{0, 0.1}, {0.2, 30}};
        const ModelCurve again = model_curve(from_elsewhere);
        REQUIRE(again.size() == curve.size());
        for (std::size_t i = 0; i < curve.size(); ++i)
            CHECK(again[i].velocity == doctest::Approx(curve[i].velocity).epsilon(1e-8));
    }
}

TEST_CASE("a model's curve and its band end at the greatest velocity") {
    CurveProblem problem = curve_problem(Law::of<Dmt>());
    const ModelCurve whole = model_curve(problem);
    problem.greatest_velocity = whole[whole.size() / 2].velocity;
    const ModelCurve curve = model_curve(problem);
    REQUIRE(curve.size() == whole.size() / 2 + 1);
    for (std::size_t i = 0; i < curve.size(); ++i) {
        CHECK(curve[i].velocity == whole[i].velocity);
        CHECK(curve[i].lower == whole[i].lower);
        CHECK(curve[i].upper == std::min(whole[i].upper, problem.greatest_velocity));
    }
}

}  // namespace ashimpact::curves

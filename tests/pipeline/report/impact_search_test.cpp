// SPDX-License-Identifier: GPL-3.0-or-later
// The search behind the curves of the report: impacts that have wanted restitutions.
#include "pipeline/present/report/data/impact_search.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/motion/impact.hpp"
#include "tests/relative_difference.hpp"

namespace ashimpact::report {

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

}  // namespace ashimpact::report

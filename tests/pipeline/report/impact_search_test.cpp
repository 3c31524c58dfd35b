// The search behind the curves of the report: impacts that have wanted restitutions.
#include <doctest/doctest.h>

#include <cmath>

#include "pipeline/report/data/impact_search.hpp"
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
        const FoundImpacts found =
            impacts_with(e, {choice, DampingLaw::tsuji, pair}, damping, 1.4 * velocity, 1e-2);
        for (Eigen::Index i = 0; i < e.size(); ++i) {
            CAPTURE(i);
            CHECK(test::relative_difference(found.velocity[i], velocity[i]) < 1e-3);
            impact.damping.coefficient = damping[i];
            impact.velocity = found.velocity[i];
            CHECK(test::relative_difference(found.contact_time[i], *solve_impact(impact).contact_time) <
                  1e-3);
        }
    }
}

}  // namespace ashimpact::report

// SPDX-License-Identifier: GPL-3.0-or-later
// Every registered damping law: its shape, its unit, its limit and the guess that searches start from.
#include <cmath>
#include <optional>
#include <string>

#include <doctest/doctest.h>

#include "solver/damping/registry.hpp"
#include "solver/motion/damping_inversion.hpp"
#include "solver/motion/scale.hpp"
#include "solver/numeric/number.hpp"
#include "tests/relative_difference.hpp"
#include "tests/support/contact_cases.hpp"
#include "tests/support/worst.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

/// Damping eta(a) [kg/s] of the coefficient C at a contact radius [m], worked out in the scale of a velocity.
double damping_at(DampingLaw law, double coefficient, double contact_radius, double velocity) {
    const Scale scale = Scale::of(ash(0.0), velocity);
    const double u = std::sqrt(contact_radius / scale.radius_length);
    const double shape = RegisteredDampings::visit<double>(law, [u]<class D>() {
        return D::shapes(u, StaticForces<double>{power<6>(u), 0.0})[0];
    });
    return scale.damping_number({law, coefficient}) * shape * scale.momentum() / scale.length;
}

DampingProblem hertz_problem(DampingLaw law, double restitution) {
    return {Law::of<Hertz>(), Detachment::zero_overlap, law, ash(0.0), 2.0, restitution};
}

}  // namespace

TEST_CASE("a damping law stands where its name does, and shape is never negative") {
    for (std::size_t i = 0; i < all_values<DampingLaw>.size(); ++i) {
        const DampingLaw law = all_values<DampingLaw>[i];
        CAPTURE(name_of(all_values<DampingLaw>[i]));
        CHECK(static_cast<std::size_t>(law) == i);
        for (const double u : {0.0, 0.3, 1.0, 2.0}) {
            CHECK(RegisteredDampings::visit<double>(law, [u]<class D>() {
                      return D::shapes(u, StaticForces<double>{power<6>(u), 0.0})[0];
                  }) >= 0.0);
        }
        CHECK(RegisteredDampings::visit<double>(law, []<class D>() {
                  return D::shapes(1.0, StaticForces<double>{1.0, 0.0})[0];
              }) == 1.0);
    }
}

TEST_CASE("the damping of a contact radius does not depend on the velocity whose scale it is worked out in") {
    for (const DampingLaw damping : all_values<DampingLaw>) {
        CAPTURE(name_of(damping));
        for (const double radius : {1e-7, 1e-6, 5e-6}) {
            const double one = damping_at(damping, 1.0, radius, 0.3);
            CHECK(relative_difference(one, damping_at(damping, 1.0, radius, 20.0)) < 1e-13);
        }
    }
}

TEST_CASE("searches start within ten per cent of the damping of a Hertz impact") {
    for (const DampingLaw damping : all_values<DampingLaw>) {
        for (const double loss : {0.05, 0.3, 0.7, 0.95}) {
            const DampingInversion found = damping_from_restitution(hertz_problem(damping, 1.0 - loss));
            const double number = Scale::of(ash(0.0), 2.0).damping_number(found.damping);
            CAPTURE(name_of(damping));
            CAPTURE(loss);
            CHECK(relative_difference(hertz_damping_number(damping, loss), number) < 0.1);
        }
    }
}

TEST_CASE("a damping law that states a closed form gives the restitution of a Hertz impact") {
    int seen = 0;
    Worst worst;
    for (const DampingLaw damping : all_values<DampingLaw>) {
        const ContactCase hertz{Law::of<Hertz>(), damping, Detachment::zero_overlap};
        for (const double number : {0.01, 0.1, 0.4, 1.0, 2.0}) {
            const auto closed = RegisteredDampings::visit<std::optional<double>>(
                damping, [&]<class D>() -> std::optional<double> {
                    if constexpr (requires { D::hertz_restitution(number); })
                        return D::hertz_restitution(number);
                    return std::nullopt;
                });
            if (!closed) continue;
            ++seen;
            for (const double v : ash_velocities) {
                const Impact impact = impact_of(hertz, ash(0.0), number, v);
                worst.see(relative_difference(solved(impact).restitution, *closed), describe(impact));
            }
        }
    }
    CHECK(seen >= 5);
    CHECK_MESSAGE(worst.deviation() < 1e-13, worst.where());
}

TEST_CASE("a law's limit of overdamping is where Hertz impacts cease to rebound") {
    for (const DampingLaw damping : all_values<DampingLaw>) {
        const double limit = std::sqrt(overdamped_squared(damping));
        if (!std::isfinite(limit)) continue;
        CAPTURE(name_of(damping));
        const ContactCase hertz{Law::of<Hertz>(), damping, Detachment::zero_overlap};
        for (const double v : ash_velocities) {
            CHECK(solved(impact_of(hertz, ash(0.0), 0.99 * limit, v)).outcome == Outcome::rebound);
            CHECK(solved(impact_of(hertz, ash(0.0), 1.0000001 * limit, v)).outcome == Outcome::capture);
        }
    }
}

// SPDX-License-Identifier: GPL-3.0-or-later
// The contact at the critical velocity, followed backward in time from its end by GSL, in overlap and
// velocity.
#include <array>
#include <cmath>
#include <string>

#include <doctest/doctest.h>

#include "materials/contact_properties.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "tests/oracles/time_domain.hpp"
#include "tests/support/checks.hpp"
#include "tests/support/ode.hpp"

namespace ashimpact::oracles {

using test::relative_difference;

namespace {

struct CriticalContact {
    double velocity;
    double contact_time;
};

// The orbit leaves the end at rest. Over the first overlap x beyond it the force is -pull x^power, so the
// speed is v = a x^((1 + power)/2) + b x with a^2 = 2 pull/(m (1 + power)), b = 2 damping/(m (3 + power)),
// and the time the integral of dx/v.
struct Departure {
    double pull;
    double power;
};

Departure departure_of(const Impact& impact, const ContactForce& force) {
    if (impact.law != Law::of<BrachDunn>()) return {-force(force.end_overlap()), 0.0};
    const double x = 1e-30 * force.overlap_scale();
    return {-force(x) / std::sqrt(x), 0.5};
}

CriticalContact backward_from_the_end(const Impact& impact) {
    using State = std::array<double, 3>;  // overlap beyond the end [m], velocity [m/s], time to the end [s]
    const ContactForce force(impact);
    const double end = force.end_overlap();
    const auto [pull, power] = departure_of(impact, force);
    const double x = 1e-14 * force.overlap_scale();
    const double a = std::sqrt(2 * pull / (impact.contact.mass * (1 + power)));
    const double b = 2 * impact.damping.coefficient / (impact.contact.mass * (3 + power));
    const double way = std::pow(x, (1 - power) / 2);
    const double time = 2 * way / (a * (1 - power)) - b * way * way / (a * a * (1 - power));
    State now{x, -(a * x / way + b * x), time};

    bool by_overlap = false;  // the clock
    const auto derivative = [&](double, const State& y) -> State {
        const double deceleration =
            (force(end + y[0]) + impact.damping.coefficient * y[1]) / impact.contact.mass;
        const double pace = by_overlap ? -1 / y[1] : 1.0;
        return {-pace * y[1], pace * deceleration, pace};
    };
    test::Ode<3, decltype(derivative)> ode(
        derivative,
        {1e-13, {1e-24 * force.overlap_scale(), 1e-16 * impact.velocity, 1e-13 * force.time_scale()}});
    double t = 0;
    double stride = 1e-9 * force.time_scale();
    State before = now;
    while (now[1] < 0 || end + now[0] > 0) {
        before = now;
        ode.step(t, 1e3 * force.time_scale(), stride, now);
    }
    by_overlap = true;
    ode.integrate(end + before[0], 0.0, before);
    return {before[1], before[2]};
}

}  // namespace

TEST_CASE("contact time and velocity of the critical impact agree with GSL, backward in the time domain") {
    for (const double w : {0.05, 0.3, 1.0}) {
        for (const double damping : {0.003, 0.0153}) {
            for (const auto& [law, detachment] : {std::pair{Law::of<Dmt>(), Detachment::zero_overlap},
                                                  std::pair{Law::of<BrachDunn>(), Detachment::zero_overlap},
                                                  std::pair{Law::of<Jkr>(), Detachment::pull_off},
                                                  std::pair{Law::of<Jkr>(), Detachment::load_controlled},
                                                  std::pair{Law::of<Jkr>(), Detachment::zero_overlap}}) {
                const Impact impact{.law = law,
                                    .detachment = detachment,
                                    .damping = {DampingLaw::constant, damping},
                                    .contact = {.mass = sphere_mass(44e-6, 2600),
                                                .effective_radius = 44e-6,
                                                .contact_modulus = 90e9,
                                                .work_of_adhesion = w},
                                    .velocity = 1.0};
                const std::string label = std::string(law.name()) + ", " + std::string(name_of(detachment));
                CAPTURE(label);
                CAPTURE(w);
                CAPTURE(damping);
                const CriticalVelocity critical =
                    critical_velocity({impact.law, impact.detachment, impact.damping, impact.contact});
                REQUIRE(critical.contact_time);
                const CriticalContact expected = backward_from_the_end(impact);
                CHECK(relative_difference(*critical.value, expected.velocity) < 1e-9);
                CHECK(relative_difference(*critical.contact_time, expected.contact_time) < 1e-9);
                if (w == 0.3 && damping == 0.0153) {
                    MESSAGE(label << ": v_c " << *critical.value << " m/s, contact time "
                                  << *critical.contact_time * 1e9 << " ns, off by "
                                  << relative_difference(*critical.contact_time, expected.contact_time));
                }
            }
        }
    }
}

}  // namespace ashimpact::oracles

// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/motion/impact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "materials/contact_properties.hpp"
#include "solver/motion/scale.hpp"
#include "solver/motion/scaled_impact.hpp"
#include "tests/support/checks.hpp"
#include "tests/support/contact_cases.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

Motion<Extended> motion_of(const Impact& impact) {
    return scaled_motion<Extended>(impact, Scale::of(impact.contact, impact.velocity));
}

/// Derivative of a series at @p h.
Extended slope_at(const Series<Extended>& c, Extended h) {
    Extended sum = 0;
    for (std::size_t n = c.size(); n-- > 1;) sum = sum * h + static_cast<Extended>(n) * c[n];
    return sum;
}

}  // namespace

TEST_CASE(
    "at the critical velocity itself, where rounding decides, an impact ends: next to no rebound or none") {
    struct Critical {
        Detachment detachment;
        double damping;   // [kg/s]
        double velocity;  // [m/s]
    };
    // Found among some 6,000 of each detachment: they turn back within rounding of the end of contact.
    constexpr Critical found[] = {{Detachment::pull_off, 0.011372500000000001, 0.42095684178046866},
                                  {Detachment::zero_overlap, 0.016467499999999999, 1.1837083830977726},
                                  {Detachment::zero_overlap, 0.010735, 0.25723631767934163},
                                  {Detachment::load_controlled, 0.014239999999999999, 0.76261683008452663},
                                  {Detachment::load_controlled, 0.012467500000000001, 0.48679811687310015}};
    const ContactPair pair{.mass = sphere_mass(48e-6, 2158.5),
                           .effective_radius = 48e-6,
                           .contact_modulus = 90e9,
                           .work_of_adhesion = 0.2959};
    for (const Critical& at : found) {
        CAPTURE(name_of(at.detachment));
        const Impact impact{
            Law::of<Jkr>(), at.detachment, {DampingLaw::constant, at.damping}, pair, at.velocity};
        double restitution = 1.0;
        CHECK_NOTHROW(restitution = restitution_of(impact));
        CHECK(restitution < 1e-7);
    }
}

TEST_CASE("restitution in double precision is that of extended precision, to rounding") {
    Worst worst;
    for (const ContactCase& c : contact_cases()) {
        for (const double w : ash_adhesions) {
            for (const double v : ash_velocities) {
                for (const double number : damping_numbers) {
                    const Impact impact = impact_of(c, ash(w), number, v);
                    worst.see(std::abs(restitution_of(impact) - solve_impact(impact).restitution),
                              describe(impact));
                }
            }
        }
    }
    CHECK(worst.count() > 500);
    CHECK_MESSAGE(worst.deviation() < 1e-13, worst.where());
}

TEST_CASE("potentials of a JKR contact, from zero contact radius: at the jump, at equilibrium, at the fold") {
    // pi w R* times the unit of overlap of Eq. 21 is pi^(5/3) (9/16)^(1/3) (w^5 R^4/E*^2)^(1/3), and the
    // integral of F d(delta) is abar^2 (2x/5 - (2/3) sqrt(6x) + 1) with x = abar^3: 8/3 at the jump, 6 at
    // equilibrium, 1/6 at the fold.
    const double pi = std::acos(-1.0);
    for (const double w : ash_adhesions) {
        const Impact impact =
            impact_of({Law::of<Jkr>(), DampingLaw::constant, Detachment::pull_off}, ash(w), 0.0, 2.0);
        const EnergyLedger energy = solve_impact(impact).energy;
        const double unit =
            std::pow(pi, 5.0 / 3.0) * std::cbrt(std::pow(w, 5) * std::pow(44e-6, 4) / (90e9 * 90e9));
        const double third = std::cbrt(9.0 / 16.0);
        CAPTURE(w);
        CHECK(relative_difference(energy.at_touch, -0.6 * std::cbrt(4.0) * unit) < 1e-14);
        CHECK(relative_difference(energy.minimum, -0.6 * std::cbrt(36.0) * third * unit) < 1e-14);
        CHECK(relative_difference(energy.potential, 0.1 * unit) < 1e-14);
    }
}

TEST_CASE(
    "an impact a billion times weaker than the adhesive well is solved, as exactly as rounding allows") {
    const ContactCase c{Law::of<Dmt>(), DampingLaw::constant, Detachment::zero_overlap};
    double deepest = 0.0;
    for (const double v : {1e-6, 1e-3, 1.0, 1e3}) {
        const ImpactResult result = solve_impact(impact_of(c, ash(1.0), 0.0, v));
        CAPTURE(v);
        CHECK(result.outcome == Outcome::rebound);
        const double depth = std::abs(result.energy.minimum) / result.energy.incident;
        CHECK(std::abs(result.restitution - 1.0) < 1e-15 + 1e-18 * depth);
        deepest = std::max(deepest, depth);
    }
    CHECK(deepest > 1e9);
}

// The regularised equation of motion and its expansion, in the solver's own scaled units.

TEST_CASE("potential, stiffness and drag belong to the force, the overlap and the damping") {
    Worst worst;
    for (const ContactCase& c : elastic_cases()) {
        const Motion<Extended> motion = motion_of(impact_of(c, ash(0.3), 0.3, 2.0));
        for (const Extended q : {0.3L, 0.8L, 1.1L}) {
            const auto near = [&](Extended a, Extended b) {
                worst.see(static_cast<double>(std::abs(a - b)), name_of(c));
            };
            near(motion.first.stiffness(q), motion.slope(q) * motion.force(q));
            near(motion.first.drag(q), motion.slope(q) * motion.damping(q));
            near(motion.first.potential.derivative()(q), motion.first.stiffness(q));
            near(motion.slope(q), motion.first.overlap.derivative()(q));
        }
        CHECK(motion.potential(0.0L) == 0.0L);
        CHECK(std::abs(motion.overlap(motion.touch)) < 1e-18L);
        CHECK(std::abs(motion.force(motion.equilibrium)) < 1e-18L);
        const bool by_place = c.detachment != Detachment::zero_force || motion.force_keeps_sign();
        CHECK(motion.end.has_value() == by_place);
    }
    CHECK_MESSAGE(worst.deviation() < 1e-17, worst.where());
}

TEST_CASE("an expansion satisfies the equation of motion all over its step") {
    Worst worst;
    for (const ContactCase& c : elastic_cases()) {
        const Motion<Extended> motion = motion_of(impact_of(c, ash(0.3), 0.3, 2.0));
        const MotionState<Extended> states[] = {{.position = motion.touch, .velocity = 1.0L},
                                                {.position = 1.02L, .velocity = 0.0L},
                                                {.position = 0.7L, .velocity = -0.6L}};
        for (const MotionState<Extended>& state : states) {
            const MotionExpansion<Extended> x = motion.expand(state);
            CHECK(x.step > 0.0L);
            for (const Extended part : {0.25L, 0.5L, 1.0L}) {
                const Extended h = part * x.step;
                const MotionState<Extended> s = x.at(h);
                const Extended acceleration =
                    -motion.slope(s.position) *
                    (motion.damping(s.position) * s.velocity + motion.force(s.position));
                const auto near = [&](Extended a, Extended b) {
                    worst.see(static_cast<double>(std::abs(a - b) / (1 + std::abs(b))), name_of(c));
                };
                near(slope_at(x.position, h), s.velocity);
                near(slope_at(x.velocity, h), acceleration);
                near(slope_at(x.time, h), motion.slope(s.position));
                near(slope_at(x.dissipation, h), motion.first.drag(s.position) * s.velocity * s.velocity);
            }
        }
    }
    CHECK(worst.count() > 500);
    CHECK_MESSAGE(worst.deviation() < 1e-17, worst.where());
}

TEST_CASE("steps follow one another: each piece begins where the one before ended") {
    for (const ContactCase& c : elastic_cases()) {
        const Motion<Extended> motion = motion_of(impact_of(c, ash(0.3), 0.3, 2.0));
        MotionState<Extended> last{.position = motion.touch, .velocity = 1.0L};
        int pieces = 0;
        const auto orbit = follow<Extended>(
            motion, 1.0L, [&](const Motion<Extended>&, const MotionExpansion<Extended>& x, Extended used) {
                CHECK(std::abs(x.position[0] - last.position) < 1e-18L);
                CHECK(std::abs(x.velocity[0] - last.velocity) < 1e-18L);
                CHECK(used > 0.0L);
                CHECK(used <= x.step);
                last = x.at(used);
                ++pieces;
            });
        CAPTURE(name_of(c));
        CHECK(pieces == orbit.steps);
        CHECK(orbit.turned);
        CHECK(orbit.turn.velocity == 0.0L);
        CHECK(last.position == orbit.end.position);
        if (motion.end) CHECK(std::abs(orbit.end.position - *motion.end) < 1e-17L);
    }
}

TEST_CASE("capture is decided only where it is certain") {
    for (const ContactCase& c : elastic_cases()) {
        const Motion<Extended> motion = motion_of(impact_of(c, ash(0.3), 0.05, 2.0));
        const CaptureTest<Extended> capture(motion);
        CAPTURE(name_of(c));
        CHECK(!capture.bound({.position = motion.touch, .velocity = 1.0L}));
        CHECK(!capture.creeping({.position = 1.0L, .velocity = -0.5L}));
        if (motion.end && motion.equilibrium > *motion.end) {
            CHECK(capture.bound({.position = motion.equilibrium, .velocity = 0.0L}));
        }
        if (!motion.end) CHECK(!capture.bound({.position = 0.5L, .velocity = 0.0L}));
    }
}

TEST_CASE("the units of the scaled impact: mass, Hertz stiffness and velocity are one") {
    const ContactPair pair = ash(0.3);
    for (const double v : ash_velocities) {
        const Scale scale = Scale::of(pair, v);
        CAPTURE(v);
        CHECK(scale.mass == pair.mass);
        CHECK(scale.velocity == v);
        CHECK(relative_difference(scale.stiffness, 4.0 / 3.0 * 90e9 * std::sqrt(44e-6)) < 1e-15);
        // Force k L^(3/2) is what stops the mass within L: m v^2 = k L^(5/2).
        CHECK(relative_difference(scale.stiffness * std::pow(scale.length, 2.5), pair.mass * v * v) < 1e-14);
        CHECK(relative_difference(scale.force(), scale.stiffness * std::pow(scale.length, 1.5)) < 1e-14);
        CHECK(relative_difference(scale.energy(), pair.mass * v * v) < 1e-15);
        CHECK(relative_difference(scale.momentum(), pair.mass * v) < 1e-15);
        CHECK(relative_difference(scale.time(), scale.length / v) < 1e-15);
        CHECK(relative_difference(scale.radius_length, std::sqrt(44e-6 * scale.length)) < 1e-15);
    }
    // At 2 m/s: L = (9.277e-10 * 4/7.96e8)^0.4 m; the greatest overlap of the reference impact is 1.093 L.
    CHECK(relative_difference(Scale::of(pair, 2.0).length * std::pow(1.25, 0.4), 1.2770060733e-7) < 1e-10);
}

TEST_CASE("the contact time of Hertz is that of the solver, and Johnson's closed form") {
    const ContactPair pair = ash(0.0);
    const double scaled =
        2 * std::pow(1.25, 0.4) * std::sqrt(std::numbers::pi) * std::tgamma(1.4) / std::tgamma(0.9);
    for (const double v : ash_velocities) {
        CAPTURE(v);
        const double time = hertz_contact_time(pair, v);
        CHECK(relative_difference(time, scaled * Scale::of(pair, v).time()) < 1e-14);
        const ImpactResult impact =
            solve_impact({Law::of<Hertz>(), Detachment::zero_overlap, {DampingLaw::constant, 0.0}, pair, v});
        CHECK(relative_difference(time, impact.contact_time.value()) < 1e-12);
    }
}

TEST_CASE(
    "scaled damping: beta = eta m^(-3/5) k^(-2/5) v^(-1/5), and every law's number is its own inverse's") {
    const ContactPair pair = ash(0.0);
    for (const double v : ash_velocities) {
        const Scale scale = Scale::of(pair, v);
        const double eta = 0.0153;
        const double beta =
            eta * std::pow(pair.mass, -0.6) * std::pow(scale.stiffness, -0.4) * std::pow(v, -0.2);
        CHECK(relative_difference(scale.damping_number({DampingLaw::constant, eta}), beta) < 1e-14);
        for (const DampingLaw law : all_values<DampingLaw>) {
            const double number = 0.37;
            const double back = scale.damping_number({law, scale.damping_coefficient(law, number)});
            CHECK(relative_difference(back, number) < 1e-15);
        }
    }
}

TEST_CASE("the three damping laws are the same damping where contact radius and overlap are their units") {
    // At delta = L the contact radius is sqrt(R L): eta = C, C a and C sqrt(m k) delta^(1/4) then agree.
    const ContactPair pair = ash(0.0);
    const Scale scale = Scale::of(pair, 2.0);
    const double number = 0.6;
    const double constant = scale.damping_coefficient(DampingLaw::constant, number);
    const double by_radius = scale.damping_coefficient(DampingLaw::contact_radius, number) *
                             std::sqrt(pair.effective_radius * scale.length);
    const double by_tsuji = scale.damping_coefficient(DampingLaw::tsuji, number) *
                            std::sqrt(pair.mass * scale.stiffness) * std::pow(scale.length, 0.25);
    CHECK(relative_difference(by_radius, constant) < 1e-14);
    CHECK(relative_difference(by_tsuji, constant) < 1e-14);
}

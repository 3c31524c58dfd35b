// SPDX-License-Identifier: GPL-3.0-or-later
// The regularised equation of motion and its expansion, in the solver's own scaled units.
#include <cmath>

#include <doctest/doctest.h>

#include "solver/motion/scaled_impact.hpp"
#include "tests/relative_difference.hpp"
#include "tests/support/contact_cases.hpp"
#include "tests/support/worst.hpp"

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
        CHECK(motion.end.has_value() == (c.detachment != Detachment::zero_force));
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

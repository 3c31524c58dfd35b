// SPDX-License-Identifier: GPL-3.0-or-later
// Energy: what an undamped impact keeps, what a damped one loses, against quadratures of their own.
// Orbits of a law without memory cannot cross: faster in is faster out, and more damping is less of it.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <doctest/doctest.h>

#include "materials/contact_properties.hpp"
#include "solver/contact/static_curve.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/motion/scaled_impact.hpp"
#include "tests/support/checks.hpp"
#include "tests/support/contact_cases.hpp"
#include "tests/support/quadrature.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Work that breaking the contact costs, from the overlap of its beginning to its end [J]: the static force
/// over the overlap, in a variable in which it is smooth at a fold.
double work_of_breaking(Law law, const ContactPair& pair, Detachment detachment) {
    const StaticCurve curve(law, pair);
    const double first = curve.touch_overlap(detachment);
    const double way = curve.end_overlap(detachment) - first;
    if (std::abs(way) < 1e-12 * pair.effective_radius) return 0.0;
    return integral(
        [&](double x) { return curve.at_overlap(first + way * (1.0 - x * x)).force() * 2.0 * x * way; }, 0.0,
        1.0);
}

/// What the ledger is exact relative to [J].
double size_of(const EnergyLedger& energy) {
    return std::max(energy.incident, std::abs(energy.minimum));
}

template <class Action>
void for_each_damped_impact(Action&& action) {
    for (const ContactCase& c : contact_cases()) {
        for (const double w : ash_adhesions) {
            for (const double v : ash_velocities) {
                for (const double number : {0.05, 0.3, 0.8, 1.3}) action(impact_of(c, ash(w), number, v));
            }
        }
    }
}

constexpr double ash_density = 2600.0;  // of ash()

struct End {
    Detachment detachment;
    Separation separation;
};
constexpr End ends[] = {{Detachment::pull_off, Separation::pull_off},
                        {Detachment::load_controlled, Separation::load_controlled}};

double analytic_velocity(double w, Separation separation) {
    return separation_velocity({.work_of_adhesion = w,
                                .effective_radius = ash(w).effective_radius,
                                .contact_modulus = ash(w).contact_modulus},
                               ash_density, separation);
}

/// first, first * factor, ... below @p end.
std::vector<double> geometric(double first, double factor, double end) {
    std::vector<double> values{first};
    while (values.back() * factor < end) values.push_back(values.back() * factor);
    return values;
}

Impact hertz_of(Impact impact) {
    impact.law = Law::of<Hertz>();
    if (impact.detachment != Detachment::zero_force) impact.detachment = Detachment::zero_overlap;
    return impact;
}

/// The largest relative difference of restitution, times and overlap.
double difference(const ImpactResult& a, const ImpactResult& b) {
    return std::max({relative_difference(a.restitution, b.restitution),
                     relative_difference(a.contact_time.value(), b.contact_time.value()),
                     relative_difference(a.approach_time.value(), b.approach_time.value()),
                     relative_difference(a.maximum_overlap, b.maximum_overlap)});
}

}  // namespace

TEST_CASE("an undamped impact loses what breaking the contact costs, and nothing else") {
    Worst ledger;
    Worst restitution;
    Worst time;
    for (const ContactCase& c : elastic_cases()) {
        for (const double w : ash_adhesions) {
            for (const double v : ash_velocities) {
                const Impact impact = impact_of(c, ash(w), 0.0, v);
                const ImpactResult result = solved(impact);
                const double kinetic = 0.5 * impact.contact.mass * v * v;
                const double breaking = work_of_breaking(c.law, impact.contact, c.detachment);
                const double expected = std::sqrt(1.0 - breaking / kinetic);
                REQUIRE(result.outcome == Outcome::rebound);
                CHECK(result.energy.dissipated == 0.0);
                ledger.see(std::abs(result.energy.residual) / kinetic, describe(impact));
                restitution.see(std::abs(result.restitution - expected), describe(impact));
                if (breaking == 0.0) {
                    time.see(relative_difference(*result.contact_time, 2.0 * *result.approach_time),
                             describe(impact));
                }
            }
        }
    }
    CHECK_MESSAGE(ledger.deviation() < 1e-12, ledger.where());
    CHECK_MESSAGE(restitution.deviation() < 1e-12, restitution.where());
    CHECK_MESSAGE(time.deviation() < 1e-12, time.where());
}

TEST_CASE("the damping law does not matter where its coefficient is zero") {
    Worst worst;
    for (const ContactCase& c : contact_cases()) {
        ContactCase plain = c;
        plain.damping_law = DampingLaw::constant;
        const ImpactResult a = solved(impact_of(c, ash(0.3), 0.0, 2.0));
        const ImpactResult b = solved(impact_of(plain, ash(0.3), 0.0, 2.0));
        worst.see(std::abs(a.restitution - b.restitution), name_of(c));
        worst.see(relative_difference(*a.contact_time, *b.contact_time), name_of(c));
        worst.see(relative_difference(a.maximum_overlap, b.maximum_overlap), name_of(c));
    }
    CHECK_MESSAGE(worst.deviation() < 1e-14, worst.where());
}

TEST_CASE("the ledger of a damped impact closes, and every entry has its sign") {
    Worst worst;
    int captures = 0;
    int yielded = 0;
    for_each_damped_impact([&](const Impact& impact) {
        const ImpactResult result = solved(impact);
        const EnergyLedger& energy = result.energy;
        CAPTURE(describe(impact));
        const double kinetic = 0.5 * impact.contact.mass * impact.velocity * impact.velocity;
        CHECK(relative_difference(energy.incident, kinetic) < 1e-14);
        CHECK(energy.dissipated > 0.0);
        CHECK(energy.remaining >= 0.0);
        CHECK(energy.minimum <= 0.0);
        worst.see(std::abs(energy.incident + energy.at_touch - energy.remaining - energy.potential -
                           energy.dissipated - energy.plastic - energy.jumps) /
                      size_of(energy),
                  describe(impact));
        worst.see(std::abs(energy.residual) / size_of(energy), describe(impact));
        CHECK(energy.plastic >= 0.0);
        CHECK(result.yielded == (energy.plastic > 0.0));
        yielded += result.yielded ? 1 : 0;
        captures += result.outcome == Outcome::capture ? 1 : 0;
        if (result.outcome == Outcome::rebound) {
            CHECK(relative_difference(energy.remaining, result.restitution * result.restitution * kinetic) <
                  1e-14);
            ContactPair elastic = impact.contact;
            elastic.yield_pressure = infinity;
            const double breaking = work_of_breaking(impact.law, elastic, impact.detachment);
            const bool at_a_place = impact.detachment != Detachment::zero_force;
            if (at_a_place && !result.yielded) {
                CHECK(std::abs(energy.potential + energy.jumps - energy.at_touch - breaking) <
                      1e-12 * size_of(energy));
            }
        }
    });
    CHECK(captures > 10);
    CHECK(yielded > 20);
    CHECK_MESSAGE(worst.deviation() < 1e-12, worst.where());
}

TEST_CASE("the dissipated energy is the work of damping, integrated by itself along the motion") {
    Worst worst;
    for_each_damped_impact([&](const Impact& impact) {
        double approach = 0.0;
        double rebound = 0.0;
        const auto add_work = [&](const auto& branch, const MotionExpansion<Extended>& x, Extended used) {
            const double work = integral(
                [&](double part) {
                    const MotionState<Extended> s = x.at(part * used);
                    return static_cast<double>(branch.damping(s.position) * s.velocity * s.velocity *
                                               branch.slope(s.position) * used);
                },
                0.0, 1.0);
            (x.velocity[0] > 0 ? approach : rebound) += work;
        };
        const auto scaled = scaled_impact<Extended>(impact, Precision::extended);
        const Orbit<Extended> orbit = follow(scaled, add_work);
        // The ledger of a capture ends at the greatest overlap.
        const double work = orbit.outcome == Outcome::rebound ? approach + rebound : approach;
        worst.see(relative_difference(work * scaled.scale.energy(), solved(impact).energy.dissipated),
                  describe(impact));
    });
    CHECK(worst.count() > 500);
    CHECK_MESSAGE(worst.deviation() < 1e-12, worst.where());
}

// JKR without damping: the dynamic solver against the analytic separation energy (Eqs. 28-30, exact
// constants).

TEST_CASE("undamped JKR impacts rebound with e = sqrt(1 - (v_s/v)^2)") {
    Worst worst;
    for (const End& end : ends) {
        for (const double w : ash_adhesions) {
            const double v_s = analytic_velocity(w, end.separation);
            for (const double ratio : {1.0001, 1.01, 1.5, 3.0, 10.0, 1000.0}) {
                const Impact impact = impact_of({Law::of<Jkr>(), DampingLaw::constant, end.detachment},
                                                ash(w), 0.0, ratio * v_s);
                const double expected = std::sqrt((1.0 - 1.0 / ratio) * (1.0 + 1.0 / ratio));
                worst.see(std::abs(solved(impact).restitution - expected), describe(impact));
            }
        }
    }
    CHECK(worst.count() == 36);
    CHECK_MESSAGE(worst.deviation() < 1e-10, worst.where());
}

TEST_CASE("the dynamic critical velocity of undamped JKR is the analytic v_s to rounding") {
    for (const End& end : ends) {
        for (const double w : ash_adhesions) {
            const CriticalVelocity critical = critical_velocity({Law::of<Jkr>(), end.detachment, {}, ash(w)});
            REQUIRE(critical.value);
            CHECK(relative_difference(*critical.value, analytic_velocity(w, end.separation)) < 1e-14);
            CHECK(critical.dissipated == 0.0);
        }
    }
}

TEST_CASE("the break costs 7.092196 or, at the largest tension, 3.502602 (w^5 R^4/E*^2)^(1/3)") {
    const ContactPair pair = ash(0.3);
    const double unit = std::cbrt(std::pow(0.3, 5) * std::pow(44e-6, 4) / (90e9 * 90e9));
    const auto constant = [&](Detachment detachment) {
        return critical_velocity({Law::of<Jkr>(), detachment, {}, pair}).detachment_energy / unit;
    };
    const double five_thirds = std::pow(std::numbers::pi, 5.0 / 3.0);
    CHECK(relative_difference(constant(Detachment::pull_off), 7.0921959718639584) < 1e-14);
    CHECK(relative_difference(constant(Detachment::pull_off),
                              five_thirds * (6.0 * std::pow(2.0, 2.0 / 3.0) + 1.0) / 10.0) < 1e-14);
    CHECK(relative_difference(constant(Detachment::load_controlled), 3.5026019718352908) < 1e-14);
    CHECK(constant(Detachment::zero_overlap) == 0.0);
}

TEST_CASE(
    "a faster impact rebounds faster, goes deeper and, with damping from first touch, keeps more of its "
    "velocity") {
    for (const ContactCase& c : elastic_cases()) {
        CAPTURE(name_of(c));
        Impact impact = impact_of(c, ash(0.3), 0.3, 2.0);
        ImpactResult before{};
        int rebounds = 0;
        for (impact.velocity = 0.02; impact.velocity < 50.0; impact.velocity *= 1.25) {
            CAPTURE(impact.velocity);
            const ImpactResult now = solved(impact);
            CHECK(now.maximum_overlap >= before.maximum_overlap);
            if (now.outcome == Outcome::capture) {
                CHECK(before.restitution == 0.0);  // captured below, rebounding above, never the other way
                CHECK(now.restitution == 0.0);
            } else {
                ++rebounds;
                CHECK(now.restitution > 0.0);
                CHECK(now.restitution < 1.0);
                CHECK(now.rebound_velocity > before.rebound_velocity);
                if (!vanishes_at_touch(c.damping_law)) CHECK(now.restitution > before.restitution);
            }
            before = now;
        }
        CHECK(rebounds > 5);
    }
}

TEST_CASE("more damping: less restitution, less overlap, a later end") {
    for (const ContactCase& c : contact_cases()) {
        for (const double w : ash_adhesions) {
            ImpactResult before = solved(impact_of(c, ash(w), 0.0, 2.0));
            for (const double number : geometric(0.01, 1.3, 3.0)) {
                const ImpactResult now = solved(impact_of(c, ash(w), number, 2.0));
                CAPTURE(name_of(c));
                CAPTURE(w);
                CAPTURE(number);
                CHECK(now.maximum_overlap < before.maximum_overlap);
                if (now.outcome == Outcome::capture) {
                    CHECK(now.restitution == 0.0);
                    before = now;
                    continue;
                }
                REQUIRE(before.outcome == Outcome::rebound);
                CHECK(now.restitution < before.restitution);
                if (c.detachment != Detachment::zero_force) CHECK(*now.contact_time > *before.contact_time);
                before = now;
            }
        }
    }
}

TEST_CASE("critical velocity rises with damping, and once every impact is captured it stays so") {
    for (const ContactCase& c : elastic_cases()) {
        for (const double w : ash_adhesions) {
            double before = 0.0;
            bool always = false;
            for (const double number : geometric(0.01, 1.5, 8.0)) {
                const Impact impact = impact_of(c, ash(w), number, 2.0);
                const CriticalVelocity now = critical_of(impact);
                CAPTURE(describe(impact));
                if (always) CHECK(now.verdict == CaptureVerdict::always_captured);
                always = now.verdict == CaptureVerdict::always_captured;
                if (now.verdict == CaptureVerdict::never_captured) CHECK(before == 0.0);
                if (now.verdict == CaptureVerdict::finite) {
                    CHECK(*now.value > before);
                    before = *now.value;
                }
            }
        }
    }
}

// Without adhesion every law is Hertz; with ever less of it every law tends to Hertz.

TEST_CASE("an impact without adhesion is that of Hertz") {
    Worst worst;
    for (const ContactCase& c : elastic_cases()) {
        for (const double v : ash_velocities) {
            for (const double number : damping_numbers) {
                const Impact impact = impact_of(c, ash(0.0), number, v);
                worst.see(difference(solved(impact), solved(hertz_of(impact))), describe(impact));
            }
        }
    }
    CHECK(worst.count() == static_cast<int>(elastic_cases().size()) * 9);
    CHECK_MESSAGE(worst.deviation() < 1e-14, worst.where());
}

TEST_CASE("an impact tends to that of Hertz as adhesion vanishes, at least with its square root") {
    Worst last;
    Worst decline;
    for (const ContactCase& c : elastic_cases()) {
        const auto distance = [&](double w) {
            const Impact impact = impact_of(c, ash(w), 0.3, 2.0);
            return difference(solved(impact), solved(hertz_of(impact)));
        };
        for (int power = -4; power > -13; power -= 2) {
            const double w = std::pow(10.0, power);
            const double before = distance(w);
            // A hundredth of the adhesion leaves a tenth of the difference, until that is rounding.
            if (before > 1e-12) decline.see(distance(w / 100) / before, name_of(c));
        }
        last.see(distance(1e-14), name_of(c));
    }
    CHECK_MESSAGE(decline.deviation() < 0.11, decline.where());
    CHECK_MESSAGE(last.deviation() < 2e-8, last.where());
}

TEST_CASE("the static force tends to that of Hertz as adhesion vanishes") {
    const double overlap = 1.3e-7;
    const double hertz = StaticCurve(Law::of<Hertz>(), ash(0.3)).at_overlap(overlap).force();
    for (std::size_t i = 0; i < Law::count(); ++i) {
        const auto distance = [&](double w) {
            return relative_difference(StaticCurve(Law::at(i), ash(w)).at_overlap(overlap).force(), hertz);
        };
        CAPTURE(Law::at(i).name());
        CHECK(distance(0.0) < 1e-15);
        CHECK(distance(1e-8) <= std::max(0.11 * distance(1e-6), 1e-13));
        CHECK(distance(1e-12) < 1e-6);
    }
}

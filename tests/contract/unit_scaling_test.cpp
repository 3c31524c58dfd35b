// SPDX-License-Identifier: GPL-3.0-or-later
// In other units of length, mass and time every result is the same number times its dimension.
#include <cmath>

#include <doctest/doctest.h>

#include "core/units/units.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/contact/pair.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/motion/damping_inversion.hpp"
#include "solver/motion/trajectory.hpp"
#include "tests/relative_difference.hpp"
#include "tests/support/contact_cases.hpp"
#include "tests/support/worst.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

constexpr double length = 7.3;
constexpr double mass = 0.21;
constexpr double time_unit = 3.7;

constexpr double velocity = length / time_unit;
constexpr double energy = mass * velocity * velocity;
constexpr double force = energy / length;

/// The old SI unit of a dimension in the new one.
double unit_of(Dimension dimension) {
    const auto powers = read_unit(si_unit(dimension)).value().powers;
    return std::pow(length, powers[0]) * std::pow(mass, powers[1]) * std::pow(time_unit, powers[2]);
}

ParameterValues<double> in_other_units(const ParameterValues<double>& values) {
    ParameterValues<double> converted;
    for (const LawParameter& parameter : law_parameters())
        if (values.has(parameter))
            converted.set(parameter.name, values[parameter] * unit_of(parameter.dimension));
    return converted;
}

ContactPair in_other_units(const ContactPair& pair) {
    return {.mass = pair.mass * mass,
            .effective_radius = pair.effective_radius * length,
            .contact_modulus = pair.contact_modulus * force / (length * length),
            .work_of_adhesion = pair.work_of_adhesion * energy / (length * length),
            .yield_pressure = pair.yield_pressure * force / (length * length),
            .parameters = in_other_units(pair.parameters)};
}

Damping in_other_units(const Damping& damping) {
    return {damping.law, damping.coefficient * unit_of(dimension_of(damping.law))};
}

Impact in_other_units(const Impact& impact) {
    return {.law = impact.law,
            .detachment = impact.detachment,
            .damping = in_other_units(impact.damping),
            .contact = in_other_units(impact.contact),
            .velocity = impact.velocity * velocity};
}

/// Sees two results, the second in the other units.
class Comparison {
  public:
    explicit Comparison(std::string where) : where_(std::move(where)) {}

    Comparison& same(double a, double b, double unit) {
        worst.see(relative_difference(a * unit, b), where_);
        return *this;
    }
    Comparison& same(const std::optional<double>& a, const std::optional<double>& b, double unit) {
        CHECK(a.has_value() == b.has_value());
        return a && b ? same(*a, *b, unit) : *this;
    }
    /// Entries that may cancel to rounding, relative to the largest.
    Comparison& same_within(double a, double b, double unit, double size) {
        worst.see(std::abs(a * unit - b) / (size * unit), where_);
        return *this;
    }

    static inline Worst worst;

  private:
    std::string where_;
};

}  // namespace

TEST_CASE("impacts scale with their units") {
    Comparison::worst = {};
    for (const ContactCase& c : contact_cases()) {
        for (const double w : ash_adhesions) {
            for (const double number : damping_numbers) {
                const Impact impact = impact_of(c, ash(w), number, 2.0);
                const ImpactResult a = solved(impact);
                const ImpactResult b = solved(in_other_units(impact));
                CHECK(a.outcome == b.outcome);
                const double size = a.energy.incident + std::abs(a.energy.minimum);
                Comparison(describe(impact))
                    .same(a.restitution, b.restitution, 1.0)
                    .same(a.rebound_velocity, b.rebound_velocity, velocity)
                    .same(a.contact_time, b.contact_time, time_unit)
                    .same(a.approach_time, b.approach_time, time_unit)
                    .same(a.maximum_overlap, b.maximum_overlap, length)
                    .same(a.energy.incident, b.energy.incident, energy)
                    .same(a.energy.dissipated, b.energy.dissipated, energy)
                    .same(a.energy.remaining, b.energy.remaining, energy)
                    .same(a.energy.minimum, b.energy.minimum, energy)
                    .same(a.energy.plastic, b.energy.plastic, energy)
                    .same_within(a.energy.potential, b.energy.potential, energy, size)
                    .same_within(a.energy.at_touch, b.energy.at_touch, energy, size);
            }
        }
    }
    CHECK(Comparison::worst.count() > 1000);
    CHECK_MESSAGE(Comparison::worst.deviation() < 1e-12, Comparison::worst.where());
}

TEST_CASE("critical velocities scale with their units") {
    Comparison::worst = {};
    for (const ContactCase& c : contact_cases()) {
        for (const double number : damping_numbers) {
            const Impact impact = impact_of(c, ash(0.3), number, 2.0);
            const Impact other = in_other_units(impact);
            const CriticalVelocity a = critical_of(impact);
            const CriticalVelocity b = critical_of(other);
            CHECK(a.verdict == b.verdict);
            Comparison(describe(impact))
                .same(a.value, b.value, velocity)
                .same(a.contact_time, b.contact_time, time_unit)
                .same(a.maximum_overlap, b.maximum_overlap, length)
                .same(a.dissipated, b.dissipated, energy)
                .same_within(a.detachment_energy, b.detachment_energy, energy,
                             a.dissipated + std::abs(a.detachment_energy) + 1e-300);
        }
    }
    CHECK(Comparison::worst.count() > 50);
    CHECK_MESSAGE(Comparison::worst.deviation() < 1e-12, Comparison::worst.where());
}

TEST_CASE("damping from restitution scales with its unit") {
    Comparison::worst = {};
    for (const ContactCase& c : contact_cases()) {
        for (const double e : {0.2, 0.7}) {
            DampingProblem problem{c.law, c.detachment, c.damping_law, ash(0.3), 2.0, e};
            problem.contact.yield_pressure = c.yield_pressure;
            const DampingInversion a = damping_from_restitution(problem);
            problem.contact = in_other_units(problem.contact);
            problem.velocity *= velocity;
            const DampingInversion b = damping_from_restitution(problem);
            Comparison(name_of(c))
                .same(a.damping.coefficient, b.damping.coefficient, unit_of(dimension_of(c.damping_law)))
                .same(a.greatest_restitution, b.greatest_restitution, 1.0);
        }
    }
    CHECK(Comparison::worst.count() > 50);
    CHECK_MESSAGE(Comparison::worst.deviation() < 1e-12, Comparison::worst.where());
}

TEST_CASE("trajectories scale with their units") {
    Comparison::worst = {};
    for (const ContactCase& c : contact_cases()) {
        const Impact impact = impact_of(c, ash(0.3), 0.3, 2.0);
        const auto a = trajectory(impact, 9);
        const auto b = trajectory(in_other_units(impact), 9);
        REQUIRE(a.size() == b.size());
        for (std::size_t i = 1; i + 1 < a.size(); ++i) {
            const double newton = a[i].repulsive_force - a[i].attractive_force;
            Comparison(describe(impact))
                .same(a[i].time, b[i].time, time_unit)
                .same(a[i].overlap, b[i].overlap, length)
                .same(a[i].contact_radius, b[i].contact_radius, length)
                .same_within(a[i].velocity, b[i].velocity, velocity, impact.velocity)
                .same_within(a[i].repulsive_force, b[i].repulsive_force, force, newton)
                .same_within(a[i].attractive_force, b[i].attractive_force, force, newton)
                .same_within(a[i].damping_force, b[i].damping_force, force, newton);
        }
    }
    CHECK(Comparison::worst.count() > 500);
    CHECK_MESSAGE(Comparison::worst.deviation() < 1e-12, Comparison::worst.where());
}

// SPDX-License-Identifier: GPL-3.0-or-later

// Every registered damping law: its shape, its unit, its limit and the guess that searches start from.
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>

#include <doctest/doctest.h>

#include "core/units/units.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/contact/pair.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/damping/registry.hpp"
#include "solver/motion/damping_inversion.hpp"
#include "solver/motion/scale.hpp"
#include "solver/motion/trajectory.hpp"
#include "solver/numeric/number.hpp"
#include "tests/support/checks.hpp"
#include "tests/support/contact_cases.hpp"

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

constexpr double length_unit = 7.3;
constexpr double mass_unit = 0.21;
constexpr double time_unit = 3.7;

constexpr double velocity_unit = length_unit / time_unit;
constexpr double energy_unit = mass_unit * velocity_unit * velocity_unit;
constexpr double force_unit = energy_unit / length_unit;

/// The old SI unit of a dimension in the new one.
double unit_of(Dimension dimension) {
    const auto powers = read_unit(si_unit(dimension)).value().powers;
    return std::pow(length_unit, powers[0]) * std::pow(mass_unit, powers[1]) * std::pow(time_unit, powers[2]);
}

ParameterValues<double> in_other_units(const ParameterValues<double>& values) {
    ParameterValues<double> converted;
    for (const LawParameter& parameter : law_parameters())
        if (values.has(parameter))
            converted.set(parameter.name, values[parameter] * unit_of(parameter.dimension));
    return converted;
}

ContactPair in_other_units(const ContactPair& pair) {
    return {.mass = pair.mass * mass_unit,
            .effective_radius = pair.effective_radius * length_unit,
            .contact_modulus = pair.contact_modulus * force_unit / (length_unit * length_unit),
            .work_of_adhesion = pair.work_of_adhesion * energy_unit / (length_unit * length_unit),
            .yield_pressure = pair.yield_pressure * force_unit / (length_unit * length_unit),
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
            .velocity = impact.velocity * velocity_unit};
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

TEST_CASE("a damping law stands where its name does, and shape is never negative") {
    for (std::size_t i = 0; i < all_values<DampingLaw>.size(); ++i) {
        const DampingLaw law = all_values<DampingLaw>[i];
        CAPTURE(name_of(all_values<DampingLaw>[i]));
        CHECK(static_cast<std::size_t>(law) == i);
        const auto page = "../../docs/laws/" + std::string(name_of(law)) + ".md";
        CHECK(std::filesystem::exists(std::filesystem::path(ASHIMPACT_TEST_DATA) / page));
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

// In other units of length, mass and time every result is the same number times its dimension.

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
                    .same(a.rebound_velocity, b.rebound_velocity, velocity_unit)
                    .same(a.contact_time, b.contact_time, time_unit)
                    .same(a.approach_time, b.approach_time, time_unit)
                    .same(a.maximum_overlap, b.maximum_overlap, length_unit)
                    .same(a.energy.incident, b.energy.incident, energy_unit)
                    .same(a.energy.dissipated, b.energy.dissipated, energy_unit)
                    .same(a.energy.remaining, b.energy.remaining, energy_unit)
                    .same(a.energy.minimum, b.energy.minimum, energy_unit)
                    .same(a.energy.plastic, b.energy.plastic, energy_unit)
                    .same_within(a.energy.potential, b.energy.potential, energy_unit, size)
                    .same_within(a.energy.at_touch, b.energy.at_touch, energy_unit, size);
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
                .same(a.value, b.value, velocity_unit)
                .same(a.contact_time, b.contact_time, time_unit)
                .same(a.maximum_overlap, b.maximum_overlap, length_unit)
                .same(a.dissipated, b.dissipated, energy_unit)
                .same_within(a.detachment_energy, b.detachment_energy, energy_unit,
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
            problem.velocity *= velocity_unit;
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
                .same(a[i].overlap, b[i].overlap, length_unit)
                .same(a[i].contact_radius, b[i].contact_radius, length_unit)
                .same_within(a[i].velocity, b[i].velocity, velocity_unit, impact.velocity)
                .same_within(a[i].repulsive_force, b[i].repulsive_force, force_unit, newton)
                .same_within(a[i].attractive_force, b[i].attractive_force, force_unit, newton)
                .same_within(a[i].damping_force, b[i].damping_force, force_unit, newton);
        }
    }
    CHECK(Comparison::worst.count() > 500);
    CHECK_MESSAGE(Comparison::worst.deviation() < 1e-12, Comparison::worst.where());
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/mechanics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "solver/contact/cohesive_zone.hpp"
#include "solver/contact/maugis_dugdale.hpp"
#include "solver/numeric/number.hpp"

namespace ashimpact {

namespace {

using std::numbers::pi;

/// K = (4/3) E* of Maugis and of the paper [Pa].
double maugis_modulus(const ContactPair& contact) {
    return 4.0 / 3.0 * contact.contact_modulus;
}

/// W_s of JKR in units of Maugis: (6 2^(2/3) + 1)/10 (16/9)^(1/3).
const double jkr_energy = (6.0 * std::cbrt(4.0) + 1.0) / 10.0 * std::cbrt(16.0 / 9.0);

/// Angle arccos((2a^2 - c^2 - r^2)/(c^2 - r^2)) of the cohesive traction, without cancellation at either end.
double cohesive_angle(double a, double c, double r) {
    return 2.0 * std::atan2(std::sqrt((c - a) * (c + a)), std::sqrt((a - r) * (a + r)));
}

}  // namespace

MaugisUnits maugis_units(const ContactPair& contact) {
    const double radius = contact.effective_radius;
    const double ratio = pi * contact.work_of_adhesion / maugis_modulus(contact);
    return {.radius = std::cbrt(ratio * radius * radius),
            .overlap = std::cbrt(ratio * ratio * radius),
            .force = pi * contact.work_of_adhesion * radius};
}

double cohesive_stress_of_range(double work_of_adhesion, double range) {
    return 16.0 / (9.0 * std::numbers::sqrt3) * work_of_adhesion / range;
}

double transition_parameter(const ContactPair& contact, double stress) {
    const double modulus = maugis_modulus(contact);
    return 2.0 * stress *
           std::cbrt(contact.effective_radius / (pi * contact.work_of_adhesion * modulus * modulus));
}

double stated_transition_parameter(const ContactPair& contact) {
    const ParameterValues<double>& given = contact.parameters;
    if (given.has(stated_tabor)) return transition_per_tabor() * given[stated_tabor];
    const double stress = given.has(cohesive_stress)
                              ? given[cohesive_stress]
                              : cohesive_stress_of_range(contact.work_of_adhesion, given[cohesion_range]);
    return transition_parameter(contact, stress);
}

double transition_parameter(const ContactPair& contact) {
    const double lambda = stated_transition_parameter(contact);
    if (is_computed_transition(lambda)) return lambda;
    throw InputError("the transition parameter of law maugis-dugdale is " + shortest(lambda),
                     "1e-4 to 1e6; law dmt below, law jkr above");
}

double transition_per_tabor() {
    static const double ratio = 32.0 / (9.0 * std::numbers::sqrt3) * std::cbrt(9.0 / (16.0 * pi));
    return ratio;
}

double cohesive_separation_energy(const ContactPair& contact, double lambda) {
    if (contact.work_of_adhesion == 0.0) return 0.0;
    return static_cast<double>(CohesiveZone(lambda).separation_energy()) * maugis_units(contact).energy();
}

double cohesive_separation_velocity(const ContactPair& contact, double lambda) {
    return std::sqrt(2.0 * cohesive_separation_energy(contact, lambda) / contact.mass);
}

double fitted_energy_ratio(double lambda) {
    if (lambda <= 0.655) return 8704.0 / (243.0 * power<3>(pi)) * power<5>(lambda) / jkr_energy;
    const double x = 1.0 / lambda;
    return (1.0 + x * (-0.8254 + x * 0.1709)) / (1.0 + x * (-0.0932 + x * (-0.3689 + x * 0.3541)));
}

double carpick_pull_off(double lambda) {
    const double x = 4.04 * std::pow(lambda, 1.4);
    return 7.0 / 4.0 - (x - 1.0) / (4.0 * (x + 1.0));
}

double PressureProfile::at(double radius) const {
    if (radius >= outer_radius && radius > contact_radius) return 0.0;
    if (radius > contact_radius) return -cohesive_stress;
    const double root =
        std::sqrt(std::max(0.0, (1.0 - radius / contact_radius) * (1.0 + radius / contact_radius)));
    double pressure = hertz_pressure * root - even_tension;
    if (rim_tension > 0.0) {
        if (root == 0.0) return -std::numeric_limits<double>::infinity();
        pressure -= rim_tension / root;
    }
    if (cohesive_stress > 0.0)
        pressure -= cohesive_stress / pi * cohesive_angle(contact_radius, outer_radius, radius);
    return pressure;
}

double PressureProfile::neutral_radius() const {
    return contact_radius * std::sqrt(std::max(0.0, 1.0 - rim_tension / hertz_pressure));
}

double PressureProfile::force() const {
    const double a = contact_radius;
    const double c = outer_radius;
    const double punch = 2.0 * pi * a * a * (hertz_pressure / 3.0 - rim_tension - even_tension / 2.0);
    if (!(cohesive_stress > 0.0)) return punch;
    const double reach = std::sqrt((c - a) * (c + a));
    return punch - 2.0 * cohesive_stress * (a * reach + c * c * std::atan2(reach, a));
}

PressureProfile hertz_pressure(const ContactPair& contact, double a) {
    return {.contact_radius = a,
            .outer_radius = a,
            .hertz_pressure = 2.0 * contact.contact_modulus * a / (pi * contact.effective_radius)};
}

PressureProfile jkr_pressure(const ContactPair& contact, double a) {
    PressureProfile profile = hertz_pressure(contact, a);
    if (contact.work_of_adhesion == 0.0 || a == 0.0) return profile;
    profile.rim_tension = std::sqrt(2.0 * contact.work_of_adhesion * contact.contact_modulus / (pi * a));
    return profile;
}

PressureProfile maugis_dugdale_pressure(const ContactPair& contact, double lambda, double a) {
    PressureProfile profile = hertz_pressure(contact, a);
    const MaugisUnits units = maugis_units(contact);
    const CohesiveState state = CohesiveZone(lambda).at_contact_radius(a / units.radius);
    profile.outer_radius = static_cast<double>(state.cohesive_radius) * units.radius;
    profile.cohesive_stress = lambda / 2.0 * units.force / (units.radius * units.radius);
    return profile;
}

std::vector<double> jkr_radii(const ContactPair& contact, double force) {
    const double tension = pi * contact.work_of_adhesion * contact.effective_radius;
    const double square = 6.0 * tension * force + 9.0 * tension * tension;
    if (!(square >= 0.0) || force <= -1.5 * tension) return {};
    const double compliance = contact.effective_radius / (4.0 / 3.0 * contact.contact_modulus);
    std::vector<double> radii{std::cbrt(compliance * (force + 3.0 * tension + std::sqrt(square)))};
    if (force <= -5.0 / 6.0 * tension)
        radii.push_back(std::cbrt(compliance * (force + 3.0 * tension - std::sqrt(square))));
    return radii;
}

}  // namespace ashimpact

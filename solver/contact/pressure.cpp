// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/pressure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "solver/contact/cohesive_zone.hpp"
#include "solver/contact/transition.hpp"

namespace ashimpact {

namespace {

using std::numbers::pi;

/// Angle arccos((2a^2 - c^2 - r^2)/(c^2 - r^2)) of the cohesive traction, without cancellation at either end.
double cohesive_angle(double a, double c, double r) {
    return 2.0 * std::atan2(std::sqrt((c - a) * (c + a)), std::sqrt((a - r) * (a + r)));
}

}  // namespace

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

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/transition.hpp"

#include <cmath>
#include <numbers>

#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "solver/contact/cohesive_zone.hpp"
#include "solver/contact/maugis_dugdale.hpp"
#include "solver/numeric/power.hpp"

namespace ashimpact {

namespace {

using std::numbers::pi;

/// K = (4/3) E* of Maugis and of the paper [Pa].
double maugis_modulus(const ContactPair& contact) {
    return 4.0 / 3.0 * contact.contact_modulus;
}

/// W_s of JKR in units of Maugis: (6 2^(2/3) + 1)/10 (16/9)^(1/3).
const double jkr_energy = (6.0 * std::cbrt(4.0) + 1.0) / 10.0 * std::cbrt(16.0 / 9.0);

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

double transition_parameter(const ContactPair& contact) {
    const ParameterValues<double>& given = contact.parameters;
    double lambda = 0.0;
    if (given.has(stated_tabor)) {
        lambda = transition_per_tabor() * given[stated_tabor];
    } else {
        const double stress = given.has(cohesive_stress)
                                  ? given[cohesive_stress]
                                  : cohesive_stress_of_range(contact.work_of_adhesion, given[cohesion_range]);
        lambda = transition_parameter(contact, stress);
    }
    if (lambda >= 1e-4 && lambda <= 1e6) return lambda;
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

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/analytic.hpp"

#include <cmath>

#include "materials/contact_properties.hpp"
#include "materials/separation_energy.hpp"
#include "solver/contact/transition.hpp"
#include "solver/motion/regime.hpp"

namespace ashimpact {

namespace {

/// Eq. 30 for a cohesion of finite range: between 0 (DMT) and the value of JKR.
CohesiveVelocity cohesive(const ContactPair& contact, double jkr_energy) {
    const double lambda = transition_parameter_of(contact);
    const double energy = lambda > 0 ? cohesive_separation_energy(contact, lambda) : 0;
    const double fitted = lambda > 0 ? fitted_energy_ratio(lambda) * jkr_energy : 0;
    const auto with_velocity = [&](double separated) {
        return AnalyticVelocity{separated, std::sqrt(2 * separated / contact.mass)};
    };
    return {with_velocity(energy), lambda, with_velocity(fitted), fitted_energy_error};
}

SampleAnalytic analytic_of(const SampleContact& sample) {
    const AdhesiveContact contact{.work_of_adhesion = sample.pair.work_of_adhesion,
                                  .effective_radius = sample.pair.effective_radius,
                                  .contact_modulus = sample.pair.contact_modulus};
    // Of two spheres m* and R* are those of one sphere of this density on a wall.
    const double density = sample.partner ? sphere_density(sample.pair.effective_radius, sample.pair.mass)
                                          : sample.density.value();
    SampleAnalytic analytic{{separation_energy(contact), separation_velocity(contact, density)}, sample.name};
    analytic.load_controlled = {separation_energy(contact, Separation::load_controlled),
                                separation_velocity(contact, density, Separation::load_controlled)};
    analytic.with_printed_constants = {dong2013::separation_energy(contact),
                                       dong2013::separation_velocity(contact, density)};
    analytic.maugis_dugdale = cohesive(sample.pair, analytic.separation_energy);
    return analytic;
}

}  // namespace

AnalyticResult analytic_stage(const ContactResult& contacts, StageRecord& record) {
    record.citations = {"dong2013, Eqs. 28-30", "thornton1998"};
    AnalyticResult result;
    for (const SampleContact& sample : contacts.samples) result.samples.push_back(analytic_of(sample));
    return result;
}

}  // namespace ashimpact

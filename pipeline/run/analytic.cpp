// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/analytic.hpp"

#include <cmath>

#include "materials/contact_properties.hpp"
#include "materials/separation_energy.hpp"
#include "pipeline/document/quantity_json.hpp"
#include "pipeline/run/contact.hpp"
#include "solver/contact/maugis/transition.hpp"
#include "solver/motion/regime.hpp"

namespace ashimpact {

namespace {

Json pair_json(double energy, double velocity) {
    return {{"separation_energy", quantity_json(energy, Dimension::energy)},
            {"critical_velocity", quantity_json(velocity, Dimension::velocity)}};
}

/// Eq. 30 for a cohesion of finite range: between 0 (DMT) and the value of JKR.
Json cohesive_json(const ContactPair& contact, double jkr_energy) {
    const double lambda = transition_parameter_of(contact);
    const double energy = lambda > 0 ? cohesive_separation_energy(contact, lambda) : 0;
    const double fitted = lambda > 0 ? fitted_energy_ratio(lambda) * jkr_energy : 0;
    Json json = pair_json(energy, std::sqrt(2 * energy / contact.mass));
    json["transition_parameter"] = lambda;
    json["fitted"] = pair_json(fitted, std::sqrt(2 * fitted / contact.mass));
    json["fitted"]["relative_error_of_energy"] = fitted_energy_error;
    return json;
}

Json analytic_json(const SampleContact& sample) {
    const AdhesiveContact contact{.work_of_adhesion = sample.pair.work_of_adhesion,
                                  .effective_radius = sample.pair.effective_radius,
                                  .contact_modulus = sample.pair.contact_modulus};
    // Of two spheres m* and R* are those of one sphere of this density on a wall.
    const double density = sample.partner ? sphere_density(sample.pair.effective_radius, sample.pair.mass)
                                          : sample.density.value;
    Json json{{"name", sample.name}};
    json.update(pair_json(separation_energy(contact), separation_velocity(contact, density)));
    json["load_controlled"] = pair_json(separation_energy(contact, Separation::load_controlled),
                                        separation_velocity(contact, density, Separation::load_controlled));
    json["with_printed_constants"] =
        pair_json(dong2013::separation_energy(contact), dong2013::separation_velocity(contact, density));
    json["maugis_dugdale"] = cohesive_json(sample.pair, separation_energy(contact));
    return json;
}

}  // namespace

StageOutput analytic_stage(const Artifacts& before) {
    StageOutput output{.citations = {"dong2013, Eqs. 28-30", "thornton1998"}};
    output.options = {{"separation", "pull-off"},
                      {"energy_constant", separation_energy_constant(Separation::pull_off)},
                      {"velocity_constant", separation_velocity_constant(Separation::pull_off)},
                      {"modulus", "contact modulus E* (the paper prints Young's modulus)"},
                      {"adhesion", "work of adhesion w (the paper prints a surface energy)"}};
    output.result["samples"] = Json::array();
    for (const SampleContact& sample : before.read(contact_artifact, read_contacts))
        output.result["samples"].push_back(analytic_json(sample));
    return output;
}

std::vector<SampleAnalytic> read_analytic(const View& result) {
    std::vector<SampleAnalytic> samples;
    for (const View& sample : result.at("samples").elements())
        samples.push_back({.name = sample.at("name").text(),
                           .separation_energy = sample.at("separation_energy").number(Dimension::energy),
                           .critical_velocity = sample.at("critical_velocity").number(Dimension::velocity)});
    return samples;
}

}  // namespace ashimpact

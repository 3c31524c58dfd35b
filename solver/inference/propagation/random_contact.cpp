// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/propagation/random_contact.hpp"

#include <algorithm>

#include "core/text/error.hpp"
#include "materials/contact_properties.hpp"

namespace ashimpact {

namespace {

/// Reads values in the order in which the inputs were added.
class Values {
  public:
    explicit Values(std::span<const double> values) : values_(values) {}
    double next() { return values_[used_++]; }

  private:
    std::span<const double> values_;
    std::size_t used_ = 0;
};

void add_mixture(std::vector<RandomInput>& inputs, const Composition& composition) {
    const std::string basis = composition.basis == FractionBasis::weight ? "weight" : "volume";
    const FractionModel& model = composition.model;
    for (std::size_t i = 0; i < model.amounts.size(); ++i) {
        inputs.push_back({.name = basis + " fraction of " + composition.components[i].name,
                          .value = model.amounts[i],
                          .standard_uncertainty = model.uncertainties[i].value_or(0.0)});
    }
    inputs.push_back({.name = "amorphous part",
                      .value = model.parameter,
                      .standard_uncertainty = model.parameter_uncertainty.value_or(0.0)});
    for (const Component& component : composition.components) {
        const bool known = component.phase.young_modulus.uncertainty().has_value();
        inputs.push_back({.name = "Young's modulus of " + component.phase.name,
                          .value = component.phase.young_modulus.value,
                          .standard_uncertainty = modulus_uncertainty(component.phase),
                          .distribution = lognormal_around,
                          .factor = known ? "" : "Young's moduli of unknown uncertainty"});
    }
}

/// @param at is left at the values: copying a mixture would cost more than its modulus
double mixed_modulus(PhaseMixture& at, Values& values) {
    for (double& amount : at.composition.model.amounts) amount = std::max(0.0, values.next());
    at.composition.model.parameter = std::max(0.0, values.next());
    for (Component& component : at.composition.components)
        component.phase.young_modulus.value = values.next();
    return young_modulus_of(at.composition, at.options);
}

double stable_poisson_ratio(double value) {
    return std::clamp(value, -0.99, 0.5);
}

/// The contact modulus that the next values give.
void set_modulus(ContactPair& pair, SphereInContact& sphere, Values& values) {
    if (sphere.contact_modulus) {
        pair.contact_modulus = values.next();
        return;
    }
    ElasticBody particle{.young_modulus = 0.0, .poisson_ratio = stable_poisson_ratio(values.next())};
    ElasticBody wall{.young_modulus = values.next(), .poisson_ratio = 0.0};
    wall.poisson_ratio = stable_poisson_ratio(values.next());
    particle.young_modulus = sphere.mixture ? mixed_modulus(*sphere.mixture, values) : values.next();
    pair.contact_modulus = contact_modulus(particle, wall);
}

}  // namespace

ContactPair RandomContact::nominal() const {
    std::vector<double> values;
    for (const RandomInput& input : inputs) values.push_back(input.value);
    return contact(values);
}

RandomContact random_contact(const SphereInContact& sphere) {
    const int ways =
        (sphere.mixture ? 1 : 0) + (sphere.young_modulus ? 1 : 0) + (sphere.contact_modulus ? 1 : 0);
    if (ways != 1) throw InputError("the modulus is given in " + std::to_string(ways) + " ways", "one");
    RandomContact result;
    result.inputs = {sphere.diameter, sphere.density, sphere.work_of_adhesion};
    if (sphere.contact_modulus) {
        result.inputs.push_back(*sphere.contact_modulus);
    } else {
        result.inputs.insert(result.inputs.end(),
                             {sphere.poisson_ratio, sphere.wall_young_modulus, sphere.wall_poisson_ratio});
        if (sphere.young_modulus) result.inputs.push_back(*sphere.young_modulus);
        if (sphere.mixture) add_mixture(result.inputs, sphere.mixture->composition);
    }
    if (sphere.partner)
        result.inputs.insert(result.inputs.end(), {sphere.partner->diameter, sphere.partner->mass});
    for (const auto& [parameter, input] : sphere.parameters) result.inputs.push_back(input);
    result.contact = [sphere = SphereInContact(sphere)](std::span<const double> all) mutable {
        Values values(all);
        const double radius = 0.5 * values.next();
        ContactPair pair{.mass = sphere_mass(radius, values.next()),
                         .effective_radius = radius,
                         .contact_modulus = 0.0,
                         .work_of_adhesion = values.next(),
                         .yield_pressure = sphere.yield_pressure,
                         .parameters = sphere.other_parameters};
        set_modulus(pair, sphere, values);
        if (sphere.partner) {
            pair.effective_radius = effective_radius(radius, 0.5 * values.next());
            pair.mass = effective_mass(pair.mass, values.next());
        }
        for (const auto& [parameter, input] : sphere.parameters)
            pair.parameters.set(parameter.name, values.next());
        return pair;
    };
    return result;
}

}  // namespace ashimpact

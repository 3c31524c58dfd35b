// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/uncertainty/uncertain_contact.hpp"

#include <algorithm>
#include <cmath>

#include "materials/composition.hpp"
#include "materials/phase_catalogue.hpp"

namespace ashimpact {

namespace {

/// An input that cannot be negative.
RandomInput positive(std::string name, const Quantity& quantity) {
    return {.name = std::move(name),
            .value = quantity.value,
            .standard_uncertainty = quantity.standard_uncertainty.value_or(0),
            .distribution = quantity.value > 0 ? lognormal_around : normal_around};
}

RandomInput ratio(const char* name, const Quantity& quantity) {
    return {.name = name,
            .value = quantity.value,
            .standard_uncertainty = quantity.standard_uncertainty.value_or(0)};
}

Quantity diameter_of(Quantity radius) {
    radius.value *= 2;
    if (radius.standard_uncertainty) *radius.standard_uncertainty *= 2;
    return radius;
}

/// @param law whose parameters are inputs; those of other laws are only carried along
SphereInContact sphere_of(const SampleContact& contact, Law law) {
    const Quantity diameter = diameter_of(contact.radius);
    SphereInContact sphere{
        .diameter = positive("diameter", diameter),
        .density = positive("density", contact.density.quantity),
        .work_of_adhesion = positive("work of adhesion", contact.work_of_adhesion.quantity),
        .yield_pressure = contact.pair.yield_pressure};
    if (contact.partner)
        sphere.partner = {positive("diameter of the partner", diameter_of(contact.partner->radius)),
                          positive("mass of the partner", contact.partner->mass)};
    for (const auto& [parameter, value] : contact.parameters) {
        const auto same = [&, &name = parameter.name](const LawParameter& own) { return own.name == name; };
        if (std::ranges::any_of(law.parameters(), same))
            sphere.parameters.emplace_back(parameter, positive(std::string(parameter.name), value.quantity));
        else
            sphere.other_parameters.set(parameter.name, value.value());
    }
    return sphere;
}

/// The same contact from its phases and wall, where the case describes it that way.
std::optional<RandomContact> from_phases(const Case& data, const Sample& sample, const SampleContact& contact,
                                         Law law) {
    const auto* wall = data.wall ? std::get_if<ElasticWall>(&*data.wall) : nullptr;
    if (wall == nullptr || sample.contact_modulus || !contact.poisson_ratio) return std::nullopt;
    const PhaseCatalogue catalogue({PhaseSet{.name = "case", .phases = data.phases}});
    SphereInContact sphere = sphere_of(contact, law);
    sphere.poisson_ratio = ratio("Poisson's ratio", contact.poisson_ratio->quantity);
    sphere.wall_young_modulus = positive("Young's modulus of the wall", wall->young_modulus.quantity);
    sphere.wall_poisson_ratio = ratio("Poisson's ratio of the wall", wall->poisson_ratio.quantity);
    sphere.mixture = PhaseMixture{compose(sample.analysis, catalogue),
                                  {.rule = data.mixture_rule, .porosity = sample.porosity}};
    RandomContact random = random_contact(sphere);
    constexpr std::ptrdiff_t own = 3;  // size, density and w are not of the modulus
    const bool uncertain = std::any_of(random.inputs.begin() + own, random.inputs.end(),
                                       [](const RandomInput& in) { return in.standard_uncertainty > 0; });
    const double modulus = random.nominal().contact_modulus;
    const bool same = std::abs(modulus / contact.pair.contact_modulus - 1) < 1e-9;
    if (!uncertain || !same) return std::nullopt;
    return random;
}

RandomContact independent_contact(const Case& data, const Sample& sample, const SampleContact& contact,
                                  Law law) {
    if (auto random = from_phases(data, sample, contact, law)) return *std::move(random);
    SphereInContact sphere = sphere_of(contact, law);
    sphere.contact_modulus = positive("contact modulus", contact.contact_modulus.quantity);
    return random_contact(sphere);
}

}  // namespace

RandomContact uncertain_contact(const Case& data, const Sample& sample, const SampleContact& contact, Law law,
                                const CalibrationResponse& response) {
    RandomContact random = independent_contact(data, sample, contact, law);
    if (response.density == 0 && response.work_of_adhesion == 0) return random;
    random.contact = [independent = std::move(random.contact), response,
                      calibrated_at = contact.pair.contact_modulus](std::span<const double> values) {
        ContactPair pair = independent(values);
        const double ratio = pair.contact_modulus / calibrated_at;
        pair.mass *= std::pow(ratio, response.density);
        pair.work_of_adhesion *= std::pow(ratio, response.work_of_adhesion);
        return pair;
    };
    return random;
}

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/modulus.hpp"

#include <set>

#include "core/quantities/readable.hpp"
#include "materials/composition.hpp"
#include "materials/phase_catalogue.hpp"

namespace ashimpact {

namespace {

/// Reuss and Voigt on (K, G), which hold for any arrangement of the phases; without every Poisson ratio the
/// series and parallel models on E take their place.
/// Pores soften them as they soften the chosen rule, by a factor of the porosity and Poisson's ratio alone.
ModulusBounds bounds_of(const ModulusEstimate& estimate, MixtureRule chosen) {
    const double softening = estimate.young_modulus / estimate.by(chosen).value().young_modulus;
    const auto bound = [&](MixtureRule first, MixtureRule second) {
        auto result = estimate.by(first);
        if (!result) result = estimate.by(second).value();
        result->young_modulus *= softening;
        result->standard_uncertainty *= softening;
        return *result;
    };
    const auto quantity = [](const RuleResult& result) {
        return make_quantity(result.young_modulus, Dimension::pressure, result.standard_uncertainty);
    };
    const RuleResult lower = bound(MixtureRule::reuss, MixtureRule::series);
    const RuleResult upper = bound(MixtureRule::voigt, MixtureRule::parallel);
    return {quantity(lower), quantity(upper), lower.rule, upper.rule};
}

void add_citations(const Composition& composition, std::vector<std::string>& citations) {
    std::set<std::string> known(citations.begin(), citations.end());
    const auto add = [&](const PhaseProperty& property) {
        for (const std::string& citation : property.citations)
            if (known.insert(citation).second) citations.push_back(citation);
    };
    for (const Component& component : composition.components) {
        add(component.phase.density);
        add(component.phase.young_modulus);
        if (component.phase.poisson_ratio) add(*component.phase.poisson_ratio);
    }
}

/// The porosity of a sample; where the case gives none, from its density and that of the phases.
std::optional<Porosity> porosity_of(const Sample& sample, const Composition& composition,
                                    StageRecord& record) {
    if (!sample.porosity_from_density) return sample.porosity;
    const PorosityFromDensity found = at_place("the sample " + sample.name, [&] {
        return porosity_from_density(*sample.porosity, sample.density->quantity, composition.density);
    });
    record.note(found.finding, sample.name);
    return found.porosity;
}

}  // namespace

PorosityFromDensity porosity_from_density(Porosity porosity, const Quantity& apparent, double true_density) {
    porosity.value = porosity_from_densities(apparent.value, true_density);
    if (apparent.standard_uncertainty)
        porosity.standard_uncertainty = *apparent.standard_uncertainty / true_density;
    return {porosity,
            {"porosity", Severity::remark,
             "a porosity of " + readable_number(porosity.value) + " follows from the density"}};
}

SampleModulus sample_modulus(const Composition& composition, const ModulusEstimate& estimate,
                             MixtureRule rule) {
    SampleModulus sample{
        .rule = rule,
        .young_modulus =
            make_quantity(estimate.young_modulus, Dimension::pressure, estimate.standard_uncertainty),
        .bounds = bounds_of(estimate, rule),
        .rules = estimate.rules,
        .density = make_quantity(estimate.density, Dimension::density, estimate.density_uncertainty),
        .poisson_ratio = estimate.poisson_ratio,
        .poisson_ratio_assumed = estimate.poisson_ratio_assumed,
        .contributions = estimate.contributions};
    for (const Component& component : composition.components)
        sample.phases.push_back({.name = component.name,
                                 .phase = component.phase.name,
                                 .weight_fraction = component.weight_fraction,
                                 .volume_fraction = component.volume_fraction,
                                 .density = component.phase.density.value,
                                 .young_modulus = component.phase.young_modulus.value});
    return sample;
}

ModulusResult modulus_stage(const Case& data, StageRecord& record) {
    const PhaseCatalogue catalogue({PhaseSet{.name = "case", .phases = data.phases}});
    record.citations = {"dong2013, Eq. 1"};
    ModulusResult result;
    for (const Sample& sample : data.samples) {
        const Composition composition = compose(sample.analysis, catalogue);
        const auto porosity = porosity_of(sample, composition, record);
        const ModulusEstimate estimate =
            estimate_modulus(composition, {.rule = data.mixture_rule, .porosity = porosity});
        SampleModulus modulus = sample_modulus(composition, estimate, data.mixture_rule);
        modulus.name = sample.name;
        modulus.diameter = sample.diameter.quantity;
        result.samples.push_back(std::move(modulus));
        record.note(composition.notes, sample.name);
        record.note(estimate.notes, sample.name);
        add_citations(composition, record.citations);
    }
    return result;
}

}  // namespace ashimpact

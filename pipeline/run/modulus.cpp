// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/modulus.hpp"

#include <set>

#include "pipeline/document/quantity_json.hpp"
#include "pipeline/present/text/readable.hpp"
#include "pipeline/run/read_case_artifact.hpp"

namespace ashimpact {

namespace {

Json phases_json(const Composition& composition) {
    Json phases = Json::array();
    for (const Component& component : composition.components)
        phases.push_back(
            {{"name", component.name},
             {"phase", component.phase.name},
             {"weight_fraction", component.weight_fraction},
             {"volume_fraction", component.volume_fraction},
             {"density", quantity_json(component.phase.density.value, Dimension::density)},
             {"young_modulus", quantity_json(component.phase.young_modulus.value, Dimension::pressure)}});
    return phases;
}

Json rule_json(const RuleResult& result) {
    return make_quantity(result.young_modulus, Dimension::pressure, result.standard_uncertainty);
}

/// Reuss and Voigt on (K, G), which hold for any arrangement of the phases; without every Poisson ratio the
/// series and parallel models on E stand for them.
/// Pores soften them as they soften the chosen rule, by a factor of the porosity and Poisson's ratio alone.
Json bounds_json(const ModulusEstimate& estimate, MixtureRule chosen) {
    const double softening = estimate.young_modulus / estimate.by(chosen).value().young_modulus;
    const auto pick = [&](MixtureRule first, MixtureRule second) {
        const auto result = estimate.by(first);
        return result ? *result : estimate.by(second).value();
    };
    RuleResult lower = pick(MixtureRule::reuss, MixtureRule::series);
    RuleResult upper = pick(MixtureRule::voigt, MixtureRule::parallel);
    for (RuleResult* bound : {&lower, &upper}) {
        bound->young_modulus *= softening;
        bound->standard_uncertainty *= softening;
    }
    return {{"lower", rule_json(lower)},
            {"upper", rule_json(upper)},
            {"lower_rule", name_of(lower.rule)},
            {"upper_rule", name_of(upper.rule)}};
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
                                    std::vector<std::string>& warnings) {
    if (!sample.porosity_from_density) return sample.porosity;
    const PorosityFromDensity found = at_place("the sample " + sample.name, [&] {
        return porosity_from_density(*sample.porosity, sample.density->quantity, composition.density);
    });
    warnings.push_back(sample.name + ": " + found.note);
    return found.porosity;
}

}  // namespace

PorosityFromDensity porosity_from_density(Porosity porosity, const Quantity& apparent, double true_density) {
    porosity.value = porosity_from_densities(apparent.value, true_density);
    if (apparent.standard_uncertainty)
        porosity.standard_uncertainty = *apparent.standard_uncertainty / true_density;
    return {porosity, "a porosity of " + readable_number(porosity.value) + " follows from the density"};
}

Json modulus_json(const Composition& composition, const ModulusEstimate& estimate, MixtureRule rule) {
    Json rules = Json::object();
    for (const RuleResult& result : estimate.rules)
        rules[std::string(name_of(result.rule))] = rule_json(result);
    Json contributions = Json::array();
    for (const Contribution& part : estimate.contributions)
        contributions.push_back({{"input", part.what}, {"share_of_variance", part.share}});
    return {{"phases", phases_json(composition)},
            {"rule", name_of(rule)},
            {"young_modulus",
             make_quantity(estimate.young_modulus, Dimension::pressure, estimate.standard_uncertainty)},
            {"bounds", bounds_json(estimate, rule)},
            {"rules", rules},
            {"density", make_quantity(estimate.density, Dimension::density, estimate.density_uncertainty)},
            {"poisson_ratio", quantity_json(estimate.poisson_ratio, Dimension::fraction)},
            {"poisson_ratio_assumed", estimate.poisson_ratio_assumed},
            {"uncertainty_contributions", contributions}};
}

StageOutput modulus_stage(const Artifacts& before) {
    const Case data = read_case_artifact(before);
    const PhaseCatalogue catalogue({PhaseSet{.name = "case", .phases = data.phases}});
    StageOutput output{.citations = {"dong2013, Eq. 1"}};
    output.options = {{"mixture_rule", name_of(data.mixture_rule)}};
    output.result["samples"] = Json::array();
    for (const Sample& sample : data.samples) {
        const Composition composition = compose(sample.analysis, catalogue);
        const auto porosity = porosity_of(sample, composition, output.warnings);
        const ModulusEstimate estimate =
            estimate_modulus(composition, {.rule = data.mixture_rule, .porosity = porosity});
        Json json{{"name", sample.name}, {"diameter", sample.diameter.quantity}};
        json.update(modulus_json(composition, estimate, data.mixture_rule));
        output.result["samples"].push_back(std::move(json));
        for (const auto& notes : {composition.notes, estimate.notes})
            for (const std::string& note : notes) output.warnings.push_back(sample.name + ": " + note);
        add_citations(composition, output.citations);
    }
    return output;
}

std::vector<SampleModulus> read_moduli(const View& result) {
    std::vector<SampleModulus> samples;
    for (const View& sample : result.at("samples").elements()) {
        SampleModulus modulus{.name = sample.at("name").text(),
                              .young_modulus = sample.at("young_modulus").quantity(Dimension::pressure),
                              .poisson_ratio = {},
                              .density = sample.at("density").number(Dimension::density)};
        if (const auto nu = sample.find("poisson_ratio"))
            modulus.poisson_ratio = nu->number(Dimension::fraction);
        samples.push_back(std::move(modulus));
    }
    return samples;
}

}  // namespace ashimpact

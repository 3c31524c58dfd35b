// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/json/view.hpp"
#include "pipeline/document/results/fields.hpp"
#include "pipeline/document/results/results_json.hpp"

namespace ashimpact {

namespace {

Json phase_share_json(const PhaseShare& share) {
    return {{"name", share.name},
            {"phase", share.phase},
            {"weight_fraction", share.weight_fraction},
            {"volume_fraction", share.volume_fraction},
            {"density", quantity_json(share.density, Dimension::density)},
            {"young_modulus", quantity_json(share.young_modulus, Dimension::pressure)}};
}

PhaseShare read_phase_share(const View& node) {
    return {.name = node.at("name").text(),
            .phase = text_if(node, "phase"),
            .weight_fraction = node.at("weight_fraction").number(Dimension::fraction),
            .volume_fraction = node.at("volume_fraction").number(Dimension::fraction),
            .density = number_if(node, "density", Dimension::density),
            .young_modulus = number_if(node, "young_modulus", Dimension::pressure)};
}

Json modulus_bounds_json(const ModulusBounds& bounds) {
    Json json{{"lower", bounds.lower}, {"upper", bounds.upper}};
    if (bounds.lower_rule) json["lower_rule"] = name_of(*bounds.lower_rule);
    if (bounds.upper_rule) json["upper_rule"] = name_of(*bounds.upper_rule);
    return json;
}

MixtureRule read_rule(const View& node) {
    return at_place(node.pointer(), [&] { return named<MixtureRule>(node.text()); });
}

ModulusBounds read_modulus_bounds(const View& node) {
    return {node.at("lower").quantity(Dimension::pressure), node.at("upper").quantity(Dimension::pressure),
            read_if(node, "lower_rule", read_rule), read_if(node, "upper_rule", read_rule)};
}

std::vector<RuleResult> read_rules(const View& node) {
    std::vector<RuleResult> rules;
    for (const auto& [key, value] : node.members()) {
        const Quantity modulus = value.quantity(Dimension::pressure);
        rules.push_back({at_place(value.pointer(), [&name = key] { return named<MixtureRule>(name); }),
                         modulus.value, modulus.standard_uncertainty.value_or(0)});
    }
    return rules;
}

SampleModulus read_sample_modulus(const View& node) {
    SampleModulus sample{.name = node.at("name").text(),
                         .diameter = node.at("diameter").quantity(Dimension::length),
                         .phases = list_if(node, "phases", read_phase_share),
                         .rule = read_if(node, "rule", read_rule).value_or(MixtureRule::parallel),
                         .young_modulus = node.at("young_modulus").quantity(Dimension::pressure),
                         .bounds = read_if(node, "bounds", read_modulus_bounds),
                         .rules = read_if(node, "rules", read_rules).value_or(std::vector<RuleResult>()),
                         .density = node.at("density").quantity(Dimension::density),
                         .poisson_ratio = number_if(node, "poisson_ratio", Dimension::fraction),
                         .contributions = list_if(node, "uncertainty_contributions", [](const View& part) {
                             return Contribution{part.at("input").text(),
                                                 part.at("share_of_variance").number(Dimension::fraction)};
                         })};
    if (const auto assumed = node.find("poisson_ratio_assumed"))
        sample.poisson_ratio_assumed = assumed->truth();
    return sample;
}

}  // namespace

Json modulus_json(const SampleModulus& sample) {
    Json phases = Json::array();
    for (const PhaseShare& share : sample.phases) phases.push_back(phase_share_json(share));
    Json rules = Json::object();
    for (const RuleResult& rule : sample.rules)
        rules[std::string(name_of(rule.rule))] =
            make_quantity(rule.young_modulus, Dimension::pressure, rule.standard_uncertainty);
    Json contributions = Json::array();
    for (const Contribution& part : sample.contributions)
        contributions.push_back({{"input", part.what}, {"share_of_variance", part.share}});
    Json json{{"phases", std::move(phases)},
              {"rule", name_of(sample.rule)},
              {"young_modulus", sample.young_modulus}};
    if (sample.bounds) json["bounds"] = modulus_bounds_json(*sample.bounds);
    json["rules"] = std::move(rules);
    json["density"] = sample.density;
    json["poisson_ratio"] = quantity_json(sample.poisson_ratio, Dimension::fraction);
    json["poisson_ratio_assumed"] = sample.poisson_ratio_assumed;
    json["uncertainty_contributions"] = std::move(contributions);
    return json;
}

Json to_json(const ModulusResult& result, DampingLaw /*law*/) {
    return samples_json(result.samples, [](const SampleModulus& sample) {
        Json json{{"name", sample.name}, {"diameter", sample.diameter}};
        json.update(modulus_json(sample));
        return json;
    });
}

template <>
ModulusResult from_json<ModulusResult>(const View& result, DampingLaw /*law*/) {
    return {samples_of(result, read_sample_modulus)};
}

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/json/view.hpp"
#include "pipeline/document/results/fields.hpp"
#include "pipeline/document/results/results_json.hpp"

namespace ashimpact {

namespace {

Json analytic_velocity_json(const AnalyticVelocity& analytic) {
    return {{"separation_energy", quantity_json(analytic.separation_energy, Dimension::energy)},
            {"critical_velocity", quantity_json(analytic.critical_velocity, Dimension::velocity)}};
}

AnalyticVelocity read_analytic_velocity(const View& node) {
    return {node.at("separation_energy").number(Dimension::energy),
            node.at("critical_velocity").number(Dimension::velocity)};
}

Json cohesive_velocity_json(const CohesiveVelocity& cohesive) {
    Json json = analytic_velocity_json(cohesive.exact);
    json["transition_parameter"] = cohesive.transition_parameter;
    json["fitted"] = analytic_velocity_json(cohesive.fitted);
    json["fitted"]["relative_error_of_energy"] = cohesive.fitted_error;
    return json;
}

CohesiveVelocity read_cohesive_velocity(const View& node) {
    const View fitted = node.at("fitted");
    return {read_analytic_velocity(node), node.at("transition_parameter").number(Dimension::fraction),
            read_analytic_velocity(fitted),
            fitted.at("relative_error_of_energy").number(Dimension::fraction)};
}

}  // namespace

Json to_json(const AnalyticResult& result, DampingLaw /*law*/) {
    return samples_json(result.samples, [](const SampleAnalytic& sample) {
        Json json{{"name", sample.name}};
        json.update(analytic_velocity_json(sample));
        if (sample.load_controlled) json["load_controlled"] = analytic_velocity_json(*sample.load_controlled);
        if (sample.with_printed_constants)
            json["with_printed_constants"] = analytic_velocity_json(*sample.with_printed_constants);
        if (sample.maugis_dugdale) json["maugis_dugdale"] = cohesive_velocity_json(*sample.maugis_dugdale);
        return json;
    });
}

template <>
AnalyticResult from_json<AnalyticResult>(const View& result, DampingLaw /*law*/) {
    return {samples_of(result, [](const View& node) {
        return SampleAnalytic{read_analytic_velocity(node), node.at("name").text(),
                              read_if(node, "load_controlled", read_analytic_velocity),
                              read_if(node, "with_printed_constants", read_analytic_velocity),
                              read_if(node, "maugis_dugdale", read_cohesive_velocity)};
    })};
}

}  // namespace ashimpact

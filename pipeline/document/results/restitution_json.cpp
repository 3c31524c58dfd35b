// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/json/view.hpp"
#include "pipeline/case/measurement_json.hpp"
#include "pipeline/document/results/fields.hpp"
#include "pipeline/document/results/results_json.hpp"

namespace ashimpact {

namespace {

Json series_json(const RestitutionSeries& series) {
    Json laws = Json::array();
    for (const Law law : series.laws) laws.push_back(law.name());
    Json json{{"laws", laws}, {"origin", name_of(series.origin)}, {"source", series.source}};
    json.update(to_json(series.columns));
    if (series.coefficient_uncertainty)
        json["coefficient_uncertainty"] = quantity_json(*series.coefficient_uncertainty, Dimension::damping);
    return json;
}

RestitutionSeries read_series(const View& node) {
    RestitutionSeries series{.origin = named<Origin>(node.at("origin").text()),
                             .source = node.at("source").text(),
                             .columns = read_listed_impacts(node)};
    for (const View& law : node.at("laws").elements()) series.laws.push_back(Law::named(law.text()));
    series.impacts = read_measurement_columns(node);
    series.impacts.source = series.source;
    if (!series.impacts.points.empty()) at_place(node.pointer(), [&] { check_impacts(series.impacts); });
    series.coefficient_uncertainty = number_if(node, "coefficient_uncertainty", Dimension::damping);
    return series;
}

}  // namespace

Json to_json(const RestitutionResult& result, DampingLaw /*law*/) {
    return samples_json(result.samples, [](const SampleRestitution& sample) {
        Json series = Json::array();
        for (const RestitutionSeries& each : sample.series) series.push_back(series_json(each));
        return Json{{"name", sample.name}, {"series", std::move(series)}};
    });
}

template <>
RestitutionResult from_json<RestitutionResult>(const View& result, DampingLaw /*law*/) {
    return {samples_of(result, [](const View& node) {
        return SampleRestitution{node.at("name").text(), list_if(node, "series", read_series)};
    })};
}

}  // namespace ashimpact

#include "pipeline/stages/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "pipeline/case/laws.hpp"
#include "pipeline/json/quantity_json.hpp"
#include "pipeline/stages/damping.hpp"
#include "pipeline/stages/read_case_artifact.hpp"

namespace ashimpact {

namespace {

/// The points up to the greatest restitution, where e rises with v: beyond it plastic deformation takes over.
std::vector<DampingPoint> rising_branch(const DampingSeries& series) {
    std::vector<DampingPoint> points;
    if (series.restitution.empty()) return points;
    const auto top =
        std::max_element(series.restitution.begin(), series.restitution.end()) - series.restitution.begin();
    const double last = series.velocity[static_cast<std::size_t>(top)];
    for (std::size_t i = 0; i < series.velocity.size(); ++i)
        if (series.velocity[i] <= last)
            points.push_back({.restitution = series.restitution[i],
                              .damping = series.damping[i],
                              .standard_uncertainty = 0});
    return points;
}

bool can_be_fitted(const std::vector<DampingPoint>& points) {
    std::set<double> distinct;
    for (const DampingPoint& point : points) distinct.insert(point.restitution);
    return distinct.size() >= 3;
}

Json covariance_json(const DampingFit& fit, const std::string& unit) {
    return {
        {"parameters", {"a", "b", "c"}}, {"values", fit.covariance}, {"unit", fmt::format("({})2", unit)}};
}

Json fit_json(const DampingFit& fit, const std::vector<DampingPoint>& points, const DampingSeries& series,
              DampingLaw damping_law) {
    const std::string unit(unit_of(damping_law));
    const auto coefficient = [&](double value, std::size_t i) {
        Json json = quantity_json(value, unit);
        json["standard_uncertainty"] = std::sqrt(std::max(0.0, fit.covariance[i][i]));
        return json;
    };
    const auto [least, greatest] =
        std::minmax_element(points.begin(), points.end(),
                            [](const auto& p, const auto& q) { return p.restitution < q.restitution; });
    return {{"a", coefficient(fit.a, 0)},
            {"b", coefficient(fit.b, 1)},
            {"c", coefficient(fit.c, 2)},
            {"critical_damping", coefficient(fit.critical_damping(), 2)},
            {"covariance", covariance_json(fit, unit)},
            {"residual_deviation", quantity_json(fit.residual_deviation, unit)},
            {"degrees_of_freedom", fit.degrees_of_freedom},
            {"points", points.size()},
            {"points_beyond_rising_branch", series.velocity.size() - points.size()},
            {"restitution_range", {least->restitution, greatest->restitution}},
            {"origin", series.origin}};
}

}  // namespace

StageOutput fit_stage(const Artifacts& before) {
    const Case data = read_case_artifact(before);
    StageOutput output{.citations = {"dong2013, section 4.3, Tables 2 and 3"}};
    output.options = {{"order", 2}, {"weights", "equal"}, {"branch", "up to the greatest restitution"}};
    output.result["samples"] = Json::array();
    const auto read = [&](const View& result) {
        return read_dampings(result, dimension_of(data.damping_law));
    };
    for (const SampleDamping& sample : before.read("5-damping.json", read)) {
        Json json{{"name", sample.name}};
        for (const auto& [law, series] : sample.laws) {
            const auto points = rising_branch(series);
            if (!can_be_fitted(points)) {
                output.warnings.push_back(
                    fmt::format("{}, {}: a quadratic needs three different restitutions on the rising branch",
                                sample.name, law.name()));
                continue;
            }
            json[std::string(law.name())] = fit_json(fit_damping(points), points, series, data.damping_law);
        }
        output.result["samples"].push_back(std::move(json));
    }
    return output;
}

std::vector<SampleFit> read_fits(const View& result, Dimension dimension) {
    std::vector<SampleFit> samples;
    for (const View& sample : result.at("samples").elements()) {
        SampleFit entry{.name = sample.at("name").text(), .laws = {}};
        for (const auto& [name, node] : sample.members()) {
            if (name == "name") continue;
            const Law law = node.located([&, &key = name] { return Law::named(key); });
            const auto value = [&, &node = node](const char* key) { return node.at(key).number(dimension); };
            entry.laws.set(law, {value("a"), value("b"), value("c"), value("critical_damping")});
        }
        samples.push_back(std::move(entry));
    }
    return samples;
}

}  // namespace ashimpact

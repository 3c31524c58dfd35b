// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/document/results/uncertainty_json.hpp"

#include <limits>

#include "core/json/view.hpp"
#include "pipeline/document/results/fields.hpp"
#include "pipeline/document/statistics_json.hpp"

namespace ashimpact {

namespace {

double number_or_none(const View& node, const char* key) {
    const auto member = node.find(key);
    return member ? member->number(Dimension::fraction) : std::numeric_limits<double>::quiet_NaN();
}

Influence read_influence(const View& node) {
    return {node.at("factor").text(),
            {number_or_none(node, "first"), number_or_none(node, "first_error")},
            {number_or_none(node, "total"), number_or_none(node, "total_error")}};
}

std::optional<double> velocity_in(const View& node, const char* key) {
    return number_if(node, key, Dimension::velocity);
}

}  // namespace

Json velocity_uncertainty_json(const VelocityUncertainty& uncertainty) {
    Json influences = Json::array();
    for (const Influence& influence : uncertainty.influences)
        influences.push_back({{"factor", influence.factor},
                              {"first", finite_json(influence.first.value)},
                              {"first_error", finite_json(influence.first.standard_error)},
                              {"total", finite_json(influence.total.value)},
                              {"total_error", finite_json(influence.total.standard_error)}});
    Json uncertain = Json::object();
    for (const auto& [name, relative] : uncertainty.relative)
        uncertain[name] = relative ? Json(*relative) : Json(nullptr);
    Json json{{"method", "Monte Carlo, sobol"},
              {"evaluations", uncertainty.evaluations},
              {"undefined", uncertainty.undefined},
              {"mean", quantity_json(uncertainty.mean, Dimension::velocity)},
              {"median", quantity_json(uncertainty.median, Dimension::velocity)},
              {"relative_standard_uncertainties", std::move(uncertain)},
              {"taken_as_exact", uncertainty.taken_as_exact},
              {"influences", std::move(influences)}};
    if (uncertainty.response)
        json["powers_of_contact_modulus"] = {{"density", uncertainty.response->density},
                                             {"work_of_adhesion", uncertainty.response->work_of_adhesion}};
    if (uncertainty.damping) json["damping"] = name_of(*uncertainty.damping);
    return json;
}

VelocityUncertainty read_velocity_uncertainty(const View& node) {
    VelocityUncertainty uncertainty{.evaluations = count_if_any(node, "evaluations"),
                                    .undefined = count_if_any(node, "undefined"),
                                    .mean = velocity_in(node, "mean"),
                                    .median = velocity_in(node, "median")};
    if (const auto relative = node.find("relative_standard_uncertainties"))
        for (const auto& [name, value] : relative->members())
            uncertainty.relative.emplace_back(name, value.json().is_null()
                                                        ? std::nullopt
                                                        : std::optional(value.number(Dimension::fraction)));
    if (const auto exact = node.find("taken_as_exact")) uncertainty.taken_as_exact = exact->texts();
    for (const View& influence : node.at("influences").elements())
        uncertainty.influences.push_back(read_influence(influence));
    if (const auto powers = node.find("powers_of_contact_modulus")) {
        const auto power = [&](const char* key) {
            const auto member = powers->find(key);
            return member ? member->number(Dimension::fraction) : 0.0;
        };
        uncertainty.response = {power("density"), power("work_of_adhesion")};
    }
    if (const auto damping = node.find("damping"))
        uncertainty.damping = named<DampingUnderChange>(damping->text());
    return uncertainty;
}

Json measured_velocity_json(const MeasuredCriticalVelocity& measured) {
    const auto velocity = [](const std::optional<double>& value) {
        return quantity_json(value, Dimension::velocity);
    };
    Json value = velocity(measured.value);
    if (measured.value && measured.standard_uncertainty.value_or(0) > 0)
        value["standard_uncertainty"] = *measured.standard_uncertainty;
    return {
        {"critical_velocity", value},
        {"interval",
         {{"level", confidence}, {"lower", velocity(measured.lower)}, {"upper", velocity(measured.upper)}}},
        {"fastest_capture", velocity(measured.fastest_capture)},
        {"slowest_rebound", velocity(measured.slowest_rebound)},
        {"transition_width", velocity(measured.width)},
        {"note", measured.note}};
}

MeasuredCriticalVelocity read_measured_velocity(const View& node) {
    MeasuredCriticalVelocity measured{};
    if (const auto value = node.find("critical_velocity")) {
        const VelocityEstimate velocity = read_velocity(*value);
        measured.value = velocity.value;
        measured.standard_uncertainty = velocity.standard_uncertainty;
    }
    if (const auto interval = node.find("interval")) {
        measured.lower = velocity_in(*interval, "lower");
        measured.upper = velocity_in(*interval, "upper");
    }
    measured.fastest_capture = velocity_in(node, "fastest_capture");
    measured.slowest_rebound = velocity_in(node, "slowest_rebound");
    measured.width = velocity_in(node, "transition_width");
    if (const auto note = node.find("note")) measured.note = note->text();
    return measured;
}

Json check_json(const CriticalVelocityCheck& check) {
    return {{"verdict", name_of(check.verdict)},
            {"deviation", check.deviation ? finite_json(*check.deviation) : Json(nullptr)}};
}

CriticalVelocityCheck read_check(const View& node) {
    const auto deviation = node.find("deviation");
    return {named<CriticalVelocityVerdict>(node.at("verdict").text()),
            deviation ? std::optional(deviation->number(Dimension::fraction)) : std::nullopt};
}

}  // namespace ashimpact

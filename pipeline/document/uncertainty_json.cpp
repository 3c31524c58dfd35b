// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/document/uncertainty_json.hpp"

#include <cmath>

#include <fmt/format.h>

#include "pipeline/document/quantity_json.hpp"
#include "pipeline/document/statistics_json.hpp"

namespace ashimpact {

Json propagation_json(const Propagation& propagation, const std::vector<RandomInput>& inputs) {
    Json influences = Json::array();
    for (const Influence& influence : propagation.influences)
        influences.push_back({{"factor", influence.factor},
                              {"first", finite_json(influence.first.value)},
                              {"first_error", finite_json(influence.first.standard_error)},
                              {"total", finite_json(influence.total.value)},
                              {"total_error", finite_json(influence.total.standard_error)}});
    Json uncertain = Json::object();
    Json exact = Json::array();
    for (const RandomInput& input : inputs) {
        if (input.standard_uncertainty > 0)
            uncertain[input.name] = finite_json(input.standard_uncertainty / std::abs(input.value));
        else
            exact.push_back(input.name);
    }
    return {{"method", "Monte Carlo, sobol"},
            {"evaluations", propagation.evaluations},
            {"undefined", propagation.undefined},
            {"mean", quantity_json(propagation.mean, Dimension::velocity)},
            {"median", quantity_json(propagation.median, Dimension::velocity)},
            {"relative_standard_uncertainties", uncertain},
            {"taken_as_exact", exact},
            {"influences", influences}};
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

Json check_json(const Interval& model, const MeasuredCriticalVelocity& measured, bool same_impacts) {
    const bool comparable =
        !measured.value || model.standard_uncertainty > 0 || measured.standard_uncertainty.value_or(0) > 0;
    const CriticalVelocityCheck verdict =
        comparable ? check(model, measured, same_impacts)
                   : CriticalVelocityCheck{CriticalVelocityVerdict::not_comparable, std::nullopt};
    return {{"verdict", name_of(verdict.verdict)},
            {"deviation", verdict.deviation ? finite_json(*verdict.deviation) : Json(nullptr)}};
}

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/uncertainty/velocity_uncertainty.hpp"

#include <fmt/format.h>

#include "pipeline/document/quantity_json.hpp"
#include "pipeline/document/statistics_json.hpp"
#include "pipeline/document/uncertainty_json.hpp"
#include "pipeline/run/attempt.hpp"
#include "pipeline/run/uncertainty/contact_models.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/inference/curve/headline.hpp"
#include "solver/inference/propagation/critical_velocity_uncertainty.hpp"

namespace ashimpact {

namespace {

constexpr const char* extrapolation_method = "eta(e) extrapolated to e = 0, a polynomial (Dong et al. 2013)";

Json propagated_json(const VelocityTask& task, const Propagation& propagation,
                     const std::vector<RandomInput>& inputs) {
    Json json{{"critical_velocity", estimate_json(propagation.interval, si_unit(Dimension::velocity))},
              {"interval", interval_json(propagation.interval, si_unit(Dimension::velocity))},
              {"uncertainty", propagation_json(propagation, inputs)}};
    const CalibrationResponse& response = task.response;
    if (response.density != 0 || response.work_of_adhesion != 0)
        json["uncertainty"]["powers_of_contact_modulus"] = {{"density", response.density},
                                                            {"work_of_adhesion", response.work_of_adhesion}};
    if (task.measured)
        json["check"] = check_json(propagation.interval, *task.measured,
                                   task.from_impacts() && !task.measured_is_reported);
    return json;
}

/// By the paper's extrapolation of measured impacts.
Json from_extrapolation(const VelocityTask& task) {
    const ContactModel model = contact_model_for(task.choice, task.contact.pair, task.series->impacts);
    const auto change = task.data.uncertainty.reread ? DampingUnderChange::reread : DampingUnderChange::held;
    Json json = propagated_json(task,
                                propagate_critical_velocity(*task.fit.extrapolated, model, task.uncertain,
                                                            change, task.data.uncertainty.propagation),
                                task.uncertain.inputs);
    json["uncertainty"]["damping"] = task.data.uncertainty.reread ? "reread" : "held";
    return json;
}

/// From what the impacts support. The curve v_r(v_in) is what was measured, and it ends at v_c whatever the
/// contact is: where the damping is read again with another contact, v_c stays.
Json from_estimate(const VelocityTask& task) {
    const Interval& damping = *task.fit.estimate;
    const auto velocity_at = [&](const std::optional<double>& value) -> std::optional<double> {
        if (!value) return std::nullopt;
        return critical_velocity({task.choice.law,
                                  task.choice.detachment,
                                  {DampingLaw::constant, *value},
                                  task.contact.pair})
            .value;
    };
    Interval velocity{.value = *velocity_at(damping.value),
                      .standard_uncertainty = 0,
                      .lower = velocity_at(damping.lower),
                      .upper = velocity_at(damping.upper)};
    const double up = 1 + 1e-4;
    velocity.standard_uncertainty = (*velocity_at(damping.value * up) - *velocity_at(damping.value / up)) /
                                    (damping.value * (up - 1 / up)) * damping.standard_uncertainty;
    Json json{{"critical_velocity", estimate_json(velocity, si_unit(Dimension::velocity))},
              {"interval", interval_json(velocity, si_unit(Dimension::velocity))}};
    if (task.measured) json["check"] = check_json(velocity, *task.measured, !task.measured_is_reported);
    return json;
}

/// From a critical damping that is known by itself.
Json from_damping(const VelocityTask& task) {
    const RandomInput damping{.name = fit_factor,
                              .value = task.critical_damping(),
                              .standard_uncertainty = task.critical_damping_uncertainty(),
                              .distribution = lognormal_around};
    std::vector<RandomInput> inputs{damping};
    inputs.insert(inputs.end(), task.uncertain.inputs.begin(), task.uncertain.inputs.end());
    Json json =
        propagated_json(task,
                        propagate_critical_velocity(task.choice.law, task.choice.detachment, damping,
                                                    task.uncertain, task.data.uncertainty.propagation),
                        inputs);
    json["uncertainty"]["damping"] = "held";
    return json;
}

/// Whether v_c can be had for thousands of draws: read from tables and maps, which a plastic history has not.
bool can_propagate(const VelocityTask& task) {
    return task.data.damping_law == DampingLaw::constant && !can_yield(task.choice.law, task.contact.pair);
}

}  // namespace

Json velocity_uncertainty_json(const VelocityTask& task, double velocity, std::vector<std::string>& notes) {
    Json json = Json::object();
    const char* method = "critical damping of 6-fit.json";
    const bool measured = task.series != nullptr && (task.fit.extrapolated || task.fit.estimate);
    if (!can_propagate(task)) {
        constexpr const char* reason =
            "no interval: that takes constant damping and a contact that does not yield";
        notes.emplace_back(reason);
        json["interval_note"] = reason;
    } else if (measured) {
        Json extrapolated = nullptr;
        if (task.fit.extrapolated)
            extrapolated = attempt("interval of the extrapolation", notes, [&] {
                               return from_extrapolation(task);
                           }).value_or(Json(nullptr));
        if (task.fit.estimate && task.data.uncertainty.reread)
            json = from_estimate(task);
        else if (task.fit.estimate)
            json = attempt("interval", notes, [&] { return from_damping(task); }).value_or(Json::object());
        else if (!extrapolated.is_null())
            json = extrapolated;
        json["extrapolated"] = extrapolated;
        method = task.fit.estimate ? estimate_method : extrapolation_method;
    } else if (!task.fit.critical_damping_uncertainty) {
        constexpr const char* reason =
            "no interval: the critical damping in 6-fit.json states no uncertainty";
        notes.emplace_back(reason);
        json["interval_note"] = reason;
    } else {
        json = attempt("interval", notes, [&] { return from_damping(task); }).value_or(Json::object());
        method = extrapolation_method;
    }
    if (!json.contains("critical_velocity"))
        json["critical_velocity"] = quantity_json(velocity, Dimension::velocity);
    // The value stays that of the exact solver; only its uncertainty comes from the propagation.
    json["critical_velocity"]["value"] = velocity;
    json["critical_velocity"]["interval"] = json.contains("interval") ? json["interval"] : Json(nullptr);
    json["critical_velocity"]["method"] = method;
    return json;
}

}  // namespace ashimpact

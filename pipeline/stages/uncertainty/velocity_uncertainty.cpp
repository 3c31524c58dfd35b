#include "pipeline/stages/uncertainty/velocity_uncertainty.hpp"

#include <fmt/format.h>

#include "pipeline/json/quantity_json.hpp"
#include "pipeline/json/statistics_json.hpp"
#include "pipeline/stages/attempt.hpp"
#include "pipeline/stages/json/uncertainty_json.hpp"
#include "pipeline/stages/uncertainty/contact_models.hpp"
#include "solver/critical_velocity/critical_velocity_curve.hpp"
#include "solver/uncertainty/propagation/critical_velocity_uncertainty.hpp"

namespace ashimpact {

namespace {

Json propagated_json(const VelocityTask& task, const Propagation& propagation,
                     const std::vector<RandomInput>& inputs) {
    Json json{{"critical_velocity", estimate_json(propagation.interval, si_unit(Dimension::velocity))},
              {"interval", interval_json(propagation.interval, si_unit(Dimension::velocity))},
              {"uncertainty", propagation_json(propagation, inputs)}};
    if (task.measured) json["check"] = check_json(propagation.interval, *task.measured);
    return json;
}

/// From a fit to measured impacts.
Json from_fit(const VelocityTask& task, const DampingCurveFit& fit) {
    const ContactModel model = contact_model_for(task.choice, task.contact.pair, task.series->impacts);
    const auto change = task.data.uncertainty.reread ? DampingUnderChange::reread : DampingUnderChange::held;
    Json json = propagated_json(
        task,
        propagate_critical_velocity(fit, model, task.uncertain, change, task.data.uncertainty.propagation),
        task.uncertain.inputs);
    json["uncertainty"]["damping"] = task.data.uncertainty.reread ? "reread" : "held";
    return json;
}

/// From a critical damping that is known by itself.
Json from_damping(const VelocityTask& task) {
    const RandomInput damping{.name = fit_factor,
                              .value = task.fit.critical_damping,
                              .standard_uncertainty = task.fit.critical_damping_uncertainty.value_or(0),
                              .distribution = lognormal_around};
    std::vector<RandomInput> inputs{damping};
    inputs.insert(inputs.end(), task.uncertain.inputs.begin(), task.uncertain.inputs.end());
    const CriticalVelocityCurve curve(task.choice.law, task.choice.detachment, task.contact.pair,
                                      damping.value, scaled_damping_factor(damping, task.uncertain));
    const auto critical = [&](std::span<const double> values) -> std::optional<double> {
        return curve(task.uncertain.contact(values.subspan(1)), values[0]);
    };
    Json json = propagated_json(task, propagate(inputs, critical, task.data.uncertainty.propagation), inputs);
    json["uncertainty"]["damping"] = "held";
    return json;
}

}  // namespace

Json velocity_uncertainty_json(const VelocityTask& task, double velocity, std::vector<std::string>& notes) {
    Json json = Json::object();
    if (!has_contact_model(task.choice, task.data.damping_law, task.contact.pair)) {
        constexpr const char* reason =
            "no interval: that takes constant damping and a contact that does not yield";
        notes.emplace_back(reason);
        json["interval_note"] = reason;
    } else if ((task.fit.extrapolated || task.fit.direct) && task.series != nullptr) {
        json = attempt("interval", notes, [&] {
                   return from_fit(task, task.fit.extrapolated ? *task.fit.extrapolated : *task.fit.direct);
               }).value_or(Json::object());
        if (task.fit.direct)
            json["direct"] = attempt("interval of the direct fit", notes, [&] {
                                 return from_fit(task, *task.fit.direct);
                             }).value_or(Json(nullptr));
    } else {
        json = attempt("interval", notes, [&] { return from_damping(task); }).value_or(Json::object());
    }
    if (!json.contains("critical_velocity"))
        json["critical_velocity"] = quantity_json(velocity, Dimension::velocity);
    // The value stays that of the exact solver; only its uncertainty comes from the propagation.
    json["critical_velocity"]["value"] = velocity;
    return json;
}

}  // namespace ashimpact

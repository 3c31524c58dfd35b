#include "pipeline/stages/velocity_uncertainty.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "materials/error.hpp"
#include "pipeline/json/quantity_json.hpp"
#include "pipeline/json/statistics_json.hpp"
#include "pipeline/stages/contact_models.hpp"
#include "pipeline/stages/uncertainty_json.hpp"
#include "solver/critical_velocity_curve.hpp"
#include "solver/uncertainty/critical_velocity_uncertainty.hpp"

namespace ashimpact {

namespace {

constexpr auto velocity_unit = "m/s";

Json propagated_json(const VelocityTask& task, const Propagation& propagation,
                     const std::vector<RandomInput>& inputs) {
    Json json{{"critical_velocity", estimate_json(propagation.interval, velocity_unit)},
              {"interval", interval_json(propagation.interval, velocity_unit)},
              {"uncertainty", propagation_json(propagation, inputs)}};
    if (task.measured) json["check"] = check_json(propagation.interval, *task.measured);
    return json;
}

/// From a fit to measured impacts.
Json from_fit(const VelocityTask& task, const DampingCurveFit& fit) {
    const ContactModel model = contact_model_for(task.choice, task.contact.pair, task.series->impacts);
    const auto change = task.data.uncertainty.reread ? DampingUnderChange::reread : DampingUnderChange::held;
    Json json = propagated_json(task,
                                propagate_critical_velocity(fit, model, task.uncertain, change,
                                                            task.data.uncertainty.propagation),
                                task.uncertain.inputs);
    json["uncertainty"]["damping"] = task.data.uncertainty.reread ? "reread" : "held";
    return json;
}

/// From a critical damping that is known by itself.
Json from_damping(const VelocityTask& task) {
    const RandomInput damping{.name = fit_factor,
                              .value = task.fit.critical_damping,
                              .standard_uncertainty = task.fit.critical_damping_uncertainty.value_or(0),
                              .shape = InputShape::lognormal};
    std::vector<RandomInput> inputs{damping};
    inputs.insert(inputs.end(), task.uncertain.inputs.begin(), task.uncertain.inputs.end());
    // The scaled damping goes with no more than the first power of any input: five standard uncertainties of
    // their sum, and a margin.
    double spread = 0;
    for (const RandomInput& input : inputs)
        if (input.standard_uncertainty > 0) spread += input.standard_uncertainty / std::abs(input.value);
    const CriticalVelocityCurve curve(task.choice.law, task.choice.detachment, task.contact.pair,
                                      damping.value, std::exp(std::clamp(5 * spread, 0.05, 2.0)));
    const auto critical = [&](std::span<const double> values) -> std::optional<double> {
        return curve(task.uncertain.contact(values.subspan(1)), values[0]);
    };
    Json json = propagated_json(task, propagate(inputs, critical, task.data.uncertainty.propagation), inputs);
    json["uncertainty"]["damping"] = "held";
    return json;
}

/// What @p compute gives, or a note why it gives nothing.
template <class Compute>
Json attempt(const char* what, std::vector<std::string>& notes, Compute&& compute) {
    try {
        return compute();
    } catch (const InputError& error) {
        notes.push_back(fmt::format("no {}: {}", what, error.problem()));
    } catch (const ConvergenceError& error) {
        notes.push_back(fmt::format("no {}: {}", what, error.what()));
    }
    return nullptr;
}

}  // namespace

Json velocity_uncertainty_json(const VelocityTask& task, double velocity, std::vector<std::string>& notes) {
    Json json = Json::object();
    if (!has_contact_model(task.choice, task.data.damping_law, task.contact.pair)) {
        notes.emplace_back("no interval: that takes constant damping and a contact that does not yield");
    } else if (task.fit.extrapolated && task.series != nullptr) {
        const Json own = attempt("interval", notes, [&] { return from_fit(task, *task.fit.extrapolated); });
        if (!own.is_null()) json = own;
        if (task.fit.direct)
            json["direct"] =
                attempt("interval of the direct fit", notes, [&] { return from_fit(task, *task.fit.direct); });
    } else {
        const Json own = attempt("interval", notes, [&] { return from_damping(task); });
        if (!own.is_null()) json = own;
    }
    if (!json.contains("critical_velocity"))
        json["critical_velocity"] = quantity_json(velocity, Dimension::velocity);
    // The value stays that of the exact solver; only its uncertainty comes from the propagation.
    json["critical_velocity"]["value"] = velocity;
    return json;
}

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/plausibility.hpp"
#include "pipeline/run/stage.hpp"
#include "pipeline/run/uncertainty/calibration.hpp"
#include "pipeline/run/uncertainty/velocity_uncertainty.hpp"
#include "solver/damping/damping.hpp"

namespace ashimpact {

namespace {

/// The critical velocity that a case reports.
MeasuredCriticalVelocity reported_velocity(const Quantity& reported) {
    MeasuredCriticalVelocity measured;
    measured.value = reported.value;
    const double u = reported.standard_uncertainty.value_or(0);
    measured.note = u > 0 ? "as reported in the case" : "as reported in the case, without an uncertainty";
    if (!(u > 0)) return measured;
    const double half = u * confidence_quantile();
    measured.standard_uncertainty = u;
    measured.lower = std::max(0.0, reported.value - half);
    measured.upper = reported.value + half;
    return measured;
}

/// The critical velocity that the outcomes of measured impacts show.
std::optional<MeasuredCriticalVelocity> velocity_by_outcomes(const RestitutionSeries* series,
                                                             double scale_uncertainty) {
    if (series == nullptr || series->origin != Origin::measured) return std::nullopt;
    return measured_critical_velocity(series->impacts, scale_uncertainty);
}

ResultOfLaw<LawCriticalVelocity> velocity_of(const VelocityTask& task) {
    LawCriticalVelocity velocity =
        law_critical_velocity({.law = task.choice.law,
                               .detachment = task.choice.detachment,
                               .damping = {task.data.damping_law, task.critical_damping().value},
                               .contact = task.contact.pair});
    std::vector<Finding> findings;
    if (const auto doubt = velocity.velocity ? outside_model(velocity.velocity->value) : std::nullopt)
        findings.push_back(*doubt);
    if (velocity.velocity) set_uncertainty(task, velocity, findings);
    if (velocity.regime)
        findings.insert(findings.end(), velocity.regime->warnings.begin(), velocity.regime->warnings.end());
    return {std::move(velocity), std::move(findings)};
}

}  // namespace

LawCriticalVelocity law_critical_velocity(const CriticalVelocityProblem& problem) {
    const CriticalVelocity result = critical_velocity(problem);
    LawCriticalVelocity velocity{.detachment = problem.detachment,
                                 .damping = problem.damping.coefficient,
                                 .verdict = result.verdict,
                                 .contact_time = result.contact_time,
                                 .maximum_overlap = result.maximum_overlap,
                                 .crossings = result.crossings,
                                 .dissipated = result.dissipated,
                                 .plastic = result.plastic,
                                 .detachment_energy = result.detachment_energy};
    if (!result.value) return velocity;
    velocity.velocity = {.value = *result.value};
    velocity.regime = regime_of({.law = problem.law,
                                 .detachment = problem.detachment,
                                 .damping = problem.damping,
                                 .contact = problem.contact,
                                 .velocity = *result.value},
                                result.maximum_overlap.value_or(0));
    return velocity;
}

CriticalVelocityResult critical_velocity_stage(const Case& data, const ModulusResult& moduli,
                                               const ContactResult& contacts,
                                               const RestitutionResult& restitutions, const FitResult& fits,
                                               ContactModels& models, StageRecord& record) {
    record.citations = {"dong2013, section 4.3, Table 4"};
    const auto responses = calibrated_constants(data, moduli, contacts, record);
    CriticalVelocityResult result;
    for (std::size_t i = 0; i < data.samples.size(); ++i) {
        const Sample& sample = data.samples[i];
        const SampleRestitution& restitution = restitutions.samples[i];
        const RestitutionSeries* first = restitution.series.empty() ? nullptr : &restitution.series.front();
        std::vector<Finding> findings;
        const auto outcomes =
            attempt("measured v_c", "no-measured-critical-velocity", Severity::doubt, findings, [&] {
                return velocity_by_outcomes(first, data.fit.estimate.scale_uncertainty);
            }).value_or(std::nullopt);
        const auto& reported = sample.measured_critical_velocity;
        const auto measured = reported ? std::optional(reported_velocity(reported->quantity)) : outcomes;
        record.note(findings, sample.name);
        const auto solve = [&](const LawChoice& choice) -> ResultOfLaw<LawCriticalVelocity> {
            const LawFit* fit = fits.samples[i].laws.find(choice.law);
            if (fit == nullptr) return {};
            const RandomContact uncertain =
                uncertain_contact(data, sample, contacts.samples[i], choice.law, responses[i]);
            return velocity_of({data, choice, contacts.samples[i], uncertain, responses[i],
                                restitution.of(choice.law), *fit, measured, outcomes, reported.has_value(),
                                models});
        };
        result.samples.push_back(
            {sample.name, measured, results_by_law<LawCriticalVelocity>(data, sample.name, record, solve)});
    }
    return result;
}

}  // namespace ashimpact

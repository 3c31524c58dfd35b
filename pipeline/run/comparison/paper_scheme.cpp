// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/comparison/paper_scheme.hpp"

#include <vector>

#include "core/text/error.hpp"
#include "pipeline/run/stage.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/inference/calibration/published_damping.hpp"
#include "solver/motion/explicit_scheme.hpp"

namespace ashimpact {

namespace {

/// Critical velocity of eta(0), exact; none where there is none.
std::optional<double> exact_velocity(const Impact& impact, double damping) {
    if (!(damping > 0)) return std::nullopt;
    return critical_velocity({impact.law, impact.detachment, {DampingLaw::constant, damping}, impact.contact})
        .value;
}

/// The same by the scheme.
std::optional<double> velocity_by_scheme(Impact impact, double damping, const ExplicitSchemeOptions& step) {
    const auto near = exact_velocity(impact, damping);
    if (!near || !(*near > 0)) return std::nullopt;
    impact.damping = {DampingLaw::constant, damping};
    impact.velocity = *near;
    return explicit_critical_velocity(impact, step);
}

SchemeBesideExact beside_exact(Impact impact, const DampingSeries& series, double time_step) {
    const ExplicitSchemeOptions step{.time_step = time_step};
    std::vector<DampingPoint> exact;
    std::vector<DampingPoint> scheme;
    for (std::size_t i = 0; i < series.velocity.size(); ++i) {
        if (series.velocity[i] > series.rising->to) continue;
        impact.velocity = series.velocity[i];
        impact.damping = {DampingLaw::constant, series.damping[i]};
        exact.push_back({series.restitution[i], series.damping[i], 0});
        scheme.push_back({series.restitution[i], explicit_damping(impact, series.restitution[i], step), 0});
    }
    SchemeBesideExact result{{fit_damping(scheme).damping}, {fit_damping(exact).damping}};
    result.exact.critical_velocity = exact_velocity(impact, result.exact.damping.critical_damping());
    result.scheme.critical_velocity =
        velocity_by_scheme(impact, result.scheme.damping.critical_damping(), step);
    return result;
}

}  // namespace

LawMap<SchemeBesideExact> paper_scheme(const Case& data, const SampleContact& contact,
                                       const SampleDamping& dampings, StageRecord& record) {
    if (!data.paper_time_step || data.damping_law != DampingLaw::constant) return {};
    const auto compute = [&](const LawChoice& choice) -> ResultOfLaw<SchemeBesideExact> {
        const DampingSeries* series = dampings.laws.find(choice.law);
        if (series == nullptr || !series->rising || !has_explicit_scheme(choice.law) ||
            choice.detachment != Detachment::zero_overlap)
            return {};
        ResultOfLaw<SchemeBesideExact> result;
        result.value = attempt("values by the paper's scheme", "no-explicit-scheme", Severity::doubt,
                               result.findings, [&] {
                                   return beside_exact({.law = choice.law,
                                                        .detachment = choice.detachment,
                                                        .damping = {},
                                                        .contact = contact.pair,
                                                        .velocity = 0},
                                                       *series, *data.paper_time_step);
                               });
        return result;
    };
    return results_by_law<SchemeBesideExact>(data, dampings.name, record, compute);
}

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/comparison/reported_velocity.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace ashimpact {

namespace {

/// The velocity with the widest interval that holds those of the admissible laws. They differ only where v_c
/// does not follow from the impacts alone.
VelocityEstimate over_admissible(const VelocityEstimate& own, const ReportedEvidence& evidence) {
    VelocityEstimate all = own;
    double variance = 0;
    double count = 0;
    for (const Law law : evidence.law.admissible) {
        const LawCriticalVelocity* velocity = evidence.velocities.find(law);
        if (velocity == nullptr || !velocity->velocity || !velocity->velocity->interval) continue;
        const VelocityEstimate& other = *velocity->velocity;
        const auto& [lower, upper] = *other.interval;
        all.interval->lower = std::min(all.interval->lower, lower);  // none is the least
        all.interval->upper =
            upper && all.interval->upper ? std::max(all.interval->upper, upper) : std::nullopt;
        variance +=
            std::pow(other.standard_uncertainty.value_or(0), 2) + std::pow(other.value - own.value, 2);
        ++count;
    }
    if (count > 1) all.standard_uncertainty = std::sqrt(variance / count);
    return all;
}

ReportedVelocity by_law(Law law, const VelocityEstimate& velocity, const ReportedEvidence& evidence) {
    ReportedVelocity reported{.law = law, .reason = evidence.law.reason, .basis = evidence.basis};
    reported.velocity = velocity;
    if (evidence.basis == ReportedBasis::reproduction) {
        reported.velocity->interval = std::nullopt;
        reported.velocity->standard_uncertainty = std::nullopt;
    } else if (velocity.interval && std::ranges::count(evidence.law.admissible, law) > 0) {
        reported.velocity = over_admissible(velocity, evidence);
    }
    reported.interval = reported.velocity->interval;
    if (!(law == evidence.law.law))
        reported.reason =
            fmt::format("{}, by which the run reports, could not be fitted here", evidence.law.law.name());
    return reported;
}

/// The bounds that the outcomes of the impacts give. @param why no law gives a velocity
ReportedVelocity by_outcomes(const ReportedEvidence& evidence, const std::string& why) {
    if (!evidence.outcomes) return {.reason = why};
    const MeasuredCriticalVelocity& outcomes = *evidence.outcomes;
    ReportedVelocity reported{.interval = Bounds{outcomes.lower, outcomes.upper},
                              .reason = (outcomes.value ? "as measured" : outcomes.note) + "; " + why,
                              .basis = ReportedBasis::outcomes};
    if (outcomes.value) reported.velocity = estimate_of(outcomes);
    return reported;
}

}  // namespace

ReportedVelocity reported_velocity(const ReportedEvidence& evidence) {
    const auto found = [&](Law law) { return evidence.velocities.find(law); };
    if (const LawCriticalVelocity* own = found(evidence.law.law)) {
        if (own->velocity) return by_law(evidence.law.law, *own->velocity, evidence);
        return by_outcomes(evidence, fmt::format("no finite velocity by {}: {}", evidence.law.law.name(),
                                                 name_of(own->verdict)));
    }
    for (const Law law : evidence.preference)
        if (const LawCriticalVelocity* other = found(law); other != nullptr && other->velocity)
            return by_law(law, *other->velocity, evidence);
    std::string why = evidence.no_damping;
    for (const auto& [law, velocity] : evidence.velocities)
        why = "no law gives a finite velocity: " + std::string(name_of(velocity.verdict));
    return by_outcomes(evidence, why);
}

}  // namespace ashimpact

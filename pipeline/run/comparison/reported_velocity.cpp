// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/comparison/reported_velocity.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "solver/statistics/interval.hpp"

namespace ashimpact {

namespace {

/// Distribution function of one law's velocity: two half normal distributions that meet in its value.
double share_below(const VelocityEstimate& law, double velocity) {
    const Bounds& ends = law.interval.value();
    const std::optional<double>& end = velocity < law.value ? ends.lower : ends.upper;
    const double width = end ? std::abs(*end - law.value) / confidence_quantile() : 0.0;
    if (width > 0) return 0.5 * std::erfc((law.value - velocity) / (width * std::numbers::sqrt2));
    return velocity < law.value ? 0.0 : 1.0;
}

/// Velocity below which the mixture has @p share, by bisection between the laws' own ends.
double mixture_quantile(const std::vector<VelocityEstimate>& laws, double share, double least,
                        double greatest) {
    const auto below = [&](double velocity) {
        double sum = 0;
        for (const VelocityEstimate& law : laws) sum += share_below(law, velocity);
        return sum / static_cast<double>(laws.size());
    };
    for (int i = 0; i < 200 && least < greatest; ++i) {
        const double middle = 0.5 * (least + greatest);
        if (middle == least || middle == greatest) break;
        (below(middle) < share ? least : greatest) = middle;
    }
    return greatest;
}

/// The velocity with its uncertainty over the admissible laws that give one.
VelocityEstimate over_admissible(const VelocityEstimate& own, const ReportedEvidence& evidence) {
    std::vector<VelocityEstimate> laws;
    for (const Law law : evidence.law.admissible)
        if (const LawCriticalVelocity* velocity = evidence.velocities.find(law))
            if (velocity->velocity && velocity->velocity->interval) laws.push_back(*velocity->velocity);
    if (laws.size() < 2) return own;
    VelocityEstimate all = own;
    all.interval = interval_over_laws(laws);
    double variance = 0;
    for (const VelocityEstimate& law : laws)
        variance += std::pow(law.standard_uncertainty.value_or(0), 2) + std::pow(law.value - own.value, 2);
    all.standard_uncertainty = std::sqrt(variance / static_cast<double>(laws.size()));
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

Bounds interval_over_laws(const std::vector<VelocityEstimate>& laws) {
    if (laws.size() == 1) return laws.front().interval.value();
    // The quantiles of the mixture lie between the least and the greatest of the laws' own.
    double least = laws.front().value;
    double greatest = least;
    bool open_below = false;
    bool open_above = false;
    for (const VelocityEstimate& law : laws) {
        const Bounds& ends = law.interval.value();
        open_below = open_below || !ends.lower;
        open_above = open_above || !ends.upper;
        least = std::min({least, law.value, ends.lower.value_or(law.value)});
        greatest = std::max({greatest, law.value, ends.upper.value_or(law.value)});
    }
    const double tail = 0.5 * (1 - confidence);
    Bounds bounds;
    if (!open_below) bounds.lower = mixture_quantile(laws, tail, least, greatest);
    if (!open_above) bounds.upper = mixture_quantile(laws, 1 - tail, least, greatest);
    return bounds;
}

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

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/run/results/critical_velocity.hpp"
#include "pipeline/run/results/reported.hpp"

namespace ashimpact {

/// What the reported velocity of a sample depends on.
struct ReportedEvidence {
    const ReportedLaw& law;
    const std::vector<Law>& preference;  ///< the laws of the case, see laws_by_preference()
    const LawMap<LawCriticalVelocity>& velocities;
    /// The velocity that the outcomes of the impacts show; not one that the case states.
    const std::optional<MeasuredCriticalVelocity>& outcomes;
    ReportedBasis basis;            ///< of what the laws give
    const std::string& no_damping;  ///< why a law has no damping: "no impacts were given"
};

/// The critical velocity of a sample by the law of the run, with the interval over the admissible laws. A
/// reproduction has no interval. If the law could not be fitted to the impacts of the sample, the next law by
/// preference that gives a velocity takes its place, and the reason names both. If no law gives a velocity,
/// or the law of the run captures always or never, there are only the bounds that the outcomes of the impacts
/// give. A measured critical velocity of the case does not enter.
[[nodiscard]] ReportedVelocity reported_velocity(const ReportedEvidence& evidence);

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "pipeline/run/results/run.hpp"

namespace ashimpact {

/// The results of a sample on which its rebounds at an angle rest.
struct ObliqueEvidence {
    const Case& data;
    const SampleContact& contact;
    const LawMap<LawCriticalVelocity>& velocities;
    const LawMap<LawCurve>& curves;
    const std::optional<ReportedVelocity>& reported;
};

/// Rebounds at an angle by the reported law, at velocities around v_c, without spin before the impact. The
/// damping follows the normal velocity along the curve e(v_in) of the model; beyond the ends of that curve it
/// is constant.
/// @return none without a friction, and where the reported law has no finite v_c
[[nodiscard]] std::optional<ObliqueCurves> oblique_curves(const ObliqueEvidence& evidence);

}  // namespace ashimpact

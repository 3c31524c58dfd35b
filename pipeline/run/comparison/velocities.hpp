// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "pipeline/case/case.hpp"
#include "pipeline/run/results/contact.hpp"
#include "pipeline/run/results/critical_velocity.hpp"
#include "pipeline/run/results/damping.hpp"
#include "pipeline/run/results/run.hpp"

namespace ashimpact {

/// Incident velocities between which a series has values [m/s].
struct SeriesRange {
    double slowest;
    double fastest;
};

/// Round velocities that lie in at least two of the ranges, increasing, about five to twelve where the ranges
/// are wide enough [m/s].
[[nodiscard]] std::vector<double> shared_velocities(const std::vector<SeriesRange>& ranges);

/// Samples and laws compared at equal incident velocities (Figure 8 of Dong et al. 2013): for each velocity
/// the damping, and restitution, contact time and greatest overlap of the impact with it. Between the points
/// of a series the damping is interpolated without overshoot; that of measured impacts which can be smoothed
/// is their smooth curve. Nothing is extrapolated: a series is absent where it has no points.
[[nodiscard]] std::vector<EqualVelocity> equal_velocities(const Case& data, const ContactResult& contacts,
                                                          const DampingStageResult& dampings);

/// What the choice of a law depends on.
struct LawEvidence {
    const std::vector<LawChoice>& laws;
    const LawMap<LawCriticalVelocity>& velocities;
    const ContactPair& contact;
    const std::optional<MeasuredCriticalVelocity>& measured;
    const std::string& no_damping;  ///< why a law has no damping: "no impacts were given"
};

/// The critical velocity of a sample that a reader is to report: the law, the velocity with its interval, and
/// the reason in words. Where no law gives a velocity, the bounds that the impacts alone give.
///
/// Of the laws that have adhesion those come first that the measured critical velocity does not contradict.
/// Among them the physics of the contact decides: thornton-ning if the contact yields, else maugis-dugdale,
/// which holds for every Tabor parameter, else JKR or DMT, whichever limit is nearer (Johnson & Greenwood
/// 1997), else brach-dunn and sjkr, whose adhesion is empirical. hertz is reported if there is nothing else.
[[nodiscard]] ReportedVelocity reported_velocity(const LawEvidence& evidence);

}  // namespace ashimpact

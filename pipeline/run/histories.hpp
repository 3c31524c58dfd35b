// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/run/results/contact.hpp"
#include "pipeline/run/results/critical_velocity.hpp"
#include "pipeline/run/results/damping.hpp"
#include "pipeline/run/results/histories.hpp"
#include "pipeline/run/results/note.hpp"

namespace ashimpact {

/// Overlap against time just above the critical velocity and in the middle of the rising branch, with the
/// momentum balance of each; Dong et al. 2013, section 4.4, Eqs. 35-45, Figure 9. With the curves of the
/// figures.
[[nodiscard]] HistoriesResult histories_stage(const Case& data, const ContactResult& contacts,
                                              const DampingStageResult& dampings, const FitResult& fits,
                                              const CriticalVelocityResult& velocities, StageRecord& record);

}  // namespace ashimpact

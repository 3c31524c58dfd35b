// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "pipeline/run/results/contact.hpp"
#include "pipeline/run/results/critical_velocity.hpp"
#include "pipeline/run/results/damping.hpp"
#include "pipeline/run/results/histories.hpp"

namespace ashimpact::curves {

/// Adds what the figures draw of each law beside its histories: the model's curve e(v_in), the impact at v_c
/// and one of the falling branch. A law without a fit has no curve; what does not converge is left out.
/// @param result with the histories of every sample of the case
void add_curves(const Case& data, const ContactResult& contacts, const DampingStageResult& dampings,
                const FitResult& fits, const CriticalVelocityResult& velocities, HistoriesResult& result);

}  // namespace ashimpact::curves

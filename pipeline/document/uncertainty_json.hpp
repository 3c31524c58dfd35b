// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/json/document.hpp"
#include "solver/inference/outcomes/measured_critical_velocity.hpp"
#include "solver/statistics/propagation.hpp"

namespace ashimpact {

/// How v_c got its interval: sequence and number of evaluations, mean and median, factors by their Sobol
/// indices, relative standard uncertainties of the inputs, and those taken as exactly known.
[[nodiscard]] Json propagation_json(const Propagation& propagation, const std::vector<RandomInput>& inputs);

/// The critical velocity that outcomes show, or that was reported.
[[nodiscard]] Json measured_velocity_json(const MeasuredCriticalVelocity& measured);

/// Verdict on a modelled v_c, null deviation where there is nothing to measure it in.
/// @param same_impacts both come from the same impacts, and share errors
[[nodiscard]] Json check_json(const Interval& model, const MeasuredCriticalVelocity& measured,
                              bool same_impacts = false);

}  // namespace ashimpact

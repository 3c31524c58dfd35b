// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/json/view.hpp"
#include "pipeline/run/results/critical_velocity.hpp"

namespace ashimpact {

/// How v_c got its interval: sequence and number of evaluations, mean and median, factors by their Sobol
/// indices, relative standard uncertainties of the inputs, and those taken as exactly known.
[[nodiscard]] Json velocity_uncertainty_json(const VelocityUncertainty& uncertainty);
[[nodiscard]] VelocityUncertainty read_velocity_uncertainty(const View& node);

/// The critical velocity that outcomes show, or that was reported.
[[nodiscard]] Json measured_velocity_json(const MeasuredCriticalVelocity& measured);
[[nodiscard]] MeasuredCriticalVelocity read_measured_velocity(const View& node);

/// Verdict on a modelled v_c, null deviation where there is nothing to measure it in.
[[nodiscard]] Json check_json(const CriticalVelocityCheck& check);
[[nodiscard]] CriticalVelocityCheck read_check(const View& node);

}  // namespace ashimpact

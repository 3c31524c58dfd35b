// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/json/view.hpp"
#include "solver/inference/curve/headline.hpp"
#include "solver/inference/extrapolation/damping_curve_fit.hpp"
#include "solver/inference/outcomes/estimate_comparison.hpp"

namespace ashimpact {

/// A fit of eta(e_n) to impacts: coefficients in ascending powers with covariance, critical damping and
/// critical velocity (for the contact as given) with 95 % intervals, goodness, and for every rebound its
/// residual, its leverage and what leaving it out changes.
/// @param numbers of the impacts that the fit was given, from 1 on, in its order
[[nodiscard]] Json damping_fit_json(const DampingCurveFit& fit, const std::vector<std::size_t>& numbers);

/// What a propagation needs of a fit, from damping_fit_json().
[[nodiscard]] DampingCurveFit read_damping_fit(const View& node);

/// What the impacts support: critical damping and velocity with their intervals, and what they rest on.
[[nodiscard]] Json damping_estimate_json(const CriticalVelocityEstimate& estimate);

/// eta_c of damping_estimate_json().
[[nodiscard]] Interval read_critical_damping(const View& node);

/// What the paper's extrapolation and the estimate say of one another.
[[nodiscard]] Json comparison_json(const FitComparison& comparison);

}  // namespace ashimpact

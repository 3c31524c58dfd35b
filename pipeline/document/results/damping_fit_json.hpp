// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/json/view.hpp"
#include "pipeline/run/results/fit.hpp"

namespace ashimpact {

/// A fit of eta(e_n) to impacts: coefficients in ascending powers with covariance, critical damping and
/// critical velocity (for the contact as given) with 95 % intervals, goodness, and for every rebound its
/// residual, its leverage and what leaving it out changes. Impacts are numbered from 1 on.
[[nodiscard]] Json damping_fit_json(const DampingCurveFit& fit);
[[nodiscard]] DampingCurveFit read_damping_fit(const View& node);

/// What the impacts support: critical damping and velocity with their intervals, and what they rest on.
[[nodiscard]] Json damping_estimate_json(const DampingEstimate& estimate);
[[nodiscard]] DampingEstimate read_damping_estimate(const View& node);

/// The paper's extrapolation and the estimate compared.
[[nodiscard]] Json comparison_json(const FitComparison& comparison);
[[nodiscard]] FitComparison read_comparison(const View& node);

/// The least and the greatest restitution of a fit [1].
[[nodiscard]] std::array<double, 2> read_range(const View& node);

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/inference/extrapolation/damping_curve_fit.hpp"

namespace ashimpact {

/// Checks that a fitted v_c does not lie above clear rebounds among the impacts it was fitted to.
///
/// A rebound is clear if v_r exceeds three standard uncertainties of the fit, which may have enlarged or
/// estimated them. For the slowest rebound the error of v_in is allowed for that the slowest of so many may
/// have. Outliers of a robust fit (weight below 0.5) and rebounds that no damping gives say nothing.
/// @throws InputError if the lower end of the interval of v_c lies above that
void require_rebounds_above(const DampingCurveFit& fit, const MeasurementSet& set);

}  // namespace ashimpact

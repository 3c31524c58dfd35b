#pragma once

#include "solver/uncertainty/likelihood/damping_curve_fit.hpp"

namespace ashimpact {

/// Checks a fitted v_c against the impacts it was fitted to: below v_c nothing rebounds.
///
/// A rebound is clear if v_r exceeds three standard uncertainties (those of the fit, if it enlarged or
/// estimated the noise). The v_in of the slowest clear rebound is allowed the noise that the slowest of so
/// many has. @throws InputError if v_c, less its uncertainty, lies above that
void require_rebounds_above(const DampingCurveFit& fit, const MeasurementSet& set);

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ostream>

#include "pipeline/case/case.hpp"
#include "solver/inference/calibration/calibration.hpp"

namespace ashimpact {

/// Calibrates a problem under the hypotheses that its case allows and prints them beside one another, with
/// averages: moduli from XRD or one contact modulus, one density or one a size, the wall as given, free or
/// rigid, exact impacts or Eq. 31 at a finite step, contact times by the laws that have published fits; w is
/// always free. If not all observations can be calibrated, v_c alone is.
/// @param data with its samples in the order of the problem
void print_hypotheses(const Case& data, const CalibrationProblem& problem, bool json, std::ostream& out);

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/inference/calibration/calibration.hpp"

namespace ashimpact {

/// How calibrated constants follow the contact modulus that they were calibrated at, to first order: the
/// exponents of powers of E*, where the E* of all samples change in the same ratio [1].
struct CalibrationResponse {
    double density = 0.0;           ///< of the sample
    double work_of_adhesion = 0.0;  ///< of the sample
};

/// The response of each sample's constants, by linearising the least squares at the constants of the problem,
/// which have to be calibrated ones. A constant that is not free does not follow.
/// @throws InputError like calibrate(); ConvergenceError
[[nodiscard]] std::vector<CalibrationResponse> response_to_contact_modulus(const CalibrationProblem& problem);

}  // namespace ashimpact

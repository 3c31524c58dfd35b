// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Dense>

#include "solver/inference/calibration/calibration.hpp"

namespace ashimpact {

/// Predictions from given samples beside the observations, and how well each is known.
struct CalibrationResiduals {
    std::vector<CalibrationResidual> critical_velocities;
    std::vector<CalibrationResidual> contact_times;
    /// Covariance of ln(predicted/observed), velocities first. The damping at v_c and the constant term of
    /// the fit that a contact time rests on are one printed number, so their rounding is one error.
    Eigen::MatrixXd covariance;
};

[[nodiscard]] CalibrationResiduals calibration_residuals(const CalibrationProblem& problem,
                                                         const std::vector<CalibrationSample>& samples);

/// ln(predicted/observed), velocities first. @throws InputError where a law has no critical velocity
[[nodiscard]] Eigen::VectorXd logarithmic_residuals(const CalibrationProblem& problem,
                                                    const std::vector<CalibrationSample>& samples);

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/inference/extrapolation/restitution_distances.hpp"

namespace ashimpact {

/// Coefficients of the curve closest to the rebounds, by least squares of their distances.
/// @param start coefficients of a similar curve @throws ConvergenceError
[[nodiscard]] Eigen::VectorXd closest(const ContactModel& model, const RestitutionData& data,
                                      const Eigen::VectorXd& start);

/// Like closest(), with bisquare weights, which are stored in @p data.
[[nodiscard]] Eigen::VectorXd closest_robustly(const ContactModel& model, RestitutionData& data,
                                               Eigen::VectorXd start);

}  // namespace ashimpact

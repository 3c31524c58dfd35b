#pragma once

#include "solver/uncertainty/likelihood/restitution_distances.hpp"

namespace ashimpact {

/// Coefficients whose curve passes closest to the rebounds, from a start close by. @throws ConvergenceError
[[nodiscard]] Eigen::VectorXd closest(const ContactModel& model, const RestitutionData& data,
                                      const Eigen::VectorXd& start);

/// The same with bisquare weights, which are left in @p data.
[[nodiscard]] Eigen::VectorXd closest_robustly(const ContactModel& model, RestitutionData& data,
                                               Eigen::VectorXd start);

}  // namespace ashimpact

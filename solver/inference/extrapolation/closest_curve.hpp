// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Dense>

#include "solver/inference/extrapolation/restitution_curve.hpp"

namespace ashimpact {

/// Data of a fit of eta(e_n). Robust fits give rebounds weights below one.
struct RestitutionData {
    std::vector<Measurement> rebounds;  ///< each with its noise
    std::vector<double> weights;
    double greatest_restitution;  ///< upper end of the curve
};

/// Distances of the rebounds, in units of their noise, from the curve that a damping implies in the plane
/// (v_in, v_r), as a function of the coefficients of eta(e_n): orthogonal-distance regression. It accounts
/// for the errors of both velocities, and so for the correlated ones of e and eta.
class RestitutionDistances {
  public:
    RestitutionDistances(const ContactModel& model, const RestitutionData& data);

    struct Rows {
        Eigen::VectorXd residuals;  ///< signed distances times the roots of the weights
        Eigen::MatrixXd jacobian;
        std::vector<double> restitutions;  ///< of the nearest points of the curve
    };
    /// Rows for coefficients. If the curve does not exist, the residuals are so large that a fit rejects the
    /// step.
    [[nodiscard]] const Rows& rows(const Eigen::VectorXd& coefficients) const;

  private:
    [[nodiscard]] Rows computed(const Eigen::VectorXd& coefficients) const;
    [[nodiscard]] double start_of(std::size_t rebound) const;

    const ContactModel* model_;
    const RestitutionData* data_;
    // Cache of the last evaluation: a fit calls for residuals and jacobian one after the other, and the last
    // curve gives first guesses for the next one.
    mutable Eigen::VectorXd last_;
    mutable Rows rows_;
    mutable std::optional<RestitutionCurve> curve_;
};

/// Coefficients of the curve closest to the rebounds, by least squares of their distances.
/// @param start coefficients of a similar curve @throws ConvergenceError
[[nodiscard]] Eigen::VectorXd closest(const ContactModel& model, const RestitutionData& data,
                                      const Eigen::VectorXd& start);

/// Like closest(), with bisquare weights, which are stored in @p data.
[[nodiscard]] Eigen::VectorXd closest_robustly(const ContactModel& model, RestitutionData& data,
                                               Eigen::VectorXd start);

/// Covariance of coefficients, (J^T J)^-1 of the jacobian of normalised residuals.
[[nodiscard]] Eigen::MatrixXd covariance_from(const Eigen::MatrixXd& jacobian);

}  // namespace ashimpact

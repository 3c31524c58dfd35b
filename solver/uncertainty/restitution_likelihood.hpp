#pragma once

#include "solver/measurement/contact_model.hpp"
#include "solver/measurement/measurement.hpp"
#include "solver/uncertainty/restitution_curve.hpp"

#include <Eigen/Dense>

#include <optional>
#include <vector>

namespace ashimpact {

/// Whether an impact stuck, as evidence on v_c.
struct ImpactOutcome {
    double velocity;              ///< v_in as measured [m/s]
    double standard_uncertainty;  ///< of it [m/s]
    bool captured;
};

/// What a fit of eta(e_n) sees. Weights below one take a rebound back (robust fits).
struct RestitutionData {
    std::vector<Measurement> rebounds;  ///< each with its noise
    std::vector<double> weights;
    std::vector<ImpactOutcome> outcomes;  ///< empty: captures are not used
    double greatest_restitution;          ///< upper end of the curve
};

/// -2 ln L of impacts as a function of the coefficients of eta(e_n), as a sum of squares.
///
/// A rebound contributes its squared distance, in units of its noise, from the curve that the damping implies
/// in the plane (v_in, v_r): orthogonal-distance regression, in which the errors of both velocities, hence
/// the correlated ones of e and eta, are treated as what they are. An outcome contributes the probability of
/// what was observed given the measured velocity, Phi((v_c - v)/u) for a capture and the rest for a rebound;
/// that takes the density of the true velocities to be the same just below and just above v_c.
class RestitutionLikelihood {
  public:
    RestitutionLikelihood(const ContactModel& model, RestitutionData data);

    struct Rows {
        Eigen::VectorXd residuals;  ///< rebounds, then outcomes
        Eigen::MatrixXd jacobian;
        std::vector<double> restitutions;  ///< of the nearest points of the curve
    };
    /// Rows for coefficients; where the curve does not exist, residuals too large for any fit to stay there.
    [[nodiscard]] const Rows& rows(const Eigen::VectorXd& coefficients) const;

    /// Curvature H of half of -2 ln L, and variance K of its gradient. A rebound near v_c speaks twice, with
    /// its distance and with its outcome, so they differ and the covariance is H^-1 K H^-1 (Godambe).
    struct Information {
        Eigen::MatrixXd curvature;
        Eigen::MatrixXd variability;
        [[nodiscard]] Eigen::MatrixXd covariance() const;
    };
    [[nodiscard]] Information information(const Eigen::VectorXd& coefficients) const;

    [[nodiscard]] const RestitutionData& data() const { return data_; }
    [[nodiscard]] const ContactModel& model() const { return *model_; }

  private:
    [[nodiscard]] Rows computed(const Eigen::VectorXd& coefficients) const;
    [[nodiscard]] double start_of(std::size_t rebound) const;

    const ContactModel* model_;
    RestitutionData data_;
    // What the last coefficients gave: a fit asks for residuals and slopes one after the other, and the next
    // coefficients are close by.
    mutable Eigen::VectorXd last_;
    mutable Rows rows_;
    mutable std::optional<RestitutionCurve> curve_;
};

}  // namespace ashimpact

#pragma once

#include "solver/uncertainty/interval.hpp"
#include "solver/uncertainty/likelihood/impact_likelihood.hpp"
#include "solver/uncertainty/likelihood/restitution_distances.hpp"

#include <optional>
#include <vector>

namespace ashimpact {

/// Coefficients whose curve passes closest to the rebounds, from a start close by. @throws ConvergenceError
[[nodiscard]] Eigen::VectorXd closest(const ContactModel& model, const RestitutionData& data,
                                      const Eigen::VectorXd& start);

/// The same with bisquare weights, which are left in @p data.
[[nodiscard]] Eigen::VectorXd closest_robustly(const ContactModel& model, RestitutionData& data,
                                               Eigen::VectorXd start);

/// Where a likelihood is greatest, and its curvature there.
struct LikelihoodMaximum {
    Eigen::VectorXd coefficients;
    double value;  ///< -ln L
    Eigen::MatrixXd covariance;
};

/// The greatest likelihood close to a start. @throws ConvergenceError
/// @param covariance of the coefficients, about, where it is known: it saves finding the curvature at the
/// start
[[nodiscard]] LikelihoodMaximum maximise(ImpactLikelihood& likelihood, const Eigen::VectorXd& start,
                                         const std::optional<Eigen::MatrixXd>& covariance = std::nullopt);

/// The best of what is reached from several starts. @throws ConvergenceError where none leads anywhere
[[nodiscard]] LikelihoodMaximum maximise_from(ImpactLikelihood& likelihood,
                                              const std::vector<Eigen::VectorXd>& starts);

/// Interval of eta_c, the first coefficient, from the profile likelihood.
/// @param quantile half width of the interval in standard uncertainties, were the likelihood normal
[[nodiscard]] Interval profile_critical_damping(ImpactLikelihood& likelihood, const LikelihoodMaximum& best,
                                                double quantile);

}  // namespace ashimpact

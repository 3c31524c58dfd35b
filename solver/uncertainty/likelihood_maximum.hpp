#pragma once

#include "solver/uncertainty/interval.hpp"
#include "solver/uncertainty/restitution_likelihood.hpp"

#include <vector>

namespace ashimpact {

/// Coefficients of greatest likelihood from a start close by. @throws ConvergenceError
[[nodiscard]] Eigen::VectorXd maximise(const RestitutionLikelihood& likelihood, const Eigen::VectorXd& start);

/// The best of what is reached from several starts. @throws ConvergenceError where none leads anywhere
[[nodiscard]] Eigen::VectorXd maximise_from(const RestitutionLikelihood& likelihood,
                                            const std::vector<Eigen::VectorXd>& starts);

/// Coefficients of a curve of @p order from nothing: by least squares up to the second order, by way of the
/// lower order above. A higher order begun on its own may end as a curve that folds back near v_c.
[[nodiscard]] Eigen::VectorXd maximise_upwards(const RestitutionLikelihood& likelihood, int order);

/// The same coefficients as a polynomial of higher order.
[[nodiscard]] Eigen::VectorXd raised(const Eigen::VectorXd& coefficients, int order);

/// The same with bisquare weights, which are left in @p data.
[[nodiscard]] Eigen::VectorXd maximise_robustly(const ContactModel& model, RestitutionData& data,
                                                Eigen::VectorXd start);

/// Interval of eta_c, the first coefficient, from the profile likelihood.
/// @param quantile half width of the interval in standard uncertainties, were the likelihood normal
[[nodiscard]] Interval profile_critical_damping(const RestitutionLikelihood& likelihood,
                                                const Eigen::VectorXd& best, double quantile);

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/calibration/calibration_response.hpp"

#include <cmath>

#include "solver/inference/calibration/calibration_fit.hpp"

namespace ashimpact {

namespace {

constexpr double log_step = 1e-3;  ///< of the logarithms, for differences

/// The problem at contact moduli multiplied by @p factor.
CalibrationProblem with_moduli(CalibrationProblem problem, double factor) {
    for (CalibrationSample& sample : problem.samples)
        sample.contact_modulus = factor * sample.contact().contact_modulus;
    return problem;
}

}  // namespace

std::vector<CalibrationResponse> response_to_contact_modulus(const CalibrationProblem& problem) {
    require_solvable(problem);
    const std::vector<CalibrationSlot> slots = slots_of(problem);
    const Eigen::VectorXd at = starting_logarithms(problem);
    const CalibrationObjective objective(problem, at);
    const auto central = [&](const auto& residuals) -> Eigen::VectorXd {
        return (residuals(log_step) - residuals(-log_step)) / (2.0 * log_step);
    };
    const Eigen::VectorXd by_modulus = central(
        [&](double change) { return objective.residuals(with_moduli(problem, std::exp(change)), at); });
    Eigen::MatrixXd by_constant(by_modulus.size(), at.size());
    for (Eigen::Index i = 0; i < at.size(); ++i)
        by_constant.col(i) = central([&](double change) {
            Eigen::VectorXd moved = at;
            moved[i] += change;
            return objective.residuals(moved);
        });
    const Eigen::VectorXd exponents = -by_constant.colPivHouseholderQr().solve(by_modulus);
    std::vector<CalibrationResponse> responses(problem.samples.size());
    for (std::size_t i = 0; i < slots.size(); ++i)
        for (std::size_t s = 0; s < responses.size(); ++s) {
            if (slots[i].sample && *slots[i].sample != s) continue;
            const double exponent = exponents[static_cast<Eigen::Index>(i)];
            if (slots[i].quantity == CalibrationQuantity::density) responses[s].density = exponent;
            if (slots[i].quantity == CalibrationQuantity::work_of_adhesion)
                responses[s].work_of_adhesion = exponent;
        }
    return responses;
}

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Dense>

#include "solver/inference/calibration/calibration.hpp"
#include "solver/numeric/gsl/fit.hpp"

namespace ashimpact {

/// One fitted number: a quantity of one sample, or of all.
struct CalibrationSlot {
    CalibrationQuantity quantity;
    std::optional<std::size_t> sample;
};

[[nodiscard]] std::vector<CalibrationSlot> slots_of(const CalibrationProblem& problem);

/// @throws InputError without free constants, with fewer observations than those, or with unknown samples
void require_solvable(const CalibrationProblem& problem);

/// The logarithms of a problem's starting values.
[[nodiscard]] Eigen::VectorXd starting_logarithms(const CalibrationProblem& problem);

/// A problem's samples with these logarithms of the fitted numbers in place.
[[nodiscard]] std::vector<CalibrationSample> samples_with(const CalibrationProblem& problem,
                                                          const std::vector<CalibrationSlot>& slots,
                                                          const Eigen::VectorXd& logarithms);

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

/// Normalised, uncorrelated residuals of a problem. The weights are computed once, at the point given to the
/// constructor, so that chi^2 keeps its meaning during a fit.
class CalibrationObjective {
  public:
    CalibrationObjective(const CalibrationProblem& problem, const Eigen::VectorXd& logarithms);

    [[nodiscard]] Eigen::VectorXd residuals(const Eigen::VectorXd& logarithms) const {
        return residuals(*problem_, logarithms);
    }
    /// Those of another problem with the same observations, with the weights of this one.
    [[nodiscard]] Eigen::VectorXd residuals(const CalibrationProblem& problem,
                                            const Eigen::VectorXd& logarithms) const;
    /// Fit from @p start; the number at index @p held, if given, keeps its value. @throws ConvergenceError
    [[nodiscard]] gsl::NonlinearFit fit(const Eigen::VectorXd& start,
                                        std::optional<Eigen::Index> held = std::nullopt) const;

  private:
    const CalibrationProblem* problem_;
    std::vector<CalibrationSlot> slots_;
    Eigen::LLT<Eigen::MatrixXd> covariance_;
};

}  // namespace ashimpact

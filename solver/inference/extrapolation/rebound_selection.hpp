// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Dense>

#include "solver/inference/extrapolation/closest_curve.hpp"

namespace ashimpact {

enum class Exclusion {
    above_reach,  ///< v_r exceeds v_in by more than three standard uncertainties, or at all if unknown
};

struct ExcludedRebound {
    std::size_t index;
    Exclusion reason;
};

/// The rebounds of a set that a fit can use, with their indices in the set.
struct ReboundSelection {
    RestitutionData data;  ///< without captures; noise that is not known is 1 m/s
    std::vector<std::size_t> indices;
    std::vector<ExcludedRebound> excluded;
    bool noise_known;
};

/// @param robust the curve ends above the restitutions that neighbours share, not above that of an outlier,
///     which only a curve that folds back could reach
[[nodiscard]] ReboundSelection select_rebounds(const ContactModel& model, const MeasurementSet& set,
                                               bool robust = false);

/// @throws InputError unless there are enough distinct rebounds for a curve of this order
void require_enough(const ReboundSelection& selection, const MeasurementSet& set, int order);

/// First coefficients, by least squares of the inverted damping on the restitution: biased by the noise in
/// both, but close. A lower order is used if @p order gives no curve. @throws ConvergenceError if no order
/// does
/// @param robust by the least median of their residuals, so that outliers do not matter
[[nodiscard]] Eigen::VectorXd starting_coefficients(const ContactModel& model, const RestitutionData& data,
                                                    int order, bool robust = false);

}  // namespace ashimpact

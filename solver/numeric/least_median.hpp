// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include <Eigen/Dense>

namespace ashimpact {

/// A linear fit y = X c that nearly half of the rows may miss: of fits through as many rows each as there are
/// coefficients, 500 of them drawn always alike, the one with the least median residual (Rousseeuw 1984,
/// J. Am. Stat. Assoc. 79:871). It is near the truth, not the best there is: a start for other fits.
/// @param design X, at least as many rows as columns; of more than 500 rows evenly spaced ones are judged
/// @param is_allowed which coefficients may be taken
/// @return none where none are allowed or all rows are alike
[[nodiscard]] std::optional<Eigen::VectorXd> least_median(
    const Eigen::MatrixXd& design, const Eigen::VectorXd& observed,
    const std::function<bool(const Eigen::VectorXd&)>& is_allowed);

}  // namespace ashimpact

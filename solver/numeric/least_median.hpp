// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include <Eigen/Dense>

namespace ashimpact {

/// A linear fit y = X c that nearly half of the rows may miss: of fits through as many rows each as there are
/// coefficients, 500 of them drawn always alike, the one with the least median residual (Rousseeuw 1984,
/// J. Am. Stat. Assoc. 79:871). It is near the truth, not the best there is: a start for other fits.
/// @param design X, at least as many rows as columns; of more than 500 rows evenly spaced ones are judged
/// @param is_allowed which coefficients may be taken
/// @return none where none are allowed or all rows are alike
[[nodiscard]] inline std::optional<Eigen::VectorXd> least_median(
    const Eigen::MatrixXd& design, const Eigen::VectorXd& observed,
    const std::function<bool(const Eigen::VectorXd&)>& is_allowed) {
    constexpr int tried = 500;
    constexpr Eigen::Index most_rows = 500;
    const Eigen::Index stride = 1 + (design.rows() - 1) / most_rows;
    std::minstd_rand random;  // the same draws for the same impacts
    std::optional<Eigen::VectorXd> best;
    double least = std::numeric_limits<double>::infinity();
    std::vector<double> residuals;
    for (int i = 0; i < tried; ++i) {
        Eigen::MatrixXd rows(design.cols(), design.cols());
        Eigen::VectorXd values(design.cols());
        for (Eigen::Index k = 0; k < design.cols(); ++k) {
            const auto drawn =
                static_cast<Eigen::Index>(random() % static_cast<unsigned long>(design.rows()));
            rows.row(k) = design.row(drawn);
            values[k] = observed[drawn];
        }
        const Eigen::FullPivLU<Eigen::MatrixXd> solver(rows);
        if (!solver.isInvertible()) continue;
        const Eigen::VectorXd coefficients = solver.solve(values);
        residuals.clear();
        for (Eigen::Index row = 0; row < design.rows(); row += stride)
            residuals.push_back(std::abs(observed[row] - design.row(row).dot(coefficients)));
        const auto middle = residuals.begin() + static_cast<std::ptrdiff_t>(residuals.size() / 2);
        std::nth_element(residuals.begin(), middle, residuals.end());
        if (!(*middle < least) || !is_allowed(coefficients)) continue;
        least = *middle;
        best = coefficients;
    }
    return best;
}

}  // namespace ashimpact

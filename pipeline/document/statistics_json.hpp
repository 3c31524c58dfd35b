// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include <Eigen/Dense>

#include "core/json/document.hpp"
#include "solver/statistics/interval.hpp"

namespace ashimpact {

/// The rows of a matrix.
[[nodiscard]] Json matrix_json(const Eigen::MatrixXd& matrix);
/// The values of a vector.
[[nodiscard]] std::vector<double> to_std_vector(const Eigen::VectorXd& vector);

/// The number, or null where it is not finite.
[[nodiscard]] Json finite_json(double value);

/// {"value", "unit", "standard_uncertainty"} of a result.
[[nodiscard]] Json estimate_json(const Interval& interval, std::string_view unit);
/// {"level", "lower", "upper"} of a result; an end that the data do not bound is null.
[[nodiscard]] Json interval_json(const Interval& interval, std::string_view unit);

}  // namespace ashimpact

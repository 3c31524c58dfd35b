// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/document/statistics_json.hpp"

#include <cmath>

#include "core/json/view.hpp"

namespace ashimpact {

Json matrix_json(const Eigen::MatrixXd& matrix) {
    Json rows = Json::array();
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
        Json row = Json::array();
        for (Eigen::Index j = 0; j < matrix.cols(); ++j) row.push_back(matrix(i, j));
        rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<double> to_std_vector(const Eigen::VectorXd& vector) {
    return {vector.data(), vector.data() + vector.size()};
}

Json finite_json(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json estimate_json(const Interval& interval, std::string_view unit) {
    Json json = quantity_json(interval.value, unit);
    if (std::isfinite(interval.standard_uncertainty))
        json["standard_uncertainty"] = interval.standard_uncertainty;
    return json;
}

Json interval_json(const Interval& interval, std::string_view unit) {
    const auto end = [&](const std::optional<double>& value) {
        return value && std::isfinite(*value) ? quantity_json(*value, unit) : Json(nullptr);
    };
    return {{"level", confidence}, {"lower", end(interval.lower)}, {"upper", end(interval.upper)}};
}

}  // namespace ashimpact

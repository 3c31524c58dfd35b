// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/oracles/dem/extrapolation.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <utility>

namespace ashimpact::oracles {

namespace {

using Row = std::vector<long double>;  // coefficients and, last, the right-hand side

std::vector<double> solve(std::vector<Row> rows) {
    const std::size_t n = rows.size();
    for (std::size_t column = 0; column < n; ++column) {
        std::size_t pivot = column;
        for (std::size_t i = column + 1; i < n; ++i)
            if (std::abs(rows[i][column]) > std::abs(rows[pivot][column])) pivot = i;
        std::swap(rows[column], rows[pivot]);
        for (std::size_t i = 0; i < n; ++i) {
            if (i == column) continue;
            const long double factor = rows[i][column] / rows[column][column];
            for (std::size_t j = column; j <= n; ++j) rows[i][j] -= factor * rows[column][j];
        }
    }
    std::vector<double> solution(n);
    for (std::size_t i = 0; i < n; ++i) solution[i] = static_cast<double>(rows[i][n] / rows[i][i]);
    return solution;
}

}  // namespace

std::vector<double> fit_powers(std::span<const double> steps, std::span<const double> values,
                               std::span<const double> powers) {
    assert(steps.size() == values.size() && steps.size() == powers.size() + 1);
    const long double unit = steps.front();
    std::vector<Row> rows;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        Row row{1};
        for (const double power : powers)
            row.push_back(std::pow(steps[i] / unit, static_cast<long double>(power)));
        row.push_back(values[i]);
        rows.push_back(std::move(row));
    }
    auto coefficients = solve(std::move(rows));
    for (std::size_t i = 0; i < powers.size(); ++i)
        coefficients[i + 1] /= static_cast<double>(std::pow(unit, static_cast<long double>(powers[i])));
    return coefficients;
}

Estimate extrapolate(std::span<const double> steps, std::span<const double> values,
                     std::span<const double> powers) {
    const double best = fit_powers(steps, values, powers).front();
    const auto lower = powers.first(powers.size() - 1);
    const double fine = fit_powers(steps.subspan(1), values.subspan(1), lower).front();
    const double coarse =
        fit_powers(steps.first(lower.size() + 1), values.first(lower.size() + 1), lower).front();
    return {best, std::max(std::abs(best - fine), std::abs(best - coarse))};
}

}  // namespace ashimpact::oracles

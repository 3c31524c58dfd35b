// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace ashimpact {

/// Weighted values of one parameter, in ascending order.
class MarginalSample {
  public:
    /// @param values pairs of value and weight; the weights add up to 1
    explicit MarginalSample(std::vector<std::pair<double, double>> values) : sorted_(std::move(values)) {
        std::sort(sorted_.begin(), sorted_.end());
    }

    /// Interpolated, half of a value's weight lying below it, so that rounding moves no result.
    [[nodiscard]] double quantile(double probability) const {
        double before = 0.0;
        for (std::size_t i = 0; i < sorted_.size(); ++i) {
            const double here =
                (i > 0 ? before + 0.5 * sorted_[i - 1].second : 0.0) + 0.5 * sorted_[i].second;
            if (here >= probability) {
                if (i == 0) return sorted_[0].first;
                const double share = (probability - before) / (here - before);
                return sorted_[i - 1].first + share * (sorted_[i].first - sorted_[i - 1].first);
            }
            before = here;
        }
        return sorted_.back().first;
    }

    [[nodiscard]] double mean() const {
        double sum = 0.0;
        for (const auto& [x, share] : sorted_) sum += share * x;
        return sum;
    }

    [[nodiscard]] double standard_deviation() const {
        const double middle = mean();
        double sum = 0.0;
        for (const auto& [x, share] : sorted_) sum += share * (x - middle) * (x - middle);
        return std::sqrt(sum);
    }

  private:
    std::vector<std::pair<double, double>> sorted_;
};

}  // namespace ashimpact

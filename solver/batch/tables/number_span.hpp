// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

namespace ashimpact::batch {

/// A range of the third number of a law's impacts within which all else is smooth in a coordinate z from -1
/// to 1: linear in the number, or in the root of its distance to a number below the range.
class NumberSpan {
  public:
    NumberSpan() = default;
    /// @param root the number of whose distance z is linear in the root
    NumberSpan(double lower, double upper, std::optional<double> root = {})
        : lower_(lower), upper_(upper), rooted_(root.has_value()), root_(root.value_or(0.0)) {
        middle_ = 0.5 * (coordinate(lower) + coordinate(upper));
        stretch_ = 2.0 / (coordinate(upper) - coordinate(lower));
    }

    [[nodiscard]] double lower() const { return lower_; }
    [[nodiscard]] double upper() const { return upper_; }
    [[nodiscard]] double z(double number) const { return (coordinate(number) - middle_) * stretch_; }
    [[nodiscard]] double number_at(double z) const {
        const double x = middle_ + z / stretch_;
        return std::clamp(rooted_ ? root_ + x * x : x, lower_, std::nextafter(upper_, lower_));
    }

  private:
    [[nodiscard]] double coordinate(double number) const {
        return rooted_ ? std::sqrt(number - root_) : number;
    }

    double lower_ = 0.0;
    double upper_ = 1.0;
    bool rooted_ = false;
    double root_ = 0.0;
    double middle_ = 0.5;
    double stretch_ = 2.0;
};

}  // namespace ashimpact::batch

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

namespace ashimpact {

/// A measured curve, interpolated without overshoot between its points (Steffen 1990, by GSL): monotone data
/// stay monotone, and no value lies outside its two neighbours.
class MeasuredCurve {
  public:
    /// @param x strictly increasing; @param y as long as x, at least 3 points, all finite
    /// @throws InputError
    MeasuredCurve(std::span<const double> x, std::span<const double> y);

    /// Value at @p x [unit of y]. @throws InputError outside the measured range: nothing is extrapolated
    [[nodiscard]] double operator()(double x) const;
    [[nodiscard]] double lower() const;  ///< first abscissa [unit of x]
    [[nodiscard]] double upper() const;  ///< last abscissa [unit of x]

  private:
    struct Spline;
    std::shared_ptr<const Spline> spline_;
};

}  // namespace ashimpact

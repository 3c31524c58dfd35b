// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

namespace ashimpact::gsl {

/// Steffen's interpolation through given points: no value lies outside its two neighbours (Steffen 1990).
class MonotoneSpline {
  public:
    /// @param x strictly increasing; @param y as long as x, at least 3 points @throws ConvergenceError
    MonotoneSpline(std::span<const double> x, std::span<const double> y);

    /// Value at @p x, from the first to the last abscissa [unit of y].
    [[nodiscard]] double operator()(double x) const;
    [[nodiscard]] double lower() const;  ///< first abscissa [unit of x]
    [[nodiscard]] double upper() const;  ///< last abscissa [unit of x]

  private:
    struct Handle;
    std::shared_ptr<const Handle> handle_;
};

}  // namespace ashimpact::gsl

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace ashimpact::test {

/// Integral of @p function from @p lower to @p upper by GSL's adaptive Gauss-Kronrod rule, to 1e-13 of itself
/// or of @p size, whichever is larger: a check on the solver that shares no line with it.
/// @throws std::runtime_error where GSL reports a failure
[[nodiscard]] double integral(const std::function<double(double)>& function, double lower, double upper,
                              double size = 0.0);

/// Integral of 2^n + 1 evenly spaced samples (n >= 4) by Romberg's extrapolation, for functions with
/// half-integer powers at either end, as forces and velocities have in time at touch and detachment: the
/// trapezoidal sums then err in the powers of the spacing below (Euler-Maclaurin; Navot 1961).
[[nodiscard]] inline double romberg(std::span<const double> samples, double spacing) {
    constexpr std::array<double, 12> powers{1.5, 2.0, 2.5, 3.5, 4.0, 4.5, 5.5, 6.0, 6.5, 7.5, 8.0, 8.5};
    constexpr std::size_t coarsest = 16;  // intervals; coarser sums are not in their asymptotic range
    const std::size_t intervals = samples.size() - 1;
    std::vector<long double> column;  // trapezoidal sums, coarse to fine
    for (std::size_t stride = intervals / coarsest; stride >= 1; stride /= 2) {
        long double sum = (static_cast<long double>(samples.front()) + samples.back()) / 2;
        for (std::size_t i = stride; i < intervals; i += stride) sum += samples[i];
        column.push_back(sum * spacing * static_cast<long double>(stride));
    }
    for (std::size_t k = 0; column.size() > 1; ++k) {
        const long double factor = std::exp2(static_cast<long double>(powers.at(k)));
        for (std::size_t i = 0; i + 1 < column.size(); ++i) {
            column[i] = (factor * column[i + 1] - column[i]) / (factor - 1);
        }
        column.pop_back();
    }
    return static_cast<double>(column.front());
}

}  // namespace ashimpact::test

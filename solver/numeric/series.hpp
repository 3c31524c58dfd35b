// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "solver/numeric/polynomial.hpp"

namespace ashimpact {

/// Taylor order at which a step of radius/e^2 is exact to the rounding of Real (Jorba & Zou 2005).
template <class Real>
inline constexpr int taylor_order = std::numeric_limits<Real>::digits * 347 / 1000 + 2;

/// Truncated power series sum c[n] h^n.
template <class Real>
using Series = std::array<Real, taylor_order<Real> + 1>;

/// Value of the series at @p h.
template <class Real, std::size_t size>
[[nodiscard]] Real value(const std::array<Real, size>& c, Real h) {
    Real sum = c[size - 1];
    for (std::size_t n = size - 1; n-- > 0;) sum = sum * h + c[n];
    return sum;
}

/// Coefficient n of the product of two series known up to n. Series take half their time here: a call would
/// cost a tenth of that.
template <class Real, std::size_t size>
[[nodiscard, gnu::always_inline]] inline Real product_coefficient(const std::array<Real, size>& a,
                                                                  const std::array<Real, size>& b,
                                                                  std::size_t n) {
    Real even{};  // two chains of additions hide the latency of one
    Real odd{};
    std::size_t i = 0;
    for (; i + 1 <= n; i += 2) {
        even += a[i] * b[n - i];
        odd += a[i + 1] * b[n - i - 1];
    }
    if (i <= n) even += a[i] * b[n - i];
    return even + odd;
}

/// Radius within which the terms fall off geometrically from the leading ones, by the root test on the last
/// ten coefficients, since a symmetric start leaves gaps of up to nine zeros; infinite if all ten vanish.
template <class Real, std::size_t size>
[[nodiscard]] Real radius(const std::array<Real, size>& c) {
    constexpr std::size_t leading = 3;
    constexpr std::size_t last = 10;
    static_assert(size > leading + last);
    const auto log2_of = [](Real x) {  // -inf for 0; the logarithm of a Real would take ten times as long
        int exponent = 0;
        const auto mantissa = static_cast<double>(std::frexp(std::abs(x), &exponent));
        return std::log2(mantissa) + exponent;
    };
    std::array<double, leading> first;
    for (std::size_t m = 0; m < leading; ++m) first[m] = log2_of(c[m]);
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t n = size - last; n < size; ++n) {
        const double tail = log2_of(c[n]);
        double largest = -std::numeric_limits<double>::infinity();
        for (std::size_t m = 0; m < leading; ++m)
            largest = std::max(largest, (first[m] - tail) / static_cast<double>(n - m));
        if (tail > -std::numeric_limits<double>::infinity()) smallest = std::min(smallest, largest);
    }
    return std::exp2(static_cast<Real>(smallest));
}

/// Series of the powers of a series; entry 0 is unused.
template <class Real>
using PowerSeries = std::array<Series<Real>, Polynomial<Real>::capacity>;

/// The powers of a series that polynomials need, each as one product of two lower ones.
class PowerChain {
  public:
    /// Adds the powers whose coefficients in @p p are not 0.
    template <class Real>
    void require(const Polynomial<Real>& p) {
        for (int j = 1; j <= p.degree; ++j)
            if (p[j] != Real(0)) require_power(j);
    }
    /// Computes coefficient @p n of the powers of @p x, from the coefficients before it.
    template <class Real>
    void advance(PowerSeries<Real>& powers, const Series<Real>& x, std::size_t n) const {
        powers[1][n] = x[n];
        for (std::size_t k = 0; k < length_; ++k) {
            const auto [power, left, right] = chain_[k];
            powers[power][n] = product_coefficient(powers[left], powers[right], n);
        }
    }

  private:
    struct Factors {
        std::size_t power;
        std::size_t left;
        std::size_t right;
    };
    static constexpr std::size_t capacity = Polynomial<double>::capacity;

    void require_power(int wanted) {
        const auto power = static_cast<std::size_t>(wanted);
        if (power == 1 || have_[power]) return;
        have_[1] = true;
        std::size_t left = 0;
        for (std::size_t i = 1; i < power && left == 0; ++i)
            if (have_[i] && have_[power - i]) left = i;
        if (left == 0) {
            left = power / 2;
            require_power(static_cast<int>(left));
            require_power(static_cast<int>(power - left));
        }
        chain_[length_++] = {power, left, power - left};
        have_[power] = true;
    }

    std::array<Factors, capacity> chain_{};
    std::size_t length_ = 0;
    std::array<bool, capacity> have_{};
};

/// Coefficient @p n of p(x(h)) from the series of the powers of x that PowerChain::require(p) provides.
template <class Real, class Coefficient>
[[nodiscard]] Real composed(const Polynomial<Coefficient>& p, const PowerSeries<Real>& powers,
                            std::size_t n) {
    Real sum = n == 0 ? static_cast<Real>(p[0]) : Real(0);
    for (int j = 1; j <= p.degree; ++j) {
        const auto coefficient = static_cast<Real>(p[j]);
        if (coefficient != Real(0)) sum += coefficient * powers[static_cast<std::size_t>(j)][n];
    }
    return sum;
}

}  // namespace ashimpact

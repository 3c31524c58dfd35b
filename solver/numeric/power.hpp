// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace ashimpact {

/// x^exponent by repeated multiplication, for any type with a product.
template <int exponent, class T>
[[nodiscard]] constexpr T power(const T& x) {
    static_assert(exponent >= 1);
    if constexpr (exponent == 1) {
        return x;
    } else if constexpr (exponent % 2 == 0) {
        const T half = power<exponent / 2>(x);
        return half * half;
    } else {
        return power<exponent - 1>(x) * x;
    }
}

/// The non-negative root x^(1/degree) of a non-negative floating-point number; degree 2, 3, 4 or 6.
template <int degree, class Real>
[[nodiscard]] Real root(const Real& x) {
    using std::cbrt;
    using std::sqrt;
    static_assert(degree == 2 || degree == 3 || degree == 4 || degree == 6);
    if constexpr (degree == 2) return sqrt(x);
    if constexpr (degree == 3) return cbrt(x);
    if constexpr (degree == 4) return sqrt(sqrt(x));
    if constexpr (degree == 6) return cbrt(sqrt(x));
}

/// x^(2/5) of a positive floating-point number.
template <class Real>
[[nodiscard]] Real two_fifths_power(const Real& x) {
    return std::pow(x, Real(0.4));
}

}  // namespace ashimpact

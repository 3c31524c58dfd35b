// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>

namespace ashimpact {

/// The scalar solver's number type: its extra bits separate capture from rebound where the adhesive well is a
/// million times deeper than the kinetic energy.
#ifdef ASHIMPACT_DOUBLE_PRECISION  // WebAssembly has no wider numbers than double but in software, a hundred
                                   // times slower
using Extended = double;
#else
using Extended = long double;
#endif

/// Numbers in which Taylor series of a cohesive zone are computed; its states are Extended in any case.
enum class Precision {
    extended,  ///< Extended: exact to the rounding of double
    standard,  ///< double: a third of the time, for searches and batches
};

/// A number of that type with all the digits it has: 0.1_ext.
constexpr Extended operator""_ext(long double value) {
    return static_cast<Extended>(value);
}

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

/// The h between 0 and @p step at which @p function changes sign, to rounding; function(0) and function(step)
/// must differ in sign. Bisection safeguards the secant (Illinois), so it cannot leave the bracket.
template <class Real, class Function>
[[nodiscard]] Real sign_change(Function&& function, Real step) {
    using std::abs;
    Real a{};
    Real b = step;
    Real fa = function(a);
    Real fb = function(b);
    if (fa == Real(0)) fa = -fb;  // starts on the event itself: the crossing meant is the next one
    Real h = b;
    for (int i = 0; i < 200 && fb != Real(0); ++i) {
        h = (i % 3 == 2) ? (a + b) / Real(2) : (a * fb - b * fa) / (fb - fa);
        const Real fh = function(h);
        if ((fh > Real(0)) == (fb > Real(0))) {
            fa = (i % 3 == 2) ? fa : fa / Real(2);
        } else {
            a = b;
            fa = fb;
        }
        b = h;
        fb = fh;
        if (abs(b - a) <= std::numeric_limits<Real>::epsilon() * abs(step)) break;
    }
    return b;
}

/// The root of a function that is negative at @p start and rises beyond it, to rounding of its distance. The
/// bracket begins with @p width and doubles until the sign changes.
template <class Real, class Function>
[[nodiscard]] Real root_beyond(Function&& function, Real start, Real width) {
    const auto beyond = [&](Real step) { return function(start + step); };
    while (beyond(width) < Real(0)) width *= Real(2);
    return start + sign_change<Real>(beyond, width);
}

}  // namespace ashimpact

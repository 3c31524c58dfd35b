// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "solver/numeric/polynomial.hpp"
#include "solver/numeric/series.hpp"

namespace ashimpact {

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

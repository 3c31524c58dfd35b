// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "solver/numeric/polynomial.hpp"
#include "solver/numeric/series.hpp"

namespace ashimpact {

/// Series of the powers of a series; entry 0 is unused.
template <class Real, class Goal = Real>
using PowerSeries = std::array<Series<Real, Goal>, Polynomial<Real>::capacity>;

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
    template <class Powers, class Terms>
    void advance(Powers& powers, const Terms& x, std::size_t n) const {
        powers[1][n] = x[n];
        for (std::size_t k = 0; k < length_; ++k) {
            const auto [power, left, right] = chain_[k];
            powers[power][n] = left == right ? square_coefficient(powers[left], n)
                                             : product_coefficient(powers[left], powers[right], n);
        }
    }

    /// Copies the first @p count terms of those powers into series of another number type.
    template <class From, class To>
    void copy(const From& from, To& to, std::size_t count) const {
        for (std::size_t power = 1; power < capacity; ++power)
            if (have_[power]) copy_terms(from[power], to[power], count);
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

/// The terms of a polynomial that are not 0, for its values of a series.
template <class Real>
class SparsePolynomial {
  public:
    template <class Coefficient>
    explicit SparsePolynomial(const Polynomial<Coefficient>& p) : constant_(static_cast<Real>(p[0])) {
        for (int j = 1; j <= p.degree; ++j)
            if (p[j] != Coefficient(0))
                terms_[length_++] = {static_cast<Real>(p[j]), static_cast<std::size_t>(j)};
    }
    [[nodiscard]] bool is_zero() const { return length_ == 0 && constant_ == Real(0); }
    /// Coefficient @p n of p(x(h)) from the series of the powers of x that PowerChain::require(p) provides.
    template <class Powers>
    [[nodiscard]] Real composed(const Powers& powers, std::size_t n) const {
        Real sum = n == 0 ? constant_ : Real(0);
        for (std::size_t k = 0; k < length_; ++k) sum += terms_[k].coefficient * powers[terms_[k].power][n];
        return sum;
    }

  private:
    struct Term {
        Real coefficient;
        std::size_t power;
    };
    Real constant_;
    std::array<Term, Polynomial<Real>::capacity> terms_;
    std::size_t length_ = 0;
};

}  // namespace ashimpact

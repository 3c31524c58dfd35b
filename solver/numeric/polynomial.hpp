// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>

namespace ashimpact {

/// A dense polynomial of bounded degree. Contact laws evaluated on Polynomial::identity() yield their
/// coefficients, which may be polynomials themselves.
template <class Real, int terms = 16>
struct Polynomial {
    static constexpr int capacity = terms;
    std::array<Real, capacity> coefficient{};
    int degree = 0;

    constexpr Polynomial() = default;
    // NOLINTNEXTLINE(google-explicit-constructor): constants mix with polynomials in the laws
    constexpr Polynomial(const Real& constant) { coefficient[0] = constant; }

    [[nodiscard]] static constexpr Polynomial identity() {
        Polynomial x;
        x.coefficient[1] = Real(1);
        x.degree = 1;
        return x;
    }

    [[nodiscard]] constexpr const Real& operator[](int power) const {
        return coefficient[static_cast<std::size_t>(power)];
    }
    constexpr Real& operator[](int power) { return coefficient[static_cast<std::size_t>(power)]; }

    /// Value at @p x.
    [[nodiscard]] Real operator()(const Real& x) const {
        Real value = (*this)[degree];
        for (int i = degree - 1; i >= 0; --i) value = value * x + (*this)[i];
        return value;
    }

    [[nodiscard]] constexpr Polynomial derivative() const {
        Polynomial result;
        for (int i = 1; i <= degree; ++i) result[i - 1] = i * (*this)[i];
        result.degree = degree > 0 ? degree - 1 : 0;
        return result;
    }

    /// Antiderivative that vanishes at 0.
    [[nodiscard]] constexpr Polynomial antiderivative() const {
        assert(degree + 1 < capacity);
        Polynomial result;
        for (int i = 0; i <= degree; ++i) result[i + 1] = (*this)[i] / (i + 1);
        result.degree = degree + 1;
        return result;
    }

    /// The polynomial p with p(x) = (*this)(x + offset).
    [[nodiscard]] Polynomial shifted(const Real& offset) const {
        Polynomial result = *this;
        for (int i = 0; i < degree; ++i)
            for (int j = degree - 1; j >= i; --j) result[j] = result[j] + offset * result[j + 1];
        return result;
    }

    /// An upper bound of the values between @p a and @p b: the largest Bernstein coefficient there.
    [[nodiscard]] Real upper_bound(const Real& a, const Real& b) const {
        std::array<Real, capacity> c = shifted(a).coefficient;
        Real scale = Real(1);
        for (int i = 1; i <= degree; ++i) {  // of t^i/binomial(degree, i) on 0 <= t <= 1
            scale = scale * (b - a) * Real(i) / Real(degree - i + 1);
            c[static_cast<std::size_t>(i)] = c[static_cast<std::size_t>(i)] * scale;
        }
        for (int i = 1; i <= degree; ++i)  // sums over binomial(j, i), by Pascal's triangle
            for (auto j = static_cast<std::size_t>(degree); j >= static_cast<std::size_t>(i); --j)
                c[j] += c[j - 1];
        return *std::max_element(c.begin(), c.begin() + degree + 1);
    }

    /// Lowest power that appears; the degree if none does.
    [[nodiscard]] constexpr int lowest() const {
        int power = 0;
        while (power < degree && (*this)[power] == Real(0)) ++power;
        return power;
    }

    /// Whether only even powers appear, so that it is a polynomial of x^2.
    [[nodiscard]] constexpr bool even() const {
        for (int i = 1; i <= degree; i += 2)
            if ((*this)[i] != Real(0)) return false;
        return true;
    }

    /// The polynomial p with p(x^2) = *this; requires even().
    [[nodiscard]] constexpr Polynomial of_square() const {
        Polynomial result;
        for (int i = 0; i <= degree; i += 2) result[i / 2] = (*this)[i];
        result.degree = degree / 2;
        return result;
    }

    friend constexpr Polynomial operator+(Polynomial a, const Polynomial& b) {
        for (int i = 0; i <= b.degree; ++i) a[i] = a[i] + b[i];
        a.degree = a.degree > b.degree ? a.degree : b.degree;
        return a;
    }
    friend constexpr Polynomial operator-(Polynomial a, const Polynomial& b) {
        for (int i = 0; i <= b.degree; ++i) a[i] = a[i] - b[i];
        a.degree = a.degree > b.degree ? a.degree : b.degree;
        return a;
    }
    friend constexpr Polynomial operator*(const Polynomial& a, const Polynomial& b) {
        assert(a.degree + b.degree < capacity);
        Polynomial result;
        for (int i = 0; i <= a.degree; ++i)
            for (int j = 0; j <= b.degree; ++j) result[i + j] = result[i + j] + a[i] * b[j];
        result.degree = a.degree + b.degree;
        return result;
    }
    friend constexpr Polynomial operator*(const Real& factor, Polynomial p) {
        for (int i = 0; i <= p.degree; ++i) p[i] = factor * p[i];
        return p;
    }
    friend constexpr Polynomial operator/(Polynomial p, int divisor) {
        for (int i = 0; i <= p.degree; ++i) p[i] = p[i] / divisor;
        return p;
    }
    /// Compares values: a leading coefficient of 0 makes no difference.
    friend constexpr bool operator==(const Polynomial& a, const Polynomial& b) {
        return a.coefficient == b.coefficient;
    }
};

}  // namespace ashimpact

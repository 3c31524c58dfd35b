// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

namespace ashimpact {

/// A polynomial in the state and in the adhesion number A, with plain coefficients: what a contact law turns
/// into when it is evaluated at compile time. It lists the powers that occur, so that the vector code of a
/// law holds its products and no others, and is still the law's own line.
struct Symbol {
    static constexpr int states = 24;
    static constexpr int adhesions = 6;
    std::array<std::array<double, adhesions>, states> coefficient{};  ///< [power of state][power of A]

    constexpr Symbol() = default;
    // NOLINTNEXTLINE(google-explicit-constructor): constants mix with polynomials in the laws
    constexpr Symbol(double constant) { coefficient[0][0] = constant; }

    /// state^power A^adhesion_power
    [[nodiscard]] static constexpr Symbol monomial(int power, int adhesion_power) {
        Symbol x;
        x.at(power, adhesion_power) = 1.0;
        return x;
    }

    constexpr double& at(int power, int adhesion_power) {
        return coefficient[static_cast<std::size_t>(power)][static_cast<std::size_t>(adhesion_power)];
    }
    [[nodiscard]] constexpr double at(int power, int adhesion_power) const {
        return coefficient[static_cast<std::size_t>(power)][static_cast<std::size_t>(adhesion_power)];
    }
    /// Whether this power of the state occurs, for some A.
    [[nodiscard]] constexpr bool has(int power) const {
        for (int j = 0; j < adhesions; ++j) {
            if (at(power, j) != 0.0) return true;
        }
        return false;
    }
    [[nodiscard]] constexpr int degree() const {
        for (int i = states - 1; i > 0; --i) {
            if (has(i)) return i;
        }
        return 0;
    }

    [[nodiscard]] constexpr Symbol derivative() const {
        Symbol result;
        for (int i = 1; i < states; ++i) {
            for (int j = 0; j < adhesions; ++j) result.at(i - 1, j) = at(i, j) * i;
        }
        return result;
    }
    /// Antiderivative that vanishes at 0.
    [[nodiscard]] constexpr Symbol antiderivative() const {
        Symbol result;
        for (int i = 0; i + 1 < states; ++i) {
            for (int j = 0; j < adhesions; ++j) result.at(i + 1, j) = at(i, j) / (i + 1);
        }
        return result;
    }
    /// Whether only even powers of the state occur.
    [[nodiscard]] constexpr bool even() const {
        for (int i = 1; i < states; i += 2) {
            if (has(i)) return false;
        }
        return true;
    }
    /// The polynomial p with p(x^2) = *this; requires even().
    [[nodiscard]] constexpr Symbol of_square() const {
        Symbol result;
        for (int i = 0; i < states; i += 2) result.coefficient[static_cast<std::size_t>(i / 2)] = row(i);
        return result;
    }

    friend constexpr Symbol operator+(Symbol a, const Symbol& b) {
        for (int i = 0; i < states; ++i) {
            for (int j = 0; j < adhesions; ++j) a.at(i, j) += b.at(i, j);
        }
        return a;
    }
    friend constexpr Symbol operator-(Symbol a, const Symbol& b) {
        for (int i = 0; i < states; ++i) {
            for (int j = 0; j < adhesions; ++j) a.at(i, j) -= b.at(i, j);
        }
        return a;
    }
    /// Powers beyond what a Symbol holds are not allowed; in a constant expression they do not compile.
    friend constexpr Symbol operator*(const Symbol& a, const Symbol& b) {
        Symbol result;
        for (int i = 0; i < states; ++i) {
            for (int j = 0; j < adhesions; ++j) {
                if (a.at(i, j) == 0.0) continue;
                for (int k = 0; k < states; ++k) {
                    for (int l = 0; l < adhesions; ++l) {
                        if (b.at(k, l) != 0.0) result.at(i + k, j + l) += a.at(i, j) * b.at(k, l);
                    }
                }
            }
        }
        return result;
    }

  private:
    [[nodiscard]] constexpr const std::array<double, adhesions>& row(int power) const {
        return coefficient[static_cast<std::size_t>(power)];
    }
};

}  // namespace ashimpact

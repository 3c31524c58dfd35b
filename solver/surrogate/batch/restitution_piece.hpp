// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

#include "solver/surrogate/batch/settled.hpp"

namespace ashimpact::batch {

/// A polynomial in t and u, which go from -1 to 1 over the sides of a square of a table. Terms of high powers
/// are so small that single precision holds them; those that are high in both are negligible.
struct alignas(64) SquarePolynomial {
    static constexpr std::size_t rows = 12;     ///< powers of t
    static constexpr std::size_t columns = 16;  ///< powers of u
    static constexpr std::size_t low_rows = rows / 2;
    static constexpr std::size_t low_columns = columns / 2;  ///< a multiple of the lanes of any register

    /// Of t^i u^j at [i low_columns + j].
    std::array<double, low_rows * low_columns> low;
    /// At [i columns + j], of t^(low_rows + i) u^j where j < low_columns, and of t^i u^j from there on.
    std::array<float, low_rows * columns> high;
};

/// What a table holds of a square.
struct RestitutionPolynomials {
    SquarePolynomial restitution_squared;
    SquarePolynomial contact_time;  ///< in units of the scale's time
};

enum class RestitutionState : std::uint8_t {
    unknown,
    rebound,  ///< every impact of the square rebounds, and the polynomials give its result
    capture,  ///< every impact of the square is captured
    quartered,
    undecided,  ///< undecided, at the edge of capture: integrate
};

/// A square of a table of impacts.
class RestitutionPiece : public Settled<RestitutionState> {
  public:
    using State = RestitutionState;

    /// The whole table: 0 <= x, y <= 1.
    RestitutionPiece() = default;

    [[nodiscard]] double lower_x() const { return middle_x_ - 1.0 / stretch_; }
    [[nodiscard]] double upper_x() const { return middle_x_ + 1.0 / stretch_; }
    [[nodiscard]] double lower_y() const { return middle_y_ - 1.0 / stretch_; }
    [[nodiscard]] double upper_y() const { return middle_y_ + 1.0 / stretch_; }
    [[nodiscard]] double t(double x) const { return (x - middle_x_) * stretch_; }
    [[nodiscard]] double u(double y) const { return (y - middle_y_) * stretch_; }

    /// The polynomials; only in state rebound.
    [[nodiscard]] const RestitutionPolynomials& polynomials() const { return *polynomials_; }
    /// The quarter that contains a place; only in state quartered.
    [[nodiscard]] RestitutionPiece& quarter(double x, double y) const {
        return (*quarters_)[(x >= middle_x_ ? 1U : 0U) + (y >= middle_y_ ? 2U : 0U)];
    }

    /// Before the state is rebound.
    void set(std::unique_ptr<RestitutionPolynomials> polynomials) { polynomials_ = std::move(polynomials); }
    /// Before the state is quartered.
    void quarter() {
        quarters_ = std::make_unique<std::array<RestitutionPiece, 4>>();
        for (std::size_t k = 0; k < 4; ++k) {
            RestitutionPiece& piece = (*quarters_)[k];
            piece.stretch_ = 2.0 * stretch_;
            piece.middle_x_ = middle_x_ + (k % 2 == 0 ? -0.5 : 0.5) / stretch_;
            piece.middle_y_ = middle_y_ + (k / 2 == 0 ? -0.5 : 0.5) / stretch_;
        }
    }

  private:
    double middle_x_ = 0.5;
    double middle_y_ = 0.5;
    double stretch_ = 2.0;
    std::unique_ptr<RestitutionPolynomials> polynomials_{};
    std::unique_ptr<std::array<RestitutionPiece, 4>> quarters_{};
};

}  // namespace ashimpact::batch

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include "solver/batch/lanes/number_task.hpp"
#include "solver/batch/tables/piece_tree.hpp"

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

/// What a table contains of a square in which every impact rebounds.
struct RestitutionPolynomials {
    SquarePolynomial restitution_squared;
    SquarePolynomial contact_time;  ///< in units of the scale's time
};

using RestitutionPiece = Piece<2, std::unique_ptr<RestitutionPolynomials>>;
using RestitutionTree = PieceTree<RestitutionPiece, 1, 6, 9>;
extern template class PieceTree<RestitutionPiece, 1, 6, 9>;

/// All impacts of one law, detachment and damping law. Scaled, they differ in two numbers, the adhesion
/// number A and the damping number beta. The table contains e^2 and the contact time as Chebyshev polynomials
/// on squares of x = A/(1 + A) and y = beta/(1 + beta), through impacts that the batch solver integrates.
/// Squares are quartered until the last coefficients are negligible. The values of a square do not depend on
/// when it is computed.
///
/// More adhesion and more damping capture more. So two opposite corners show whether a whole square rebounds
/// or is captured. docs/decisions/0010-tables.md
class RestitutionTable final : public RestitutionTree {
  public:
    /// The table of that combination, one for the process. Thread-safe.
    /// @param kernel of the law for one instruction set; no two of them share one
    [[nodiscard]] static RestitutionTable& of(NumberKernel kernel, Detachment detachment,
                                              DampingLaw damping_law);

    RestitutionTable(NumberKernel kernel, Detachment detachment, DampingLaw damping_law);

    /// The piece that contains a place 0 <= x, y <= 1; none if the place is not a number.
    [[nodiscard]] const RestitutionPiece* at(double x, double y) {
        if (!(x + y <= 2.0)) return nullptr;
        return find({x, y}, index_of(x) * index_size + index_of(y));
    }

  private:
    static constexpr int least_depth = 4;  ///< quarterings before the first polynomials
    static constexpr std::size_t index_size = std::size_t{1} << index_depth;

    [[nodiscard]] static std::size_t index_of(double x) {
        const auto place = static_cast<std::size_t>(x * index_size);
        return place < index_size ? place : index_size - 1;
    }

    [[nodiscard]] PieceState judge(const RestitutionPiece& piece, int depth,
                                   std::unique_ptr<RestitutionPolynomials>& content) const override;
    /// The polynomials of a square; none if they do not represent it within the tolerances.
    [[nodiscard]] std::unique_ptr<RestitutionPolynomials> fitted(const RestitutionPiece& piece) const;

    NumberKernel kernel_;
    Detachment detachment_;
    DampingLaw damping_law_;
};

}  // namespace ashimpact::batch

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstddef>

#include "solver/batch/kernel.hpp"
#include "solver/surrogate/batch/restitution_piece.hpp"

namespace ashimpact::batch {

/// All impacts of one law, detachment and damping law. Scaled, they differ in two numbers, the adhesion
/// number A and the damping number beta. The table holds e^2 and the contact time as Chebyshev polynomials on
/// squares of x = A/(1 + A) and y = beta/(1 + beta), through impacts that the batch solver integrates.
/// Squares are quartered until the last coefficients are negligible. A square is computed when it is first
/// needed; its values do not depend on when.
///
/// More adhesion and more damping capture more. So two opposite corners show whether a whole square rebounds
/// or is captured. Squares that the edge of capture still cuts after the last quartering are undecided:
/// integrate their impacts. docs/decisions/0010-tables.md
class RestitutionTable {
  public:
    using State = RestitutionPiece::State;

    /// The table of that combination for the present instruction set, one for the process. Thread-safe.
    [[nodiscard]] static RestitutionTable& of(Law law, Detachment detachment, DampingLaw damping_law);

    RestitutionTable(Kernels kernels, Detachment detachment, DampingLaw damping_law)
        : kernels_(kernels), detachment_(detachment), damping_law_(damping_law) {}

    /// The piece that holds a place 0 <= x, y <= 1: its state is rebound, capture or undecided. None if the
    /// place is not a number.
    [[nodiscard]] const RestitutionPiece* at(double x, double y) {
        if (!(x + y <= 2.0)) return nullptr;
        const std::size_t place = index_of(x) * index_size + index_of(y);
        RestitutionPiece* piece = index_[place].load(std::memory_order_acquire);
        if (piece == nullptr) piece = &entered(x, y, place);
        int depth = index_depth;
        while (true) {
            const State state = piece->state();
            if (state == State::unknown) {
                compute(*piece, depth);
            } else if (state == State::quartered) {
                piece = &piece->quarter(x, y);
                ++depth;
            } else {
                return piece;
            }
        }
    }

  private:
    static constexpr int least_depth = 4;  ///< quarterings before the first polynomials
    static constexpr int most_depth = 9;
    static constexpr int index_depth = 6;
    static constexpr std::size_t index_size = std::size_t{1} << index_depth;

    [[nodiscard]] static std::size_t index_of(double x) {
        const auto place = static_cast<std::size_t>(x * index_size);
        return place < index_size ? place : index_size - 1;
    }

    /// Finds the piece that contains a place, of index_depth or larger, and enters it into the index.
    /// @param place of the index
    RestitutionPiece& entered(double x, double y, std::size_t place);
    void compute(RestitutionPiece& piece, int depth) const;
    /// The state if corners and fit decide it, else unknown.
    [[nodiscard]] State judged(RestitutionPiece& piece, int depth) const;
    /// Fits the polynomials. @return whether they represent the piece within the tolerances
    [[nodiscard]] bool fitted(RestitutionPiece& piece) const;

    Kernels kernels_;
    Detachment detachment_;
    DampingLaw damping_law_;
    RestitutionPiece root_;
    std::array<std::atomic<RestitutionPiece*>, index_size * index_size> index_{};
};

}  // namespace ashimpact::batch

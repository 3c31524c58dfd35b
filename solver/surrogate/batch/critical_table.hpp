// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/surrogate/batch/critical_piece.hpp"

namespace ashimpact::batch {

/// The critical velocity of one law, detachment and damping law with adhesion. It depends on one number: the
/// damping number beta in the scale in which the adhesion number is 1 (velocity V_a). The table holds the
/// work of damping at v_c over beta as polynomials on octaves of beta, through backward integrations. Octaves
/// are halved until the last coefficients are below 1e-12. A piece is computed when it is first needed.
///
/// The relative error of v_c is below 1e-10 (1e-12 as measured in the tests). The table has no value next to
/// the damping from which on everything is captured.
class CriticalTable {
  public:
    using State = CriticalPiece::State;

    /// The table of that combination, one for the process. Thread-safe.
    [[nodiscard]] static CriticalTable& of(Law law, Detachment detachment, DampingLaw damping_law);

    CriticalTable();

    /// The damping number itself, or the lowest of the table, below which the work over beta is the same.
    [[nodiscard]] static double inside(double beta) { return beta < lowest ? lowest : beta; }

    /// The piece for @p beta = inside(beta), which is finite, always_captured or undecided; none beyond the
    /// table.
    [[nodiscard]] const CriticalPiece* at(double beta) {
        const std::uint64_t place = (std::bit_cast<std::uint64_t>(beta) - lowest_bits) >> index_shift;
        if (place >= index_size) return nullptr;
        CriticalPiece* piece = index_[place].load(std::memory_order_acquire);
        if (piece == nullptr) piece = &entered(beta, place);
        int depth = index_depth;
        while (true) {
            const State state = piece->state();
            if (state == State::unknown) {
                compute(*piece, depth);
            } else if (state == State::halved) {
                piece = &piece->half(beta);
                ++depth;
            } else {
                return piece;
            }
        }
    }
    /// The length at which the adhesion number is 1 is its value at length 1 to this power.
    [[nodiscard]] double length_power() const { return length_power_; }

  private:
    static constexpr double lowest = 0x1p-40;
    static constexpr std::size_t octaves = 64;
    static constexpr int index_depth = 5;  ///< halvings of an octave: the first bits of a number's fraction
    static constexpr std::size_t index_size = octaves << index_depth;
    static constexpr int index_shift = 52 - index_depth;
    static constexpr std::uint64_t lowest_bits = std::bit_cast<std::uint64_t>(lowest);
    static constexpr int most_depth = 16;

    /// Finds the piece that contains a number, of index_depth or larger, and enters it into the index.
    CriticalPiece& entered(double beta, std::uint64_t place);
    void compute(CriticalPiece& piece, int depth) const;
    [[nodiscard]] State judged(CriticalPiece& piece) const;
    [[nodiscard]] CriticalVelocity solved(double beta) const;

    Law law_;
    Detachment detachment_ = Detachment::zero_overlap;
    DampingLaw damping_law_ = DampingLaw::constant;
    double length_power_ = 0.0;
    std::array<CriticalPiece, octaves> pieces_;
    std::array<std::atomic<CriticalPiece*>, index_size> index_{};
};

}  // namespace ashimpact::batch

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "solver/batch/tables/piece_tree.hpp"

namespace ashimpact {

class Law;
enum class DampingLaw;
enum class Detachment;

namespace batch {

/// What a table contains of an interval of damping numbers.
struct CriticalPolynomial {
    static constexpr std::size_t terms = 16;  ///< a multiple of the lanes of any register

    std::array<double, terms> coefficients;  ///< ln(work of damping/(beta m V_a^2)) by powers of t
    double detachment_energy;                ///< [m V_a^2]
};

using CriticalPiece = Piece<1, CriticalPolynomial>;
using CriticalTree = PieceTree<CriticalPiece, 64, 5, 16>;
extern template class PieceTree<CriticalPiece, 64, 5, 16>;

/// The critical velocity of one law, detachment and damping law with adhesion. It depends on one number: the
/// damping number beta in the scale in which the adhesion number is 1 (velocity V_a). The table contains the
/// work of damping at v_c over beta as polynomials on octaves of beta, through backward integrations. Octaves
/// are halved until the last coefficients are below 1e-12.
///
/// The relative error of v_c is below 1e-10 (1e-12 as measured in the tests). The table has no value next to
/// the damping from which on everything is captured.
class CriticalTable final : public CriticalTree {
  public:
    /// The table of that combination, one for the process. Thread-safe.
    [[nodiscard]] static CriticalTable& of(Law law, Detachment detachment, DampingLaw damping_law);

    CriticalTable(Law law, Detachment detachment, DampingLaw damping_law);

    /// The damping number itself, or the lowest of the table, below which the work over beta is the same.
    [[nodiscard]] static double inside(double beta) { return beta < lowest ? lowest : beta; }

    /// The piece that contains @p beta = inside(beta); none beyond the table.
    [[nodiscard]] const CriticalPiece* at(double beta) {
        const std::uint64_t slot = (std::bit_cast<std::uint64_t>(beta) - lowest_bits) >> index_shift;
        return slot < slots ? find({beta}, slot) : nullptr;
    }
    /// The length at which the adhesion number is 1 is its value at length 1 to this power.
    [[nodiscard]] double length_power() const { return length_power_; }

  private:
    static constexpr double lowest = 0x1p-40;
    static constexpr std::uint64_t lowest_bits = std::bit_cast<std::uint64_t>(lowest);
    static constexpr int index_shift =
        52 - index_depth;  ///< the first bits of a number's fraction are the halvings of an octave

    [[nodiscard]] PieceState judge(const CriticalPiece& piece, int depth,
                                   CriticalPolynomial& content) const override;

    std::size_t law_;  ///< its position in the registry: kernels read tables and include no other law
    Detachment detachment_;
    DampingLaw damping_law_;
    double length_power_;
};

}  // namespace batch
}  // namespace ashimpact

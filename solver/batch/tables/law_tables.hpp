// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "solver/batch/lanes/number_task.hpp"
#include "solver/batch/tables/number_span.hpp"
#include "solver/batch/tables/piece_tree.hpp"
#include "solver/batch/tables/yield_onset.hpp"
#include "solver/batch/tables/zone_curve.hpp"

namespace ashimpact {

class Law;
enum class DampingLaw;
enum class Detachment;

namespace batch {

/// What a table contains of an interval of damping numbers.
struct CriticalPolynomial {
    static constexpr std::size_t terms = 16;  ///< a multiple of the lanes of any register

    std::array<double, terms> coefficients;  ///< of the CriticalQuantity, by powers of t
    double detachment_energy;                ///< [m V_a^2]
};

/// The quantity of the impact at v_c that a table holds.
enum class CriticalQuantity {
    work,     ///< ln(work of damping/(beta m V_a^2))
    overlap,  ///< ln(greatest overlap), in units of the scale
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
    [[nodiscard]] static CriticalTable& of(Law law, Detachment detachment, DampingLaw damping_law,
                                           CriticalQuantity quantity = CriticalQuantity::work);

    CriticalTable(Law law, Detachment detachment, DampingLaw damping_law, CriticalQuantity quantity);

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
    CriticalQuantity quantity_;
    double length_power_;
};

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

/// What a table contains of a square in which every impact rebounds, scaled.
struct RestitutionPolynomials {
    SquarePolynomial result;  ///< square of the speed at the end; of an approach u at the turn
    SquarePolynomial time;    ///< of the part of the impact
};

/// One set; of a law with a third number one for each power of the place in a span of it.
using RestitutionContent = std::unique_ptr<RestitutionPolynomials[]>;
struct NumberedImpacts;
using RestitutionPiece = Piece<2, RestitutionContent>;
using RestitutionTree = PieceTree<RestitutionPiece, 1, 6, 9>;
extern template class PieceTree<RestitutionPiece, 1, 6, 9>;

/// All impacts of one law, detachment and damping law. Scaled, they differ in two numbers, the adhesion
/// number A and the damping number beta. The table contains e^2 and the contact time as Chebyshev polynomials
/// on squares of x, which rises with A, and y = beta/(1 + beta), through impacts that the batch solver
/// integrates. Squares are quartered until the last coefficients are negligible. The values of a square do
/// not depend on when it is computed.
///
/// Where impacts have a third number there is a table for each span of it, whose polynomials' coefficients
/// are polynomials in the place z in the span. It is the transition parameter lambda with a cohesive zone
/// (ZoneSpans), and the adhesion at yield c where contacts yield (YieldSpans). In the latter case those
/// tables contain approaches that yield, over x, which rises with the velocity beyond the onset (YieldOnset),
/// and the place y of the damping number in units of yield; of_release() contains what follows, over x that
/// rises with the third root of the adhesion number and y. The table itself contains the impacts that do not
/// yield.
///
/// More adhesion and more damping capture more. So two opposite corners show whether a whole square rebounds
/// or is captured. docs/decisions/0010-tables.md, 0014-cohesive-lanes.md, 0015-plastic-lanes.md
class RestitutionTable final : public RestitutionTree {
  public:
    static constexpr std::size_t layers = 8;  ///< powers of z
    /// A contact released at rest pulls back below this third root of the adhesion number: x = 1.
    static constexpr double release_root = 0.87358046473629887;  // (2/3)^(1/3)
    /// x of a law with a cohesive zone goes from 0 to 1 over these powers of two of A; others have A/(1 + A).
    static constexpr double zone_least_power = -16.5;
    static constexpr double zone_powers = 23.0;

    /// The table of that combination, one for the process. Thread-safe.
    /// @param kernel of the law for one instruction set; no two of them share one
    [[nodiscard]] static RestitutionTable& of(NumberKernel kernel, Detachment detachment,
                                              DampingLaw damping_law);

    RestitutionTable(NumberKernel kernel, Detachment detachment, DampingLaw damping_law,
                     ImpactPart part = ImpactPart::whole);
    /// Of a span of the third number of a law: whole impacts with a cohesive zone, or approaches that yield.
    RestitutionTable(NumberKernel kernel, Detachment detachment, DampingLaw damping_law, ImpactPart part,
                     const NumberSpan& span);

    /// The table of a span of Spans, in which a third number must be, made when it is first needed.
    /// Thread-safe.
    template <class Spans>
    [[nodiscard]] RestitutionTable& at_number(double number) {
        static_assert(Spans::count <= most_spans);
        const std::size_t index = Spans::index(number);
        RestitutionTable* const table = of_spans_[index].load(std::memory_order_acquire);
        return table != nullptr ? *table : make_span(index, Spans::of(number), Spans::part);
    }
    [[nodiscard]] double z(double number) const { return span_.z(number); }
    /// Of a law that yields: what follows the turn.
    [[nodiscard]] RestitutionTable& of_release() const;
    /// Of approaches that yield.
    [[nodiscard]] const YieldOnset& onset() const { return onset_; }

    /// The piece that contains a place 0 <= x, y <= 1; none outside.
    [[nodiscard]] const RestitutionPiece* at(double x, double y) {
        if (!(x >= 0.0 && x <= 1.0 && y <= 1.0)) return nullptr;
        return find({x, y}, index_of(x) * index_size + index_of(y));
    }

  private:
    static constexpr int least_depth = 4;           ///< quarterings before the first polynomials
    static constexpr int least_approach_depth = 1;  ///< of approaches, which no edge of capture cuts
    static constexpr int most_approach_depth = 6;
    static constexpr std::size_t most_spans = ZoneSpans::count;
    static constexpr std::size_t index_size = std::size_t{1} << index_depth;

    [[nodiscard]] static std::size_t index_of(double x) {
        const auto place = static_cast<std::size_t>(x * index_size);
        return place < index_size ? place : index_size - 1;
    }

    [[nodiscard]] RestitutionTable& make_span(std::size_t index, const NumberSpan& span, ImpactPart part);
    [[nodiscard]] double adhesion_at(double x) const;
    [[nodiscard]] PieceState judge(const RestitutionPiece& piece, int depth,
                                   RestitutionContent& content) const override;
    /// Whether all impacts of a corner end so, at every transition parameter; next to the corner by the share
    /// @p more of the adhesion number, to be certain of those between.
    [[nodiscard]] bool all_end(LaneEnd end, double x, double y, double more) const;
    /// The polynomials of a square; none if they do not represent it within the tolerances.
    [[nodiscard]] RestitutionContent fitted(const RestitutionPiece& piece) const;
    /// Adds the numbers of an impact, at one place of the third.
    void add(double x, double y, std::size_t layer, NumberedImpacts& impacts) const;
    void solve(std::size_t layer, NumberedImpacts& impacts) const;

    NumberKernel kernel_;
    Detachment detachment_;
    DampingLaw damping_law_;
    ImpactPart part_ = ImpactPart::whole;
    NumberSpan span_{};
    std::vector<double> numbers_{};    ///< the third number at Chebyshev nodes of the span; none without
    std::vector<ZoneCurve> curves_{};  ///< at those, and at the ends; none without a cohesive zone
    YieldOnset onset_{};
    std::array<std::atomic<RestitutionTable*>, most_spans> of_spans_{};
};

}  // namespace batch

}  // namespace ashimpact

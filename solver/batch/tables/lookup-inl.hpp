// SPDX-License-Identifier: GPL-3.0-or-later
// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_TABLES_LOOKUP_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_TABLES_LOOKUP_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_TABLES_LOOKUP_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_TABLES_LOOKUP_INL_HPP
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "solver/batch/lanes/equation-inl.hpp"
#include "solver/batch/tables/law_tables.hpp"
#include "solver/numeric/number.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

/// The powers of one number, consecutive ones in the lanes of a register.
class PowerRow {
  public:
    HWY_INLINE explicit PowerRow(double u) : powers_(1.0), next_(u) {
        const hn::RebindToUnsigned<Tag> integers;
        const auto lane = hn::Iota(integers, 0);
        for (std::size_t bit = 1; bit < lane_count; bit *= 2) {
            const Mask has_bit = hn::RebindMask(Tag(), hn::TestBit(lane, hn::Set(integers, bit)));
            powers_ = select(has_bit, powers_ * next_, powers_);
            next_ = next_ * next_;
        }
    }

    /// The sum of coefficients times powers.
    template <std::size_t registers>
    [[nodiscard]] HWY_INLINE double sum(const std::array<Lanes, registers>& coefficients) const {
        Lanes sum = coefficients[registers - 1];
        for (std::size_t k = registers - 1; k-- > 0;) sum = multiply_add(sum, next_, coefficients[k]);
        return hn::GetLane(hn::SumOfLanes(Tag(), (sum * powers_).v));
    }

  private:
    Lanes powers_;  ///< 1, u, u^2, ...
    Lanes next_;    ///< u to the number of lanes
};

/// Coordinate of an adhesion or damping number n in a table: n/(1 + n).
[[nodiscard]] HWY_INLINE Lanes place_of(Lanes number) {
    const Lanes n = min(number, 1e300);
    return n / (n + Lanes(1.0));
}

/// Evaluates the polynomials of a piece at one place.
class PlaceInPiece {
  public:
    HWY_INLINE PlaceInPiece(double t, double u)
        : t_(t), row_of_high_(power<static_cast<int>(low_rows)>(t)), powers_(u) {}

    [[nodiscard]] HWY_INLINE double value(const batch::SquarePolynomial& c) const {
        HWY_ALIGN float high[columns];
        add_rows_of_high(c, high);
        const hn::Rebind<float, Tag> singles;
        const auto high_at = [&](std::size_t j) HWY_ATTR {
            return Lanes(hn::PromoteTo(Tag(), hn::Load(singles, high + j)));
        };
        std::array<Lanes, columns / lane_count> row;
        for (std::size_t j = 0; j < low_columns; j += lane_count) {
            Lanes low = Lanes::load(c.low.data() + (low_rows - 1) * low_columns + j);
            for (std::size_t i = low_rows - 1; i-- > 0;)
                low = multiply_add(low, t_, Lanes::load(c.low.data() + i * low_columns + j));
            row[j / lane_count] = multiply_add(high_at(j), row_of_high_, low);
            row[(low_columns + j) / lane_count] = high_at(low_columns + j);
        }
        return powers_.sum(row);
    }

  private:
    static constexpr std::size_t columns = batch::SquarePolynomial::columns;
    static constexpr std::size_t low_rows = batch::SquarePolynomial::low_rows;
    static constexpr std::size_t low_columns = batch::SquarePolynomial::low_columns;

    /// The sums over the rows of c.high, in single precision.
    HWY_INLINE void add_rows_of_high(const batch::SquarePolynomial& c, float* sums) const {
        const hn::ScalableTag<float> singles;
        const auto t = hn::Set(singles, static_cast<float>(hn::GetLane(t_.v)));
        for (std::size_t j = 0; j < columns; j += hn::MaxLanes(singles)) {
            auto sum = hn::LoadU(singles, c.high.data() + (low_rows - 1) * columns + j);
            for (std::size_t i = low_rows - 1; i-- > 0;)
                sum = hn::MulAdd(sum, t, hn::LoadU(singles, c.high.data() + i * columns + j));
            hn::Store(sum, singles, sums + j);
        }
    }

    Lanes t_;
    Lanes row_of_high_;  ///< t^low_rows
    PowerRow powers_;
};

/// The result of an impact as a table holds it, scaled.
struct TableEntry {
    batch::LaneEnd end;  ///< undecided: the table has no result, and the impact has to be integrated
    double speed;        ///< at the end of contact; 0 for a capture
    double time;         ///< of contact; NaN for a capture
};

/// The polynomial of one transition parameter, from those by powers of its place z in the span.
HWY_INLINE void contract(const batch::RestitutionPolynomials* layers,
                         batch::SquarePolynomial batch::RestitutionPolynomials::*which, double z,
                         batch::SquarePolynomial& out) {
    constexpr std::size_t last = batch::RestitutionTable::layers - 1;
    const auto sum_all = [&](auto tag, auto part) HWY_ATTR {
        auto& sums = out.*part;
        const auto factor = hn::Set(tag, static_cast<hn::TFromD<decltype(tag)>>(z));
        for (std::size_t i = 0; i < sums.size(); i += hn::MaxLanes(tag)) {
            auto sum = hn::LoadU(tag, (layers[last].*which.*part).data() + i);
            for (std::size_t k = last; k-- > 0;)
                sum = hn::MulAdd(sum, factor, hn::LoadU(tag, (layers[k].*which.*part).data() + i));
            hn::StoreU(sum, tag, sums.data() + i);
        }
    };
    sum_all(Tag(), &batch::SquarePolynomial::low);
    sum_all(hn::ScalableTag<float>(), &batch::SquarePolynomial::high);
}

/// The polynomials of one transition parameter, kept from one impact to the next: those of one parameter come
/// from few squares.
template <bool with_time>
[[nodiscard]] HWY_INLINE const batch::RestitutionPolynomials& contracted(const batch::RestitutionPiece& piece,
                                                                         double z) {
    using Polynomials = batch::RestitutionPolynomials;
    struct Slot {
        const batch::RestitutionPiece* piece = nullptr;
        double z = 0.0;
        Polynomials polynomials;
    };
    thread_local std::vector<Slot> kept(
        512);  // megabytes: in the storage of threads, none of them would start
    Slot& slot = kept[reinterpret_cast<std::uintptr_t>(&piece) / sizeof(piece) % kept.size()];
    if (slot.piece != &piece || slot.z != z) {
        contract(piece.content().get(), &Polynomials::result, z, slot.polynomials.result);
        if (with_time) contract(piece.content().get(), &Polynomials::time, z, slot.polynomials.time);
        slot.piece = &piece;
        slot.z = z;
    }
    return slot.polynomials;
}

/// A place in a table.
struct TablePlace {
    double x;
    double y;
    double z = 0.0;  ///< in the span of transition parameters; otherwise unused
};

/// The entry at a place of a piece; undecided if @p piece is null, as it is where the place is not a number.
template <bool with_time, bool layered>
[[nodiscard]] HWY_INLINE TableEntry entry_at(const batch::RestitutionPiece* piece, const TablePlace& at) {
    using State = batch::PieceState;
    constexpr double least_square = 1e-6;  // of e^2; below it the error of the table is relatively too large
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    const State state = piece == nullptr ? State::undecided : piece->state();
    if (state == State::captured) return {batch::LaneEnd::capture, 0.0, nothing};
    if (state != State::tabulated) return {batch::LaneEnd::undecided, 0.0, nothing};
    const PlaceInPiece place(piece->local(0, at.x), piece->local(1, at.y));
    const batch::RestitutionPolynomials* polynomials = piece->content().get();
    if constexpr (layered) polynomials = &contracted<with_time>(*piece, at.z);
    const double square = place.value(polynomials->result);
    if (square < least_square) return {batch::LaneEnd::undecided, 0.0, nothing};
    const double time = with_time ? place.value(polynomials->time) : nothing;
    return {batch::LaneEnd::rebound, std::sqrt(std::min(square, 1.0)), time};
}

/// Looks up one critical velocity.
/// @param log_work ln(work of damping/(beta m V_a^2)), @param energy of the detachment [m V_a^2]; 0 unless
/// tabulated
[[nodiscard]] HWY_INLINE batch::PieceState critical_entry_at(batch::CriticalTable& table, double beta,
                                                             double& log_work, double& energy) {
    constexpr std::size_t registers = batch::CriticalPolynomial::terms / lane_count;
    log_work = energy = 0.0;
    if (!(beta > 0.0)) return batch::PieceState::undecided;
    const double inside = batch::CriticalTable::inside(beta);
    const batch::CriticalPiece* piece = table.at(inside);
    const batch::PieceState state = piece == nullptr ? batch::PieceState::undecided : piece->state();
    if (state != batch::PieceState::tabulated) return state;
    const batch::CriticalPolynomial& polynomial = piece->content();
    std::array<Lanes, registers> coefficients;
    for (std::size_t k = 0; k < registers; ++k)
        coefficients[k] = Lanes::load(polynomial.coefficients.data() + k * lane_count);
    log_work = PowerRow(piece->local(0, inside)).sum(coefficients);
    energy = polynomial.detachment_energy;
    return state;
}

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

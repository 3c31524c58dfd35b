// SPDX-License-Identifier: GPL-3.0-or-later
// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_LOOKUP_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_LOOKUP_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_LOOKUP_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_LOOKUP_INL_HPP
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "solver/numeric/power.hpp"
#include "solver/surrogate/batch/power_row-inl.hpp"
#include "solver/surrogate/batch/restitution_table.hpp"
#include "solver/surrogate/batch/scaled_task-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

/// Coordinate x or y of an adhesion or damping number n in a table: n/(1 + n).
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

/// The entry at a place of a piece; undecided if @p piece is null, as it is where the place is not a number.
template <bool with_time>
[[nodiscard]] HWY_INLINE TableEntry entry_at(const batch::RestitutionPiece* piece, double x, double y) {
    using State = batch::RestitutionPiece::State;
    constexpr double least_square = 1e-6;  // of e^2; below it the error of the table is relatively too large
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    const State state = piece == nullptr ? State::undecided : piece->state();
    if (state == State::capture) return {batch::LaneEnd::capture, 0.0, nothing};
    if (state != State::rebound) return {batch::LaneEnd::undecided, 0.0, nothing};
    const PlaceInPiece place(piece->t(x), piece->u(y));
    const double square = place.value(piece->polynomials().restitution_squared);
    if (square < least_square) return {batch::LaneEnd::undecided, 0.0, nothing};
    const double time = with_time ? place.value(piece->polynomials().contact_time) : nothing;
    return {batch::LaneEnd::rebound, std::sqrt(std::min(square, 1.0)), time};
}

/// Coordinates in a table for a column of numbers.
inline void place_all(const double* numbers, std::size_t count, double* places) {
    for (std::size_t i = 0; i < count; i += lane_count) {
        place_of(Lanes::load(numbers + i)).store(places + i);
    }
}

/// Reads the results of a task from its table. @return impacts that have to be integrated
template <bool with_time>
HWY_NOINLINE PlaceList look_up(const batch::ImpactTask& task, const ScaledTask& scaled) {
    HWY_ALIGN double x[ScaledTask::capacity];
    HWY_ALIGN double y[ScaledTask::capacity];
    place_all(scaled.adhesion, task.count, x);
    place_all(scaled.damping, task.count, y);
    const batch::RestitutionPiece* pieces[batch::most_impacts];
    for (std::size_t i = 0; i < task.count; ++i) pieces[i] = task.table->at(x[i], y[i]);
    PlaceList open;
    for (std::size_t i = 0; i < task.count; ++i) {
        const TableEntry impact = entry_at<with_time>(pieces[i], x[i], y[i]);
        if (impact.end == batch::LaneEnd::undecided) open.add(i);
        task.end[i] = impact.end;
        task.restitution[i] = impact.speed;
        task.contact_time[i] = impact.time * scaled.time[i];
    }
    return open;
}

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

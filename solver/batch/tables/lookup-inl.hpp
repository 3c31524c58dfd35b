// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_LOOKUP_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_LOOKUP_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_LOOKUP_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_LOOKUP_INL_HPP
#endif

#include "solver/batch/tables/power_row-inl.hpp"
#include "solver/batch/tables/restitution_table.hpp"
#include "solver/batch/tables/scaled_task-inl.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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
    HWY_INLINE PlaceInPiece(double t, double u) : t_(t), powers_(u) {}

    [[nodiscard]] HWY_INLINE double value(const batch::RestitutionPolynomials::Coefficients& c) const {
        constexpr std::size_t columns = batch::RestitutionPolynomials::columns;
        constexpr std::size_t registers = columns / lane_count;
        const auto at = [&](std::size_t i, std::size_t k)
                            HWY_ATTR { return Lanes::load(c.data() + i * columns + k * lane_count); };
        std::size_t i = batch::RestitutionPolynomials::rows - 1;
        std::array<Lanes, registers> row;
        for (std::size_t k = 0; k < registers; ++k) row[k] = at(i, k);
        while (i-- > 0) {
            for (std::size_t k = 0; k < registers; ++k) row[k] = multiply_add(row[k], t_, at(i, k));
        }
        return powers_.sum(row);
    }

  private:
    Lanes t_;
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

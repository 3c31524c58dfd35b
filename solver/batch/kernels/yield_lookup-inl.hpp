// SPDX-License-Identifier: GPL-3.0-or-later
// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_KERNELS_YIELD_LOOKUP_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_KERNELS_YIELD_LOOKUP_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_KERNELS_YIELD_LOOKUP_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_KERNELS_YIELD_LOOKUP_INL_HPP
#endif

#include <algorithm>
#include <array>
#include <cstddef>

#include <hwy/contrib/math/math-inl.h>

#include "solver/batch/kernels/scaled_task-inl.hpp"
#include "solver/batch/tables/lookup-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

/// The onset of yield for one value of the third number after another.
class OnsetOfNumber {
  public:
    /// @return whether it is known for that number
    [[nodiscard]] HWY_INLINE bool find(batch::RestitutionTable& law, double yield_adhesion) {
        if (table_ != nullptr && yield_adhesion == number_) return known_;  // one size has one
        if (!batch::YieldSpans::hold(yield_adhesion)) return false;
        number_ = yield_adhesion;
        table_ = &law.at_number<batch::YieldSpans>(yield_adhesion);
        z_ = table_->z(yield_adhesion);
        known_ = table_->onset().known();
        const auto& layers = table_->onset().velocity_squared();
        for (std::size_t j = 0; j < registers; ++j) {
            const auto layer = [&](std::size_t k)
                                   HWY_ATTR { return Lanes::load(layers[k].data() + j * lane_count); };
            coefficients_[j] = layer(layers.size() - 1);
            for (std::size_t k = layers.size() - 1; k-- > 0;)
                coefficients_[j] = multiply_add(coefficients_[j], z_, layer(k));
        }
        return known_;
    }
    /// Square of the velocity at a place of the damping number.
    [[nodiscard]] HWY_INLINE double velocity_squared(double y) const {
        return PowerRow(batch::YieldOnset::local(y)).sum(coefficients_);
    }
    [[nodiscard]] HWY_INLINE batch::RestitutionTable& table() const { return *table_; }
    [[nodiscard]] HWY_INLINE double z() const { return z_; }

  private:
    static constexpr std::size_t registers = batch::YieldOnset::terms / lane_count;

    batch::RestitutionTable* table_ = nullptr;
    double number_ = 0.0;
    double z_ = 0.0;
    bool known_ = false;
    std::array<Lanes, registers> coefficients_;
};

/// Impacts of a task that yield, at their turn and after it, in units of the length at which the yield number
/// is 1.
template <class F>
struct YieldedPlaces {
    static constexpr std::size_t capacity = ScaledTask::capacity;
    using Damping = typename F::Damping;

    std::size_t count = 0;
    std::uint16_t impact[capacity];
    HWY_ALIGN double turn[capacity];  ///< u
    HWY_ALIGN double approach_time[capacity];
    HWY_ALIGN double yield_adhesion[capacity];
    HWY_ALIGN double yield_number[capacity];  ///< in units of the impact
    HWY_ALIGN double damping[capacity];
    HWY_ALIGN double x[capacity];  ///< in the table of what follows the turn, as y
    HWY_ALIGN double y[capacity];
    HWY_ALIGN double speed_unit[capacity];  ///< of that table, over the velocity of the impact
    HWY_ALIGN double time_unit[capacity];   ///< of that table

    /// Fills in the places of the returns.
    HWY_FLATTEN inline void release() {
        const std::size_t padded = (count + lane_count - 1) / lane_count * lane_count;
        for (double* column : {turn, yield_adhesion, yield_number, damping})
            std::fill(column + count, column + padded, 1.0);
        for (std::size_t i = 0; i < count; i += lane_count) {
            const Lanes u = Lanes::load(turn + i);
            const Lanes c = Lanes::load(yield_adhesion + i);
            const Lanes number = Lanes::load(yield_number + i);
            const YieldedLaw<F> contact{LaneNumber(c * c * c), LaneNumber(1.0)};
            const LaneNumber flattening = contact.loading().flattening(LaneNumber(u));
            const Lanes f = flattening.lanes();
            const Lanes u2 = u * u;
            const Lanes u4 = u2 * u2;
            const BasicScale<LaneNumber> scale{LaneNumber(1.0), LaneNumber(1.0), LaneNumber(u4 * u),
                                               LaneNumber(u4), LaneNumber(u2)};
            const Lanes share =
                Damping::shapes(LaneNumber(1.0), StaticForces<LaneNumber>{flattening, LaneNumber(0.0)})[0]
                    .lanes();
            const Lanes returning = Lanes::load(damping + i) * share / Damping::units(scale)[0].lanes();
            (c / (cbrt(f) * u * Lanes(batch::RestitutionTable::release_root))).store(x + i);
            place_of(returning).store(y + i);
            (u4 * u * f * number * number * sqrt(number)).store(speed_unit + i);
            (Lanes(1.0) / u).store(time_unit + i);
        }
    }
};

/// Sorts impacts by whether they yield, and finds the turns of those that do.
/// @param elastic gets those that do not yield
/// @param open gets those that have to be integrated
template <bool with_time, class F>
HWY_INLINE void find_turns(batch::RestitutionTable& law, const ScaledTask& scaled, const PlaceList& all,
                           std::size_t count, PlaceList& elastic, PlaceList& open,
                           YieldedPlaces<F>& yielded) {
    using Onset = batch::YieldOnset;
    HWY_ALIGN double square[ScaledTask::capacity];  // of the velocity
    HWY_ALIGN double damping[ScaledTask::capacity];
    HWY_ALIGN double beyond[ScaledTask::capacity];  // of the square, beyond the onset
    TablePlace at[ScaledTask::capacity];
    for (std::size_t i = 0; i < count; i += lane_count) {
        HWY_ALIGN double y[lane_count];
        const Lanes number = min(Lanes::load(scaled.yield_number + i), 1e50);
        const Lanes n2 = number * number;
        const Lanes n5 = n2 * n2 * number;
        const BasicScale<LaneNumber> scale{LaneNumber(1.0), LaneNumber(1.0), LaneNumber(sqrt(n5)),
                                           LaneNumber(n2), LaneNumber(number)};
        const Lanes own = Lanes::load(scaled.damping + i) / F::Damping::units(scale)[0].lanes();
        (Lanes(1.0) / n5).store(square + i);
        own.store(damping + i);
        Lanes(0.0).store(beyond + i);
        place_of(own).store(y);
        for (std::size_t k = 0; k < lane_count; ++k) at[i + k].y = y[k];
    }
    OnsetOfNumber onset;
    PlaceList yielding;
    batch::RestitutionTable* tables[batch::most_impacts];
    const batch::RestitutionPiece* pieces[batch::most_impacts];
    for (const std::size_t i : all.places()) {
        if (!onset.find(law, scaled.yield_adhesion[i])) {
            open.add(i);
            continue;
        }
        // More damping only delays yield.
        beyond[i] = square[i] - onset.velocity_squared(std::min(at[i].y, Onset::greatest_place));
        if (beyond[i] < 0.0) {
            elastic.add(i);
        } else if (at[i].y < Onset::greatest_place) {
            tables[i] = &onset.table();
            at[i].z = onset.z();
            yielding.add(i);
        } else {
            open.add(i);
        }
    }
    for (std::size_t i = 0; i < count; i += lane_count) {
        HWY_ALIGN double x[lane_count];
        const Lanes distance = max(Lanes::load(beyond + i), 0.0) - Lanes(Onset::margin);
        const Lanes ratio = multiply_add(distance, 1.0 / Onset::unit, 1.0);
        (Lanes(hn::Log2(Tag(), ratio.v)) * Lanes(1.0 / Onset::powers)).store(x);
        for (std::size_t k = 0; k < lane_count; ++k) at[i + k].x = x[k];
    }
    for (const std::size_t i : yielding.places()) pieces[i] = tables[i]->at(std::max(at[i].x, 0.0), at[i].y);
    for (const std::size_t i : yielding.places()) {
        const batch::RestitutionPiece* piece = pieces[i];
        if (piece == nullptr || piece->state() != batch::PieceState::tabulated) {
            open.add(i);
            continue;
        }
        const PlaceInPiece place(piece->local(0, at[i].x), piece->local(1, at[i].y));
        const auto& polynomials = contracted<with_time>(*piece, at[i].z);
        const std::size_t k = yielded.count++;
        yielded.impact[k] = static_cast<std::uint16_t>(i);
        yielded.turn[k] = place.value(polynomials.result);
        yielded.approach_time[k] = with_time ? place.value(polynomials.time) : 0.0;
        yielded.yield_adhesion[k] = scaled.yield_adhesion[i];
        yielded.yield_number[k] = scaled.yield_number[i];
        yielded.damping[k] = damping[i];
    }
}

/// Reads the results of impacts that yield from the tables of their two parts.
/// @param elastic gets those that do not yield
/// @return impacts that have to be integrated
template <bool with_time, class F>
HWY_NOINLINE PlaceList look_up_yielding(const batch::ImpactTask& task, const ScaledTask& scaled,
                                        const PlaceList& all, PlaceList& elastic) {
    PlaceList open;
    YieldedPlaces<F> yielded;
    find_turns<with_time, F>(*task.table, scaled, all, task.count, elastic, open, yielded);
    yielded.release();
    batch::RestitutionTable& table = task.table->of_release();
    const batch::RestitutionPiece* pieces[batch::most_impacts];
    for (std::size_t k = 0; k < yielded.count; ++k) pieces[k] = table.at(yielded.x[k], yielded.y[k]);
    for (std::size_t k = 0; k < yielded.count; ++k) {
        const std::size_t i = yielded.impact[k];
        const TableEntry end = entry_at<with_time, false>(pieces[k], {yielded.x[k], yielded.y[k]});
        if (end.end == batch::LaneEnd::undecided) open.add(i);
        task.end[i] = end.end;
        task.restitution[i] = std::min(end.speed * yielded.speed_unit[k], 1.0);
        const double time = yielded.approach_time[k] + end.time * yielded.time_unit[k];
        task.contact_time[i] = time / std::sqrt(yielded.yield_number[k]) * scaled.time[i];
    }
    return open;
}

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

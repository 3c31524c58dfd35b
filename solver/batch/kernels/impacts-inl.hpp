// SPDX-License-Identifier: GPL-3.0-or-later
// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_KERNELS_IMPACTS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_KERNELS_IMPACTS_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_KERNELS_IMPACTS_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_KERNELS_IMPACTS_INL_HPP
#endif

#include <algorithm>
#include <limits>
#include <span>

#include "solver/batch/kernels/order.hpp"
#include "solver/batch/kernels/scaling-inl.hpp"
#include "solver/batch/lanes/block-inl.hpp"
#include "solver/batch/tables/lookup-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

/// Writes the end of an impact into the results of its task.
inline void write_end(const batch::ImpactTask& task, const ScaledTask& scaled, std::size_t i,
                      const Block& block, std::size_t lane) {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    const bool rebounds = block.rebounds(lane);
    task.end[i] = block.end(lane);
    task.restitution[i] = rebounds ? std::min(block.speed[lane], 1.0) : 0.0;
    task.contact_time[i] = rebounds ? block.time[lane] * scaled.time[i] : nothing;
}

/// Writes the turning point of an impact; a greatest overlap of NaN if it is in doubt.
inline void write_turn(const batch::ImpactTask& task, const ScaledTask& scaled, std::size_t i,
                       const Block& block, std::size_t lane) {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    task.approach_time[i] = block.turn_time[lane] * scaled.time[i];
    task.maximum_overlap[i] = block.turns(lane) ? block.turn_overlap[lane] * scaled.length[i] : nothing;
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

/// Integrates impacts, given by their numbers, in blocks of similar ones, so that the lanes of a block end
/// together.
/// @param write called with (place of the impact, block, lane) for each impact integrated
template <class F, class Write>
HWY_INLINE void follow_all(const batch::NumberColumns& numbers, std::span<const std::uint16_t> impacts,
                           Detachment detachment, Goal goal, const Write& write) {
    batch::Order order;
    order.sort(numbers, impacts);
    for (std::size_t first = 0; first < impacts.size(); first += block_size) {
        const std::size_t used = std::min(impacts.size() - first, block_size);
        Block block;
        for (std::size_t lane = 0; lane < block_size; ++lane) {
            const std::size_t i = order[first + (lane < used ? lane : used - 1)];
            block.adhesion[lane] = numbers.adhesion[i];
            block.damping[lane] = numbers.damping[i];
        }
        follow<F>(block, detachment, goal);
        for (std::size_t lane = 0; lane < used; ++lane) write(order[first + lane], block, lane);
    }
}

/// Solves the impacts of a task: scales them, reads results from the table if there is one, and integrates
/// the others. A table has no turning points: they are integrated in a second pass.
template <class F>
HWY_NOINLINE void solve_task(const batch::ImpactTask& task) {
    ScaledTask scaled;
    scale_task<F>(task.inputs, task.count, scaled);
    const batch::NumberColumns numbers{scaled.adhesion, scaled.damping};
    const auto follow_to = [&](Goal goal, std::span<const std::uint16_t> impacts) HWY_ATTR {
        follow_all<F>(numbers, impacts, task.detachment, goal,
                      [&](std::size_t i, const Block& block, std::size_t lane) HWY_ATTR {
                          if (goal != Goal::turn) write_end(task, scaled, i, block, lane);
                          if (goal != Goal::end) write_turn(task, scaled, i, block, lane);
                      });
    };
    const PlaceList all = PlaceList::all(task.count);
    if (task.table == nullptr) {
        follow_to(task.turning_point ? Goal::end_and_turn : Goal::end, all.places());
        return;
    }
    const PlaceList open =
        task.with_contact_time ? look_up<true>(task, scaled) : look_up<false>(task, scaled);
    follow_to(Goal::end, open.places());
    if (task.turning_point) follow_to(Goal::turn, all.places());
}

/// Solves impacts given by their numbers.
template <class F>
HWY_NOINLINE void solve_numbers(const batch::NumberTask& task) {
    const PlaceList all = PlaceList::all(task.count);
    follow_all<F>({task.adhesion, task.damping}, all.places(), task.detachment, Goal::end,
                  [&](std::size_t i, const Block& block, std::size_t lane) HWY_ATTR {
                      task.end[i] = block.end(lane);
                      task.speed[i] = block.speed[lane];
                      task.time[i] = block.time[lane];
                  });
}

template <template <class> class L>
void solve_law(const batch::ImpactTask& task) {
    with_form<L>(task.damping_law, [&](auto form) { solve_task<decltype(form)>(task); });
}

template <template <class> class L>
void solve_law_numbers(const batch::NumberTask& task) {
    with_form<L>(task.damping_law, [&](auto form) { solve_numbers<decltype(form)>(task); });
}

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

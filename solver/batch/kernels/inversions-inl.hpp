// SPDX-License-Identifier: GPL-3.0-or-later
// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_KERNELS_INVERSIONS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_KERNELS_INVERSIONS_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_KERNELS_INVERSIONS_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_KERNELS_INVERSIONS_INL_HPP
#endif

#include "solver/batch/kernels/damping_search.hpp"
#include "solver/batch/kernels/impacts-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

inline constexpr int most_trials = 16;  ///< impacts after which a search is left to the scalar solver

/// e_0, the restitution without damping: only the energy spent at detachment is lost. 0 if that exceeds the
/// kinetic energy.
template <class F>
HWY_INLINE void undamped_restitutions(const ScaledTask& scaled, Detachment detachment, std::size_t count,
                                      double* out) {
    for (std::size_t i = 0; i < count; i += lane_count) {
        const Equation<F> equation(Lanes::load(scaled.adhesion + i), Lanes(0.0));
        const Places places = places_of(equation, detachment);
        const Lanes cost = places.end_potential - equation.potential(places.touch);
        HWY_ALIGN double values[lane_count];
        sqrt(max(subtract_product(Lanes(1.0), Lanes(2.0), cost), 0.0)).store(values);
        for (std::size_t k = 0; k < lane_count && i + k < count; ++k) out[i + k] = values[k];
    }
}

/// Searches the dampings of the impacts of one block, each lane independently.
template <class F>
HWY_INLINE void search(Block& block, Detachment detachment, batch::DampingSearch* searches) {
    for (int trial = 0; trial < most_trials; ++trial) {
        bool all_found = true;
        for (std::size_t lane = 0; lane < block_size; ++lane) {
            all_found = all_found && searches[lane].found();
            block.damping[lane] = searches[lane].number();
        }
        if (all_found) return;
        follow<F>(block, detachment, Goal::end);
        for (std::size_t lane = 0; lane < block_size; ++lane) {
            if (searches[lane].found()) continue;
            searches[lane].observe(block.rebounds(lane) ? block.speed[lane] : 0.0);
        }
    }
}

/// Searches the damping of one impact in a table. @return whether it was found there
HWY_INLINE bool search(batch::RestitutionTable& table, double x, batch::DampingSearch& search) {
    for (int trial = 0; trial < most_trials && !search.found(); ++trial) {
        const double y = search.number() / (1.0 + search.number());
        const TableEntry impact = entry_at<false>(table.at(x, y), x, y);
        if (impact.end == batch::LaneEnd::undecided) return false;
        search.observe(impact.speed);
    }
    return search.found();
}

/// Searches, by integration, the dampings of the impacts that a table left open. @param start first guesses
template <class F>
HWY_INLINE void search_all(const batch::InversionTask& task, const ScaledTask& scaled, const double* start,
                           const PlaceList& open) {
    const std::span<const std::uint16_t> places = open.places();
    batch::Order order;
    order.sort({scaled.adhesion, start}, places);
    for (std::size_t first = 0; first < places.size(); first += block_size) {
        const std::size_t used = std::min(places.size() - first, block_size);
        Block block;
        std::array<batch::DampingSearch, block_size> searches;
        for (std::size_t lane = 0; lane < block_size; ++lane) {
            const std::size_t i = order[first + (lane < used ? lane : used - 1)];
            block.adhesion[lane] = scaled.adhesion[i];
            searches[lane] =
                batch::DampingSearch(task.damping_law, task.inputs.restitution.at(i), task.undamped[i]);
        }
        search<F>(block, task.detachment, searches.data());
        for (std::size_t lane = 0; lane < used; ++lane) {
            task.number[order[first + lane]] = searches[lane].number();
            task.found[order[first + lane]] = searches[lane].found() ? 1 : 0;
        }
    }
}

template <class F>
HWY_NOINLINE void invert_task(const batch::InversionTask& task) {
    ScaledTask scaled;
    scale_task<F>(task.inputs, task.count, scaled);
    undamped_restitutions<F>(scaled, task.detachment, task.count, task.undamped);
    HWY_ALIGN double x[ScaledTask::capacity];
    place_all(scaled.adhesion, task.count, x);
    double start[batch::most_impacts];  // first damping number of each search
    PlaceList open;
    for (std::size_t i = 0; i < task.count; ++i) {
        batch::DampingSearch own(task.damping_law, task.inputs.restitution.at(i), task.undamped[i]);
        start[i] = own.number();
        if (task.table == nullptr || !search(*task.table, x[i], own)) open.add(i);
        task.number_unit[i] = 1.0 / scaled.damping[i];
        task.number[i] = own.number();
        task.found[i] = own.found() ? 1 : 0;
    }
    search_all<F>(task, scaled, start, open);
}

template <template <class> class L>
void invert_law(const batch::InversionTask& task) {
    with_form<L>(task.damping_law, [&](auto form) { invert_task<decltype(form)>(task); });
}

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

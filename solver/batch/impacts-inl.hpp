// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_IMPACTS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_IMPACTS_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_IMPACTS_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_IMPACTS_INL_HPP
#endif

#include "solver/batch/block-inl.hpp"
#include "solver/batch/lookup-inl.hpp"
#include "solver/batch/order.hpp"
#include "solver/batch/scaling-inl.hpp"

#include <algorithm>
#include <limits>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

/// The impacts of a task, scaled.
struct ScaledTask {
    static constexpr std::size_t capacity = batch::most_impacts + lane_count;
    HWY_ALIGN double adhesion[capacity];
    HWY_ALIGN double damping[capacity];
    HWY_ALIGN double length[capacity];  ///< [m]
    HWY_ALIGN double time[capacity];    ///< [s]
};

template <class F>
HWY_INLINE void scale_task(const batch::Inputs& inputs, std::size_t count, ScaledTask& out) {
    for (std::size_t i = 0; i < count; i += lane_count) {
        const ScaledLanes lanes = scaled<F>(inputs, i, count);
        lanes.adhesion.store(out.adhesion + i);
        lanes.damping.store(out.damping + i);
        lanes.length.store(out.length + i);
        lanes.time.store(out.time + i);
    }
}

/// Places of impacts in their task.
class PlaceList {
  public:
    void add(std::size_t place) { place_[count_++] = static_cast<std::uint16_t>(place); }
    [[nodiscard]] std::span<const std::uint16_t> places() const { return {place_, count_}; }

    [[nodiscard]] static PlaceList all(std::size_t count) {
        PlaceList list;
        for (std::size_t i = 0; i < count; ++i) list.add(i);
        return list;
    }

  private:
    std::uint16_t place_[batch::most_impacts];  // the first count_ are filled
    std::size_t count_ = 0;
};

/// Places of a column of numbers in a table.
inline void place_all(const double* numbers, std::size_t count, double* places) {
    for (std::size_t i = 0; i < count; i += lane_count) {
        place_of(Lanes::load(numbers + i)).store(places + i);
    }
}

/// Reads the impacts of a task from its table. @return those that it does not tell
HWY_NOINLINE inline PlaceList look_up(const batch::ImpactTask& task, const ScaledTask& scaled) {
    HWY_ALIGN double x[ScaledTask::capacity];
    HWY_ALIGN double y[ScaledTask::capacity];
    place_all(scaled.adhesion, task.count, x);
    place_all(scaled.damping, task.count, y);
    const batch::RestitutionPiece* pieces[batch::most_impacts];
    for (std::size_t i = 0; i < task.count; ++i) pieces[i] = task.table->at(x[i], y[i]);
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    PlaceList open;
    for (std::size_t i = 0; i < task.count; ++i) {
        const Told impact = told<true>(pieces[i], x[i], y[i]);
        if (impact.end == batch::LaneEnd::undecided) open.add(i);
        task.end[i] = impact.end;
        task.restitution[i] = impact.speed;
        task.contact_time[i] = impact.time * scaled.time[i];
        task.approach_time[i] = task.maximum_overlap[i] = nothing;
    }
    return open;
}

inline void write(const batch::ImpactTask& task, const ScaledTask& scaled, std::size_t i, const Block& block,
                  std::size_t lane) {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    const bool rebounds = block.rebounds(lane);
    task.end[i] = block.end(lane);
    task.restitution[i] = rebounds ? std::min(block.speed[lane], 1.0) : 0.0;
    task.contact_time[i] = rebounds ? block.time[lane] * scaled.time[i] : nothing;
    task.approach_time[i] = task.turning_point ? block.turn_time[lane] * scaled.time[i] : nothing;
    task.maximum_overlap[i] = task.turning_point ? block.turn_overlap[lane] * scaled.length[i] : nothing;
}

/// Follows impacts, given by their numbers, in blocks of like ones, so that the lanes of a block end together.
/// @param write takes (place of the impact, block, lane) of what has been followed
template <class F, class Write>
HWY_INLINE void follow_all(const batch::NumberColumns& numbers, std::span<const std::uint16_t> impacts,
                           Detachment detachment, bool turning_point, const Write& write) {
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
        follow<F>(block, detachment, turning_point);
        for (std::size_t lane = 0; lane < used; ++lane) write(order[first + lane], block, lane);
    }
}

/// Solves the impacts of a task: scales them, reads what a table tells, and follows the others.
template <class F>
HWY_NOINLINE void solve_task(const batch::ImpactTask& task) {
    ScaledTask scaled;
    scale_task<F>(task.inputs, task.count, scaled);
    const PlaceList open = task.table != nullptr ? look_up(task, scaled) : PlaceList::all(task.count);
    follow_all<F>({scaled.adhesion, scaled.damping}, open.places(), task.detachment, task.turning_point,
                  [&](std::size_t i, const Block& block, std::size_t lane)
                      HWY_ATTR { write(task, scaled, i, block, lane); });
}

/// Solves the impacts of a task that gives their numbers.
template <class F>
HWY_NOINLINE void solve_numbers(const batch::NumberTask& task) {
    const PlaceList all = PlaceList::all(task.count);
    follow_all<F>({task.adhesion, task.damping}, all.places(), task.detachment, false,
                  [&](std::size_t i, const Block& block, std::size_t lane) HWY_ATTR {
                      task.end[i] = block.end(lane);
                      task.speed[i] = block.speed[lane];
                      task.time[i] = block.time[lane];
                  });
}

template <template <class> class L>
void solve_law(const batch::ImpactTask& task) {
    switch (task.damping_law) {
        case DampingLaw::constant:
            return solve_task<Form<L, DampingLaw::constant>>(task);
        case DampingLaw::contact_radius:
            return solve_task<Form<L, DampingLaw::contact_radius>>(task);
        case DampingLaw::tsuji:
            return solve_task<Form<L, DampingLaw::tsuji>>(task);
    }
}

template <template <class> class L>
void solve_law_numbers(const batch::NumberTask& task) {
    switch (task.damping_law) {
        case DampingLaw::constant:
            return solve_numbers<Form<L, DampingLaw::constant>>(task);
        case DampingLaw::contact_radius:
            return solve_numbers<Form<L, DampingLaw::contact_radius>>(task);
        case DampingLaw::tsuji:
            return solve_numbers<Form<L, DampingLaw::tsuji>>(task);
    }
}

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

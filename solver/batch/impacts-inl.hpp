// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_IMPACTS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_IMPACTS_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_IMPACTS_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_IMPACTS_INL_HPP
#endif

#include "solver/batch/block-inl.hpp"
#include "solver/batch/order.hpp"
#include "solver/batch/scaling-inl.hpp"

#include <limits>

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

inline void write(const batch::ImpactTask& task, const ScaledTask& scaled, std::size_t i, const Block& block,
                  std::size_t lane) {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    const bool rebounds = block.rebounds(lane);
    task.end[i] = rebounds               ? batch::LaneEnd::rebound
                  : block.captures(lane) ? batch::LaneEnd::capture
                                         : batch::LaneEnd::undecided;
    task.restitution[i] = rebounds ? block.speed[lane] : 0.0;
    task.contact_time[i] = rebounds ? block.time[lane] * scaled.time[i] : nothing;
    task.approach_time[i] = task.turning_point ? block.turn_time[lane] * scaled.time[i] : nothing;
    task.maximum_overlap[i] = task.turning_point ? block.turn_overlap[lane] * scaled.length[i] : nothing;
}

/// Solves the impacts of a task: scales them, and follows them in blocks of like ones, so that the lanes of a
/// block end together.
template <class F>
HWY_NOINLINE void solve_task(const batch::ImpactTask& task) {
    ScaledTask scaled;
    scale_task<F>(task.inputs, task.count, scaled);
    batch::Order order;
    order.sort(scaled.adhesion, scaled.damping, task.count);
    for (std::size_t first = 0; first < task.count; first += block_size) {
        const std::size_t used = task.count - first < block_size ? task.count - first : block_size;
        Block block;
        for (std::size_t lane = 0; lane < block_size; ++lane) {
            const std::size_t i = order[first + (lane < used ? lane : used - 1)];
            block.adhesion[lane] = scaled.adhesion[i];
            block.damping[lane] = scaled.damping[i];
        }
        follow<F>(block, task.detachment, task.turning_point);
        for (std::size_t lane = 0; lane < used; ++lane) write(task, scaled, order[first + lane], block, lane);
    }
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

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

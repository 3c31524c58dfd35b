// SPDX-License-Identifier: GPL-3.0-or-later
// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_SCALED_TASK_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_SCALED_TASK_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_SCALED_TASK_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_SCALED_TASK_INL_HPP
#endif

#include <cstdint>
#include <span>

#include "solver/surrogate/batch/scaling-inl.hpp"

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

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

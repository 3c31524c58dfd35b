// SPDX-License-Identifier: GPL-3.0-or-later
// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_KERNELS_CRITICAL_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_KERNELS_CRITICAL_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_KERNELS_CRITICAL_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_KERNELS_CRITICAL_INL_HPP
#endif

#include <algorithm>
#include <cstddef>

#include <hwy/contrib/math/math-inl.h>

#include "solver/batch/kernels/scaling-inl.hpp"
#include "solver/batch/lanes/form.hpp"
#include "solver/batch/tables/lookup-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

/// Some critical velocities on their way through the table.
struct CriticalBlock {
    static constexpr std::size_t size = 128;
    HWY_ALIGN double unit[size];           ///< V_a, at which the adhesion number is 1 [m/s]
    HWY_ALIGN double number[size];         ///< beta in that scale
    HWY_ALIGN double log_work[size] = {};  ///< ln(work of damping/(beta m V_a^2))
    HWY_ALIGN double energy[size] = {};    ///< of the detachment [m V_a^2]
};

/// Fills in units and numbers, from problem @p first on.
template <class F>
HWY_FLATTEN inline void scale_block(const batch::CriticalTask& task, std::size_t first, std::size_t count,
                                    CriticalBlock& block) {
    using Law = typename F::template ContactLaw<LaneNumber>;
    const Lanes power(task.table->length_power());
    for (std::size_t i = 0; i < count; i += lane_count) {
        const BasicContactPair<LaneNumber> pair = read_pair(task.inputs, first + i, task.count);
        const Lanes at_one = Law::adhesion_number(pair, LaneNumber(1.0)).lanes();
        const Mask adhesive = at_one > Lanes(0.0);
        const Lanes log_length = power * Lanes(hn::Log(Tag(), select(adhesive, at_one, 1.0).v));
        const Lanes length(hn::Exp(Tag(), log_length.v));
        const LaneNumber stiffness = hertz_stiffness(pair);
        const Lanes velocity = length * sqrt(stiffness.lanes() * sqrt(length) / pair.mass.lanes());
        const BasicScale<LaneNumber> scale{
            .mass = pair.mass,
            .stiffness = stiffness,
            .velocity = LaneNumber(velocity),
            .length = LaneNumber(length),
            .radius_length = LaneNumber(sqrt(pair.effective_radius.lanes() * length))};
        const Lanes number =
            read(task.inputs.damping, first + i, task.count) / F::Damping::unit(scale).lanes();
        velocity.store(block.unit + i);
        select(adhesive, number, 0.0).store(block.number + i);
    }
}

/// Reads critical velocities from their table.
template <class F>
HWY_NOINLINE void read_critical(const batch::CriticalTask& task) {
    CriticalBlock block;
    for (std::size_t first = 0; first < task.count; first += CriticalBlock::size) {
        const std::size_t count = std::min(CriticalBlock::size, task.count - first);
        scale_block<F>(task, first, count, block);
        for (std::size_t i = 0; i < count; ++i)
            task.state[first + i] =
                critical_entry_at(*task.table, block.number[i], block.log_work[i], block.energy[i]);
        for (std::size_t i = 0; i < count; i += lane_count) {
            const Lanes work =
                Lanes::load(block.number + i) * Lanes(hn::Exp(Tag(), Lanes::load(block.log_work + i).v));
            const Lanes half_square = work + Lanes::load(block.energy + i);
            (sqrt(half_square + half_square) * Lanes::load(block.unit + i)).store(block.unit + i);
        }
        std::copy_n(block.unit, count, task.value + first);
    }
}

template <template <class> class L>
void critical_law(const batch::CriticalTask& task) {
    with_form<L>(task.damping_law, [&](auto form) { read_critical<decltype(form)>(task); });
}

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

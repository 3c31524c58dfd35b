// SPDX-License-Identifier: GPL-3.0-or-later
// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_BLOCK_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_BLOCK_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_BLOCK_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_BLOCK_INL_HPP
#endif

#include <cstdint>

#include "solver/batch/lanes/leapfrog-inl.hpp"
#include "solver/batch/lanes/number_task.hpp"
#include "solver/batch/lanes/orbit-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

inline constexpr std::size_t block_size = group_count * lane_count;
inline constexpr int most_passes = 64;  ///< steps; an impact that needs more is left to the scalar solver

/// Scaled impacts of one block with their results.
struct Block {
    HWY_ALIGN double adhesion[block_size];
    HWY_ALIGN double damping[block_size];
    HWY_ALIGN double speed[block_size];         ///< at the end of contact
    HWY_ALIGN double time[block_size];          ///< of contact
    HWY_ALIGN double turn_time[block_size];     ///< NaN where it never turns
    HWY_ALIGN double turn_overlap[block_size];  ///< or its supremum
    std::uint64_t rebound;                      ///< one bit a lane; set only if certain
    std::uint64_t capture;                      ///< one bit a lane; set only if certain
    std::uint64_t turn;                         ///< one bit a lane; turning point known

    [[nodiscard]] bool rebounds(std::size_t lane) const { return ((rebound >> lane) & 1U) != 0; }
    [[nodiscard]] bool captures(std::size_t lane) const { return ((capture >> lane) & 1U) != 0; }
    [[nodiscard]] bool turns(std::size_t lane) const { return ((turn >> lane) & 1U) != 0; }
    [[nodiscard]] batch::LaneEnd end(std::size_t lane) const {
        if (rebounds(lane)) return batch::LaneEnd::rebound;
        return captures(lane) ? batch::LaneEnd::capture : batch::LaneEnd::undecided;
    }
};

[[nodiscard]] HWY_INLINE std::uint64_t bits_of(Mask mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(Tag(), mask, bytes);
    return bytes[0];
}

/// One step of each orbit.
template <class F, int sequences = LaneOrbit<F>::sequences>
HWY_INLINE void advance(Groups<LaneOrbit<F>>& orbits) {
    Groups<LaneStep> steps;
    ExtrapolatedLeapfrog<F, sequences, LaneOrbit<F>>::step(orbits, steps);
    for (std::size_t group = 0; group < group_count; ++group) orbits[group].take(steps[group]);
}

/// Steps orbits until none is active. @param pass count of the steps that each lane has tried at least
template <class F>
HWY_INLINE void integrate(Groups<LaneOrbit<F>>& orbits, int pass) {
    for (; pass < most_passes; ++pass) {
        Mask active = none();
        for (LaneOrbit<F>& orbit : orbits) {
            orbit.observe(pass);
            active = either(active, orbit.active());
        }
        if (!any(active)) break;
        advance<F>(orbits);
    }
}

template <class F>
HWY_INLINE void store_ends(const Groups<LaneOrbit<F>>& orbits, Block& block) {
    for (std::size_t group = 0; group < group_count; ++group) {
        const std::size_t first = group * lane_count;
        const LaneArrival end = orbits[group].end_point();
        end.time.store(block.time + first);
        end.speed.store(block.speed + first);
        block.rebound |= bits_of(orbits[group].surely_ended(end)) << first;
        block.capture |= bits_of(orbits[group].surely_captured()) << first;
    }
}

template <class F>
HWY_INLINE void store_turns(const Groups<LaneOrbit<F>>& orbits, Block& block) {
    for (std::size_t group = 0; group < group_count; ++group) {
        const std::size_t first = group * lane_count;
        const LaneTurn turn = orbits[group].turning_point();
        block.turn |= bits_of(orbits[group].surely_turned(turn.time)) << first;
        turn.time.store(block.turn_time + first);
        turn.overlap.store(block.turn_overlap + first);
    }
}

/// Integrates the impacts of a block.
template <class F>
HWY_NOINLINE void follow(Block& block, Detachment detachment, Goal goal) {
    using Orbit = LaneOrbit<F>;
    Groups<Orbit> orbits;
    for (std::size_t group = 0; group < group_count; ++group) {
        const std::size_t first = group * lane_count;
        const Equation<F> equation(Lanes::load(block.adhesion + first), Lanes::load(block.damping + first));
        orbits[group] = Orbit(equation, detachment, goal);
    }
    block.rebound = block.capture = block.turn = 0;
    integrate<F>(orbits, 0);
    if (goal != Goal::turn) store_ends<F>(orbits, block);
    if (goal == Goal::end) return;
    for (Orbit& orbit : orbits) orbit.return_to_turn();
    advance<F, Orbit::sequences_to_turn>(orbits);
    integrate<F>(orbits, Orbit::late);
    store_turns<F>(orbits, block);
}

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

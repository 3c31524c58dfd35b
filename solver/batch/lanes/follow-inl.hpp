// SPDX-License-Identifier: GPL-3.0-or-later
// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_FOLLOW_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_FOLLOW_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_FOLLOW_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_FOLLOW_INL_HPP
#endif

#include <cstddef>
#include <cstdint>
#include <new>
#include <type_traits>

#include "solver/batch/lanes/orbit-inl.hpp"
#include "solver/motion/scale.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

/// The equation of the lanes of a block from @p first on.
template <class F>
[[nodiscard]] HWY_INLINE Equation<F> equation_of(const Block& block, std::size_t first) {
    const Lanes adhesion = Lanes::load(block.adhesion + first);
    const Lanes damping = Lanes::load(block.damping + first);
    if constexpr (std::is_same_v<F, ZoneForm>)
        return {adhesion, damping, block.curve + first, *block.law};
    else
        return {{adhesion}, damping};
}

/// Finds the turning points of impacts that were followed to their end.
template <class F>
HWY_INLINE void follow_to_turn(Groups<LaneOrbit<F>>& orbits, Block& block, Goal goal) {
    if (goal == Goal::end) return;
    for (LaneOrbit<F>& orbit : orbits) orbit.return_to_turn();
    advance<F, LaneOrbit<F>::sequences_to_turn>(orbits);
    integrate<F>(orbits);
    for (std::size_t group = 0; group < group_count; ++group)
        orbits[group].store_turn(block, group * lane_count);
}

/// The return of lanes that are at rest at a place, in a contact of this equation.
/// @param places speed_squared is that of the impact so far, at least
template <class F>
[[nodiscard]] HWY_FLATTEN inline LaneOrbit<F> released(const Equation<F>& equation, Places places,
                                                       Lanes place, Mask active) {
    places.touch = place;
    places.touch_speed = 0.0;
    places.yield = 0.0;
    const Lanes fall = equation.potential(place) - equation.potential(places.equilibrium);
    places.speed_squared = max(places.speed_squared, fall + fall);
    const Lanes drag = equation.damping * value_of<F::drag>(equation.numbers, place);
    const Lanes stiffness = value_of<F::stiffness_slope>(equation.numbers, place);
    return {equation, places, Lanes(1.3) / sqrt(multiply_add(drag, drag, stiffness)), none(), active};
}

/// Integrates the impacts of a block from rest at q = 1 on.
template <class F>
HWY_NOINLINE void follow_release(Block& block, Detachment detachment) {
    Groups<LaneOrbit<F>> orbits;
    block.rebound = block.capture = block.turn = 0;
    for (std::size_t group = 0; group < group_count; ++group) {
        const Equation<F> equation = equation_of<F>(block, group * lane_count);
        Places places = places_of(equation, detachment);
        places.speed_squared = 0.0;
        orbits[group] = released(equation, places, Lanes(1.0), every());
    }
    integrate<F>(orbits);
    for (std::size_t group = 0; group < group_count; ++group)
        orbits[group].store_end(block, group * lane_count);
}

/// Contact laws of a form that yields, and of its plastic branch, on the lanes.
template <class F>
using YieldedLaw = typename F::template ContactLaw<double>::template Yielded<LaneNumber>;
template <class F>
using LoadingLaw = typename F::template ContactLaw<double>::template Loading<LaneNumber>;

/// The place at which an approach yields; out of reach where it never does.
template <class F>
[[nodiscard]] HWY_FLATTEN inline Lanes yield_place(const Equation<F>& equation, Lanes yield_number) {
    const YieldedLaw<F> contact{LaneNumber(equation.numbers.adhesion), LaneNumber(yield_number)};
    const Lanes place = contact.yield_point().lanes();
    constexpr double out_of_reach = 1e300;
    return select(place < Lanes(out_of_reach), place, out_of_reach);
}

/// The impacts of a block that yield, from yield on: along the plastic branch to the turn, and back on the
/// sphere that is flattened then.
///
/// Plastic loading is in units of the length at which the yield number is 1. Unloading is that of an elastic
/// contact with the radius of the flattened sphere: in the units of the impact, but for velocities, which are
/// the flattening f times as great, it has the adhesion number A/f.
template <class F>
class YieldedImpacts {
    using Loading = LoadingForm<F>;
    using Damping = typename F::Damping;
    static_assert(!F::squared && !Loading::squared);

  public:
    /// Follows those of elastic impacts that left their branch.
    HWY_INLINE YieldedImpacts(const Groups<LaneOrbit<F>>& elastic, const Block& block, Detachment detachment,
                              Goal goal) {
        Mask some = none();
        for (std::size_t group = 0; group < group_count; ++group) {
            left_[group] = elastic[group].found().turned;
            some = either(some, left_[group]);
        }
        any_ = any(some);
        if (!any_) return;
        for (std::size_t group = 0; group < group_count; ++group)
            load(group, elastic[group], Lanes::load(block.yield_number + group * lane_count));
        integrate<Loading>(loading_);
        for (std::size_t group = 0; group < group_count; ++group) turn_[group] = loading_[group].turn();
        if (goal == Goal::turn) return;
        for (std::size_t group = 0; group < group_count; ++group)
            unload(group, elastic[group], Lanes::load(block.yield_number + group * lane_count), detachment);
        integrate<F>(unloading_);
    }

    /// Replaces what was stored of the elastic branch, which the impacts have left.
    HWY_INLINE void store(Block& block, Goal goal) const {
        if (!any_) return;
        for (std::size_t group = 0; group < group_count; ++group) {
            const std::size_t first = group * lane_count;
            const auto write = [&](const Lanes& value, double* to) HWY_ATTR {
                select(left_[group], value, Lanes::load(to + first)).store(to + first);
            };
            const auto mark = [&](Mask mask, std::uint64_t& bits) HWY_ATTR {
                bits &= ~(bits_of(left_[group]) << first);
                bits |= bits_of(both(yielded_[group], mask)) << first;
            };
            if (goal != Goal::end) {
                write(turn_[group].time * time_unit_[group], block.turn_time);
                write(turn_[group].overlap * length_unit_[group], block.turn_overlap);
                write(turn_[group].position / time_unit_[group], block.turn_place);
                mark(loading_[group].turns(turn_[group]), block.turn);
            }
            if (goal == Goal::turn) continue;
            const LaneOrbit<F>& unloading = unloading_[group];
            const LaneArrival end = unloading.arrival();
            write(end.speed * flattening_[group], block.speed);
            write(end.time, block.time);
            mark(unloading.rebounds(end), block.rebound);
            mark(either(unloading.captures(), loading_[group].found().never_turns), block.capture);
        }
    }

  private:
    /// Begins plastic loading.
    HWY_FLATTEN void load(std::size_t group, const LaneOrbit<F>& elastic, Lanes yield_number) {
        const Places& before = elastic.places();
        const Lanes root = sqrt(yield_number);
        const Lanes length = yield_number * yield_number;
        const Lanes velocity = length * root;
        length_unit_[group] = length;
        time_unit_[group] = Lanes(1.0) / root;
        const YieldedLaw<F> contact{LaneNumber(elastic.equation().numbers.adhesion / (yield_number * root)),
                                    LaneNumber(1.0)};
        law_[group] = contact.loading();
        const BasicScale<LaneNumber> scale{LaneNumber(1.0), LaneNumber(1.0), LaneNumber(velocity),
                                           LaneNumber(length), LaneNumber(yield_number)};
        const Equation<Loading> equation({contact.adhesion.lanes(), law_[group].offset.lanes()},
                                         elastic.equation().damping / Damping::units(scale)[0].lanes());
        const LaneState& near = elastic.found().turn;
        const LaneArrival arrival = arrival_at(elastic.equation(), before.yield, none(), near,
                                               time_to_place(elastic.equation(), before.yield, near));
        yielded_[group] = both(left_[group], arrival.found);
        Places places;
        places.touch = before.yield / root;
        places.touch_speed = -arrival.speed / velocity;
        places.touch_time = arrival.time / time_unit_[group];
        places.incident = Lanes(1.0) / (velocity * velocity);
        places.speed_squared = before.speed_squared * places.incident;
        places.equilibrium = equilibrium_of(equation, places.touch);
        places.turn_doubt = 1e-7;  // the times of both branches are added
        places.end = places.end_potential = 0.0;
        places.by_force = places.too_slow = none();
        loading_[group] = LaneOrbit<Loading>(equation, places, inward_step(equation, places), yielded_[group],
                                             yielded_[group]);
        loading_[group].stop_at_turn();
    }
    /// Where the force of plastic loading vanishes beyond @p yield; 0 where it is repulsive throughout.
    [[nodiscard]] HWY_INLINE static Lanes equilibrium_of(const Equation<Loading>& equation, Lanes yield) {
        const auto& [adhesion, offset] = equation.numbers;
        Lanes u = max(adhesion * Lanes(2.0 / 3.0), sqrt(sqrt(offset * Lanes(4.0 / 3.0))));
        for (int i = 0; i < 10; ++i)  // convex there: Newton comes down to the root
            u = u - equation.force(u) / equation.force_slope(u);
        return select(equation.force(yield) < Lanes(0.0), u, 0.0);
    }
    /// Begins unloading.
    HWY_FLATTEN void unload(std::size_t group, const LaneOrbit<F>& elastic, Lanes yield_number,
                            Detachment detachment) {
        const LaneNumber greatest(turn_[group].position);
        const LaneNumber flattening = law_[group].flattening(greatest);
        flattening_[group] = flattening.lanes();
        const Lanes share =
            Damping::shapes(LaneNumber(1.0), StaticForces<LaneNumber>{flattening, LaneNumber(0.0)})[0]
                .lanes();
        const Equation<F> equation({elastic.equation().numbers.adhesion / flattening_[group]},
                                   elastic.equation().damping * share);
        Places places = places_of(equation, detachment);
        places.touch_time = turn_[group].time * time_unit_[group];
        places.incident = Lanes(1.0) / (flattening_[group] * flattening_[group]);
        places.speed_squared = elastic.places().speed_squared * places.incident;
        unloading_[group] = released(equation, places, greatest.lanes() * sqrt(yield_number),
                                     both(yielded_[group], loading_[group].found().turned));
    }

    bool any_ = false;
    Groups<Mask> left_;     ///< the elastic branch
    Groups<Mask> yielded_;  ///< those of which state and time at yield are known
    Groups<Lanes> length_unit_;
    Groups<Lanes> time_unit_;
    Groups<Lanes> flattening_;
    Groups<LoadingLaw<F>> law_;
    Groups<LaneOrbit<Loading>> loading_;
    Groups<LaneTurn> turn_;
    Groups<LaneOrbit<F>> unloading_;
};

/// Gives a block further impacts in place of those of a group that have ended.
struct Supply {
    /// Takes the results of a group and puts other impacts there; false without any left.
    bool (*next)(void* context, Block& block, std::size_t group) = nullptr;
    void* context = nullptr;
};

/// Integrates the impacts of a block, and those that @p supply gives if only the end is wanted.
template <class F>
HWY_NOINLINE void follow(Block& block, Detachment detachment, Goal goal, Supply supply = {}) {
    using Orbit = LaneOrbit<F>;
    Groups<Orbit> orbits;
    const auto begin = [&](std::size_t group) HWY_ATTR {
        const std::size_t first = group * lane_count;
        const Equation<F> equation = equation_of<F>(block, first);
        Places places = places_of(equation, detachment);
        if constexpr (F::yields)
            places.yield = yield_place<F>(equation, Lanes::load(block.yield_number + first));
        new (&orbits[group]) Orbit(equation, places, goal);  // in its place: it takes kilobytes
        const std::uint64_t others = ~(bits_of(every()) << first);
        block.rebound &= others;
        block.capture &= others;
        block.turn &= others;
    };
    const auto refill = [&](std::size_t group) HWY_ATTR {
        if (supply.next == nullptr || F::yields || goal != Goal::end) return false;
        orbits[group].store_end(block, group * lane_count);
        if (!supply.next(supply.context, block, group)) return false;
        begin(group);
        return true;
    };
    block.rebound = block.capture = block.turn = 0;
    for (std::size_t group = 0; group < group_count; ++group) begin(group);
    integrate<F>(orbits, refill);
    if (goal != Goal::turn)
        for (std::size_t group = 0; group < group_count; ++group)
            orbits[group].store_end(block, group * lane_count);
    if constexpr (F::yields) {
        YieldedImpacts<F> yielded(orbits, block, detachment, goal);
        follow_to_turn<F>(orbits, block, goal);
        yielded.store(block, goal);
    } else {
        follow_to_turn<F>(orbits, block, goal);
    }
}

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

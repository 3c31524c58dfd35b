// SPDX-License-Identifier: GPL-3.0-or-later
// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_EVENTS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_EVENTS_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_EVENTS_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_EVENTS_INL_HPP
#endif

#include <array>
#include <limits>

#include "solver/batch/lanes/equation-inl.hpp"
#include "solver/contact/pair.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

/// Values of q at which a contact law begins, rests and ends, for the adhesion numbers of the lanes, and the
/// depth of its potential well.
struct Places {
    Places() = default;

    Lanes touch;
    Lanes equilibrium;
    Lanes end;  ///< of contact, except in lanes of by_force
    Lanes end_potential;
    Lanes speed_squared;      ///< v^2 in the bottom of the well, undamped: 1 + 2 (U_touch - U_min)
    Lanes touch_speed = 1.0;  ///< v at touch
    Lanes incident = 1.0;     ///< v^2 of the impact
    Lanes touch_time = 0.0;   ///< since the impact began
    Lanes end_overlap = 0.0;  ///< with a cohesive zone
    Lanes parting = 0.0;      ///< potential at end; that of end_potential lies across a gap
    Lanes yield = 0.0;        ///< where an approach leaves the branch of a form that yields
    /// Share of the energy in the well below which the kernels cannot separate capture from rebound.
    Lanes energy_doubt = 1e-9;
    /// Square of the share of the speed in the well that has to pull back at a turn that is certain.
    double turn_doubt = 1e-8;
    Mask by_force;  ///< the contact ends where the total force vanishes
    Mask too_slow;  ///< no return is fast enough at equilibrium to reach the end of contact
};

/// Whether the damping of a form falls to touch with the repulsion, or faster; see
/// Motion::force_keeps_sign().
template <class F>
inline constexpr bool falls_with_repulsion = F::damping_of_state.lowest() >= (F::squared ? 3 : 6);

/// Lanes whose damping keeps every return slower than what the well takes, as CaptureTest has it.
template <class F>
[[nodiscard]] HWY_INLINE Mask too_slow_to_leave(const Equation<F>& equation, const Places& places) {
    if constexpr (requires(const DampingNumbers<LaneNumber>& n) { F::Damping::fastest_return(n); }) {
        const LaneNumber number(max(equation.damping, 1e-300));
        const Lanes fastest = F::Damping::fastest_return(DampingNumbers<LaneNumber>{number}).lanes();
        const Lanes climb = places.end_potential - equation.potential(places.equilibrium);
        return without(fastest * fastest < climb + climb, places.by_force);
    } else {
        return none();
    }
}

template <class F>
[[nodiscard]] HWY_FLATTEN inline Places places_of(const Equation<F>& equation, Detachment detachment) {
    const typename F::template ContactLaw<LaneNumber> law{LaneNumber(equation.numbers.adhesion)};
    const auto place = [](const LaneNumber& u)
                           HWY_ATTR { return F::squared ? u.lanes() * u.lanes() : u.lanes(); };
    Places p;
    p.touch = place(law.touch());
    p.equilibrium = place(*law.detachment_point(Detachment::zero_force));
    p.end = place(*law.detachment_point(detachment));
    p.end_potential = equation.potential(p.end);
    const Lanes fall = equation.potential(p.touch) - equation.potential(p.equilibrium);
    p.speed_squared = multiply_add(fall, 2.0, 1.0);
    p.by_force = detachment == Detachment::zero_force ? equation.damping > Lanes(0.0) : none();
    if constexpr (falls_with_repulsion<F>) p.by_force = both(p.by_force, p.equilibrium > Lanes(0.0));
    p.too_slow = too_slow_to_leave(equation, p);
    return p;
}

/// The static law in equilibrium.
struct Rest {
    Lanes overlap;
    Lanes damping;      ///< eta
    Lanes slope;        ///< d(delta)/dq
    Lanes force_slope;  ///< dF/dq
};
template <class F>
[[nodiscard]] HWY_INLINE Rest rest_of(const Equation<F>& equation, const Places& places) {
    const Lanes q = places.equilibrium;
    return {equation.overlap(q), equation.damping_at(q), equation.slope_of(q), equation.force_slope(q)};
}
template <class F>
[[nodiscard]] HWY_INLINE Lanes overlap_at_end(const Equation<F>& equation, const Places& places) {
    return equation.overlap(places.end);
}
/// Some damping laws capture every impact that touches at q = 0, from a limit of the damping number on.
template <class F>
[[nodiscard]] HWY_INLINE Mask overdamped(const Equation<F>& equation, const Places& places) {
    constexpr double limit = F::Damping::overdamped_squared;
    if constexpr (limit == std::numeric_limits<double>::infinity()) return none();
    return both(places.touch <= Lanes(0.0), equation.damping * equation.damping >= Lanes(limit));
}

/// v^2 in the well from which on rounding in the well is seen in the energy of a rebound.
inline constexpr double deepest_well = 1e5;

/// Lanes that may creep up to equilibrium, and back from beyond it.
struct MayCreep {
    Mask up;
    Mask back;
};
template <class F>
[[nodiscard]] HWY_INLINE MayCreep may_creep(const Equation<F>& /*equation*/, const Places& /*places*/,
                                            Lanes /*q*/, Lanes /*v*/) {
    return {every(), every()};
}

/// Lanes that are certainly captured, and those that never turn.
struct LaneVerdict {
    Mask captured;
    Mask never_turn;
};

/// Decides capture from the state, as CaptureTest does.
template <class F>
class LaneCapture {
  public:
    HWY_INLINE LaneCapture(const Equation<F>& equation, const Places& places)
        : equation_(equation), places_(places) {}

    /// @param look_for_creeping whether to look for lanes that creep, which are rare and slow to detect
    [[nodiscard]] HWY_INLINE LaneVerdict verdict(Lanes q, Lanes v, Mask active, Mask approaching,
                                                 bool look_for_creeping) const {
        const Mask leaving = without(without(active, approaching), places_.by_force);
        // Where double precision leaves it in doubt, damping goes on to take energy: a later state decides.
        const Lanes certain = -(places_.speed_squared * places_.energy_doubt);
        const Mask caught = both(both(leaving, q > places_.end), energy_left(q, v) <= certain);
        LaneVerdict verdict{either(caught, both(leaving, places_.too_slow)), none()};
        if (look_for_creeping) {
            const auto [up, back] = may_creep(equation_, places_, q, v);
            const Mask inward = both(both(active, approaching), up);
            const Mask outward = both(without(active, approaching), back);
            if (any(inward)) verdict.never_turn = both(inward, creeping_up(q, v));
            if (any(outward)) verdict.captured = either(verdict.captured, both(outward, creeping(q, v)));
            verdict.captured = either(verdict.captured, verdict.never_turn);
        }
        return verdict;
    }

  private:
    /// v^2/2 + U(q) - U_end: if negative after the turn, the end of contact cannot be reached.
    [[nodiscard]] HWY_INLINE Lanes energy_left(Lanes q, Lanes v) const {
        return multiply_add(v * Lanes(0.5), v, equation_.potential(q) - places_.end_potential);
    }
    /// After the turn: so damped that it creeps back without ever reaching the end of contact.
    [[nodiscard]] HWY_INLINE Mask creeping(Lanes q, Lanes v) const {
        const Lanes way = equation_.overlap(q) - overlap_at_end(equation_, places_);
        const Lanes least = rest_of(equation_, places_).damping;
        const Mask slow = v >= least * way * Lanes(-0.5);
        const Mask soft = Lanes(4.0) * equation_.force(q) < least * least * way;
        return without(
            either(both(q >= places_.equilibrium, both(slow, soft)), overdamped(equation_, places_)),
            places_.by_force);
    }
    /// Before the turn: so damped that it creeps up to equilibrium and never turns.
    [[nodiscard]] HWY_INLINE Mask creeping_up(Lanes q, Lanes v) const {
        const Rest rest = rest_of(equation_, places_);
        const Lanes damping = equation_.damping_at(q);
        const Lanes way = rest.overlap - equation_.overlap(q);
        // eta^2 >= 4 dF/d(delta) at equilibrium and here, between which it is no greater; without the
        // division
        const Mask there = damping * damping * rest.slope >= Lanes(4.0) * rest.force_slope;
        const Mask here = damping * damping * equation_.slope_of(q) >= Lanes(4.0) * equation_.force_slope(q);
        const Mask damped = both(there, here);
        const Mask creeps = both(q < places_.equilibrium, both(damped, v <= damping * way * Lanes(0.5)));
        if constexpr (F::yields) return without(creeps, places_.yield < places_.equilibrium);
        return creeps;
    }

    const Equation<F>& equation_;
    const Places& places_;
};

/// How a state changes with pseudo-time.
struct Rates {
    Lanes stiffness;     ///< h
    Lanes acceleration;  ///< dv/dtheta
    Lanes jerk;          ///< d2v/dtheta2
};

template <class F>
[[nodiscard]] HWY_INLINE Rates rates_of(const Equation<F>& equation, Lanes q, Lanes v) {
    const Lanes beta = equation.damping;
    const Lanes drag = beta * value_of<F::drag>(equation.numbers, q);
    const Lanes drag_slope = beta * value_of<F::drag_slope>(equation.numbers, q);
    Rates r;
    r.stiffness = value_of<F::stiffness>(equation.numbers, q);
    r.acceleration = -multiply_add(drag, v, r.stiffness);
    const Lanes spring = multiply_add(drag_slope, v, value_of<F::stiffness_slope>(equation.numbers, q));
    r.jerk = -multiply_add(drag, r.acceleration, spring * v);
    return r;
}

/// Predicts the next event of each lane: the turning point for a lane that still approaches, else the end of
/// contact.
class NextEvent {
  public:
    static constexpr double out_of_sight = 1e300;  ///< pseudo-time to an event that is not predicted yet

    HWY_INLINE NextEvent(const Places& places, Mask approaching)
        : places_(places), approaching_(approaching) {}

    /// Pseudo-time to the event, from the expansion to third order: negative once the lane has passed it,
    /// out_of_sight if none is predicted.
    [[nodiscard]] HWY_INLINE Lanes time(Lanes q, Lanes v, const Rates& r) const {
        const Lanes third = r.jerk * Lanes(1.0 / 6.0);
        const Lanes half = r.acceleration * Lanes(0.5);
        const Lanes p0 = select(approaching_, v, select(places_.by_force, -r.acceleration, q - places_.end));
        const Lanes p1 = select(approaching_, r.acceleration, select(places_.by_force, -r.jerk, v));
        const Lanes p2 =
            select(approaching_, r.jerk * Lanes(0.5), select(places_.by_force, Lanes(0.0), half));
        const Lanes p3 = select(either(approaching_, places_.by_force), Lanes(0.0), third);
        return time_to_zero(p0, p1, p2, p3);
    }
    /// Pseudo-time until an approach leaves its branch.
    [[nodiscard]] HWY_INLINE Lanes time_to_yield(Lanes q, Lanes v, const Rates& r) const {
        return time_to_zero(places_.yield - q, -v, r.acceleration * Lanes(-0.5), r.jerk * Lanes(-1.0 / 6.0));
    }

    /// Pseudo-time before the event from which on its Taylor series is used. For an end by force it is also
    /// at most a small part of the way to zero overlap, where other roots lie.
    [[nodiscard]] HWY_INLINE Lanes reach(Lanes q, Lanes v, Lanes usual) const {
        const Lanes usual_reach = usual * Lanes(landing);
        if (!any(places_.by_force)) return usual_reach;
        const Lanes to_zero = abs(q / v) * Lanes(0.1 * landing);
        return select(without(places_.by_force, approaching_), min(usual_reach, to_zero), usual_reach);
    }

  private:
    static constexpr double landing = 0.06;  ///< part of a usual step

    /// First zero of p0 + p1 h + p2 h^2 + p3 h^3, which falls.
    [[nodiscard]] HWY_INLINE static Lanes time_to_zero(Lanes p0, Lanes p1, Lanes p2, Lanes p3) {
        const Lanes square = subtract_product(p1 * p1, Lanes(4.0) * p2, p0);
        const Lanes root = sqrt(max(square, 0.0));
        const Lanes h = Lanes(2.0) * p0 / (root - p1);
        const Lanes bend = p3 * h * h;
        const Lanes better = multiply_add(bend, h / subtract_product(root, bend, 3.0), h);
        const Mask mild = abs(bend) < Lanes(0.2) * root;
        const Mask real = square > Lanes(0.0);
        // Once the event is passed, the way back is known at least to first order.
        const Mask passed = both(p0 < Lanes(0.0), p1 < Lanes(0.0));
        const Lanes back = select(passed, -p0 / p1, out_of_sight);
        return select(both(p1 < Lanes(0.0), real), select(mild, better, h), back);
    }

    const Places& places_;
    Mask approaching_;
};

/// n (n - 1) ... of so many factors.
[[nodiscard]] constexpr double falling(int n, int count) {
    double product = 1.0;
    for (int i = 0; i < count; ++i) product *= n - i;
    return product;
}

/// A derivative of a Taylor polynomial at a distance @p h. @param c coefficients in ascending powers
template <int derivative, std::size_t count>
[[nodiscard]] HWY_INLINE Lanes series_value(const std::array<Lanes, count>& c, Lanes h) {
    constexpr int order = static_cast<int>(count) - 1;
    Lanes sum = c[order] * Lanes(falling(order, derivative));
    for (int n = order - 1; n >= derivative; --n)
        sum = multiply_add(sum, h, c[n] * Lanes(falling(n, derivative)));
    return sum;
}

/// The motion about a state as Taylor series in pseudo-time, for the last part of the way to an event.
template <class F, int order>
class LaneSeries {
  public:
    using Coefficients = std::array<Lanes, order + 1>;

    HWY_INLINE LaneSeries(const Equation<F>& equation, const LaneState& state) {
        position_[0] = state.position;
        momentum_[0] = state.momentum;
        time_[0] = state.time;
        for (int n = 0; n < order; ++n) {
            multiply<2>(n);
            const Lanes factor(1.0 / (n + 1));
            const Lanes damping = equation.damping * composed<F::impulse, 0>(equation.numbers, n);
            position_[n + 1] = (momentum_[n] - damping) * factor;
            momentum_[n + 1] = composed<F::stiffness, 0>(equation.numbers, n) * (-factor);
            time_[n + 1] = composed<F::slope, 0>(equation.numbers, n) * factor;
        }
    }

    /// v = dq/dtheta
    [[nodiscard]] HWY_INLINE Lanes velocity_at(Lanes h) const { return series_value<1>(position_, h); }
    [[nodiscard]] HWY_INLINE Lanes acceleration_at(Lanes h) const { return series_value<2>(position_, h); }
    [[nodiscard]] HWY_INLINE Lanes position_at(Lanes h) const { return series_value<0>(position_, h); }
    [[nodiscard]] HWY_INLINE Lanes jerk_at(Lanes h) const { return series_value<3>(position_, h); }
    [[nodiscard]] HWY_INLINE Lanes time_at(Lanes h) const { return series_value<0>(time_, h); }

  private:
    static constexpr PowerSet all_powers(const Symbol& p) {
        PowerSet set = 0;
        for (int i = 1; i < Symbol::capacity; ++i)
            if (has(p, i)) set |= power_bit(i);
        return set;
    }
    static constexpr PowerSet powers =
        closed(all_powers(F::impulse) | all_powers(F::stiffness) | all_powers(F::slope));

    /// Coefficient n of every power of q above the first.
    template <int power>
    HWY_INLINE void multiply(int n) {
        if constexpr (power <= highest(powers)) {
            if constexpr (contains(powers, power)) {
                constexpr int i = factor_of(powers, power);
                const Coefficients& a = i == 1 ? position_ : power_[i];
                const Coefficients& b = power - i == 1 ? position_ : power_[power - i];
                Lanes sum = a[0] * b[n];
                for (int k = 1; k <= n; ++k) sum = multiply_add(a[k], b[n - k], sum);
                power_[power][n] = sum;
            }
            multiply<power + 1>(n);
        }
    }
    /// Coefficient n of a polynomial of q.
    template <const Symbol& symbol, int power>
    [[nodiscard]] HWY_INLINE Lanes composed(const LawNumbers& numbers, int n) const {
        if constexpr (power > symbol.degree) {
            return Lanes(0.0);
        } else if constexpr (!has(symbol, power)) {
            return composed<symbol, power + 1>(numbers, n);
        } else {
            const Lanes rest = composed<symbol, power + 1>(numbers, n);
            const Lanes factor = coefficient_of<symbol, power>(numbers, 1.0);
            if constexpr (power == 0) return n == 0 ? rest + factor : rest;
            return multiply_add(factor, power == 1 ? position_[n] : power_[power][n], rest);
        }
    }

    Coefficients position_;
    Coefficients momentum_;
    Coefficients time_;
    std::array<Coefficients, highest(powers) + 1> power_;
};

/// A turning point, scaled.
struct LaneTurn {
    Lanes time;
    Lanes position;
    Lanes overlap;
};

/// An arrival at the end of contact, scaled.
struct LaneArrival {
    Lanes speed;
    Lanes time;
    Mask found;  ///< whether Newton's method converged; not if the end is next to a turn
};

inline constexpr int landing_order = 10;  ///< of the Taylor series about a state next to an event
inline constexpr int turn_order = 7;      ///< of that at a turn, which the state is nearer to
inline constexpr int newton_steps = 4;

/// Greatest overlap and its time, from a state next to the turn. A lane that never @p turned gets the
/// supremum of the overlap, and NaN for the time.
template <class F>
[[nodiscard]] HWY_INLINE LaneTurn turning_point(const Equation<F>& equation, const Places& places,
                                                const LaneState& near, Mask turned) {
    const LaneSeries<F, turn_order> x(equation, near);
    Lanes h = 0.0;
    for (int i = 1; i < newton_steps; ++i) h = h - x.velocity_at(h) / x.acceleration_at(h);
    LaneTurn turn;
    turn.time = select(turned, x.time_at(h), Lanes(hn::NaN(Tag())));
    turn.position = x.position_at(h);
    turn.overlap = select(turned, equation.overlap(turn.position), rest_of(equation, places).overlap);
    return turn;
}

/// Pseudo-time from a state of an approach to a place that it may hardly reach, to second order: a start for
/// Newton's method, which from the state itself does not come close to a turn.
template <class F>
[[nodiscard]] HWY_INLINE Lanes time_to_place(const Equation<F>& equation, Lanes place,
                                             const LaneState& near) {
    const Lanes way = place - near.position;
    const Lanes v = equation.velocity(near);
    const Lanes pull = rates_of(equation, near.position, v).acceleration;
    const Lanes square = multiply_add(v, v, Lanes(2.0) * pull * way);
    return Lanes(2.0) * way / (v + sqrt(max(square, 0.0)));
}

/// Outward speed and time of arrival at a place, or at no total force, from a state next to it.
/// @param h first guess of the pseudo-time
template <class F>
[[nodiscard]] HWY_INLINE LaneArrival arrival_at(const Equation<F>& equation, Lanes place, Mask by_force,
                                                const LaneState& near, Lanes h = 0.0) {
    const LaneSeries<F, landing_order> x(equation, near);
    Lanes move = 0.0;
    for (int i = 0; i < newton_steps; ++i) {
        move = (x.position_at(h) - place) / x.velocity_at(h);
        if (any(by_force)) move = select(by_force, x.acceleration_at(h) / x.jerk_at(h), move);
        h = h - move;
    }
    return {-x.velocity_at(h), x.time_at(h), abs(move) < Lanes(1e-8)};
}

/// The arrival outside of contact, from that at its end.
template <class F>
[[nodiscard]] HWY_INLINE LaneArrival separated(const Equation<F>& /*equation*/, const Places& /*places*/,
                                               const LaneArrival& arrival) {
    return arrival;
}

/// What was found of the impacts of the lanes.
struct LaneFindings {
    LaneFindings() = default;

    LaneState turn;  ///< next to the turning point
    LaneState end;   ///< next to the end of contact
    Mask captured = none();
    Mask turned = none();
    Mask ended = none();
    Mask never_turns = none();  ///< creeps up to equilibrium

    /// Forgets all but the lanes that never turn.
    HWY_INLINE void forget() { captured = turned = ended = none(); }

    HWY_INLINE void record(Mask turning, Mask ending, const LaneState& state) {
        turn = select(turning, state, turn);
        end = select(ending, state, end);
        turned = either(turned, turning);
        ended = either(ended, ending);
    }
    HWY_INLINE void record(const LaneVerdict& verdict) {
        captured = either(captured, verdict.captured);
        never_turns = either(never_turns, verdict.never_turn);
    }

    /// Lanes that have certainly ended, with a reliable speed.
    [[nodiscard]] HWY_INLINE Mask surely_ended(const LaneArrival& arrival, const Places& places) const {
        const Mask fast = arrival.speed * arrival.speed > places.speed_squared * places.energy_doubt;
        const Mask deep = places.speed_squared >= places.incident * Lanes(deepest_well);
        return both(both(ended, arrival.found), without(fast, deep));
    }
    /// Lanes whose turning point at @p time, or its absence, is certain. In doubt are those that turn while
    /// hardly anything pulls them back: where that changes the speed by 1e-4 of what it is in the well
    /// (turn_doubt), errors of 1e-12 move the time by 1e-8 of itself.
    template <class F>
    [[nodiscard]] HWY_INLINE Mask surely_turned(Lanes time, const Equation<F>& equation,
                                                const Places& places) const {
        const Lanes slope = equation.slope_of(turn.position);
        const Lanes pull = rates_of(equation, turn.position, Lanes(0.0)).acceleration / slope * time;
        const Mask doubt = pull * pull < places.speed_squared * Lanes(places.turn_doubt);
        return either(without(turned, doubt), never_turns);
    }
};

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

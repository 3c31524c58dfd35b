// SPDX-License-Identifier: GPL-3.0-or-later
// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_FINDINGS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_FINDINGS_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_FINDINGS_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_FINDINGS_INL_HPP
#endif

#include <array>

#include "solver/batch/lanes/equation-inl.hpp"
#include "solver/batch/lanes/events-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

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
            const Lanes damping = equation.damping * composed<F::impulse, 0>(equation.adhesion, n);
            position_[n + 1] = (momentum_[n] - damping) * factor;
            momentum_[n + 1] = composed<F::stiffness, 0>(equation.adhesion, n) * (-factor);
            time_[n + 1] = composed<F::slope, 0>(equation.adhesion, n) * factor;
        }
    }

    /// v = dq/dtheta
    [[nodiscard]] HWY_INLINE Lanes velocity_at(Lanes h) const { return value<1>(position_, h); }
    [[nodiscard]] HWY_INLINE Lanes acceleration_at(Lanes h) const { return value<2>(position_, h); }
    [[nodiscard]] HWY_INLINE Lanes position_at(Lanes h) const { return value<0>(position_, h); }
    [[nodiscard]] HWY_INLINE Lanes jerk_at(Lanes h) const { return value<3>(position_, h); }
    [[nodiscard]] HWY_INLINE Lanes time_at(Lanes h) const { return value<0>(time_, h); }

  private:
    static constexpr PowerSet all_powers(const Symbol& p) {
        PowerSet set = 0;
        for (int i = 1; i < Symbol::states; ++i) {
            if (p.has(i)) set |= power_bit(i);
        }
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
    [[nodiscard]] HWY_INLINE Lanes composed(Lanes adhesion, int n) const {
        if constexpr (power > symbol.degree()) {
            return Lanes(0.0);
        } else if constexpr (!symbol.has(power)) {
            return composed<symbol, power + 1>(adhesion, n);
        } else {
            const Lanes rest = composed<symbol, power + 1>(adhesion, n);
            const Lanes factor = coefficient_of<symbol, power>(adhesion, 1.0);
            if constexpr (power == 0) return n == 0 ? rest + factor : rest;
            return multiply_add(factor, power == 1 ? position_[n] : power_[power][n], rest);
        }
    }
    /// Value of the derivative of that order.
    template <int derivative>
    [[nodiscard]] HWY_INLINE static Lanes value(const Coefficients& c, Lanes h) {
        Lanes sum = c[order] * Lanes(falling(order, derivative));
        for (int n = order - 1; n >= derivative; --n) {
            sum = multiply_add(sum, h, c[n] * Lanes(falling(n, derivative)));
        }
        return sum;
    }
    static constexpr double falling(int n, int count) {
        double product = 1.0;
        for (int i = 0; i < count; ++i) product *= n - i;
        return product;
    }

    Coefficients position_;
    Coefficients momentum_;
    Coefficients time_;
    std::array<Coefficients, highest(powers) + 1> power_;
};

/// A turning point, scaled.
struct LaneTurn {
    Lanes time;
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
    turn.overlap = equation.overlap(select(turned, x.position_at(h), places.equilibrium));
    return turn;
}

/// Speed and time at the end of contact, from a state next to it.
template <class F>
[[nodiscard]] HWY_INLINE LaneArrival end_point(const Equation<F>& equation, const Places& places,
                                               const LaneState& near) {
    const LaneSeries<F, landing_order> x(equation, near);
    Lanes h = 0.0;
    Lanes move = 0.0;
    for (int i = 0; i < newton_steps; ++i) {
        move = (x.position_at(h) - places.end) / x.velocity_at(h);
        if (any(places.by_force)) move = select(places.by_force, x.acceleration_at(h) / x.jerk_at(h), move);
        h = h - move;
    }
    return {-x.velocity_at(h), x.time_at(h), abs(move) < Lanes(1e-8)};
}

/// What was found of the impacts of the lanes.
struct LaneFindings {
    LaneFindings() = default;

    LaneState turn;  ///< next to the turning point
    LaneState end;   ///< next to the end of contact
    Mask captured = none();
    Mask turned = none();
    Mask ended = none();
    Mask doubtful = none();     ///< captured or not, for lack of digits in the energy
    Mask never_turns = none();  ///< creeps up to equilibrium

    /// Forgets all but the lanes that never turn.
    HWY_INLINE void forget() { captured = turned = ended = doubtful = none(); }

    HWY_INLINE void record(Mask turning, Mask ending, const LaneState& state) {
        turn = select(turning, state, turn);
        end = select(ending, state, end);
        turned = either(turned, turning);
        ended = either(ended, ending);
    }
    HWY_INLINE void record(const LaneVerdict& verdict) {
        doubtful = either(doubtful, verdict.doubtful);
        captured = either(captured, verdict.captured);
        never_turns = either(never_turns, verdict.never_turn);
    }

    /// Lanes that have certainly ended, with a reliable speed.
    [[nodiscard]] HWY_INLINE Mask surely_ended(const LaneArrival& arrival, const Places& places) const {
        const Mask fast = arrival.speed * arrival.speed > places.speed_squared * Lanes(energy_doubt);
        return both(both(ended, arrival.found), both(fast, places.speed_squared < Lanes(deepest_well)));
    }
    /// Lanes whose turning point at @p time, or its absence, is certain. In doubt are those that turn while
    /// hardly anything pulls them back: where that changes the speed by 1e-4 of what it is in the well,
    /// errors of 1e-12 move the time by 1e-8 of itself.
    template <class F>
    [[nodiscard]] HWY_INLINE Mask surely_turned(Lanes time, const Equation<F>& equation,
                                                const Places& places) const {
        const Lanes slope = value_of<F::slope>(equation.adhesion, turn.position);
        const Lanes pull = rates_of(equation, turn.position, Lanes(0.0)).acceleration / slope * time;
        const Mask doubt = pull * pull < places.speed_squared * Lanes(1e-8);
        return either(without(turned, doubt), never_turns);
    }
};

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

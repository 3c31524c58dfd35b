// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_ORBIT_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_ORBIT_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_ORBIT_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_ORBIT_INL_HPP
#endif

#include "solver/batch/landing-inl.hpp"
#include "solver/batch/leapfrog-inl.hpp"
#include "solver/batch/pilot-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

/// A turning point, scaled.
struct LaneTurn {
    Lanes time;
    Lanes overlap;
};

/// An arrival at the end of contact, scaled.
struct LaneArrival {
    Lanes speed;
    Lanes time;
    Mask found;  ///< not where the end is next to a turn
};

/// Follows the impacts of one register of lanes, each on its own; a lane that has ended is left as it is.
template <class F>
class LaneOrbit {
  public:
    static constexpr int sequences = 8;
    static constexpr int late = 5;  ///< steps from which on creeping is asked for: rare, and never in a hurry
    /// Part of a step within which an event is found by the Taylor series of landing order.
    static constexpr double landing = 0.06;
    static constexpr int landing_order = 10;

    LaneOrbit() = default;
    /// @param with_turn whether turning_point() will be asked for; only then a step ends at the turn
    HWY_INLINE LaneOrbit(const Equation<F>& equation, Detachment detachment, bool with_turn)
        : equation_(equation),
          places_(places_of(equation, detachment)),
          pilot_(inward_step(equation, places_)),
          inverse_speed_squared_(Lanes(1.0) / places_.speed_squared),
          with_turn_(with_turn),
          approaching_(every()),
          active_(every()) {
        state_.position = places_.touch;
        state_.momentum = Lanes(1.0) + equation.damping_impulse(places_.touch);
        state_.time = 0.0;
        turn_ = end_ = state_;
    }

    [[nodiscard]] HWY_INLINE const Equation<F>& equation() const { return equation_; }
    [[nodiscard]] HWY_INLINE const LaneState& state() const { return state_; }
    [[nodiscard]] HWY_INLINE Lanes step() const { return step_; }
    [[nodiscard]] HWY_INLINE Mask active() const { return active_; }

    /// What has happened at the present state, and how far to go next.
    HWY_INLINE void observe(int pass) {
        const Lanes q = state_.position;
        const Lanes v = equation_.velocity(state_);
        const Rates r = rates(q, v);
        const Lanes usual = pilot_.step();
        if (!with_turn_) approaching_ = without(approaching_, v <= Lanes(0.0));
        Lanes event = time_to_event(q, v, r);
        if (!with_turn_) event = select(approaching_, no_event, event);
        const Mask near = both(active_, abs(event) <= landing_reach(q, v, usual));
        const Mask turning = both(near, approaching_);
        const Mask ending = both(without(near, approaching_), v < Lanes(0.0));
        keep(turning, turn_);
        keep(ending, end_);
        turned_ = either(turned_, turning);
        ended_ = either(ended_, ending);
        active_ = without(active_, ending);
        approaching_ = without(approaching_, turning);
        detect_capture(q, v, pass);
        const Mask within = without(event < usual * pilot_.reach(), turning);
        step_ = select(within, max(event, -usual), usual);
        speed_ = abs(v);
        stiffness_ = abs(r.stiffness);
    }

    /// Takes the step if it is good enough.
    HWY_INLINE void take(const LaneStep& step) {
        LaneState next;
        next.position = state_.position + step.change.position;
        next.momentum = state_.momentum + step.change.momentum;
        next.time = state_.time + step.change.time;
        const Lanes v = equation_.velocity(next);
        const Lanes error = multiply_add(max(speed_, abs(v)), abs(step.momentum_error),
                                         max(stiffness_, abs(step.end_stiffness)) * abs(step.position_error));
        // A step that leaves and comes back may have been at the end of contact in between.
        const Mask returned = without(v > Lanes(0.0), approaching_);
        const Lanes judged = select(returned, returned_error, error * inverse_speed_squared_);
        const Mask good =
            pilot_.template judge<2 * sequences - 1>(abs(step_), judged, v > Lanes(0.0), active_);
        const Mask taken = both(good, active_);
        state_.position = select(taken, next.position, state_.position);
        state_.momentum = select(taken, next.momentum, state_.momentum);
        state_.time = select(taken, next.time, state_.time);
    }

    /// Greatest overlap and when it is reached; for a lane that never turns its supremum, and no time.
    [[nodiscard]] HWY_INLINE LaneTurn turning_point() const {
        const LaneSeries<F, landing_order> x(equation_, turn_);
        Lanes h = 0.0;
        for (int i = 0; i < newton_steps; ++i) h = h - x.velocity_at(h) / x.acceleration_at(h);
        LaneTurn turn;
        turn.time = select(turned_, x.time_at(h), Lanes(hn::NaN(Tag())));
        turn.overlap = equation_.overlap(select(turned_, x.position_at(h), places_.equilibrium));
        return turn;
    }
    /// Speed at the end of contact and when it is reached.
    [[nodiscard]] HWY_INLINE LaneArrival end_point() const {
        const LaneSeries<F, landing_order> x(equation_, end_);
        Lanes h = 0.0;
        Lanes move = 0.0;
        for (int i = 0; i < newton_steps; ++i) {
            move = (x.position_at(h) - places_.end) / x.velocity_at(h);
            if (any(places_.by_force))
                move = select(places_.by_force, x.acceleration_at(h) / x.jerk_at(h), move);
            h = h - move;
        }
        return {-x.velocity_at(h), x.time_at(h), abs(move) < Lanes(1e-8)};
    }

    /// Lanes that have ended with a speed that is not in doubt.
    [[nodiscard]] HWY_INLINE Mask surely_ended(const LaneArrival& end) const {
        return both(both(ended_, end.found), end.speed * end.speed > places_.speed_squared * Lanes(doubt));
    }
    /// Captured lanes that the double precision of the energy leaves no doubt of.
    [[nodiscard]] HWY_INLINE Mask surely_captured() const { return without(captured_, doubtful_); }
    /// Lanes that turn while hardly anything pulls them back, so that rounding moves the time of the turn.
    [[nodiscard]] HWY_INLINE Mask turns_in_doubt(Lanes time) const {
        const Lanes pull = rates(turn_.position, Lanes(0.0)).acceleration * time;
        return both(turned_, pull * pull < places_.speed_squared * Lanes(1e-3));
    }

  private:
    static constexpr int newton_steps = 4;
    static constexpr double no_event = 1e300;  ///< pseudo-time to what is not in sight
    static constexpr double doubt = 1e-9;  ///< energy, over that in the well, too near capture to tell here
    static constexpr double returned_error = 1.0;  ///< has the pilot shorten the step as far as it ever does

    struct Rates {
        Lanes stiffness;     ///< h
        Lanes acceleration;  ///< dv/dtheta
        Lanes jerk;          ///< d2v/dtheta2
    };
    [[nodiscard]] HWY_INLINE Rates rates(Lanes q, Lanes v) const {
        const Lanes beta = equation_.damping;
        const Lanes drag = beta * value_of<F::drag>(equation_.adhesion, q);
        const Lanes drag_slope = beta * value_of<F::drag_slope>(equation_.adhesion, q);
        Rates r;
        r.stiffness = value_of<F::stiffness>(equation_.adhesion, q);
        r.acceleration = -multiply_add(drag, v, r.stiffness);
        const Lanes spring = multiply_add(drag_slope, v, value_of<F::stiffness_slope>(equation_.adhesion, q));
        r.jerk = -multiply_add(drag, r.acceleration, spring * v);
        return r;
    }

    /// Pseudo-time to the turning point, or after it to the end of contact, from the expansion to third
    /// order; beyond any step where none is in sight.
    [[nodiscard]] HWY_INLINE Lanes time_to_event(Lanes q, Lanes v, const Rates& r) const {
        const Lanes third = r.jerk * Lanes(1.0 / 6.0);
        const Lanes half = r.acceleration * Lanes(0.5);
        const Lanes p0 = select(approaching_, v, select(places_.by_force, -r.acceleration, q - places_.end));
        const Lanes p1 = select(approaching_, r.acceleration, select(places_.by_force, -r.jerk, v));
        const Lanes p2 =
            select(approaching_, r.jerk * Lanes(0.5), select(places_.by_force, Lanes(0.0), half));
        const Lanes p3 = select(either(approaching_, places_.by_force), Lanes(0.0), third);
        const Lanes square = subtract_product(p1 * p1, Lanes(4.0) * p2, p0);
        const Lanes root = sqrt(max(square, 0.0));
        const Lanes h = Lanes(2.0) * p0 / (root - p1);
        const Lanes bend = p3 * h * h;
        const Lanes better = multiply_add(bend, h / subtract_product(root, bend, 3.0), h);
        const Mask mild = abs(bend) < Lanes(0.2) * root;
        const Mask real = square > Lanes(0.0);
        // Gone past it, the way back is known at least to first order.
        const Mask passed = both(p0 < Lanes(0.0), p1 < Lanes(0.0));
        const Lanes back = select(passed, -p0 / p1, no_event);
        return select(both(p1 < Lanes(0.0), real), select(mild, better, h), back);
    }

    /// How far from an event its series is used: for an end by force also a small part of the way to zero
    /// overlap, where other roots are.
    [[nodiscard]] HWY_INLINE Lanes landing_reach(Lanes q, Lanes v, Lanes usual) const {
        const Lanes reach = usual * Lanes(landing);
        if (!any(places_.by_force)) return reach;
        const Lanes to_zero = abs(q / v) * Lanes(0.1 * landing);
        return select(without(places_.by_force, approaching_), min(reach, to_zero), reach);
    }

    HWY_INLINE void keep(Mask mask, LaneState& kept) const {
        kept.position = select(mask, state_.position, kept.position);
        kept.momentum = select(mask, state_.momentum, kept.momentum);
        kept.time = select(mask, state_.time, kept.time);
    }

    HWY_INLINE void detect_capture(Lanes q, Lanes v, int pass) {
        const LaneCapture<F> capture(equation_, places_);
        const Mask leaving = without(without(active_, approaching_), places_.by_force);
        const Lanes left = capture.energy_left(q, v);
        const Lanes margin = places_.speed_squared * Lanes(doubt);
        Mask caught = both(both(leaving, q > places_.end), left < Lanes(0.0));
        doubtful_ = either(doubtful_, both(caught, left > -margin));
        if (pass >= late) {
            caught = either(caught, both(without(active_, approaching_), capture.creeping(q, v)));
            caught = either(caught, both(both(active_, approaching_), capture.creeping_up(q, v)));
        }
        captured_ = either(captured_, caught);
        active_ = without(active_, caught);
    }

    Equation<F> equation_;
    Places places_;
    Pilot pilot_;
    Lanes inverse_speed_squared_;
    LaneState state_;
    LaneState turn_;  ///< next to the turning point
    LaneState end_;   ///< next to the end of contact
    Lanes step_;
    Lanes speed_;
    Lanes stiffness_;
    bool with_turn_ = true;
    Mask approaching_;
    Mask active_;
    Mask captured_ = none();
    Mask turned_ = none();
    Mask ended_ = none();
    Mask doubtful_ = none();
};

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

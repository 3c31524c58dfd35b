// SPDX-License-Identifier: GPL-3.0-or-later
// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_STEPS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_STEPS_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_STEPS_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_STEPS_INL_HPP
#endif

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "solver/batch/lanes/events-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

/// Step for the approach: a part of the period of the motion about the estimated greatest q, where the period
/// is shortest. The estimate balances the incident energy with the potential and the work of damping at a
/// mean speed.
template <class F>
[[nodiscard]] HWY_INLINE Lanes inward_step(const Equation<F>& equation, const Places& places) {
    constexpr double part = 1.3;         // of a radian
    constexpr double mean_speed = 0.72;  // of v_in
    constexpr int degree = F::potential.degree;
    static const double free_turn = std::pow(1.0 / F::potential[degree][0], 1.0 / degree);
    static const double bound_turn =
        std::pow(1.36 * 1.15, 5.0 / degree);  // of DMT; that of the other laws is less
    const LawNumbers& a = equation.numbers;
    const Lanes brake = equation.damping * Lanes(mean_speed);
    const auto work = [&](Lanes q) HWY_ATTR {
        return multiply_add(value_of<F::impulse>(a, q), brake, equation.potential(q));
    };
    const Lanes speed = places.touch_speed;
    const Lanes wanted = multiply_add(speed * Lanes(0.5), speed, work(places.touch));
    const Lanes free = sqrt(sqrt(speed)) * Lanes(free_turn);  // of a speed of 1 or degree 8
    Lanes q = max(max(places.equilibrium * Lanes(bound_turn), free), places.touch * Lanes(1.02));
    for (int i = 0; i < 4; ++i) {  // convex and increasing there: Newton comes down to the root
        const Lanes slope = multiply_add(value_of<F::drag>(a, q), brake, value_of<F::stiffness>(a, q));
        q = q - (work(q) - wanted) / slope;
    }
    const Lanes drag = equation.damping * value_of<F::drag>(a, q);
    return Lanes(part) / sqrt(multiply_add(drag, drag, value_of<F::stiffness_slope>(a, q)));
}

/// Chooses steps. During the approach they stay constant unless the error is far from the tolerance. During
/// the rebound the ideal step grows by a factor that changes little from step to step, so it is extrapolated
/// (predictive controller, Gustafsson 1994). Hardly any step has to be repeated.
class Pilot {
  public:
    static constexpr double tolerance = 0.8e-12;  ///< of the estimate, which is far above the error
    static constexpr double acceptable = 2.5;     ///< tolerances up to which a step is kept
    static constexpr double longest_reach = 1.1;

    Pilot() = default;
    HWY_INLINE explicit Pilot(Lanes first) : log_step_(rough_log2(first)) {}

    [[nodiscard]] HWY_INLINE Lanes step() const { return rough_exp2(log_step_); }
    /// Longest step to an event, as a multiple of step(); 1 after a step that failed.
    [[nodiscard]] HWY_INLINE Lanes reach() const { return reach_; }

    /// Chooses the next step from the size @p taken of the last one and its error estimate @p error.
    /// @param inward lanes whose overlap still grows
    /// @return lanes whose step is accurate enough to be kept
    template <int order>
    HWY_INLINE Mask judge(Lanes taken, Lanes error, Mask inward, Mask active) {
        constexpr double floor = 1e-6 * tolerance;
        const Mask good = error <= Lanes(acceptable * tolerance);
        const Lanes log_taken = rough_log2(taken);
        const Lanes gain =
            (rough_log2(Lanes(tolerance)) - rough_log2(max(error, floor))) * Lanes(1.0 / order);
        const Lanes ideal = log_taken + gain;
        const Lanes trend = min(max(ideal - last_ideal_, 0.0), 0.4);
        const Mask left = leaving_ > Lanes(0.0);
        const Lanes outward =
            min(ideal + select(left, trend, first_trend), log_taken + select(left, Lanes(0.45), Lanes(0.25)));
        const Lanes change = min(max(gain - Lanes(0.35), 0.0), 0.3) * touched_;
        const Lanes steady = log_taken + change;
        const Lanes next = select(good, select(inward, steady, outward), ideal - Lanes(0.1));
        // An accurate step that was shortened for an event does not determine the next one.
        const Mask telling = without(active, both(good, log_taken < log_step_ - Lanes(0.2)));
        log_step_ = select(telling, next, log_step_);
        last_ideal_ = select(telling, ideal, last_ideal_);
        leaving_ = select(both(telling, without(good, inward)), 1.0, leaving_);
        touched_ = 1.0;
        reach_ = select(good, Lanes(longest_reach), 1.0);
        return good;
    }

  private:
    static constexpr double first_trend = 0.1;
    Lanes log_step_;
    Lanes last_ideal_{0.0};
    Lanes leaving_{0.0};  ///< 1 if the last ideal step was one of the rebound
    Lanes touched_{0.0};  ///< 0 during the first step, in which too little happens to judge the step
    Lanes reach_{longest_reach};
};

/// What is to be found of an impact. Both are found by the same steps alone and together, so that asking for
/// the one does not change the other.
enum class Goal { end, turn, end_and_turn };

/// How near to the turn the series is used, as a part of how near to other events: turn_order is lower.
inline constexpr double turn_reach = 1.0 / 3.0;

/// Where on the way from 0 to 1 the cubic with the values @p f0 > 0 and @p f1 <= 0 and the slopes @p d0 and
/// @p d1 at the ends vanishes.
[[nodiscard]] HWY_INLINE Lanes falling_root(Lanes f0, Lanes d0, Lanes f1, Lanes d1) {
    const Lanes change = f1 - f0;
    const Lanes c2 = multiply_add(change, 3.0, -(d0 + d0 + d1));
    const Lanes c3 = multiply_add(change, -2.0, d0 + d1);
    Lanes s = -f0 / change;
    for (int i = 0; i < 3; ++i) {
        const Lanes value = multiply_add(multiply_add(multiply_add(c3, s, c2), s, d0), s, f0);
        const Lanes slope = multiply_add(multiply_add(c3 * Lanes(3.0), s, c2 + c2), s, d0);
        s = min(max(s - value / slope, 0.0), 1.0);
    }
    return s;
}

/// Where and how a step to the turning point begins.
struct StepToTurn {
    LaneState state;
    Lanes velocity;
    Lanes step;   ///< below zero from a state after the turn; the usual one for a lane that has not turned
    Lanes usual;  ///< step that the pilot chose before the turn
};

/// The last state of each lane before its turn and the first one after it. From the nearer one a single step
/// reaches the turning point.
class AroundTurn {
  public:
    AroundTurn() = default;

    /// Records a state of the motion.
    /// @param approaching lanes that had not turned before
    /// @param usual step that the pilot chooses now; @param taken step that led here
    HWY_INLINE void observe(Mask approaching, const LaneState& state, Lanes v, Lanes acceleration,
                            Lanes usual, Lanes taken) {
        const Mask passed = both(approaching, v <= Lanes(0.0));
        const Mask inward = without(approaching, passed);
        before_ = select(inward, state, before_);
        velocity_ = select(inward, v, velocity_);
        acceleration_ = select(inward, acceleration, acceleration_);
        usual_ = select(inward, usual, usual_);
        if (!any(passed)) return;
        after_ = select(passed, state, after_);
        step_ = select(passed, taken, step_);
        later_velocity_ = select(passed, v, later_velocity_);
        later_acceleration_ = select(passed, acceleration, later_acceleration_);
        passed_ = either(passed_, passed);
    }

    [[nodiscard]] HWY_INLINE StepToTurn step_to_turn() const {
        const Lanes part =
            falling_root(velocity_, acceleration_ * step_, later_velocity_, later_acceleration_ * step_);
        const Mask late = both(passed_, part > Lanes(0.5));
        const Lanes step = select(late, (part - Lanes(1.0)) * step_, part * step_);
        return {select(late, after_, before_), select(late, later_velocity_, velocity_),
                select(passed_, step, usual_), usual_};
    }

  private:
    LaneState before_;
    LaneState after_;
    Lanes velocity_;
    Lanes acceleration_;
    Lanes usual_;
    Lanes step_{1.0};
    Lanes later_velocity_{0.0};
    Lanes later_acceleration_{0.0};
    Mask passed_ = none();
};

/// Weights that extrapolate results of 2, 4, ..., 2k substeps, whose error is a series in the substep
/// squared, to substep zero (Richardson 1911; Bulirsch & Stoer 1966). Those of one substep count less give
/// the error estimate.
template <int sequences>
struct Extrapolation {
    std::array<double, static_cast<std::size_t>(sequences)> weight{};
    std::array<double, static_cast<std::size_t>(sequences)>
        difference{};  ///< to the weights without the finest

    constexpr Extrapolation() {
        for (int i = 1; i <= sequences; ++i) {
            weight[static_cast<std::size_t>(i - 1)] = of(i, sequences);
            difference[static_cast<std::size_t>(i - 1)] =
                of(i, sequences) - (i < sequences ? of(i, sequences - 1) : 0.0);
        }
    }

  private:
    static constexpr double of(int i, int count) {
        double product = 1.0;
        for (int j = 1; j <= count; ++j)
            if (j != i) product *= static_cast<double>(i * i) / static_cast<double>(i * i - j * j);
        return product;
    }
};

/// One step of order 2 sequences for all groups of lanes: leapfrogs of 2, 4, ..., 2 sequences substeps
///
///     y_(m+1/2) = y_(m-1/2) - tau h(q_m),
///     q_(m+1) = q_(m-1) + tau (y_(m-1/2) + y_(m+1/2)) - 2 tau beta g(q_m),
///
/// extrapolated to tau = 0. Their error is a series in tau^2, as that of Gragg's midpoint rule (Gragg 1965;
/// without damping Stoermer's rule: Hairer, Norsett & Wanner, Solving ODEs I, II.14). No square root, no
/// division. Momentum is in units of tau times the leading coefficient of h: a kick is one multiply-add.
///
/// @tparam Orbit has equation() (an Equation<F>), state() and step()
template <class F, int sequences, class Orbit>
class ExtrapolatedLeapfrog {
  public:
    HWY_INLINE static void step(const Groups<Orbit>& orbits, Groups<LaneStep>& results) {
        Groups<Start> start;
        for (std::size_t group = 0; group < group_count; ++group) {
            start[group] = started(orbits[group]);
            results[group] = {{0.0, 0.0, 0.0}, 0.0, 0.0, 0.0};
        }
        for (int sequence = sequences; sequence >= 1; --sequence)
            run(orbits, start, sequence, results, std::make_index_sequence<group_count>{});
        for (std::size_t group = 0; group < group_count; ++group) finish(orbits[group], results[group]);
    }

  private:
    static constexpr Extrapolation<sequences> extrapolation{};
    using At = typename Equation<F>::At;

    /// Relative to the state at the start, so that rounding scales with the change.
    struct Chain {
        Lanes previous;  ///< q_(m-1)
        Lanes position;  ///< q_m
        Lanes momentum;  ///< y_(m-1/2)
        Lanes slopes;    ///< sum of the monic part of delta'(q)
    };
    struct Start {
        Lanes momentum;    ///< y in units of kick_unit() H
        Lanes half_kick;   ///< -h/2, monic
        Lanes impulse;     ///< g, monic
        Lanes half_slope;  ///< monic part
        Lanes drift;       ///< kick_unit() H^2
        Lanes damping;     ///< 2 H beta (leading coefficient of g)
    };
    /// What Start and the step H give for one substep.
    struct Substep {
        Lanes drift;
        Lanes damping;
        Lanes free;  ///< twice the displacement without any force
    };

    [[nodiscard]] HWY_INLINE static Start started(const Orbit& orbit) {
        const Equation<F>& equation = orbit.equation();
        const Lanes h = orbit.step();
        const At at = equation.at(orbit.state().position, 0.0);
        const Lanes kick_unit = equation.kick_unit();
        Start s;
        s.momentum = orbit.state().momentum / (kick_unit * h);
        s.half_kick = equation.kicked(0.0, at) * Lanes(0.5);
        s.impulse = equation.impulse_at(at);
        s.half_slope = equation.slope_at(at) * Lanes(0.5);
        s.drift = kick_unit * h * h;
        s.damping = Lanes(2.0) * equation.impulse_unit() * h * equation.damping;
        return s;
    }

    /// One sequence of substeps.
    template <std::size_t... group>
    HWY_INLINE static void run(const Groups<Orbit>& orbits, const Groups<Start>& start, int sequence,
                               Groups<LaneStep>& results, std::index_sequence<group...> /*groups*/) {
        const int substeps = 2 * sequence;
        const double share = 1.0 / substeps;
        Groups<Substep> substep;
        Groups<Chain> chain;
        ((substep[group] = {start[group].drift * Lanes(share * share), start[group].damping * Lanes(share),
                            start[group].drift * start[group].momentum * Lanes(2.0 * share)}),
         ...);
        ((chain[group] = begun(start[group], substep[group])), ...);
        for (int m = 1; m < substeps; ++m) (advance(orbits[group], substep[group], chain[group]), ...);
        (collect(orbits[group], chain[group], sequence, results[group]), ...);
    }

    [[nodiscard]] HWY_INLINE static Chain begun(const Start& s, const Substep& h) {
        Chain c;
        c.previous = 0.0;
        c.momentum = s.half_kick;
        const Lanes undamped = multiply_add(h.drift, c.momentum, h.free * Lanes(0.5));
        c.position = subtract_product(undamped, h.damping * Lanes(0.5), s.impulse);
        c.slopes = s.half_slope;
        return c;
    }

    HWY_INLINE static void advance(const Orbit& orbit, const Substep& h, Chain& c) {
        const Equation<F>& equation = orbit.equation();
        const At at = equation.at(orbit.state().position, c.position);
        const Lanes kicked = equation.kicked(c.momentum, at);
        const Lanes braked = subtract_product(c.previous + h.free, h.damping, equation.impulse_at(at));
        c.slopes = c.slopes + equation.slope_at(at);
        c.previous = c.position;
        c.position = multiply_add(h.drift, c.momentum + kicked, braked);
        c.momentum = kicked;
    }

    HWY_INLINE static void collect(const Orbit& orbit, const Chain& c, int sequence, LaneStep& r) {
        const double substeps = 2.0 * sequence;
        const double weight = extrapolation.weight[static_cast<std::size_t>(sequence - 1)];
        const double difference = extrapolation.difference[static_cast<std::size_t>(sequence - 1)];
        const Equation<F>& equation = orbit.equation();
        const At at = equation.at(orbit.state().position, c.position);
        const Lanes kick = equation.kicked(0.0, at);
        const Lanes slopes = multiply_add(equation.slope_at(at), 0.5, c.slopes);
        const Lanes pushed = multiply_add(kick, 0.5, c.momentum);
        r.change.position = multiply_add(c.position, weight, r.change.position);
        r.change.momentum = multiply_add(pushed, weight / substeps, r.change.momentum);
        r.change.time = multiply_add(slopes, weight / substeps, r.change.time);
        r.position_error = multiply_add(c.position, difference, r.position_error);
        r.momentum_error = multiply_add(pushed, difference / substeps, r.momentum_error);
        if (sequence == sequences) r.end_stiffness = -(kick * equation.kick_unit());
    }

    HWY_INLINE static void finish(const Orbit& orbit, LaneStep& r) {
        const Lanes h = orbit.step();
        const Lanes unit = orbit.equation().kick_unit() * h;
        r.change.momentum = r.change.momentum * unit;
        r.momentum_error = r.momentum_error * unit;
        r.change.time =
            h * multiply_add(r.change.time, orbit.equation().slope_unit(), orbit.equation().slope_constant);
    }
};

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// Included once for each instruction set.
#if defined(ASHIMPACT_SOLVER_BATCH_LEAPFROG_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_LEAPFROG_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_LEAPFROG_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_LEAPFROG_INL_HPP
#endif

#include <array>
#include <cstddef>
#include <utility>

#include "solver/batch/lanes/equation-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

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
        for (int j = 1; j <= count; ++j) {
            if (j != i) product *= static_cast<double>(i * i) / static_cast<double>(i * i - j * j);
        }
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
        for (int sequence = sequences; sequence >= 1; --sequence) {
            run(orbits, start, sequence, results, std::make_index_sequence<group_count>{});
        }
        for (std::size_t group = 0; group < group_count; ++group) finish(orbits[group], results[group]);
    }

  private:
    static constexpr Extrapolation<sequences> extrapolation{};
    static constexpr double kick_unit = Equation<F>::Stiffness::Pattern::leading;
    using At = Powers<Equation<F>::powers>;

    /// Relative to the state at the start, so that rounding scales with the change.
    struct Chain {
        Lanes previous;  ///< q_(m-1)
        Lanes position;  ///< q_m
        Lanes momentum;  ///< y_(m-1/2)
        Lanes slopes;    ///< sum of the monic part of delta'(q)
    };
    struct Start {
        Lanes momentum;    ///< y in units of kick_unit H
        Lanes half_kick;   ///< -h/2, monic
        Lanes impulse;     ///< g, monic
        Lanes half_slope;  ///< monic part
        Lanes drift;       ///< kick_unit H^2
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
        const At at(orbit.state().position);
        Start s;
        s.momentum = orbit.state().momentum / (Lanes(kick_unit) * h);
        s.half_kick = equation.stiffness.subtracted_from(0.0, at) * Lanes(0.5);
        s.impulse = equation.impulse(at);
        s.half_slope = equation.slope(at) * Lanes(0.5);
        s.drift = Lanes(kick_unit) * h * h;
        s.damping = Lanes(2.0 * Equation<F>::Impulse::Pattern::leading) * h * equation.damping;
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
        const At at(orbit.state().position + c.position);
        const Lanes kicked = equation.stiffness.subtracted_from(c.momentum, at);
        const Lanes braked = subtract_product(c.previous + h.free, h.damping, equation.impulse(at));
        c.slopes = c.slopes + equation.slope(at);
        c.previous = c.position;
        c.position = multiply_add(h.drift, c.momentum + kicked, braked);
        c.momentum = kicked;
    }

    HWY_INLINE static void collect(const Orbit& orbit, const Chain& c, int sequence, LaneStep& r) {
        const double substeps = 2.0 * sequence;
        const double weight = extrapolation.weight[static_cast<std::size_t>(sequence - 1)];
        const double difference = extrapolation.difference[static_cast<std::size_t>(sequence - 1)];
        const Equation<F>& equation = orbit.equation();
        const At at(orbit.state().position + c.position);
        const Lanes kick = equation.stiffness.subtracted_from(0.0, at);
        const Lanes slopes = multiply_add(equation.slope(at), 0.5, c.slopes);
        const Lanes pushed = multiply_add(kick, 0.5, c.momentum);
        r.change.position = multiply_add(c.position, weight, r.change.position);
        r.change.momentum = multiply_add(pushed, weight / substeps, r.change.momentum);
        r.change.time = multiply_add(slopes, weight / substeps, r.change.time);
        r.position_error = multiply_add(c.position, difference, r.position_error);
        r.momentum_error = multiply_add(pushed, difference / substeps, r.momentum_error);
        if (sequence == sequences) r.end_stiffness = kick * Lanes(-kick_unit);
    }

    HWY_INLINE static void finish(const Orbit& orbit, LaneStep& r) {
        const Lanes h = orbit.step();
        r.change.momentum = r.change.momentum * (Lanes(kick_unit) * h);
        r.momentum_error = r.momentum_error * (Lanes(kick_unit) * h);
        r.change.time = h * multiply_add(r.change.time, Equation<F>::Slope::Pattern::leading,
                                         orbit.equation().slope_constant);
    }
};

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_LEAPFROG_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_LEAPFROG_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_LEAPFROG_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_LEAPFROG_INL_HPP
#endif

#include "solver/batch/equation-inl.hpp"
#include "solver/batch/extrapolation.hpp"

#include <utility>

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

inline constexpr int group_count = 2;  ///< registers of lanes advanced together, to hide latency
template <class T>
using Groups = std::array<T, group_count>;

/// What one step did to a state, and an estimate of its error.
struct LaneStep {
    LaneState change;
    Lanes position_error;
    Lanes momentum_error;
    Lanes end_stiffness;  ///< h(q) at the end, to second order
};

/// One step of order 2 sequences for two groups of lanes: explicit leapfrogs of 2, 4, ..., 2 sequences substeps
///
///     y_(m+1/2) = y_(m-1/2) - tau h(q_m),   q_(m+1) = q_(m-1) + tau (y_(m-1/2) + y_(m+1/2)) - 2 tau beta g(q_m),
///
/// extrapolated to tau = 0. Their error is a series in tau^2, as Gragg's midpoint rule has it (Gragg 1965; without
/// damping this is Stoermer's rule: Hairer, Norsett & Wanner, Solving ODEs I, II.14). No square root, no division
/// within, next to no memory traffic. Momentum is carried in units of tau times the leading coefficient of h, so that
/// a kick is one multiply-add with the law's own polynomial.
///
/// @tparam Orbit has equation() (an Equation<F>), state() and step()
template <class F, int sequences, class Orbit>
class ExtrapolatedLeapfrog {
  public:
    HWY_INLINE explicit ExtrapolatedLeapfrog(const Groups<Orbit>& orbits) : orbit_(orbits) {
        prepare<0>();
        prepare<1>();
        run(std::make_integer_sequence<int, Layout::length>{});
        finish<0>();
        finish<1>();
    }
    template <int group>
    [[nodiscard]] HWY_INLINE const LaneStep& result() const {
        return result_[group];
    }

  private:
    using Layout = Chains<sequences, group_count>;
    static constexpr Extrapolation<sequences> extrapolation{};
    static constexpr double kick_unit = Equation<F>::Stiffness::Pattern::leading;
    using At = Powers<Equation<F>::powers>;

    struct Chain {
        Lanes previous;  ///< q_(m-1)
        Lanes position;  ///< q_m
        Lanes momentum;  ///< y_(m-1/2)
        Lanes slopes;    ///< sum of the monic part of delta'(q)
    };
    struct Start {
        Lanes momentum;          ///< y in units of kick_unit H
        Lanes half_kick;         ///< -h/2, monic
        Lanes impulse;           ///< g, monic
        Lanes half_slope;        ///< monic part
        Lanes drift;             ///< kick_unit H^2
        Lanes damping;           ///< 2 H beta (leading coefficient of g)
    };

    template <int group>
    HWY_INLINE void prepare() {
        const Equation<F>& equation = orbit_[group].equation();
        const Lanes h = orbit_[group].step();
        Start& s = start_[group];
        const At at(orbit_[group].state().position);
        s.momentum = orbit_[group].state().momentum / (Lanes(kick_unit) * h);
        s.half_kick = equation.stiffness.subtracted_from(0.0, at) * Lanes(0.5);
        s.impulse = equation.impulse(at);
        s.half_slope = equation.slope(at) * Lanes(0.5);
        s.drift = Lanes(kick_unit) * h * h;
        s.damping = Lanes(2.0 * Equation<F>::Impulse::Pattern::leading) * h * equation.damping;
        result_[group] = {{0.0, 0.0, 0.0}, 0.0, 0.0, 0.0};
    }

    template <int... slot>
    HWY_INLINE void run(std::integer_sequence<int, slot...> /*slots*/) {
        (every_chain<slot>(std::make_integer_sequence<int, Layout::count>{}), ...);
    }
    template <int slot, int... chain>
    HWY_INLINE void every_chain(std::integer_sequence<int, chain...> /*chains*/) {
        (substep<slot, chain>(), ...);
    }

    template <int slot, int chain>
    HWY_INLINE void substep() {
        constexpr auto here = Layout::place(chain, slot);
        constexpr int substeps = 2 * here.sequence;
        if constexpr (here.substep == 0) {
            begin<here.group, chain, substeps>();
        } else {
            advance<here.group, chain, substeps>();
        }
        if constexpr (here.substep == substeps - 1) {
            // The groups share a chain one after the other; both add its result last, so that the order of a
            // sum, and with it every bit, is the same whichever group a lane is in.
            constexpr bool alone = Layout::is_shared(chain);
            if constexpr (alone) {
                kept_[here.group] = chain_[chain];
            } else {
                collect<here.group, here.sequence>(chain_[chain]);
            }
        }
    }

    template <int group, int chain, int substeps>
    HWY_INLINE void begin() {
        const Start& s = start_[group];
        Chain& c = chain_[chain];
        c.previous = orbit_[group].state().position;
        c.momentum = multiply_add(s.momentum, double{substeps}, s.half_kick);
        const Lanes undamped =
            multiply_add(s.drift * Lanes(1.0 / (substeps * substeps)), c.momentum, c.previous);
        c.position = subtract_product(undamped, s.damping * Lanes(0.5 / substeps), s.impulse);
        c.slopes = s.half_slope;
    }

    template <int group, int chain, int substeps>
    HWY_INLINE void advance() {
        const Equation<F>& equation = orbit_[group].equation();
        const Start& s = start_[group];
        Chain& c = chain_[chain];
        const At at(c.position);
        const Lanes kicked = equation.stiffness.subtracted_from(c.momentum, at);
        const Lanes braked = subtract_product(c.previous, s.damping * Lanes(1.0 / substeps), equation.impulse(at));
        c.previous = c.position;
        c.position = multiply_add(s.drift * Lanes(1.0 / (substeps * substeps)), c.momentum + kicked, braked);
        c.momentum = kicked;
        c.slopes = c.slopes + equation.slope(at);
    }

    template <int group, int sequence>
    HWY_INLINE void collect(const Chain& c) {
        constexpr double substeps = 2.0 * sequence;
        constexpr double weight = extrapolation.weight[sequence - 1];
        constexpr double difference = extrapolation.difference[sequence - 1];
        const Equation<F>& equation = orbit_[group].equation();
        const Start& s = start_[group];
        const At at(c.position);
        const Lanes kick = equation.stiffness.subtracted_from(0.0, at);
        const Lanes slopes = multiply_add(equation.slope(at), 0.5, c.slopes);
        const Lanes moved = c.position - orbit_[group].state().position;
        const Lanes pushed = multiply_add(kick, 0.5, c.momentum) - s.momentum * Lanes(substeps);
        LaneStep& r = result_[group];
        r.change.position = multiply_add(moved, weight, r.change.position);
        r.change.momentum = multiply_add(pushed, weight / substeps, r.change.momentum);
        r.change.time = multiply_add(slopes, weight / substeps, r.change.time);
        r.position_error = multiply_add(moved, difference, r.position_error);
        r.momentum_error = multiply_add(pushed, difference / substeps, r.momentum_error);
        if constexpr (sequence == sequences) r.end_stiffness = kick * Lanes(-kick_unit);
    }

    template <int group>
    HWY_INLINE void finish() {
        if constexpr (Layout::shared) collect<group, sequences / 2>(kept_[group]);
        LaneStep& r = result_[group];
        const Lanes h = orbit_[group].step();
        r.change.momentum = r.change.momentum * (Lanes(kick_unit) * h);
        r.momentum_error = r.momentum_error * (Lanes(kick_unit) * h);
        r.change.time = h * multiply_add(r.change.time, Equation<F>::Slope::Pattern::leading,
                                         orbit_[group].equation().slope_constant);
    }

    const Groups<Orbit>& orbit_;
    Groups<Start> start_;
    std::array<Chain, Layout::count> chain_;
    Groups<Chain> kept_;
    Groups<LaneStep> result_;
};

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

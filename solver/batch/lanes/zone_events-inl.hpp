// SPDX-License-Identifier: GPL-3.0-or-later
// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_ZONE_EVENTS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_ZONE_EVENTS_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_ZONE_EVENTS_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_ZONE_EVENTS_INL_HPP
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "solver/batch/lanes/zone-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

[[nodiscard]] HWY_INLINE Rest rest_of(const Equation<ZoneForm>& equation, const Places& places) {
    return {equation.rest_overlap, equation.damping_at(places.equilibrium), equation.rest_slope,
            equation.rest_force_slope};
}
[[nodiscard]] HWY_INLINE Lanes overlap_at_end(const Equation<ZoneForm>& /*equation*/, const Places& places) {
    return places.end_overlap;
}
[[nodiscard]] HWY_INLINE Mask overdamped(const Equation<ZoneForm>& /*equation*/, const Places& /*places*/) {
    return none();
}

/// By bounds on the overlap, which costs more than the other functions.
[[nodiscard]] HWY_INLINE MayCreep may_creep(const Equation<ZoneForm>& e, const Places& places, Lanes q,
                                            Lanes v) {
    const Rest rest = rest_of(e, places);
    const Lanes square = rest.damping * rest.damping;
    const Mask below = q < places.equilibrium;
    const Lanes way = multiply_add(e.overlap_unit * q * q, q * q, -places.end_overlap);  // at most
    const Mask slow = both(v >= rest.damping * way * Lanes(-0.5), Lanes(4.0) * e.force(q) < square * way);
    return {both(below, square * rest.slope >= Lanes(3.9) * rest.force_slope), without(slow, below)};
}

/// Gauss-Legendre nodes and weights for the time across a gap, dense where a slow return ends.
struct GapNodes {
    static constexpr std::size_t count = 32;
    std::array<double, count> place;
    std::array<double, count> weight;

    GapNodes() {
        for (std::size_t i = 0; i < count; ++i) {
            double x = std::cos(std::numbers::pi * (static_cast<double>(i) + 0.75) / (count + 0.5));
            double slope = 1.0;
            for (int step = 0; step < 8; ++step) {
                double before = 1.0;
                double now = x;
                for (std::size_t n = 2; n <= count; ++n)
                    before = std::exchange(now, (static_cast<double>(2 * n - 1) * x * now -
                                                 static_cast<double>(n - 1) * before) /
                                                    static_cast<double>(n));
                slope = static_cast<double>(count) * (x * now - before) / (x * x - 1.0);
                x -= now / slope;
            }
            const double s = 0.5 * (1.0 + x);
            place[i] = s * s * s;
            weight[i] = 3.0 * s * s / ((1.0 - x * x) * slope * slope);
        }
    }
};

/// The gap of each lane: beyond the place where the surfaces part, at overlaps above that of the gap's fold
/// by x^2/2, the velocity squared is that at the fold plus @c strength x^2 (f^2/2 + 2 f x/3 + x^2/4).
struct LaneGap {
    Lanes fold;   ///< f
    Lanes width;  ///< x where the surfaces part
    Lanes strength;

    HWY_INLINE explicit LaneGap(const Equation<ZoneForm>& equation) {
        using Curve = batch::ZoneCurve;
        fold = equation.of_curve([](const Curve& c) { return c.gap_fold(); });
        width = equation.of_curve([](const Curve& c) { return c.join_radius(); }) - fold;
        strength = equation.energy_unit * Lanes(std::numbers::pi) *
                   equation.of_curve([](const Curve& c) { return c.lambda(); });
    }
    [[nodiscard]] HWY_INLINE Lanes gain(Lanes x) const {
        const Lanes bracket =
            multiply_add(x, multiply_add(x, 0.25, fold * Lanes(2.0 / 3.0)), fold * fold * Lanes(0.5));
        return strength * x * x * bracket;
    }
    /// Time from x = @p from to the width. @param square of the velocity at the fold
    [[nodiscard]] HWY_INLINE Lanes time(const Equation<ZoneForm>& equation, Lanes from, Lanes square) const {
        static const GapNodes nodes;
        const Lanes length = width - from;
        Lanes sum = 0.0;
        for (std::size_t i = 0; i < GapNodes::count; ++i) {
            const Lanes x = multiply_add(length, nodes.place[i], from);
            sum = multiply_add(x * Lanes(nodes.weight[i]), Lanes(1.0) / sqrt(max(square + gain(x), 1e-300)),
                               sum);
        }
        return equation.overlap_unit * length * sum;
    }
};

[[nodiscard]] HWY_FLATTEN inline Places places_of(const Equation<ZoneForm>& equation,
                                                  Detachment /*detachment*/) {
    using Curve = batch::ZoneCurve;
    const auto number = [&](const auto& of) HWY_ATTR { return equation.of_curve(of); };
    const Lanes energy = equation.energy_unit;
    Places p;
    p.touch = number([](const Curve& c) { return c.begin().touching.position; });
    p.equilibrium = number([](const Curve& c) { return c.rest().place.position; });
    p.end = number([](const Curve& c) { return c.end().touching.position; });
    p.end_overlap = equation.overlap_unit * number([](const Curve& c) { return c.end().touching.overlap; });
    p.end_potential = energy * number([](const Curve& c) { return c.end().potential; });
    const Lanes begin = energy * number([](const Curve& c) { return c.begin().potential; });
    const Lanes bottom = energy * number([](const Curve& c) { return c.rest().place.potential; });
    const Lanes touch = energy * number([](const Curve& c) { return c.begin().touching.potential; });
    p.parting = energy * number([](const Curve& c) { return c.end().touching.potential; });
    p.speed_squared = multiply_add(begin - bottom, 2.0, 1.0);
    p.touch_speed = sqrt(multiply_add(begin - touch, 2.0, 1.0));
    const LaneGap gap(equation);
    const Lanes at_fold = Lanes(1.0) - gap.gain(gap.fold);  // an impact begins at x = f
    const Mask across = number([](const Curve& c) { return c.begin().in_gap ? 1.0 : 0.0; }) > Lanes(0.0);
    if (any(across)) p.touch_time = select(across, gap.time(equation, gap.fold, at_fold), 0.0);
    p.by_force = none();
    // The motion is followed to 1e-9; in the deepest wells the potential at the end is less exact.
    p.energy_doubt = select(p.speed_squared < Lanes(deepest_well), Lanes(2e-8), Lanes(1e-6));
    p.turn_doubt = 1e-4;
    p.too_slow = none();
    if (equation.law->bounds_return) {
        const Lanes fastest = Lanes(1.0) / max(equation.damping, 1e-300);
        const Lanes climb = p.end_potential - bottom;
        p.too_slow = fastest * fastest < climb + climb;
    }
    return p;
}

[[nodiscard]] HWY_INLINE LaneArrival separated(const Equation<ZoneForm>& equation, const Places& places,
                                               const LaneArrival& arrival) {
    const Mask across = places.parting < places.end_potential;
    if (!any(across)) return arrival;
    const Lanes climb = places.end_potential - places.parting;
    const Lanes square = subtract_product(arrival.speed * arrival.speed, 2.0, climb);
    const Lanes time = arrival.time + LaneGap(equation).time(equation, 0.0, square);
    return {select(across, sqrt(max(square, 0.0)), arrival.speed), select(across, time, arrival.time),
            both(arrival.found, either(without(every(), across), square > Lanes(0.0)))};
}

/// As rates_of() of other laws.
[[nodiscard]] HWY_INLINE Rates rates_of(const Equation<ZoneForm>& e, Lanes q, Lanes v) {
    const Lanes t = e.place_of(q);
    const ValueAndSlope slope = value_and_slope_at(e.function(batch::ZoneBand::slope), t);
    const ValueAndSlope force = value_and_slope_at(e.function(batch::ZoneBand::force), t);
    const Lanes eta = e.damping_at(q);
    const Lanes eta_slope = eta * Lanes(e.law->power) / max(q, 1e-9);
    const Lanes slope_value = e.overlap_unit * slope.value;
    const Lanes bend = e.overlap_unit * slope.slope * e.stretch();
    const Lanes drag = slope_value * eta;
    const Lanes drag_slope = multiply_add(bend, eta, slope_value * eta_slope);
    const Lanes stiffness_slope =
        e.energy_unit * e.stretch() * multiply_add(slope.slope, force.value, slope.value * force.slope);
    Rates r;
    r.stiffness = e.energy_unit * slope.value * force.value;
    r.acceleration = -multiply_add(drag, v, r.stiffness);
    r.jerk = -multiply_add(drag, r.acceleration, multiply_add(drag_slope, v, stiffness_slope) * v);
    return r;
}

/// Steps are chosen by ZonePilot.
[[nodiscard]] HWY_INLINE Lanes inward_step(const Equation<ZoneForm>& /*equation*/, const Places& /*places*/) {
    return 1.0;
}

/// As LaneSeries of other laws: the polynomials of the piece are shifted to the state.
template <int order>
class LaneSeries<ZoneForm, order> {
  public:
    using Coefficients = std::array<Lanes, order + 1>;

    HWY_INLINE LaneSeries(const Equation<ZoneForm>& e, const LaneState& state) {
        const Lanes t = e.place_of(state.position);
        const Coefficients slope =
            shifted(e.function(batch::ZoneBand::slope), t, e.overlap_unit, e.stretch());
        const Coefficients force =
            shifted(e.function(batch::ZoneBand::force), t, e.overlap_unit * e.radius_unit, e.stretch());
        const Coefficients impulse =
            shifted(e.function(batch::ZoneBand::impulse), t, e.damping * e.impulse_unit(), e.stretch());
        Coefficients stiffness;
        for (int n = 0; n <= order; ++n) {
            stiffness[n] = slope[0] * force[n];
            for (int k = 1; k <= n; ++k) stiffness[n] = multiply_add(slope[k], force[n - k], stiffness[n]);
        }
        position_[0] = 0.0;  // relative to the state
        momentum_[0] = state.momentum;
        time_[0] = state.time;
        start_ = state.position;
        for (int n = 0; n < order; ++n) {
            for (int k = 2; k <= n; ++k) {  // coefficient n of position^k
                Lanes sum = 0.0;
                const Coefficients& lower = k == 2 ? position_ : power_[k - 1];
                for (int i = 1; i <= n - k + 1; ++i) sum = multiply_add(position_[i], lower[n - i], sum);
                power_[k][n] = sum;
            }
            const Lanes factor(1.0 / (n + 1));
            position_[n + 1] = (momentum_[n] - composed(impulse, n)) * factor;
            momentum_[n + 1] = -(composed(stiffness, n) * factor);
            time_[n + 1] = composed(slope, n) * factor;
        }
    }

    [[nodiscard]] HWY_INLINE Lanes velocity_at(Lanes h) const { return series_value<1>(position_, h); }
    [[nodiscard]] HWY_INLINE Lanes acceleration_at(Lanes h) const { return series_value<2>(position_, h); }
    [[nodiscard]] HWY_INLINE Lanes position_at(Lanes h) const {
        return start_ + series_value<0>(position_, h);
    }
    [[nodiscard]] HWY_INLINE Lanes jerk_at(Lanes h) const { return series_value<3>(position_, h); }
    [[nodiscard]] HWY_INLINE Lanes time_at(Lanes h) const { return series_value<0>(time_, h); }

  private:
    /// Coefficients of a polynomial of the piece by powers of the distance from t.
    [[nodiscard]] HWY_INLINE static Coefficients shifted(ZonePolynomial powers, Lanes t, Lanes unit,
                                                         Lanes stretch) {
        std::array<Lanes, batch::ZoneBand::terms> c;
        for (std::size_t k = 0; k < c.size(); ++k) c[k] = powers[k];
        Coefficients result;
        Lanes factor = unit;
        for (std::size_t n = 0; n <= static_cast<std::size_t>(order); ++n) {
            for (std::size_t k = c.size() - 1; k-- > n;) c[k] = multiply_add(c[k + 1], t, c[k]);
            result[n] = c[n] * factor;
            factor = factor * stretch;
        }
        return result;
    }
    [[nodiscard]] HWY_INLINE Lanes composed(const Coefficients& c, int n) const {
        if (n == 0) return c[0];
        Lanes sum = c[1] * position_[n];
        for (int k = 2; k <= n; ++k) sum = multiply_add(c[k], power_[k][n], sum);
        return sum;
    }

    Lanes start_;
    Coefficients position_;
    Coefficients momentum_;
    Coefficients time_;
    std::array<Coefficients, order + 1> power_;
};

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

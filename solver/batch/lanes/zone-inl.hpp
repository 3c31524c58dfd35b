// SPDX-License-Identifier: GPL-3.0-or-later
// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_ZONE_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_ZONE_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_ZONE_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_ZONE_INL_HPP
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "solver/batch/lanes/events-inl.hpp"
#include "solver/batch/tables/zone_curve.hpp"
#include "solver/damping/registry.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

/// The coefficients of one function, a lane each, by powers of t.
using ZonePolynomial = const Lanes*;

/// Value at t.
[[nodiscard]] HWY_INLINE Lanes value_at(ZonePolynomial c, Lanes t) {
    Lanes sum = c[batch::ZoneBand::terms - 1];
#pragma GCC unroll 20
    for (std::size_t k = batch::ZoneBand::terms - 1; k-- > 0;) sum = multiply_add(sum, t, c[k]);
    return sum;
}

/// Value and derivative by t.
struct ValueAndSlope {
    Lanes value;
    Lanes slope;
};
[[nodiscard]] HWY_INLINE ValueAndSlope value_and_slope_at(ZonePolynomial c, Lanes t) {
    ValueAndSlope r{c[batch::ZoneBand::terms - 1], 0.0};
#pragma GCC unroll 20
    for (std::size_t k = batch::ZoneBand::terms - 1; k-- > 0;) {
        r.slope = multiply_add(r.slope, t, r.value);
        r.value = multiply_add(r.value, t, c[k]);
    }
    return r;
}

/// Turns numbers of each lane, from @p rows on, into lanes of each number: as many as there are lanes.
HWY_INLINE void transpose(const double* const* rows, std::size_t from, Lanes* to) {
#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
    const Tag d;
    const auto row = [&](std::size_t lane) HWY_ATTR { return hn::LoadU(d, rows[lane] + from); };
    const auto even = [&](std::size_t lane)
                          HWY_ATTR { return hn::InterleaveLower(d, row(lane), row(lane + 1)); };
    const auto odd = [&](std::size_t lane)
                         HWY_ATTR { return hn::InterleaveUpper(d, row(lane), row(lane + 1)); };
#if HWY_TARGET == HWY_AVX2
    to[0] = Lanes(hn::ConcatLowerLower(d, even(2), even(0)));
    to[1] = Lanes(hn::ConcatLowerLower(d, odd(2), odd(0)));
    to[2] = Lanes(hn::ConcatUpperUpper(d, even(2), even(0)));
    to[3] = Lanes(hn::ConcatUpperUpper(d, odd(2), odd(0)));
#else
    const auto place = [&](std::size_t first, const auto& a, const auto& b, const auto& c, const auto& e)
                           HWY_ATTR {
                               const auto ab = hn::OddEvenBlocks(hn::SwapAdjacentBlocks(b), a);
                               const auto ba = hn::OddEvenBlocks(b, hn::SwapAdjacentBlocks(a));
                               const auto ce = hn::OddEvenBlocks(hn::SwapAdjacentBlocks(e), c);
                               const auto ec = hn::OddEvenBlocks(e, hn::SwapAdjacentBlocks(c));
                               to[first] = Lanes(hn::ConcatLowerLower(d, ce, ab));
                               to[first + 2] = Lanes(hn::ConcatLowerLower(d, ec, ba));
                               to[first + 4] = Lanes(hn::ConcatUpperUpper(d, ce, ab));
                               to[first + 6] = Lanes(hn::ConcatUpperUpper(d, ec, ba));
                           };
    place(0, even(0), even(2), even(4), even(6));
    place(1, odd(0), odd(2), odd(4), odd(6));
#endif
#else
    for (std::size_t i = 0; i < lane_count; ++i)
        for (std::size_t lane = 0; lane < lane_count; ++lane)
            reinterpret_cast<double*>(to + i)[lane] = rows[lane][from + i];
#endif
}

/// The equation of motion in a cohesive zone: each lane holds the piece of its curve that its next step is
/// on.
template <>
struct Equation<ZoneForm> {
    static constexpr double tolerance = 0.05;  ///< of the error of a step; the curve is as exact as that

    struct At {
        Lanes slope;  ///< d(delta)/dq
        Lanes force;
        Lanes impulse;
    };

    Lanes adhesion;
    Lanes damping;
    Lanes slope_constant = 0.0;
    Lanes radius_unit;  ///< unit of Maugis for the contact radius
    Lanes overlap_unit;
    Lanes energy_unit;
    Lanes damping_unit;  ///< eta for beta = 1 where u = 1
    const batch::ZoneCurve* curve[lane_count] = {};
    const ZoneDamping* law = nullptr;

    Equation() = default;
    Equation(Lanes adhesion_number, Lanes damping_number, const batch::ZoneCurve* const* curves,
             const ZoneDamping& damping_law)
        : adhesion(adhesion_number), damping(damping_number), law(&damping_law) {
        radius_unit = cbrt(adhesion * adhesion * Lanes(0.375));
        overlap_unit = radius_unit * radius_unit;
        energy_unit = overlap_unit * overlap_unit * radius_unit;
        damping_unit = power_of(sqrt(radius_unit));
        std::copy_n(curves, lane_count, curve);
    }

    [[nodiscard]] HWY_INLINE At at(Lanes q) const {
        const Lanes t = place_of(q);
        constexpr std::size_t last = batch::ZoneBand::terms - 1;
        const ZonePolynomial slopes = function(batch::ZoneBand::slope);
        const ZonePolynomial forces = function(batch::ZoneBand::force);
        const ZonePolynomial impulses = function(batch::ZoneBand::impulse);
        At x{slopes[last], forces[last], impulses[last]};
#pragma GCC unroll 20
        for (std::size_t k = last; k-- > 0;) {
            x.slope = multiply_add(x.slope, t, slopes[k]);
            x.force = multiply_add(x.force, t, forces[k]);
            x.impulse = multiply_add(x.impulse, t, impulses[k]);
        }
        return x;
    }
    [[nodiscard]] HWY_INLINE Lanes kicked(Lanes c, const At& x) const {
        return subtract_product(c, x.slope, x.force);
    }
    [[nodiscard]] HWY_INLINE Lanes impulse_at(const At& x) const {
        return x.impulse;
    }
    [[nodiscard]] HWY_INLINE Lanes slope_at(const At& x) const {
        return x.slope;
    }
    [[nodiscard]] HWY_INLINE Lanes kick_unit() const {
        return energy_unit;
    }
    [[nodiscard]] HWY_INLINE Lanes impulse_unit() const {
        return overlap_unit * damping_unit;
    }
    [[nodiscard]] HWY_INLINE Lanes slope_unit() const {
        return overlap_unit;
    }
    [[nodiscard]] HWY_INLINE Lanes error_weight() const {
        return tolerance * law->error_weight;
    }

    /// Takes the piece with most of its length ahead.
    HWY_INLINE void prepare(Lanes q, Mask lanes, Mask inward) {
        HWY_ALIGN double position[lane_count];
        HWY_ALIGN double ahead[lane_count];
        q.store(position);
        select(lanes, select(inward, Lanes(1.0), Lanes(-1.0)), Lanes(0.0)).store(ahead);
        bool changed = false;
        for (std::size_t lane = 0; lane < lane_count; ++lane)
            if (ahead[lane] != 0.0) changed = take_piece(lane, position[lane], ahead[lane] > 0.0) || changed;
        if (!changed) return;
        const double* rows[lane_count];
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            const double* const kept = curve[lane]->kept(index_[lane]);
            rows[lane] = kept != nullptr ? kept : own_[lane];
        }
        for (std::size_t i = 0; i < batch::ZoneBand::padded; i += lane_count)
            transpose(rows, i, coefficients_.data() + i);
    }
    [[nodiscard]] HWY_INLINE Lanes longest_step(Lanes q, Lanes v, Lanes acceleration, Lanes step) const {
        constexpr double most = 0.97;  // of the way to the end of the piece
        const Mask inward = v > Lanes(0.0);
        const Lanes way = Lanes(most) * select(inward, Lanes::load(upper_) - q, q - Lanes::load(lower_));
        const Lanes gain = select(inward, acceleration, -acceleration);
        const Lanes square = multiply_add(way + way, gain, v * v);
        const Lanes h = (way + way) / (abs(v) + sqrt(max(square, 0.0)));
        return select(square > Lanes(0.0), min(step, h), step);
    }
    [[nodiscard]] HWY_INLINE Mask knows(Lanes q) const {
        return abs(place_of(q)) < Lanes(1.04);
    }

    [[nodiscard]] HWY_INLINE Lanes damping_impulse(Lanes q) const {
        return damping * impulse_unit() * value_at(function(batch::ZoneBand::impulse), place_of(q));
    }
    [[nodiscard]] HWY_INLINE Lanes velocity(const LaneState& state) const {
        return state.momentum - damping_impulse(state.position);
    }
    [[nodiscard]] HWY_INLINE Lanes slope_of(Lanes q) const {
        return overlap_unit * value_at(function(batch::ZoneBand::slope), place_of(q));
    }
    [[nodiscard]] HWY_INLINE Lanes force(Lanes q) const {
        return overlap_unit * radius_unit * value_at(function(batch::ZoneBand::force), place_of(q));
    }
    [[nodiscard]] HWY_INLINE Lanes potential(Lanes q) const {
        return energy_unit * value_at(function(batch::ZoneBand::potential), place_of(q));
    }
    [[nodiscard]] HWY_INLINE Lanes overlap(Lanes q) const {
        return overlap_unit * value_at(function(batch::ZoneBand::overlap), place_of(q));
    }
    [[nodiscard]] HWY_INLINE Lanes damping_at(Lanes q) const {
        return damping * damping_unit * power_of(q);
    }

    [[nodiscard]] HWY_INLINE Lanes place_of(Lanes q) const {
        return (q - middle_) * stretch_;
    }
    /// q to the power of the damping law.
    [[nodiscard]] HWY_INLINE Lanes power_of(Lanes q) const {
        Lanes product = 1.0;
        for (int i = 0; i < law->power; ++i) product = product * q;
        return product;
    }
    [[nodiscard]] HWY_INLINE Lanes stretch() const {
        return stretch_;
    }
    [[nodiscard]] HWY_INLINE ZonePolynomial function(batch::ZoneBand::Function which) const {
        return coefficients_.data() + which * batch::ZoneBand::terms;
    }
    /// A number of each lane's curve.
    template <class Number>
    [[nodiscard]] HWY_INLINE Lanes of_curve(const Number& number) const {
        HWY_ALIGN double values[lane_count];
        for (std::size_t lane = 0; lane < lane_count; ++lane) values[lane] = number(*curve[lane]);
        return Lanes::load(values);
    }

  private:
    /// @return whether the piece is another than before
    HWY_INLINE bool take_piece(std::size_t lane, double q, bool inward) {
        const auto& pieces = curve[lane]->band().pieces();
        std::size_t k = index_[lane] == none_yet ? 0 : index_[lane];
        if (inward) {
            while (k + 1 < pieces.size() && pieces[k + 1].lower <= q) ++k;
            while (k > 0 && pieces[k].lower > q) --k;
        } else {
            while (k > 0 && pieces[k - 1].upper >= q) --k;
            while (k + 1 < pieces.size() && pieces[k].upper < q) ++k;
        }
        if (k == index_[lane]) return false;
        index_[lane] = k;
        const batch::ZoneBand::Piece& piece = pieces[k];
        lower_[lane] = piece.lower;
        upper_[lane] = piece.upper;
        reinterpret_cast<double*>(&middle_)[lane] = 0.5 * (piece.lower + piece.upper);
        reinterpret_cast<double*>(&stretch_)[lane] = 2.0 / (piece.upper - piece.lower);
        if (curve[lane]->kept(k) != nullptr) return true;
        double* const to = curve[lane]->room(k) != nullptr ? curve[lane]->room(k) : own_[lane];
        const double x = curve[lane]->place();
        for (std::size_t i = 0; i < batch::ZoneBand::padded; i += lane_count) {
            Lanes sum = Lanes::load(piece.by_order.back().data() + i);
#pragma GCC unroll 20
            for (std::size_t j = batch::ZoneBand::orders - 1; j-- > 0;)
                sum = multiply_add(sum, x, Lanes::load(piece.by_order[j].data() + i));
            sum.store(to + i);
        }
        curve[lane]->keep(k);
        return true;
    }

    static constexpr std::size_t none_yet = std::numeric_limits<std::size_t>::max();

    std::array<Lanes, batch::ZoneBand::padded> coefficients_;
    HWY_ALIGN double own_[lane_count][batch::ZoneBand::padded];  ///< of lanes whose curve keeps none
    Lanes middle_;
    Lanes stretch_;
    HWY_ALIGN double lower_[lane_count];
    HWY_ALIGN double upper_[lane_count];
    std::array<std::size_t, lane_count> index_ = [] {
        std::array<std::size_t, lane_count> all;
        all.fill(none_yet);
        return all;
    }();
};

[[nodiscard]] HWY_INLINE Rest rest_of(const Equation<ZoneForm>& equation, const Places& places) {
    using Curve = batch::ZoneCurve;
    const Lanes force_unit = equation.overlap_unit * equation.radius_unit;
    return {equation.overlap_unit * equation.of_curve([](const Curve& c) { return c.rest().place.overlap; }),
            equation.damping_at(places.equilibrium),
            equation.overlap_unit * equation.of_curve([](const Curve& c) { return c.rest().slope; }),
            force_unit * equation.of_curve([](const Curve& c) { return c.rest().force_slope; })};
}
[[nodiscard]] HWY_INLINE Lanes overlap_at_end(const Equation<ZoneForm>& /*equation*/, const Places& places) {
    return places.end_overlap;
}
[[nodiscard]] HWY_INLINE Mask overdamped(const Equation<ZoneForm>& /*equation*/, const Places& /*places*/) {
    return none();
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

/// As inward_step() of other laws, from the turn of a Hertz contact with an attraction of DMT's kind.
[[nodiscard]] HWY_INLINE Lanes inward_step(const Equation<ZoneForm>& e, const Places& /*places*/) {
    constexpr double part = 1.3;         // of a radian
    constexpr double mean_speed = 0.72;  // of v_in
    const int power = e.law->power;
    const auto power_of_root = [](Lanes root, int exponent) HWY_ATTR {
        Lanes product = 1.0;
        for (int i = 0; i < exponent; ++i) product = product * root;
        return product;
    };
    const Lanes brake = e.damping * Lanes(mean_speed);
    const Lanes pull = e.radius_unit * e.overlap_unit * Lanes(1.8);
    Lanes b = multiply_add(e.radius_unit, 1.6, 1.05);  // contact radius
    for (int i = 0; i < 5; ++i) {
        const Lanes drag = brake * power_of_root(sqrt(b), power);
        const Lanes b2 = b * b;
        const Lanes work =
            multiply_add(drag, b2 * Lanes(4.0 / (4 + power)), multiply_add(b2 * b2 * b, 0.4, -(pull * b2))) -
            Lanes(0.5);
        const Lanes slope = multiply_add(drag, b + b, multiply_add(b2, b2 + b2, -(pull * (b + b))));
        b = max(b - work / slope, e.radius_unit);
    }
    const Lanes drag = e.damping * Lanes(4.0) * sqrt(e.radius_unit) * power_of_root(sqrt(b), power + 3);
    const Lanes stiff = Lanes(36.0) * e.radius_unit * b * b * b * b;
    return Lanes(part) / sqrt(multiply_add(drag, drag, stiff));
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
        std::copy_n(powers, c.size(), c.begin());
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

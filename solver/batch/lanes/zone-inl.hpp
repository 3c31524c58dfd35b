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

#include "solver/batch/lanes/events-inl.hpp"
#include "solver/batch/tables/zone_curve.hpp"
#include "solver/damping/registry.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

/// The coefficients of one function, a lane each, by powers of t; not of the overlap.
struct ZonePolynomial {
    const Lanes* first;
    [[nodiscard]] HWY_INLINE Lanes operator[](std::size_t term) const {
        return first[batch::ZoneBand::index(batch::ZoneBand::slope, term)];
    }
};

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
    static constexpr double tolerance = 0.01;  ///< weight of the error of a step, of which 1e-9 is allowed

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
    Lanes rest_overlap;
    Lanes rest_slope;
    Lanes rest_force_slope;
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
        using Curve = batch::ZoneCurve;
        rest_overlap = overlap_unit * of_curve([](const Curve& c) { return c.rest().place.overlap; });
        rest_slope = overlap_unit * of_curve([](const Curve& c) { return c.rest().slope; });
        rest_force_slope =
            overlap_unit * radius_unit * of_curve([](const Curve& c) { return c.rest().force_slope; });
    }

    /// At a distance from q.
    [[nodiscard]] HWY_INLINE At at(Lanes q, Lanes distance) const {
        const Lanes t = multiply_add(distance, stretch_, place_of(q));
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

    /// Takes the piece with most of its length ahead; inwards with no more than a @p turn needs, so that the
    /// way back is on it as well.
    HWY_INLINE void prepare(Lanes q, Mask lanes, Mask inward, Lanes turn = 1e300) {
        if (!any(lanes)) return;
        HWY_ALIGN double position[lane_count];
        HWY_ALIGN double wanted[lane_count];
        max(turn * Lanes(1.05), q * Lanes(1.1)).store(wanted);
        HWY_ALIGN double ahead[lane_count];
        q.store(position);
        select(lanes, select(inward, Lanes(1.0), Lanes(-1.0)), Lanes(0.0)).store(ahead);
        bool changed = false;
        for (std::size_t lane = 0; lane < lane_count; ++lane)
            if (ahead[lane] != 0.0)
                changed = take_piece(lane, position[lane], ahead[lane] > 0.0, wanted[lane]) || changed;
        if (!changed) return;
        const double* rows[lane_count];
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            const double* const kept = curve[lane]->kept(index_[lane]);
            rows[lane] = kept != nullptr ? kept : own_[lane];
        }
        for (std::size_t i = 0; i < batch::ZoneBand::of_steps; i += lane_count)
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
    [[nodiscard]] HWY_INLINE Lanes force_slope(Lanes q) const {
        return overlap_unit * radius_unit * stretch_ *
               value_and_slope_at(function(batch::ZoneBand::force), place_of(q)).slope;
    }
    [[nodiscard]] HWY_INLINE Lanes potential(Lanes q) const {
        return energy_unit * value_at(function(batch::ZoneBand::potential), place_of(q));
    }
    [[nodiscard]] HWY_NOINLINE Lanes overlap(Lanes q) const {
        constexpr std::size_t first = batch::ZoneBand::of_steps;
        constexpr std::size_t count = batch::ZoneBand::padded - first;
        HWY_ALIGN double values[lane_count][count];
        const double* rows[lane_count];
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            const batch::ZoneBand::Piece& piece = curve[lane]->band().pieces()[index_[lane]];
            for (std::size_t i = 0; i < count; i += lane_count)
                contracted(piece, first + i, curve[lane]->place()).store(values[lane] + i);
            rows[lane] = values[lane];
        }
        std::array<Lanes, count> c;
        for (std::size_t i = 0; i < count; i += lane_count) transpose(rows, i, c.data() + i);
        const Lanes t = place_of(q);
        Lanes sum = c[batch::ZoneBand::terms - 1];
        for (std::size_t k = batch::ZoneBand::terms - 1; k-- > 0;) sum = multiply_add(sum, t, c[k]);
        return overlap_unit * sum;
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
        return {coefficients_.data() + which};
    }
    /// A number of each lane's curve.
    template <class Number>
    [[nodiscard]] HWY_INLINE Lanes of_curve(const Number& number) const {
        HWY_ALIGN double values[lane_count];
        for (std::size_t lane = 0; lane < lane_count; ++lane) values[lane] = number(*curve[lane]);
        return Lanes::load(values);
    }

  private:
    /// Coefficients of a piece at a place in its band, from @p first on.
    [[nodiscard]] HWY_INLINE static Lanes contracted(const batch::ZoneBand::Piece& piece, std::size_t first,
                                                     Lanes x) {
        Lanes sum = Lanes::load(piece.by_order.back().data() + first);
#pragma GCC unroll 20
        for (std::size_t j = batch::ZoneBand::orders - 1; j-- > 0;)
            sum = multiply_add(sum, x, Lanes::load(piece.by_order[j].data() + first));
        return sum;
    }
    /// @return whether the piece is another than before
    HWY_INLINE bool take_piece(std::size_t lane, double q, bool inward, double wanted) {
        const auto& pieces = curve[lane]->band().pieces();
        std::size_t k = index_[lane] == none_yet ? 0 : index_[lane];
        if (inward) {
            while (k + 1 < pieces.size() && pieces[k + 1].lower <= q) ++k;
            while (k > 0 && (pieces[k].lower > q || pieces[k - 1].upper >= wanted)) --k;
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
        for (std::size_t i = 0; i < batch::ZoneBand::of_steps; i += lane_count)
            contracted(piece, i, x).store(to + i);
        curve[lane]->keep(k);
        return true;
    }

    static constexpr std::size_t none_yet = std::numeric_limits<std::size_t>::max();

    std::array<Lanes, batch::ZoneBand::of_steps> coefficients_;
    HWY_ALIGN double own_[lane_count][batch::ZoneBand::of_steps];  ///< of lanes whose curve keeps none
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

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

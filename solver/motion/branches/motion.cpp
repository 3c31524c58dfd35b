// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/motion/branches/motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "solver/numeric/number.hpp"

namespace ashimpact {

namespace {

/// Step of a motion that nothing accelerates, whose series end: it doubles or ends the coordinate.
template <class Real>
Real uniform_step(const MotionState<Real>& state) {
    using std::abs;
    const Real way = state.position != Real(0) ? abs(state.position) : Real(1);
    return state.velocity != Real(0) ? way / abs(state.velocity) : Real(1);
}

/// The motion along one piece, by which its step is not ended.
template <class Real>
MotionExpansion<Real> series_on(const MotionPiece<Real>& on, const MotionState<Real>& state, int sense) {
    MotionExpansion<Real> x{};
    x.position[0] = state.position;
    x.velocity[0] = state.velocity;
    x.time[0] = state.time;
    x.dissipation[0] = state.dissipation;

    PowerSeries<Real> series;  // the on.powers of the chain are filled below
    Series<Real> drag_series;
    Series<Real> drag_velocity;
    const bool damped = on.drag.degree > 0 || on.drag[0] != Real(0);
    for (std::size_t n = 0; n + 1 < x.position.size(); ++n) {
        on.powers.advance(series, x.position, n);
        const Real factor = Real(1) / static_cast<Real>(n + 1);
        Real acceleration = -composed(on.stiffness, series, n);
        if (damped) {
            drag_series[n] = composed(on.drag, series, n);
            drag_velocity[n] = product_coefficient(drag_series, x.velocity, n);
            acceleration -= drag_velocity[n];
            x.dissipation[n + 1] = factor * product_coefficient(drag_velocity, x.velocity, n);
        }
        x.position[n + 1] = factor * x.velocity[n];
        x.velocity[n + 1] = factor * acceleration;
        x.time[n + 1] = factor * composed(on.slope, series, n);
    }
    const Real within = std::min(radius(x.position), radius(x.velocity));
    const bool uniform = within == std::numeric_limits<Real>::infinity();
    x.step = Real(sense) *
             (uniform ? uniform_step(state) : within / (std::numbers::e_v<Real> * std::numbers::e_v<Real>));
    return x;
}

/// Ends the step where the coordinate leaves [lower, upper]; just beyond a turn, if it does so after that.
template <class Real>
void cut(MotionExpansion<Real>& x, Real lower, Real upper) {
    const Real sign = x.velocity[0] < Real(0) ? Real(-1) : Real(1);
    const auto onward = [&](Real h) { return sign * value(x.velocity, h); };
    const bool turns = x.velocity[0] != Real(0) && onward(x.step) < Real(0);
    const Real turn = turns ? sign_change<Real>(onward, x.step) : x.step;
    const auto below = [&](Real h) { return upper - value(x.position, h); };
    const auto above = [&](Real h) { return value(x.position, h) - lower; };
    if (below(turn) < Real(0))
        x.step = sign_change<Real>(below, turn);
    else if (above(turn) < Real(0))
        x.step = sign_change<Real>(above, turn);
    else if (below(x.step) < Real(0) || above(x.step) < Real(0))
        x.step = turn * (1 + 4 * std::numeric_limits<Real>::epsilon());
}

}  // namespace

template <class Real>
bool Motion<Real>::is_soft(const Real& from, const Real& to, const Real& most) const {
    const auto soft = [&](const MotionPiece<Real>& piece, const Real& lower, const Real& upper) {
        return (piece.force.derivative() - most * piece.slope).upper_bound(lower, upper) <= Real(0);
    };
    if (!soft(at(from), from, std::min(to, at(from).until))) return false;
    for (Real lower = at(from).until; const MotionPiece<Real>& piece : beyond) {
        if (piece.until <= lower || lower >= to) continue;
        if (!soft(piece, lower, std::min(to, piece.until))) return false;
        lower = piece.until;
    }
    return true;
}

template <class Real>
MotionExpansion<Real> Motion<Real>::expand(const MotionState<Real>& state, int sense) const {
    if (beyond.empty()) return series_on(first, state, sense);
    const Real q = state.position;
    const Real way = state.velocity != Real(0) ? Real(sense) * state.velocity : -slope(q) * force(q);
    const Real rounding = 16 * std::numeric_limits<Real>::epsilon() * std::abs(q);
    const MotionPiece<Real>& piece = at(way > Real(0) ? q + rounding : q - rounding);
    MotionExpansion<Real> x = series_on(piece, state, sense);
    Real lower = -std::numeric_limits<Real>::infinity();
    for (const MotionPiece<Real>* below = &first; below->until < piece.until;
         below = below == &first ? beyond.data() : below + 1)
        lower = below->until;
    cut(x, lower, piece.until);
    return x;
}

template <class Real>
Motion<Real> branch_motion(std::span<const StaticBranch<Real>> pieces, const ScaledDamping<Real>& eta) {
    Motion<Real> motion;
    motion.overdamped = eta.overdamped;
    motion.squared = std::ranges::all_of(pieces, [&](const StaticBranch<Real>& piece) {
        return piece.overlap.even() && (piece.forces.repulsion - piece.forces.attraction).even() &&
               eta.on_branch(piece.forces).even();
    });
    const auto reduced = [&](const Polynomial<Real>& p) { return motion.squared ? p.of_square() : p; };
    motion.beyond.reserve(pieces.size() - 1);
    for (const StaticBranch<Real>& piece : pieces) {
        const bool is_first = &piece == &pieces.front();
        const MotionPiece<Real>& below = motion.beyond.empty() ? motion.first : motion.beyond.back();
        MotionPiece<Real> m;
        m.until = motion.coordinate(piece.until);
        m.overlap = reduced(piece.overlap);
        m.force = reduced(piece.forces.repulsion - piece.forces.attraction);
        m.damping = reduced(eta.on_branch(piece.forces));
        m.slope = m.overlap.derivative();
        m.stiffness = m.slope * m.force;
        m.drag = m.slope * m.damping;
        m.potential = m.stiffness.antiderivative();
        if (!is_first) m.potential[0] = below.potential(below.until) - m.potential(below.until);
        for (const Polynomial<Real>* p : {&m.slope, &m.drag, &m.stiffness}) m.powers.require(*p);
        if (is_first)
            motion.first = m;
        else
            motion.beyond.push_back(m);
    }
    return motion;
}

template struct Motion<double>;
template struct Motion<long double>;
template Motion<double> branch_motion(std::span<const StaticBranch<double>>, const ScaledDamping<double>&);
template Motion<long double> branch_motion(std::span<const StaticBranch<long double>>,
                                           const ScaledDamping<long double>&);

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/motion/branches/motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "solver/motion/branches/creep.hpp"
#include "solver/motion/branches/leading_terms.hpp"
#include "solver/numeric/number.hpp"

namespace ashimpact {

/// The polynomials of a piece as series.
template <class Real, class Goal = Real>
class PieceTerms {
  public:
    static constexpr bool time_may_converge_least = false;

    explicit PieceTerms(const MotionPiece<Goal>& piece)
        : piece_(&piece), slope_(piece.slope), stiffness_(piece.stiffness), drag_(piece.drag) {}
    /// With the leading terms of another number type.
    template <class Other>
    explicit PieceTerms(const PieceTerms<Other, Goal>& other) : PieceTerms(*other.piece_) {
        piece_->powers.copy(other.powers_, powers_, leading_terms);
        copy_terms(other.drag, drag, leading_terms);
    }

    void advance(const Series<Real, Goal>& position, std::size_t n) {
        piece_->powers.advance(powers_, position, n);
        slope[n] = slope_.composed(powers_, n);
        stiffness[n] = stiffness_.composed(powers_, n);
        if (damped()) drag[n] = drag_.composed(powers_, n);
    }
    void follow(const Series<Real, Goal>& /*position*/, const Series<Real, Goal>& /*velocity*/,
                std::size_t /*n*/) {}
    [[nodiscard]] bool damped() const { return !drag_.is_zero(); }

    Series<Real, Goal> slope;
    Series<Real, Goal> stiffness;
    Series<Real, Goal> drag{};

  private:
    template <class, class>
    friend class PieceTerms;

    const MotionPiece<Goal>* piece_;
    SparsePolynomial<Real> slope_, stiffness_, drag_;
    PowerSeries<Real, Goal> powers_;  // only those that piece_->powers requires are set
};

namespace {

/// The motion as if @p piece had no borders: the step may end beyond them. @param creeps whether a stiff
/// return may be followed as a creep, in which the small total force that ends some contacts is lost
template <class Real>
MotionExpansion<Real> expand_on(const MotionPiece<Real>& piece, const MotionState<Real>& state, int sense,
                                bool creeps) {
    const Real q = state.position;
    if (sense > 0 && creeps && may_creep(state, piece.stiffness(q), piece.drag(q)))
        if (const auto creeping = expand_creep(state, [&] { return PieceTerms<Real>(piece); }))
            return *creeping;
    MotionSteps<PieceTerms, Real> steps(state, piece);
    complete_expansion(steps);
    Real& step = steps.x.step;
    const bool uniform = step == std::numeric_limits<Real>::infinity();
    constexpr Real e = std::numbers::e_v<Real>;  // radius/e^2: the step of taylor_order
    step = Real(sense) * (uniform ? uniform_step(state) : step / (e * e));
    return steps.x;
}

/// Ends the step where the coordinate leaves [lower, upper], or just beyond the turn if it leaves after one.
template <class Real>
void end_step_at_border(MotionExpansion<Real>& x, Real lower, Real upper) {
    const Real sign = x.velocity[0] < Real(0) ? Real(-1) : Real(1);
    const auto onward = [&](Real h) { return sign * value(x.velocity, h); };
    const auto to_upper = [&](Real h) { return upper - value(x.position, h); };
    const auto to_lower = [&](Real h) { return value(x.position, h) - lower; };
    const bool turns = x.velocity[0] != Real(0) && onward(x.step) < Real(0);
    const Real turn = turns ? sign_change<Real>(onward, x.step) : x.step;
    if (to_upper(turn) < Real(0))
        x.step = sign_change<Real>(to_upper, turn);
    else if (to_lower(turn) < Real(0))
        x.step = sign_change<Real>(to_lower, turn);
    else if (to_upper(x.step) < Real(0) || to_lower(x.step) < Real(0))
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
    if (beyond.empty()) return expand_on(first, state, sense, end.has_value());
    const Real q = state.position;
    // At a border the piece is that ahead of the motion; at rest, that ahead of its acceleration.
    const Real direction = state.velocity != Real(0) ? Real(sense) * state.velocity : -slope(q) * force(q);
    const Real rounding = 16 * std::numeric_limits<Real>::epsilon() * std::abs(q);
    const MotionPiece<Real>& piece = at(direction > Real(0) ? q + rounding : q - rounding);
    const Real lower = &piece == &first          ? -std::numeric_limits<Real>::infinity()
                       : &piece == beyond.data() ? first.until
                                                 : (&piece - 1)->until;
    MotionExpansion<Real> x = expand_on(piece, state, sense, end.has_value());
    end_step_at_border(x, lower, piece.until);
    return x;
}

template <class Real>
Motion<Real> branch_motion(std::span<const StaticBranch<Real>> pieces, const ScaledDamping<Real>& eta) {
    Motion<Real> motion;
    motion.overdamped = eta.overdamped;
    // A return is bounded by its repulsion where nothing else repels.
    const auto attracts = [](const StaticBranch<Real>& piece) {
        const Polynomial<Real>& attraction = piece.forces.attraction;
        for (int i = 0; i <= attraction.degree; ++i)
            if (attraction[i] < Real(0)) return false;
        return true;
    };
    if (std::ranges::all_of(pieces, attracts)) motion.fastest_return = eta.fastest_return;
    motion.squared = std::ranges::all_of(pieces, [&](const StaticBranch<Real>& piece) {
        return piece.overlap.even() && (piece.forces.repulsion - piece.forces.attraction).even() &&
               eta.on_branch(piece.forces).even();
    });
    const auto reduced = [&](const Polynomial<Real>& p) { return motion.squared ? p.of_square() : p; };
    motion.beyond.reserve(pieces.size() - 1);
    for (const StaticBranch<Real>& piece : pieces) {
        const bool is_first = &piece == &pieces.front();
        const MotionPiece<Real>& before = motion.beyond.empty() ? motion.first : motion.beyond.back();
        MotionPiece<Real> m;
        m.until = motion.coordinate(piece.until);
        m.overlap = reduced(piece.overlap);
        m.force = reduced(piece.forces.repulsion - piece.forces.attraction);
        m.damping = reduced(eta.on_branch(piece.forces));
        m.slope = m.overlap.derivative();
        m.stiffness = m.slope * m.force;
        m.drag = m.slope * m.damping;
        m.potential = m.stiffness.antiderivative();
        if (!is_first) m.potential[0] = before.potential(before.until) - m.potential(before.until);
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

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "solver/motion/branches/motion_state.hpp"
#include "solver/numeric/series.hpp"

namespace ashimpact {

/// Terms of an expansion that need all the digits of a number type wider than double. In a step of radius/e^2
/// the others are together less than a part in 10^6 of the sum: rounded to double they are exact enough.
inline constexpr std::size_t leading_terms = 8;

/// Whether the terms, and products of some of them, are in the range of double.
template <std::size_t size>
[[nodiscard]] bool fits_double(const std::array<double, size>& terms) {
    return std::ranges::all_of(
        terms, [](double x) { return x == 0.0 || (std::abs(x) > 1e-200 && std::abs(x) < 1e200); });
}

/// Copies the terms of @p rest from the @p first one on, and its step, into an expansion of another number
/// type.
template <class Goal, class Rest>
void append(const Rest& rest, std::size_t first, MotionExpansion<Goal>& all) {
    const auto copy = [first](const auto& from, auto& to) {
        for (std::size_t n = first; n < from.size(); ++n) to[n] = static_cast<Goal>(from[n]);
    };
    copy(rest.position, all.position);
    copy(rest.velocity, all.velocity);
    copy(rest.time, all.time);
    copy(rest.dissipation, all.dissipation);
    all.step = static_cast<Goal>(rest.step);
}

/// The expansion of a motion term by term, in number type Real, for sums to the rounding of Goal.
/// @tparam Terms the equation of motion as series of the pseudo-time, as of MotionPiece: advance() computes a
/// coefficient of slope, stiffness and drag from those of the position up to it, follow() takes the
/// velocity's
template <template <class, class> class Terms, class Real, class Goal = Real>
class MotionSteps {
  public:
    /// @param equation what Terms are made from
    template <class... Equation>
    explicit MotionSteps(const MotionState<Goal>& state, const Equation&... equation) : terms_(equation...) {
        x.position[0] = state.position;
        x.velocity[0] = state.velocity;
        x.time[0] = state.time;
        x.dissipation[0] = state.dissipation;
    }
    /// With the leading terms of another number type.
    template <class Other>
    explicit MotionSteps(const MotionSteps<Terms, Other, Goal>& other) : terms_(other.terms()) {
        copy_terms(other.x.position, x.position, leading_terms + 1);
        copy_terms(other.x.velocity, x.velocity, leading_terms + 1);
        copy_terms(other.x.time, x.time, leading_terms + 1);
        if (terms_.damped()) copy_terms(other.braking(), braking_, leading_terms);
    }

    /// Computes the terms from + 1..to.
    void advance(std::size_t from, std::size_t to) {
        for (std::size_t n = from; n < to; ++n) {
            terms_.advance(x.position, n);
            const Real factor = Real(1) / static_cast<Real>(n + 1);
            Real acceleration = -terms_.stiffness[n];
            if (terms_.damped()) {
                braking_[n] = product_coefficient(terms_.drag, x.velocity, n);
                acceleration -= braking_[n];
                x.dissipation[n + 1] = factor * product_coefficient(braking_, x.velocity, n);
            }
            x.position[n + 1] = factor * x.velocity[n];
            x.velocity[n + 1] = factor * acceleration;
            x.time[n + 1] = factor * terms_.slope[n];
            terms_.follow(x.position, x.velocity, n);
        }
    }
    /// Radius of convergence.
    [[nodiscard]] Real convergence() const {
        const Real of_motion = std::min(radius(x.position), radius(x.velocity));
        if constexpr (!Terms<Real, Goal>::time_may_converge_least) {
            return of_motion;
        } else {
            // What counts of the time is a part of that which a unit length takes.
            Series<Real, Goal> time = x.time;
            time[0] = 1 / (1 + std::abs(x.velocity[0]));
            return std::min(of_motion, radius(time));
        }
    }
    [[nodiscard]] const Terms<Real, Goal>& terms() const { return terms_; }
    /// delta' eta v
    [[nodiscard]] const Series<Real, Goal>& braking() const { return braking_; }

    MotionExpansion<Real, Goal> x{};

  private:
    Terms<Real, Goal> terms_;
    Series<Real, Goal> braking_;
};

/// Completes the expansion to the rounding of Goal, with the radius of convergence as its step: the leading
/// terms in that number type, the others in double if they are in its range, since that takes a third of the
/// time. @param steps with the terms of the start alone
template <template <class, class> class Terms, class Goal>
void complete_expansion(MotionSteps<Terms, Goal>& steps) {
    constexpr std::size_t order = taylor_order<Goal>;
    std::size_t known = 0;
    if constexpr (!std::is_same_v<Goal, double>) {
        steps.advance(0, leading_terms);
        MotionSteps<Terms, double, Goal> rest(steps);
        rest.advance(leading_terms, order);
        if (fits_double(rest.x.position) && fits_double(rest.x.velocity) && fits_double(rest.x.time)) {
            rest.x.step = rest.convergence();
            append(rest.x, leading_terms + 1, steps.x);
            return;
        }
        known = leading_terms;
    }
    steps.advance(known, order);
    steps.x.step = steps.convergence();
}

}  // namespace ashimpact

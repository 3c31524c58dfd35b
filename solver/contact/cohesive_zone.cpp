// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/cohesive_zone.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace ashimpact {

namespace {

constexpr Extended extended_pi = std::numbers::pi_v<Extended>;
constexpr Extended right_angle = extended_pi / 2;

/// Below this angle P and Q are summed as power series: their closed forms cancel.
constexpr Extended small_angle = 0.5_ext;

/// Sum of alternating terms that fall from the first on: @p next(k) gives the k-th, k = 1, 2, ...; the first
/// that does not count ends it.
template <class Real, class Next>
Real falling_sum(Next&& next) {
    Real sum = 0;
    for (int k = 1; k < 20; ++k) {
        const Real term = next(k);
        sum += term;
        if (std::abs(term) < std::numeric_limits<Real>::epsilon() / 64 * std::abs(sum)) break;
    }
    return sum;
}

/// sin x - x cos x = sum over k >= 1 of (-1)^(k+1) 2k x^(2k+1)/(2k+1)!
/// @param sine, cosine of x
template <class Real>
Real sine_excess(Real x, Real sine, Real cosine) {
    if (x > 2 * static_cast<Real>(small_angle)) return sine - x * cosine;
    Real power = x;  // (-1)^(k+1) x^(2k+1)/(2k+1)!
    return falling_sum<Real>([&](int k) {
        power *= static_cast<Real>(k == 1 ? 1 : -1) * x * x / static_cast<Real>(2 * k * (2 * k + 1));
        return static_cast<Real>(2 * k) * power;
    });
}

/// x sin x + cos x - 1 = sum over k >= 1 of (-1)^(k+1) (2k-1) x^(2k)/(2k)!
/// @param sine, cosine of x
template <class Real>
Real versine_excess(Real x, Real sine, Real cosine) {
    if (x > static_cast<Real>(small_angle)) return x * sine + cosine - 1;
    Real power = 1;  // (-1)^(k+1) x^(2k)/(2k)!
    return falling_sum<Real>([&](int k) {
        power *= static_cast<Real>(k == 1 ? 1 : -1) * x * x / static_cast<Real>((2 * k - 1) * 2 * k);
        return static_cast<Real>(2 * k - 1) * power;
    });
}

/// An angle theta with its sine and cosine.
template <class Real>
struct Angle {
    Real angle;
    Real sine;
    Real cosine;
};

/// P of the class's comment.
template <class Real>
Real quadratic_of(Real lambda, const Angle<Real>& at) {
    const Real cosine_of_double = (at.cosine - at.sine) * (at.cosine + at.sine);
    return lambda / 4 * sine_excess(2 * at.angle, 2 * at.sine * at.cosine, cosine_of_double);
}

/// Q of the class's comment.
template <class Real>
Real linear_of(Real lambda, const Angle<Real>& at) {
    return 4 * lambda * lambda / 3 * versine_excess(at.angle, at.sine, at.cosine);
}

/// A step of Newton for ln(P c^2 + Q c) = 0 with c = a/cos(theta) in ln(tan theta), nearly a straight line,
/// at tan(theta) = @p t.
template <class Real>
Real step_to_radius(Real lambda, Real a, Real t) {
    const Real cosine_squared = 1 / (1 + t * t);
    const Real cosine = std::sqrt(cosine_squared);
    const Real sine = t * cosine;
    const Real theta = std::atan(t);
    const Real c = a / cosine;
    const Real p = quadratic_of<Real>(lambda, {theta, sine, cosine});
    const Real q = linear_of<Real>(lambda, {theta, sine, cosine});
    const Real sum = (p * c + q) * c;
    const Real rise =
        theta * cosine * (2 * lambda * sine * c + 4 * lambda * lambda / 3) * c + (2 * p * c + q) * c * t;
    const Real off = sum - 1;
    const Real log = std::abs(off) < Real(1e-6) ? off - off * off / 2 : std::log(sum);
    return -log * sum / (rise * t * cosine_squared);
}

/// Steps from @p t on until one leaves no more than the rounding of Real.
template <class Real>
Real tangent_at_radius(Real lambda, Real a, Real t) {
    const Real enough = Real(0.1) * std::sqrt(std::numeric_limits<Real>::epsilon());  // leaves its square
    for (int i = 0; i < 60; ++i) {
        const Real step = step_to_radius(lambda, a, t);
        if (std::abs(step) < enough) return t * (1 + step);
        t *= std::exp(std::fmax(Real(-2), std::fmin(Real(2), step)));
    }
    return t;
}

}  // namespace

CohesiveZone::CohesiveZone(Extended lambda) : lambda_(lambda) {
    join_ = at_angle(right_angle);
    const auto stable = [&](Extended theta) { return slopes(at_angle(theta)).overlap; };
    const Extended gap_fold = 8 * lambda_ / (3 * extended_pi);
    pull_off_ = stable(right_angle) < 0 ? contact_where(stable, right_angle) : in_gap(gap_fold);
    const Extended edge = pull_off_.touching() ? pull_off_.angle : right_angle;
    touch_ = 2 * gap_fold <= join_.cohesive_radius
                 ? in_gap(2 * gap_fold)
                 : contact_where([&](Extended theta) { return overlap(at_angle(theta)) + reach(); }, edge);
    greatest_tension_ = contact_where([&](Extended theta) { return slopes(at_angle(theta)).force; }, edge);
    equilibrium_ = contact_where([&](Extended theta) { return force(at_angle(theta)); }, edge);
}

Extended CohesiveZone::reach() const {
    return 2 / (extended_pi * lambda_);
}

Extended CohesiveZone::quadratic(const CohesiveState& state) const {
    return quadratic_of<Extended>(lambda_, {state.angle, state.sine, state.cosine});
}

Extended CohesiveZone::linear(const CohesiveState& state) const {
    return linear_of<Extended>(lambda_, {state.angle, state.sine, state.cosine});
}

CohesiveState CohesiveZone::at_angle(Extended theta) const {
    CohesiveState state{
        .angle = theta, .sine = std::sin(theta), .cosine = std::sin(right_angle - theta)};  // 0 at pi/2
    const Extended p = quadratic(state);
    const Extended q = linear(state);
    state.cohesive_radius = 2 / (q + std::sqrt(q * q + 4 * p));
    return state;
}

CohesiveState CohesiveZone::in_gap(Extended c) {
    return {.angle = right_angle, .sine = 1, .cosine = 0, .cohesive_radius = c};
}

CohesiveState CohesiveZone::at_contact_radius(Extended a) const {
    if (a <= 0) return join_;
    // The last state of each thread is kept: overlap, force and potential of one place follow one another.
    struct Known {
        Extended lambda = 0;
        Extended radius = 0;
        CohesiveState state{};
    };
    thread_local Known last;
    if (last.lambda == lambda_ && last.radius == a) return last.state;
    const Extended guess =
        1 / (std::cbrt(lambda_ * a * a / 1.5_ext) + std::sqrt(lambda_ * lambda_ * a / 1.5_ext));
    // Most of the way in double, which is several times as fast.
    const double near =
        tangent_at_radius(static_cast<double>(lambda_), static_cast<double>(a), static_cast<double>(guess));
    const bool known = std::isnormal(near) && near > 0;
    const Extended t = tangent_at_radius<Extended>(lambda_, a, known ? static_cast<Extended>(near) : guess);
    const Extended secant = std::sqrt(1 + t * t);
    last = {lambda_,
            a,
            {.angle = std::atan(t), .sine = t / secant, .cosine = 1 / secant, .cohesive_radius = a * secant}};
    return last.state;
}

CohesiveState CohesiveZone::at_overlap(Extended delta) const {
    if (delta <= overlap(pull_off_)) return pull_off_;
    if (delta < overlap(join_) && !pull_off_.touching()) {
        const Extended fold = 8 * lambda_ / (3 * extended_pi);
        return in_gap(fold + std::sqrt(fold * fold + 2 * (delta + reach())));
    }
    const Extended edge = pull_off_.touching() ? pull_off_.angle : right_angle;
    return contact_where([&](Extended theta) { return overlap(at_angle(theta)) - delta; }, edge);
}

Extended CohesiveZone::overlap(const CohesiveState& state) const {
    const Extended c = state.cohesive_radius;
    if (state.angle >= right_angle && c < join_.cohesive_radius) return gap_overlap()(c);
    const Extended a = state.contact_radius();
    return a * a - 4 * lambda_ / 3 * c * state.sine;
}

Extended CohesiveZone::force(const CohesiveState& state) const {
    const Extended c = state.cohesive_radius;
    const Extended a = state.contact_radius();
    return a * a * a - lambda_ * c * (c * state.angle + a * state.sine);
}

Extended CohesiveZone::potential(const CohesiveState& state) const {
    const Extended c = state.cohesive_radius;
    const Extended a = state.contact_radius();
    if (state.angle >= right_angle && c < join_.cohesive_radius)
        return lambda_ * c * c * c * (4 * lambda_ / 9 - extended_pi / 8 * c);
    const Extended sine_of_double = 2 * state.sine * state.cosine;
    const Extended cosine_of_double = (state.cosine - state.sine) * (state.cosine + state.sine);
    const Extended moment = state.angle / 12 + sine_of_double / 18 + sine_of_double * cosine_of_double / 72;
    return force(state) * overlap(state) / 3 + a * a * a * a * a / 15 - c * c / 3 -
           lambda_ * c * c * c * c * moment;
}

CohesiveZone::Slopes CohesiveZone::slopes(const CohesiveState& state) const {
    const auto& [theta, sine, cosine, c] = state;
    const Extended m = theta * (2 * lambda_ * sine * c + 4 * lambda_ * lambda_ / 3) * c /
                       (2 * quadratic(state) * c + linear(state));
    const Extended radius = cosine * cosine * m + c * sine;
    return {
        .radius = radius,
        .cohesive_radius = m,
        .overlap = 2 * c * radius + 4 * lambda_ / 3 * (c - m * sine),
        .force = 3 * c * c * cosine * radius - 2 * lambda_ * c * (m * (theta + sine * cosine) - c * cosine)};
}

Extended CohesiveZone::stiffness(const CohesiveState& state) const {
    const Extended c = state.cohesive_radius;
    if (state.angle >= right_angle && c < join_.cohesive_radius)
        return -extended_pi * lambda_ * c / (c - 8 * lambda_ / (3 * extended_pi));
    const Slopes slope = slopes(state);
    return slope.force / slope.overlap;
}

Polynomial<Extended> CohesiveZone::gap_overlap() const {
    const auto c = Polynomial<Extended>::identity();
    return 0.5_ext * (c * c) - (8 * lambda_ / (3 * extended_pi)) * c - Polynomial<Extended>(reach());
}

Polynomial<Extended> CohesiveZone::gap_force() const {
    const auto c = Polynomial<Extended>::identity();
    return -(extended_pi / 2 * lambda_) * (c * c);
}

Extended CohesiveZone::separation_energy() const {
    return potential(pull_off_) - potential(touch_);
}

template <class Function>
CohesiveState CohesiveZone::contact_where(Function&& function, Extended from) const {
    // The function is positive far inside, where the angle is small.
    Extended theta = from;
    while (function(theta) < 0) theta /= 2;
    if (theta == from) return at_angle(from);
    return at_angle(theta + sign_change<Extended>([&](Extended x) { return function(theta + x); }, theta));
}

}  // namespace ashimpact

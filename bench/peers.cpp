// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/peers.hpp"

#include <array>
#include <cmath>

#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include "solver/contact/dmt.hpp"
#include "solver/contact/registry.hpp"
#include "solver/motion/scale.hpp"
#include "tests/support/ode.hpp"

namespace ashimpact::bench {

namespace {

constexpr double hertz_contact_time = 3.21806546;  // undamped, in time scales

constexpr double captured = 0.0;      ///< the result of a method that loses too much energy
constexpr double least_step = 1e-13;  ///< in overlap, with which it would come to rest before the end

using State = std::array<double, 2>;  // overlap and velocity

/// Scaled DMT with constant damping.
struct Contact {
    double adhesion;
    double damping;

    explicit Contact(const Impact& impact) {
        const Scale scale = Scale::of(impact.contact, impact.velocity);
        adhesion = Dmt<double>::adhesion_number(impact.contact, scale.length);
        damping = scale.damping_number(impact.damping);
    }
    [[nodiscard]] double acceleration(double overlap, double velocity) const {
        const double repulsion = overlap > 0.0 ? overlap * std::sqrt(overlap) : 0.0;
        return adhesion - repulsion - damping * velocity;
    }
    [[nodiscard]] State in_time(const State& x) const { return {x[1], acceleration(x[0], x[1])}; }
    /// Overlap as the clock: d(velocity)/d(overlap), d(overlap)/d(overlap).
    [[nodiscard]] State in_overlap(double overlap, const State& x) const {
        return {1.0, acceleration(overlap, x[1]) / x[1]};
    }
};

/// Boost.odeint with an error-controlled stepper.
template <class ErrorStepper>
double odeint_restitution(const Impact& impact, double tolerance) {
    namespace odeint = boost::numeric::odeint;
    const Contact contact(impact);
    const auto in_time = [&](const State& x, State& slope, double) { slope = contact.in_time(x); };
    const auto in_overlap = [&](const State& x, State& slope, double overlap) {
        slope = contact.in_overlap(overlap, x);
    };
    auto stepper = odeint::make_controlled<ErrorStepper>(tolerance, tolerance);
    State state{0.0, 1.0};
    double time = 0.0;
    double step = 0.05;
    while (true) {
        State next = state;
        double next_time = time;
        while (stepper.try_step(in_time, next, next_time, step) != odeint::success) {
        }
        if (next[0] <= 0.0 && state[1] < 0.0) break;
        if (next[0] <= 0.0) {  // over turn and end at once
            step = 0.5 * (next_time - time);
            continue;
        }
        if (state[1] < 0.0 && next[1] > 0.0) return captured;
        state = next;
        time = next_time;
    }
    auto last = odeint::make_controlled<ErrorStepper>(tolerance, tolerance);
    double overlap = state[0];
    step = -overlap;
    while (overlap > 0.0) {
        step = std::max(step, -overlap);
        static_cast<void>(last.try_step(in_overlap, state, overlap, step));
        if (std::abs(step) < least_step && overlap > least_step) return captured;
    }
    return -state[1];
}

}  // namespace

double gsl_rk8pd(const Impact& impact) {
    constexpr double tolerance = 1e-10;
    const Contact contact(impact);
    const auto in_time = [&](double, const State& x) { return contact.in_time(x); };
    const auto in_overlap = [&](double overlap, const State& x) { return contact.in_overlap(overlap, x); };
    test::Ode<2, decltype(in_time)> inward(in_time, {tolerance, {tolerance, tolerance}});
    State state{0.0, 1.0};
    double time = 0.0;
    double step = 0.05;
    while (true) {
        State next = state;
        double next_time = time;
        inward.step(next_time, 1e9, step, next);
        if (next[0] <= 0.0 && state[1] < 0.0) break;
        if (next[0] <= 0.0) {  // over turn and end at once
            step = 0.5 * (next_time - time);
            inward.restart();
            continue;
        }
        if (state[1] < 0.0 && next[1] > 0.0) return captured;
        state = next;
        time = next_time;
    }
    test::Ode<2, decltype(in_overlap)> last(in_overlap, {tolerance, {tolerance, tolerance}});
    last.integrate(state[0], 0.0, state);
    return -state[1];
}

double odeint_fehlberg78(const Impact& impact) {
    return odeint_restitution<boost::numeric::odeint::runge_kutta_fehlberg78<State>>(impact, 1e-7);
}

double odeint_dopri5(const Impact& impact) {
    return odeint_restitution<boost::numeric::odeint::runge_kutta_dopri5<State>>(impact, 1e-7);
}

double velocity_verlet(const Impact& impact) {
    const Contact contact(impact);
    constexpr double step = hertz_contact_time / 200.0;
    double overlap = 0.0;
    double velocity = 1.0;
    double acceleration = contact.acceleration(overlap, velocity);
    while (true) {
        const double half = velocity + 0.5 * step * acceleration;
        const double next = overlap + step * half;
        acceleration = contact.acceleration(next, half);
        const double next_velocity = half + 0.5 * step * acceleration;
        if (next <= 0.0) return -(velocity + (next_velocity - velocity) * overlap / (overlap - next));
        if (velocity < 0.0 && next_velocity > 0.0) return captured;
        overlap = next;
        velocity = next_velocity;
    }
}

}  // namespace ashimpact::bench

#include "solver/critical_velocity.hpp"

#include "materials/error.hpp"
#include "solver/orbit.hpp"
#include "solver/scaled_impact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ashimpact {

namespace {

/// Beyond this coordinate, in units of the equilibrium or of the damping length, a backward orbit has
/// escaped: no velocity is high enough to rebound.
constexpr Extended escape = 1e25L;

/// Where the critical orbit is followed backward from.
struct Arrival {
    MotionState<Extended> state;
    Extended dissipated_after = 0;  ///< work of damping from that state to the end
};

/// Work of damping over the last stretch [0, x] before the end at speed sqrt(2 (U_end - U)): three-point
/// Gauss in x^(1/2), in which the integrand of every law is smooth.
Extended last_dissipation(const Polynomial<Extended>& fall, const Polynomial<Extended>& drag, Extended x) {
    constexpr std::array<Extended, 3> node{0.112701665379258311482L, 0.5L, 0.887298334620741688518L};
    constexpr std::array<Extended, 3> weight{5.0L / 18, 8.0L / 18, 5.0L / 18};
    Extended sum = 0;
    for (std::size_t i = 0; i < node.size(); ++i) {
        const Extended at = x * node[i] * node[i];
        sum += weight[i] * 2 * node[i] * x * drag(at) * std::sqrt(std::max(0.0L, 2 * fall(at)));
    }
    return sum;
}

/// The end of contact is a rest point of the regularised motion: the critical orbit leaves it backward along
/// v^2/2 = U_end - U(q) + (work of damping up to the end), so near it that damping hardly matters.
Arrival at_rest_point(const Motion<Extended>& motion) {
    const Extended end = *motion.end;
    const Polynomial<Extended> rise = motion.potential.shifted(end);
    const Polynomial<Extended> drag = motion.drag.shifted(end);
    Polynomial<Extended> fall = Extended(-1) * rise;
    fall[0] = 0;  // U_end - U at the end itself
    fall[1] = 0;  // delta' = 0 there
    Extended x = 1e-4L * (motion.equilibrium - end);
    Extended dissipated = last_dissipation(fall, drag, x);
    while (dissipated > 1e-4L * fall(x)) {
        x /= 8;
        dissipated = last_dissipation(fall, drag, x);
    }
    Arrival arrival;
    arrival.state.position = end + x;
    arrival.state.velocity = -std::sqrt(2 * (fall(x) + dissipated));
    arrival.dissipated_after = dissipated;
    return arrival;
}

/// Hertz with constant damping beta: the critical orbit arrives along v = -beta delta + (2/(3 beta))
/// delta^(3/2).
Arrival at_damped_end(const Motion<Extended>& motion, Extended beta) {
    const Extended delta = 1e-12L * std::pow(beta, 4.0L);
    Arrival arrival;
    arrival.state.position = motion.squared ? std::sqrt(delta) : std::sqrt(std::sqrt(delta));
    arrival.state.velocity = -beta * delta + 2 / (3 * beta) * delta * std::sqrt(delta);
    arrival.dissipated_after = beta * beta * delta * delta / 2;
    return arrival;
}

struct BackwardOrbit {
    bool escaped = false;
    MotionState<Extended> turn;
    MotionState<Extended> touch;
    int steps = 0;
};

/// Follows the motion backward in time from @p state, outward leg first, until it touches or escapes.
BackwardOrbit follow_back(const Motion<Extended>& motion, MotionState<Extended> state, Extended unit) {
    const MotionStepper<Extended> stepper(motion);
    BackwardOrbit orbit;
    bool approaching = false;
    while (true) {
        if (++orbit.steps > most_steps) throw ConvergenceError("critical velocity: step limit reached");
        MotionExpansion<Extended> x = stepper.expand(state);
        x.step = -x.step;
        const auto turn = [](const MotionState<Extended>& s) { return -s.velocity; };
        const auto touch = [&](const MotionState<Extended>& s) { return s.position - motion.touch; };
        if (const auto h = approaching ? event_within(x, x.step, touch) : event_within(x, x.step, turn)) {
            state = x.at(*h);
            (approaching ? orbit.touch : orbit.turn) = state;
            if (approaching) return orbit;
            approaching = true;
            state.velocity = 0;
            continue;
        }
        state = x.at(x.step);
        if (state.position > escape * unit) {
            orbit.escaped = true;
            return orbit;
        }
    }
}

/// A velocity of the order of the answer, so that scaled numbers stay near one [m/s].
double velocity_unit(const CriticalVelocityProblem& problem) {
    const Scale unit = Scale::of(problem.contact, 1.0);
    double velocity = 0.0;
    const double beta = unit.damping_number(problem.damping);
    if (problem.damping.law == DampingLaw::constant) velocity = std::pow(beta, 5);
    const double adhesion = problem.law.visit<double>(
        [&]<template <class> class L>() { return L<double>::adhesion_number(problem.contact, 1.0); });
    if (adhesion > 0.0) {
        // Each law's adhesion number falls with a power of length; find the length at which it is one.
        const double at_half = problem.law.visit<double>(
            [&]<template <class> class L>() { return L<double>::adhesion_number(problem.contact, 0.5); });
        const double exponent = std::log2(at_half / adhesion);
        const double length = std::pow(adhesion, 1.0 / exponent);
        velocity = std::max(velocity, std::sqrt(unit.stiffness * std::pow(length, 2.5) / unit.mass));
    }
    return velocity;
}

CriticalVelocity verdict_only(CaptureVerdict verdict) {
    return {.verdict = verdict};
}

}  // namespace

std::string_view name_of(CaptureVerdict verdict) {
    switch (verdict) {
        case CaptureVerdict::finite:
            return "finite";
        case CaptureVerdict::always_captured:
            return "always-captured";
        case CaptureVerdict::never_captured:
            return "never-captured";
    }
    return {};
}

CriticalVelocity critical_velocity(const CriticalVelocityProblem& problem) {
    validate(Impact{problem.law, problem.detachment, problem.damping, problem.contact, 1.0});
    const bool tsuji_overdamped = problem.damping.law == DampingLaw::tsuji &&
                                  problem.damping.coefficient * problem.damping.coefficient >= 5.0;
    const double unit = velocity_unit(problem);
    const bool adhesive =
        unit > 0.0 && problem.contact.work_of_adhesion > 0.0 && problem.law != Law::of<Hertz>();
    const bool constant = problem.damping.law == DampingLaw::constant && problem.damping.coefficient > 0.0;
    if (problem.detachment == Detachment::zero_force) return verdict_only(CaptureVerdict::never_captured);
    if (!adhesive && tsuji_overdamped) return verdict_only(CaptureVerdict::always_captured);
    if (!adhesive && !constant) return verdict_only(CaptureVerdict::never_captured);

    const Scale scale = Scale::of(problem.contact, unit);
    const Impact impact{problem.law, problem.detachment, problem.damping, problem.contact, unit};
    const Motion<Extended> motion = scaled_motion<Extended>(impact, scale);
    const Extended released = motion.potential(*motion.end) - motion.potential(motion.touch);
    const bool rest_point = std::abs(motion.slope(*motion.end)) < 1e-12L;
    if (adhesive && rest_point && problem.damping.coefficient == 0.0 && released <= 0.0L) {
        return verdict_only(CaptureVerdict::never_captured);
    }
    Arrival arrival{.state = {.position = *motion.end}};
    if (!adhesive) {
        arrival = at_damped_end(motion, scale.damping_number(problem.damping));
    } else if (rest_point) {
        arrival = at_rest_point(motion);
    }
    const BackwardOrbit orbit = follow_back(
        motion, arrival.state, std::max(1.0L, std::max(motion.equilibrium, arrival.state.position)));
    if (orbit.escaped) return verdict_only(CaptureVerdict::always_captured);

    const Extended dissipated = arrival.dissipated_after - orbit.touch.dissipation;
    const Extended value = std::sqrt(2 * (dissipated + released));
    CriticalVelocity result{.verdict = CaptureVerdict::finite};
    if (value == 0) return verdict_only(CaptureVerdict::never_captured);
    result.value = static_cast<double>(value) * unit;
    if (!rest_point) result.contact_time = static_cast<double>(-orbit.touch.time) * scale.time();
    result.maximum_overlap = static_cast<double>(motion.overlap(orbit.turn.position)) * scale.length;
    result.dissipated = static_cast<double>(dissipated) * scale.energy();
    result.detachment_energy = static_cast<double>(released) * scale.energy();
    result.steps = orbit.steps;
    return result;
}

}  // namespace ashimpact

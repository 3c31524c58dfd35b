#include "solver/critical_velocity.hpp"

#include "materials/error.hpp"
#include "solver/adhesion_velocity.hpp"
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

/// The part of a backward step before the velocity changes sign; the whole step if it does not.
Extended same_direction(const MotionExpansion<Extended>& x, bool approaching) {
    const auto speed = [&](const MotionState<Extended>& s) { return approaching ? s.velocity : -s.velocity; };
    return event_within(x, x.step, speed).value_or(x.step);
}

/// Follows the motion backward in time from @p state, outward leg first, until it touches or escapes.
BackwardOrbit follow_back(const Motion<Extended>& motion, MotionState<Extended> state, Extended unit) {
    const MotionStepper<Extended> stepper(motion);
    const auto touch = [&](const MotionState<Extended>& s) { return s.position - motion.touch; };
    BackwardOrbit orbit;
    bool approaching = false;
    while (true) {
        if (++orbit.steps > most_steps) throw ConvergenceError("critical velocity: step limit reached");
        MotionExpansion<Extended> x = stepper.expand(state);
        x.step = -x.step;
        const Extended part = same_direction(x, approaching);
        const auto touching = approaching ? event_within(x, part, touch) : std::nullopt;
        state = x.at(touching.value_or(part));
        if (touching ||
            (approaching && part != x.step)) {  // the energy suffices: rest before touch is rounding
            orbit.touch = state;
            return orbit;
        }
        if (part != x.step) {
            approaching = true;
            state.velocity = 0;
            orbit.turn = state;
        }
        if (state.position > escape * unit) {
            orbit.escaped = true;
            return orbit;
        }
    }
}

/// Velocity at which constant damping is of order one, beta = 1; 0 without it [m/s].
double velocity_of_damping(const CriticalVelocityProblem& problem) {
    if (problem.damping.law != DampingLaw::constant) return 0.0;
    return std::pow(Scale::of(problem.contact, 1.0).damping_number(problem.damping), 5);
}

bool is_rest_point(const Motion<Extended>& motion) {
    return std::abs(motion.slope(*motion.end)) < 1e-12L;
}

/// Verdict known beforehand, or none where the critical orbit has to be followed.
std::optional<CaptureVerdict> known_verdict(const CriticalVelocityProblem& problem, bool adhesive,
                                            bool breaking_costs) {
    const Damping& damping = problem.damping;
    if (problem.detachment == Detachment::zero_force) return CaptureVerdict::never_captured;
    if (damping.coefficient == 0.0 && !breaking_costs) return CaptureVerdict::never_captured;
    if (adhesive) return std::nullopt;
    if (damping.law == DampingLaw::constant) return std::nullopt;
    const bool overdamped =
        damping.law == DampingLaw::tsuji && damping.coefficient * damping.coefficient >= 5.0;
    return overdamped ? CaptureVerdict::always_captured : CaptureVerdict::never_captured;
}

Arrival arrival_at_end(const Motion<Extended>& motion, const Scale& scale, const Damping& damping,
                       bool adhesive) {
    if (!adhesive) return at_damped_end(motion, scale.damping_number(damping));
    if (is_rest_point(motion)) return at_rest_point(motion);
    return {.state = {.position = *motion.end}};
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
    const double of_adhesion = adhesion_velocity(problem.law, problem.contact);
    const bool adhesive = of_adhesion > 0.0;
    const double unit =
        std::max({of_adhesion, velocity_of_damping(problem), std::numeric_limits<double>::min()});
    const Scale scale = Scale::of(problem.contact, unit);
    const Motion<Extended> motion = scaled_motion<Extended>(
        {problem.law, problem.detachment, problem.damping, problem.contact, unit}, scale);
    const Extended released =
        motion.end ? motion.potential(*motion.end) - motion.potential(motion.touch) : Extended(0);
    if (const auto verdict = known_verdict(problem, adhesive, released > 0)) return {.verdict = *verdict};

    const Arrival arrival = arrival_at_end(motion, scale, problem.damping, adhesive);
    const BackwardOrbit orbit =
        follow_back(motion, arrival.state, std::max({1.0L, motion.equilibrium, arrival.state.position}));
    if (orbit.escaped) return {.verdict = CaptureVerdict::always_captured};

    const Extended dissipated = arrival.dissipated_after - orbit.touch.dissipation;
    CriticalVelocity result;
    result.value = static_cast<double>(std::sqrt(2 * (dissipated + released))) * unit;
    if (adhesive && !is_rest_point(motion)) {
        result.contact_time = static_cast<double>(-orbit.touch.time) * scale.time();
    }
    result.maximum_overlap = static_cast<double>(motion.overlap(orbit.turn.position)) * scale.length;
    result.dissipated = static_cast<double>(dissipated) * scale.energy();
    result.detachment_energy = static_cast<double>(released) * scale.energy();
    result.steps = orbit.steps;
    return result;
}

}  // namespace ashimpact

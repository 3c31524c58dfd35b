// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/motion/explicit_scheme.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "solver/contact/registry.hpp"
#include "solver/motion/impact_result.hpp"
#include "solver/motion/scale.hpp"
#include "solver/motion/scaled_impact.hpp"

namespace ashimpact {

bool has_explicit_scheme(Law law) {
    return law.visit<bool>([]<template <class> class L>() {
        if constexpr (has_polynomials<L>) return L<double>{1.0}.touch() == 0.0;
        return false;
    });
}

namespace {

/// Longest step that the scheme takes, in units of the undamped Hertz contact: beyond it nothing is resolved.
constexpr double longest_step = 0.1;

/// Steps of suggested length in m/eta, the time in which damping alone takes 1/e of the velocity.
constexpr double steps_per_damping_time = 100;

/// Beyond m/eta the damping term of the scheme alone would turn the motion round.
double longest_time_step(const Impact& impact) {
    const Scale scale = Scale::of(impact.contact, impact.velocity);
    const double damping = scale.damping_number(impact.damping);
    return std::min(longest_step * hertz_contact_time(impact.contact, impact.velocity),
                    scale.time() / damping);
}

void require_treatable(const Impact& impact, const ExplicitSchemeOptions& options) {
    validate(impact);
    const auto require = [](bool holds, const std::string& problem, const std::string& allowed) {
        if (!holds) throw InputError(problem, allowed);
    };
    require(has_explicit_scheme(impact.law),
            "the paper's explicit scheme cannot treat law '" + std::string(impact.law.name()) +
                "': its force is not a function of overlap",
            law_names(has_explicit_scheme));
    require(impact.detachment == Detachment::zero_overlap,
            "the paper's explicit scheme ends contact at zero overlap", "zero-overlap");
    require(impact.damping.law == DampingLaw::constant, "the paper's explicit scheme has constant damping",
            "constant");
    const std::string step = "time_step is " + shortest(options.time_step) + " s";
    require(options.time_step > 0.0 && std::isfinite(options.time_step), step, "a finite number > 0 s");
    const double longest = longest_time_step(impact);
    require(options.time_step <= longest, step + ", too long for this impact",
            "up to " + shortest(longest) + " s");
}

/// The recurrence of Eq. 31, scaled; remembers the three latest overlaps.
struct Recurrence {
    const Motion<double>& motion;
    double step;
    double earlier = -step;  // free flight before first touch
    double before = 0.0;
    double now = step;
    double dissipated = 0.0;  ///< before the last step

    [[nodiscard]] double coordinate(double overlap) const {
        const double root = std::sqrt(overlap);  // u^2 of the laws with overlap u^4
        return motion.squared ? root : std::sqrt(root);
    }
    [[nodiscard]] double velocity() const { return (now - before) / step; }  ///< half a step ago
    [[nodiscard]] MotionState<double> state() const {
        return {.position = coordinate(now), .velocity = velocity()};
    }
    /// Work of damping over the last step.
    [[nodiscard]] double step_work() const { return motion.damping(0) * velocity() * velocity() * step; }
    /// At rest in equilibrium, where a creeping approach ends: damping has taken all that is above it.
    [[nodiscard]] MotionState<double> at_rest() const {
        const double above = motion.potential(coordinate(now)) - motion.potential(motion.equilibrium);
        return {.position = motion.equilibrium,
                .dissipation = dissipated + step_work() + velocity() * velocity() / 2.0 + above};
    }
    /// Part of the last step at which the overlap fell through zero, by linear interpolation.
    [[nodiscard]] double crossing() const { return before / (before - now); }
    /// The state there, its velocity from those half a step and one and a half steps ago.
    [[nodiscard]] MotionState<double> at_crossing() const {
        const double previous = (before - earlier) / step;
        const double crossing_velocity = velocity() + (velocity() - previous) * (crossing() - 0.5);
        return {.velocity = std::min(0.0, crossing_velocity),
                .dissipation = dissipated + crossing() * step_work()};
    }
    void advance() {
        const double next = 2.0 * now - before -
                            step * step * (motion.damping(0) * velocity() + motion.force(coordinate(now)));
        dissipated += step_work();
        earlier = before;
        before = now;
        now = next;
    }
};

}  // namespace

double explicit_time_step(const Impact& impact, double steps) {
    const Scale scale = Scale::of(impact.contact, impact.velocity);
    const double damping = scale.damping_number(impact.damping);
    return std::min(hertz_contact_time(impact.contact, impact.velocity) / steps,
                    scale.time() / (steps_per_damping_time * damping));
}

ImpactResult solve_impact_explicit(const Impact& impact, const ExplicitSchemeOptions& options) {
    require_treatable(impact, options);
    const Scale scale = Scale::of(impact.contact, impact.velocity);
    const Motion<double> motion = scaled_motion<double>(impact, scale);
    const CaptureTest<double> capture(motion);
    Recurrence r{.motion = motion, .step = options.time_step / scale.time()};
    Orbit<double> orbit;
    orbit.rest_potential = motion.potential(motion.equilibrium);
    long count = 1;
    long turned_at = 0;
    bool captured = false;
    while (r.now > 0.0 && !captured) {
        if (++count > options.most_steps) throw ConvergenceError("explicit scheme: step limit reached");
        r.advance();
        const bool rises = r.now >= r.before;
        if (!orbit.turned && !rises) {
            orbit.turned = true;
            turned_at = count - 1;
            orbit.turn = {.position = r.coordinate(r.before), .dissipation = r.dissipated};
            orbit.maximum_overlap = r.before;
        } else if (orbit.turned && rises) {
            captured = true;  // a second turning point, still in contact
        }
        if (r.now <= 0.0 || captured) continue;
        captured = orbit.turned ? capture.creeping(r.state()) : capture.creeping_up(r.state());
    }
    if (!orbit.turned) {
        orbit.turn = r.at_rest();
        orbit.maximum_overlap = motion.overlap(motion.equilibrium);
    }
    if (!captured) {
        orbit.outcome = Outcome::rebound;
        orbit.end = r.at_crossing();
    }
    orbit.last_potential = motion.potential(orbit.last().position);
    orbit.steps = static_cast<int>(count);
    ImpactResult result = impact_result(orbit, 1.0, scale, impact.velocity);
    result.restitution = static_cast<double>(orbit.restitution(1.0));  // a coarse step may gain energy
    result.rebound_velocity = result.restitution * impact.velocity;
    if (!captured) result.contact_time = (static_cast<double>(count - 1) + r.crossing()) * options.time_step;
    if (orbit.turned) result.approach_time = static_cast<double>(turned_at) * options.time_step;
    return result;
}

/// The number near @p start above which a statement holds, to rounding; it fails below.
/// @throws ConvergenceError if it holds, or fails, from @p start/26,000 to 26,000 @p start
template <class Statement>
static double least_that(Statement&& holds, double start) {
    double low = start;
    double high = start;
    double factor = 1.01;
    for (int i = 0; i < 10 && holds(low); ++i, factor *= factor) high = std::exchange(low, low / factor);
    for (int i = 0; i < 10 && !holds(high); ++i, factor *= factor) low = std::exchange(high, high * factor);
    if (holds(low) || !holds(high)) throw ConvergenceError("the explicit scheme has no such impact");
    while (high - low > 4 * std::numeric_limits<double>::epsilon() * high) {
        const double middle = (low + high) / 2;
        (holds(middle) ? high : low) = middle;
    }
    return high;
}

double explicit_critical_velocity(const Impact& near, const ExplicitSchemeOptions& options) {
    Impact impact = near;
    return least_that(
        [&](double velocity) {
            impact.velocity = velocity;
            return solve_impact_explicit(impact, options).outcome == Outcome::rebound;
        },
        near.velocity);
}

double explicit_damping(const Impact& near, double restitution, const ExplicitSchemeOptions& options) {
    Impact impact = near;
    return least_that(
        [&](double coefficient) {
            impact.damping.coefficient = coefficient;
            const ImpactResult result = solve_impact_explicit(impact, options);
            return result.outcome == Outcome::capture || result.restitution < restitution;
        },
        near.damping.coefficient);
}

}  // namespace ashimpact

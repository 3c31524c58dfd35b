// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/motion/explicit_scheme.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"
#include "core/text.hpp"
#include "solver/contact/registry.hpp"
#include "solver/motion/hertz_contact.hpp"
#include "solver/motion/orbit.hpp"
#include "solver/motion/scaled_impact.hpp"

namespace ashimpact {

namespace {

/// Longest step that the scheme takes, in units of the undamped Hertz contact: beyond it nothing is resolved.
constexpr double longest_step = 0.1;

/// Steps of suggested length in m/eta, the time in which damping alone takes 1/e of the velocity.
constexpr double steps_per_damping_time = 100;

/// The scheme needs the force as a function of overlap, from no contact radius at first touch on.
bool is_treatable(Law law) {
    return law.visit<bool>([]<template <class> class L>() {
        if constexpr (has_polynomials<L>) return L<double>{1.0}.touch() == 0.0;
        return false;
    });
}

std::string treatable_laws() {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < Law::count(); ++i)
        if (is_treatable(Law::at(i))) names.emplace_back(Law::at(i).name());
    return joined(names);
}

/// Beyond m/eta the damping term of the scheme alone would turn the motion round.
double longest_time_step(const Impact& impact) {
    const Scale scale = Scale::of(impact.contact, impact.velocity);
    const double damping = scale.damping_number(impact.damping);
    return std::min(longest_step * hertz_contact_time(impact.contact, impact.velocity),
                    scale.time() / damping);
}

void require_treatable(const Impact& impact, const ExplicitSchemeOptions& options) {
    validate(impact);
    if (!is_treatable(impact.law)) {
        throw InputError("the paper's explicit scheme cannot treat law '" + std::string(impact.law.name()) +
                             "': its force is not a function of overlap",
                         treatable_laws());
    }
    if (impact.detachment != Detachment::zero_overlap) {
        throw InputError("the paper's explicit scheme ends contact at zero overlap", "zero-overlap");
    }
    if (impact.damping.law != DampingLaw::constant) {
        throw InputError("the paper's explicit scheme has constant damping", "constant");
    }
    if (!(options.time_step > 0.0) || !std::isfinite(options.time_step)) {
        throw InputError("time_step is " + shortest(options.time_step) + " s", "a finite number > 0 s");
    }
    const double longest = longest_time_step(impact);
    if (options.time_step > longest) {
        throw InputError("time_step is " + shortest(options.time_step) + " s, too long for this impact",
                         "up to " + shortest(longest) + " s");
    }
}

/// Where the ledger ends: detachment, or for a capture the greatest overlap or the rest it creeps to.
struct LedgerEnd {
    double overlap = 0.0;
    double speed = 0.0;
    double dissipated = 0.0;
};

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
    /// Part of the last step at which the overlap fell through zero, by linear interpolation.
    [[nodiscard]] double crossing() const { return before / (before - now); }
    /// Velocity at the crossing, from those half a step and one and a half steps ago.
    [[nodiscard]] double crossing_velocity() const {
        const double previous = (before - earlier) / step;
        return velocity() + (velocity() - previous) * (crossing() - 0.5);
    }
    /// At rest in equilibrium, where a creeping approach ends: damping has taken all that is above it.
    [[nodiscard]] LedgerEnd at_rest() const {
        const double rest = motion.overlap(motion.equilibrium);
        const double above = motion.potential(coordinate(now)) - motion.potential(motion.equilibrium);
        return {rest, 0.0, dissipated + step_work() + velocity() * velocity() / 2.0 + above};
    }
    [[nodiscard]] LedgerEnd at_crossing() const {
        return {0.0, std::max(0.0, -crossing_velocity()), dissipated + crossing() * step_work()};
    }
    /// Work of damping over the last step.
    [[nodiscard]] double step_work() const { return motion.damping[0] * velocity() * velocity() * step; }
    void advance() {
        const double next = 2.0 * now - before -
                            step * step * (motion.damping[0] * velocity() + motion.force(coordinate(now)));
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
    const double step = options.time_step / scale.time();
    Recurrence r{.motion = motion, .step = step};

    const CaptureTest<double> capture(motion);
    long count = 1;
    long turned_at = 0;
    LedgerEnd last;
    bool captured = false;
    while (r.now > 0.0 && !captured) {
        if (++count > options.most_steps) throw ConvergenceError("explicit scheme: step limit reached");
        r.advance();
        const bool rises = r.now >= r.before;
        if (turned_at == 0 && !rises) {
            turned_at = count - 1;
            last = {.overlap = r.before, .speed = 0.0, .dissipated = r.dissipated};
        } else if (turned_at != 0 && rises) {
            captured = true;  // a second turning point, still in contact
        }
        if (r.now <= 0.0 || captured) continue;
        captured = turned_at == 0 ? capture.creeping_up(r.state()) : capture.creeping(r.state());
    }
    const bool turned = turned_at != 0;
    const double maximum = turned ? last.overlap : motion.overlap(motion.equilibrium);
    if (!turned) last = r.at_rest();
    if (!captured) last = r.at_crossing();
    const double speed = last.speed;
    const double potential = motion.potential(r.coordinate(last.overlap));

    ImpactResult result{};
    result.outcome = captured ? Outcome::capture : Outcome::rebound;
    result.restitution = captured ? 0.0 : speed;
    result.rebound_velocity = result.restitution * impact.velocity;
    if (!captured) {
        result.contact_time = (static_cast<double>(count - 1) + r.crossing()) * options.time_step;
    }
    if (turned) result.approach_time = static_cast<double>(turned_at) * options.time_step;
    result.maximum_overlap = maximum * scale.length;
    result.energy = {.incident = 0.5 * scale.energy(),
                     .remaining = 0.5 * speed * speed * scale.energy(),
                     .at_touch = 0.0,
                     .potential = potential * scale.energy(),
                     .dissipated = last.dissipated * scale.energy(),
                     .plastic = 0.0,
                     .jumps = 0.0,
                     .residual = (0.5 - 0.5 * speed * speed - potential - last.dissipated) * scale.energy(),
                     .minimum = motion.potential(motion.equilibrium) * scale.energy()};
    result.steps = static_cast<int>(count);
    return result;
}

}  // namespace ashimpact

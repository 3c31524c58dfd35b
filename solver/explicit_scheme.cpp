#include "solver/explicit_scheme.hpp"

#include "materials/error.hpp"
#include "solver/orbit.hpp"
#include "solver/scaled_impact.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace ashimpact {

namespace {

/// Contact time of an undamped Hertz impact in units of L/v.
constexpr double hertz_contact_time = 3.21806546;

/// The scheme needs the force as a function of overlap, from no contact radius at first touch on.
bool is_treatable(Law law) {
    return law.visit<bool>([]<template <class> class L>() { return L<double>{1.0}.touch() == 0.0; });
}

std::string treatable_laws() {
    std::string names;
    for (std::size_t i = 0; i < Law::count(); ++i) {
        if (!is_treatable(Law::at(i))) continue;
        if (!names.empty()) names += ", ";
        names += Law::at(i).name();
    }
    return names;
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
        throw InputError("time_step is " + std::to_string(options.time_step) + " s", "a finite number > 0 s");
    }
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
    /// Part of the last step at which the overlap fell through zero, by linear interpolation.
    [[nodiscard]] double crossing() const { return before / (before - now); }
    /// Velocity at the crossing, from those half a step and one and a half steps ago.
    [[nodiscard]] double crossing_velocity() const {
        const double previous = (before - earlier) / step;
        return velocity() + (velocity() - previous) * (crossing() - 0.5);
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
    return hertz_contact_time * Scale::of(impact.contact, impact.velocity).time() / steps;
}

ImpactResult solve_impact_explicit(const Impact& impact, const ExplicitSchemeOptions& options) {
    require_treatable(impact, options);
    const Scale scale = Scale::of(impact.contact, impact.velocity);
    const Motion<double> motion = scaled_motion<double>(impact, scale);
    const double step = options.time_step / scale.time();
    Recurrence r{.motion = motion, .step = step};

    const CaptureTest<double> capture(motion);
    double maximum = r.now;
    long count = 1;
    long turned_at = 0;
    bool creeping = false;  // captured, and so damped that there is no second turning point to wait for
    bool captured = false;
    while (r.now > 0.0 && !captured) {
        if (++count > options.most_steps) throw ConvergenceError("explicit scheme: step limit reached");
        r.advance();
        maximum = std::max(maximum, r.now);
        if (turned_at == 0 && r.now < r.before) turned_at = count - 1;
        if (r.now > 0.0) {
            creeping = turned_at == 0 ? capture.creeping_up(r.state()) : capture.creeping(r.state());
        }
        captured = creeping || (turned_at != 0 && r.now > r.before);
    }
    const bool turned = turned_at != 0;
    if (!turned) maximum = motion.overlap(motion.equilibrium);
    double speed = 0.0;  // at the end of the ledger; a second turning point has none
    if (creeping) speed = std::abs(r.velocity());
    if (!captured) {
        speed = std::max(0.0, -r.crossing_velocity());
        r.dissipated += r.crossing() * r.step_work();
    }
    const double last = creeping ? r.now : captured ? r.before : 0.0;
    const double potential = motion.potential(r.coordinate(last));

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
                     .dissipated = r.dissipated * scale.energy(),
                     .plastic = 0.0,
                     .residual = (0.5 - 0.5 * speed * speed - potential - r.dissipated) * scale.energy(),
                     .minimum = motion.potential(motion.equilibrium) * scale.energy()};
    result.steps = static_cast<int>(count);
    return result;
}

}  // namespace ashimpact

#include "solver/explicit_scheme.hpp"

#include "materials/error.hpp"
#include "solver/scaled_impact.hpp"

#include <cmath>
#include <string>

namespace ashimpact {

namespace {

/// Contact time of an undamped Hertz impact in units of L/v.
constexpr double hertz_contact_time = 3.21806546;

void require_treatable(const Impact& impact, const ExplicitSchemeOptions& options) {
    validate(impact);
    if (impact.law == Law::of<Jkr>() || impact.law == Law::of<ThorntonNing>()) {
        throw InputError("the paper's explicit scheme cannot treat law '" + std::string(impact.law.name()) +
                             "': its force is not a function of overlap",
                         "hertz, dmt, brach-dunn");
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

/// The recurrence of Eq. 31, scaled; remembers the two latest overlaps.
struct Recurrence {
    const Motion<double>& motion;
    double step;
    double before = 0.0;
    double now;
    double dissipated = 0.0;

    [[nodiscard]] double coordinate(double overlap) const {
        const double root = std::sqrt(overlap);  // u^2 of the laws with overlap u^4
        return motion.squared ? root : std::sqrt(root);
    }
    void advance() {
        const double velocity = (now - before) / step;
        const double eta = motion.damping[0];
        const double next =
            2.0 * now - before - step * step * (eta * velocity + motion.force(coordinate(now)));
        dissipated += eta * velocity * velocity * step;
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
    Recurrence r{.motion = motion, .step = step, .now = step};

    double maximum = r.now;
    long count = 1;
    long turned_at = 0;
    bool captured = false;
    while (r.now > 0.0 && !captured) {
        if (++count > options.most_steps) throw ConvergenceError("explicit scheme: step limit reached");
        r.advance();
        maximum = std::max(maximum, r.now);
        if (turned_at == 0 && r.now < r.before) turned_at = count - 1;
        captured = turned_at != 0 && r.now > r.before;
    }
    const double crossing = r.before / (r.before - r.now);  // part of the last step
    const double velocity = captured ? 0.0 : (r.before - r.now) / step;
    const double last = captured ? r.before : 0.0;
    const double potential = motion.potential(r.coordinate(last));

    ImpactResult result{};
    result.outcome = captured ? Outcome::capture : Outcome::rebound;
    result.restitution = velocity;
    result.rebound_velocity = velocity * impact.velocity;
    if (!captured) result.contact_time = (static_cast<double>(count - 1) + crossing) * options.time_step;
    result.approach_time = static_cast<double>(turned_at) * options.time_step;
    result.maximum_overlap = maximum * scale.length;
    result.energy = {
        .incident = 0.5 * scale.energy(),
        .remaining = 0.5 * velocity * velocity * scale.energy(),
        .at_touch = 0.0,
        .potential = potential * scale.energy(),
        .dissipated = r.dissipated * scale.energy(),
        .plastic = 0.0,
        .residual = (0.5 - 0.5 * velocity * velocity - potential - r.dissipated) * scale.energy(),
        .minimum = motion.potential(motion.equilibrium) * scale.energy()};
    result.steps = static_cast<int>(count);
    return result;
}

}  // namespace ashimpact

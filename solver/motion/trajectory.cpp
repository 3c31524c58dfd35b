// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/motion/trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <boost/math/quadrature/gauss.hpp>
#include <fmt/format.h>

#include "core/text/error.hpp"
#include "solver/contact/registry.hpp"
#include "solver/motion/scaled_impact.hpp"

namespace ashimpact {

namespace {

/// Contact radius and static forces of one state, scaled.
struct Contact {
    Extended radius;
    Extended repulsion;
    Extended attraction;
};

/// Turns scaled states into points with their forces, on any branch.
class Sampler {
  public:
    Sampler(const Impact& impact, const Scale& scale) : law_(impact.law), scale_(scale) {
        adhesion_ = law_.visit<double>([&]<template <class> class L>() {
            return L<double>::adhesion_number(impact.contact, scale.length);
        });
    }

    template <class Branch>
    [[nodiscard]] TrajectoryPoint at(const Branch& branch, const MotionState<Extended>& s) const {
        const auto newton = [&](Extended f) { return static_cast<double>(f) * scale_.force(); };
        const Contact contact = contact_at(branch, s.position);
        return {.time = static_cast<double>(s.time) * scale_.time(),
                .overlap = static_cast<double>(branch.overlap(s.position)) * scale_.length,
                .velocity = static_cast<double>(s.velocity) * scale_.velocity,
                .contact_radius = static_cast<double>(contact.radius) * scale_.radius_length,
                .repulsive_force = newton(contact.repulsion),
                .attractive_force = newton(contact.attraction),
                .damping_force = newton(branch.damping(s.position) * s.velocity)};
    }

    /// F_a on any branch, never positive, scaled.
    template <class Branch>
    [[nodiscard]] Extended attraction(const Branch& branch, Extended position) const {
        return contact_at(branch, position).attraction;
    }

  private:
    [[nodiscard]] Contact contact_at(const Motion<Extended>& motion, Extended q) const {
        const Extended u = motion.root_radius(q);
        const Extended attraction = attraction_at(u);
        return {u * u, std::max(0.0_ext, motion.force(q) - attraction), attraction};
    }
    /// With a cohesive zone the repulsion is the Hertz part a^3, the rest attraction.
    [[nodiscard]] static Contact contact_at(const TouchingBranch& branch, Extended q) {
        const Extended a = branch.state(q).contact_radius();
        const Extended repulsion = a * a * a;
        return {a, repulsion, std::min(0.0_ext, branch.force(q) - repulsion)};
    }
    [[nodiscard]] static Contact contact_at(const GapBranch& branch, Extended q) {
        return {0, 0, std::min(0.0_ext, branch.force(q))};
    }
    /// The law's attraction; yielding changes the Hertz part of the force alone.
    [[nodiscard]] Extended attraction_at(Extended u) const {
        return law_.visit<Extended>([&]<template <class> class L>() -> Extended {
            if constexpr (has_polynomials<L>)
                return 0 - L<Extended>{adhesion_}.attraction(u);  // never -0
            else
                return 0;  // without adhesion, or it would have a cohesive zone
        });
    }

    Law law_;
    Scale scale_;
    Extended adhesion_;
};

/// Pseudo-time within a step that ends at @p used at which its time series reaches @p time.
Extended pseudo_time(const Series<Extended>& series, Extended used, Extended time) {
    if (time <= series[0]) return 0;
    if (time >= value(series, used)) return used;
    return sign_change<Extended>([&](Extended h) { return time - value(series, h); }, used);
}

/// A step of an impact, kept to be sampled once the duration is known.
struct SampledStep {
    MotionExpansion<Extended> expansion;
    Extended used;
    std::function<TrajectoryPoint(const MotionState<Extended>&)> point_at;  ///< owns the branch
};

/// Sides of (44) or (45) nearer than this share are equal but for rounding.
constexpr double rounding = 1e-12;

/// Scaled time and impulses of one stage.
struct Impulses {
    Extended duration = 0;
    Extended contact = 0;
    Extended damping = 0;  ///< negative while the bodies part
};

/// Time integral over a step of a force of the state, scaled.
template <class Branch, class Force>
Extended over_time(const Branch& motion, const MotionExpansion<Extended>& x, Extended used,
                   const Force& force) {
    // 15 points are exact for the series of a step: their terms fall by 1/e^2 each.
    using Rule = boost::math::quadrature::gauss<Extended, 15>;
    return Rule::integrate(
        [&](Extended h) {
            const MotionState<Extended> state = x.at(h);
            return force(state) * motion.slope(state.position);
        },
        Extended(0), used);
}

/// Adds up both stages, step by step.
struct Integrator {
    Impulses approach;
    Impulses rebound;

    template <class Branch>
    void operator()(const Branch& motion, const MotionExpansion<Extended>& x, Extended used) {
        Impulses& stage = x.at(used / 2).velocity > 0 ? approach : rebound;
        stage.duration += value(x.time, used) - x.time[0];
        stage.contact += over_time(motion, x, used, [&](const auto& s) { return motion.force(s.position); });
        stage.damping += over_time(motion, x, used,
                                   [&](const auto& s) { return motion.damping(s.position) * s.velocity; });
    }
};

/// @param momentum at the open end of the stage, scaled
StageMomentum stage_of(const Impulses& stage, Extended momentum, const Scale& scale) {
    const Extended residual = stage.contact + stage.damping - momentum;
    const auto newton_second = [&](Extended impulse) {
        return static_cast<double>(impulse) * scale.momentum();
    };
    return {.duration = static_cast<double>(stage.duration) * scale.time(),
            .static_impulse = newton_second(stage.contact),
            .damping_impulse = newton_second(std::abs(stage.damping)),
            .mean_force = static_cast<double>(stage.contact / stage.duration) * scale.force(),
            .residual = newton_second(residual)};
}

std::string comparison(double left, double right, double size, const char* unit) {
    const bool equal = std::abs(left - right) <= rounding * size;
    return fmt::format("{:g} {} {} {:g} {}", left, unit, equal ? '=' : left > right ? '>' : '<', right, unit);
}

}  // namespace

std::vector<TrajectoryPoint> trajectory(const Impact& impact, int count) {
    validate(impact);
    if (count < 2) throw InputError("trajectory has " + std::to_string(count) + " points", "at least 2");
    const auto scaled = scaled_impact<Extended>(impact, Precision::extended);
    const Sampler sampler(impact, scaled.scale);
    std::vector<SampledStep> steps;
    const auto record = [&](const auto& branch, const MotionExpansion<Extended>& x, Extended used) {
        steps.push_back(
            {x, used, [&sampler, branch](const auto& state) { return sampler.at(branch, state); }});
    };
    follow(scaled, record, static_cast<std::size_t>(count));
    const Extended last = value(steps.back().expansion.time, steps.back().used);
    std::vector<TrajectoryPoint> points;
    points.reserve(static_cast<std::size_t>(count));
    auto step = steps.begin();
    for (int i = 0; i < count; ++i) {
        const Extended time = last * static_cast<Extended>(i) / (count - 1);
        const auto ends_before = [time](const SampledStep& s) {
            return value(s.expansion.time, s.used) < time;
        };
        while (step + 1 != steps.end() && ends_before(*step)) ++step;
        const auto& [x, used, point_at] = *step;
        points.push_back(point_at(x.at(pseudo_time(x.time, used, time))));
    }
    return points;
}

bool MomentumBalance::damping_exceeds_loss() const {
    return damping_impulse - momentum_lost > rounding * incident_momentum;
}

bool MomentumBalance::rebound_is_longer() const {
    return rebound.duration - approach.duration > rounding * approach.duration;
}

std::string verdict_of(const MomentumBalance& balance) {
    const auto holds = [](bool yes) { return yes ? "holds" : "does not hold"; };
    return fmt::format(
        "(44) {}: damping impulse {} lost; (45) {}: rebound {} approach; mean forces, equal in (40), are as "
        "{:.4g} to 1",
        holds(balance.damping_exceeds_loss()),
        comparison(balance.damping_impulse, balance.momentum_lost, balance.incident_momentum, "N s"),
        holds(balance.rebound_is_longer()),
        comparison(balance.rebound.duration, balance.approach.duration, balance.approach.duration, "s"),
        balance.mean_force_ratio());
}

MomentumBalance momentum_balance(const Impact& impact) {
    validate(impact);
    Integrator sum;
    const auto scaled = scaled_impact<Extended>(impact, Precision::extended);
    const Orbit<Extended> orbit = follow(scaled, sum);
    if (orbit.outcome == Outcome::capture)
        throw InputError("a captured particle has no momentum balance of a rebound",
                         "a velocity above the critical one");
    const Scale& scale = scaled.scale;
    const Extended incident = scaled.velocity;
    const Extended left = std::abs(orbit.end.velocity);
    return {.approach = stage_of(sum.approach, incident, scale),
            .rebound = stage_of(sum.rebound, left, scale),
            .incident_momentum = static_cast<double>(incident) * scale.momentum(),
            .damping_impulse =
                static_cast<double>(sum.approach.damping + std::abs(sum.rebound.damping)) * scale.momentum(),
            .momentum_lost = static_cast<double>(incident - left) * scale.momentum()};
}

double attraction_impulse(const Impact& impact, Precision precision) {
    validate(impact);
    const auto scaled = scaled_impact<Extended>(impact, precision);
    const Sampler sampler(impact, scaled.scale);
    Extended sum = 0;
    const auto add = [&](const auto& branch, const MotionExpansion<Extended>& x, Extended used) {
        sum -=
            over_time(branch, x, used, [&](const auto& s) { return sampler.attraction(branch, s.position); });
    };
    if (follow(scaled, add).outcome == Outcome::capture)
        throw InputError("a captured particle has no momentum balance of a rebound",
                         "a velocity above the critical one");
    return static_cast<double>(sum) * scaled.scale.momentum();
}

}  // namespace ashimpact

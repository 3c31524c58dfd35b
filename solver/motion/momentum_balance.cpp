// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/motion/momentum_balance.hpp"

#include <cmath>
#include <sstream>

#include <boost/math/quadrature/gauss.hpp>

#include "core/text/error.hpp"
#include "solver/motion/scaled_impact.hpp"

namespace ashimpact {

namespace {

/// Sides of (44) or (45) nearer than this share are equal but for rounding.
constexpr double rounding = 1e-12;

/// Scaled time and impulses of one stage.
struct Impulses {
    Extended duration = 0;
    Extended contact = 0;
    Extended damping = 0;  ///< negative while the bodies part
};

/// Adds up both stages, step by step.
struct Integrator {
    Impulses approach;
    Impulses rebound;

    template <class Branch>
    void operator()(const Branch& motion, const MotionExpansion<Extended>& x, Extended used) {
        // 15 points are exact for the series of a step: their terms fall by 1/e^2 each.
        using Rule = boost::math::quadrature::gauss<Extended, 15>;
        const auto over_time = [&](auto&& force) {
            return Rule::integrate(
                [&](Extended h) {
                    const MotionState<Extended> state = x.at(h);
                    return force(state) * motion.slope(state.position);
                },
                Extended(0), used);
        };
        Impulses& stage = x.at(used / 2).velocity > 0 ? approach : rebound;
        stage.duration += value(x.time, used) - x.time[0];
        stage.contact += over_time([&](const auto& s) { return motion.force(s.position); });
        stage.damping += over_time([&](const auto& s) { return motion.damping(s.position) * s.velocity; });
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
    std::ostringstream text;
    text.precision(6);
    const bool equal = std::abs(left - right) <= rounding * size;
    text << left << ' ' << unit << (equal ? " = " : left > right ? " > " : " < ") << right << ' ' << unit;
    return text.str();
}

}  // namespace

bool MomentumBalance::damping_exceeds_loss() const {
    return damping_impulse - momentum_lost > rounding * incident_momentum;
}

bool MomentumBalance::rebound_is_longer() const {
    return rebound.duration - approach.duration > rounding * approach.duration;
}

std::string verdict_of(const MomentumBalance& balance) {
    std::ostringstream text;
    text.precision(4);
    const auto holds = [](bool yes) { return yes ? " holds: " : " does not hold: "; };
    text << "(44)" << holds(balance.damping_exceeds_loss()) << "damping impulse "
         << comparison(balance.damping_impulse, balance.momentum_lost, balance.incident_momentum, "N s")
         << " lost; (45)" << holds(balance.rebound_is_longer()) << "rebound "
         << comparison(balance.rebound.duration, balance.approach.duration, balance.approach.duration, "s")
         << " approach; mean forces, equal in (40), are as " << balance.mean_force_ratio() << " to 1";
    return text.str();
}

MomentumBalance momentum_balance(const Impact& impact) {
    validate(impact);
    Integrator sum;
    const auto scaled = scaled_impact<Extended>(impact, Precision::extended);
    const Orbit<Extended> orbit = follow(scaled, sum);
    if (orbit.outcome == Outcome::capture) {
        throw InputError("a captured particle has no momentum balance of a rebound",
                         "a velocity above the critical one");
    }
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

}  // namespace ashimpact

#include "solver/momentum_balance.hpp"

#include "materials/error.hpp"
#include "solver/scaled_impact.hpp"

namespace ashimpact {

namespace {

/// Damping impulses of the two legs, summed branch by branch: integral of eta d(delta), scaled.
struct DampingImpulse {
    Extended approach = 0;
    Extended rebound = 0;

    void operator()(const Motion<Extended>& motion, const MotionExpansion<Extended>& x, Extended used) {
        const Polynomial<Extended> impulse = motion.drag.antiderivative();
        const Extended gained = impulse(value(x.position, used)) - impulse(x.position[0]);
        (gained > 0 ? approach : rebound) += gained;
    }
};

Orbit<Extended> observed(const Impact& impact, const Scale& scale, DampingImpulse& impulse) {
    if (can_yield(impact.law, impact.contact)) {
        return follow_plastic(scaled_plastic_motion<Extended>(impact, scale), 1.0L, impulse).orbit;
    }
    return follow(scaled_motion<Extended>(impact, scale), 1.0L, impulse);
}

}  // namespace

MomentumBalance momentum_balance(const Impact& impact) {
    validate(impact);
    const Scale scale = Scale::of(impact.contact, impact.velocity);
    DampingImpulse damping;
    const Orbit<Extended> orbit = observed(impact, scale, damping);
    if (!orbit.turned) {
        throw InputError("the impact is so damped that it never turns: it has no approach time",
                         "less damping");
    }
    const double momentum = scale.momentum();
    MomentumBalance balance{};
    balance.approach_time = static_cast<double>(orbit.turn.time) * scale.time();
    balance.approach_damping_impulse = static_cast<double>(damping.approach) * momentum;
    balance.approach_static_impulse = static_cast<double>(1 - damping.approach) * momentum;
    balance.approach_mean_force = balance.approach_static_impulse / balance.approach_time;
    balance.momentum_lost = momentum;
    if (orbit.outcome == Outcome::capture) return balance;

    const Extended lost = 1 + orbit.end.velocity;
    balance.rebound_time = static_cast<double>(orbit.end.time - orbit.turn.time) * scale.time();
    balance.rebound_damping_impulse = static_cast<double>(-damping.rebound) * momentum;
    balance.rebound_static_impulse = static_cast<double>(-orbit.end.velocity - damping.rebound) * momentum;
    balance.rebound_mean_force = balance.rebound_static_impulse / balance.rebound_time;
    balance.momentum_lost = static_cast<double>(lost) * momentum;
    balance.inequality_44 = damping.approach - damping.rebound > lost;
    balance.inequality_45 = balance.rebound_time > balance.approach_time;
    return balance;
}

}  // namespace ashimpact

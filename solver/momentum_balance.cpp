#include "solver/momentum_balance.hpp"

#include "materials/error.hpp"
#include "solver/trajectory.hpp"

#include <cmath>
#include <vector>

namespace ashimpact {

namespace {

struct Instant {
    double time;
    double static_force;
    double damping_force;
};

Instant instant_of(const TrajectoryPoint& point) {
    return {point.time, point.repulsive_force + point.attractive_force, point.damping_force};
}

/// The instants of each stage; both hold the turning point, where the damping force is zero.
struct Stages {
    std::vector<Instant> approach;
    std::vector<Instant> rebound;
};

Stages stages_of(const std::vector<TrajectoryPoint>& points, double turn) {
    Stages stages;
    for (const TrajectoryPoint& point : points) {
        const Instant now = instant_of(point);
        if (now.time < turn) {
            stages.approach.push_back(now);
            continue;
        }
        if (stages.rebound.empty()) {
            const Instant before = stages.approach.back();
            const double share = (turn - before.time) / (now.time - before.time);
            const double force = before.static_force + share * (now.static_force - before.static_force);
            stages.approach.push_back({turn, force, 0.0});
            stages.rebound.push_back({turn, force, 0.0});
        }
        if (now.time > turn) stages.rebound.push_back(now);
    }
    return stages;
}

/// @param sign of the damping impulse in the stage's balance; @param momentum at its open end [N s]
StageMomentum momentum_of(const std::vector<Instant>& instants, double sign, double momentum) {
    StageMomentum stage{};
    for (std::size_t i = 1; i < instants.size(); ++i) {
        const double step = instants[i].time - instants[i - 1].time;
        stage.static_impulse += step * (instants[i].static_force + instants[i - 1].static_force) / 2.0;
        stage.damping_impulse +=
            step * std::abs(instants[i].damping_force + instants[i - 1].damping_force) / 2.0;
    }
    stage.duration = instants.back().time - instants.front().time;
    stage.mean_force = stage.static_impulse / stage.duration;
    stage.residual = stage.static_impulse + sign * stage.damping_impulse - momentum;
    return stage;
}

}  // namespace

MomentumBalance momentum_balance(const Impact& impact, int points) {
    const ImpactResult result = solve_impact(impact);
    if (result.outcome == Outcome::capture) {
        throw InputError("a captured particle has no momentum balance of a rebound",
                         "a velocity above the critical one");
    }
    const Stages stages = stages_of(trajectory(impact, points), *result.approach_time);
    const double mass = impact.contact.mass;
    MomentumBalance balance{};
    balance.approach = momentum_of(stages.approach, 1.0, mass * impact.velocity);
    balance.rebound = momentum_of(stages.rebound, -1.0, mass * result.rebound_velocity);
    balance.damping_impulse = balance.approach.damping_impulse + balance.rebound.damping_impulse;
    balance.momentum_lost = mass * (impact.velocity - result.rebound_velocity);
    return balance;
}

}  // namespace ashimpact

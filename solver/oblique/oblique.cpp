// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/oblique/oblique.hpp"

#include <algorithm>
#include <cmath>

#include "core/quantities/checks.hpp"
#include "solver/motion/trajectory.hpp"

namespace ashimpact {

namespace {

/// (5/2) P/(m R): spin that a tangential impulse at the surface of a solid sphere gives it [rad/s].
double spin_by(double impulse, const SphereBody& body) {
    return 2.5 * impulse / (body.mass * body.radius);
}

/// I omega^2/2 [J].
double spin_energy(const SphereBody& sphere, double spin) {
    const double rim = sphere.radius * spin;
    return 0.2 * sphere.mass * rim * rim;
}

ObliqueEnergy energy_of(const ContactBodies& bodies, double mass, double normal,
                        const TangentialMotion& motion, double partner_spin) {
    return {.normal = 0.5 * mass * normal * normal,
            .sliding = 0.5 * mass * motion.velocity * motion.velocity,
            .spin = spin_energy(bodies.sphere, motion.spin) +
                    (bodies.partner ? spin_energy(*bodies.partner, partner_spin) : 0)};
}

}  // namespace

void require_tangential(const TangentialMotion& before, double friction) {
    require_not_negative("friction", friction, Dimension::fraction);
    // Of any sign, and not too great to compute energies with.
    require_not_negative("magnitude of the tangential velocity", std::abs(before.velocity),
                         Dimension::velocity);
    require_not_negative("magnitude of the spin", std::abs(before.spin), Dimension::angular_velocity);
}

double rolling_impulse(double effective_mass, double slip) {
    return 2.0 / 7.0 * effective_mass * std::abs(slip);
}

TangentialRebound tangential_rebound(const ContactBodies& bodies, double effective_mass,
                                     const TangentialMotion& before, double friction,
                                     double repulsive_impulse) {
    const double slip = before.velocity + bodies.sphere.radius * before.spin;
    TangentialRebound rebound{.after = before};
    if (slip == 0 || friction == 0) return rebound;
    const double most = friction * repulsive_impulse;
    const double needed = rolling_impulse(effective_mass, slip);
    rebound.regime = most < needed ? SlidingRegime::sliding : SlidingRegime::rolling;
    rebound.impulse = std::min(most, needed);
    const double impulse = std::copysign(rebound.impulse, slip);
    rebound.after.velocity -= impulse / effective_mass;
    rebound.after.spin -= spin_by(impulse, bodies.sphere);
    if (bodies.partner) rebound.partner_spin = -spin_by(impulse, *bodies.partner);
    // The slip falls in proportion to the impulse: work is the impulse times its mean.
    const double left = rebound.regime == SlidingRegime::rolling ? 0 : std::abs(slip) * (1 - most / needed);
    rebound.friction_work = 0.5 * rebound.impulse * (std::abs(slip) + left);
    return rebound;
}

ReboundRatios rebound_ratios(const TangentialMotion& before, const TangentialRebound& tangential,
                             double effective_mass, double incident, double rebound) {
    const double after = tangential.after.velocity;
    const bool moved = before.velocity != 0;
    const double forward = moved ? std::copysign(1.0, before.velocity) : 1.0;
    return {.tangential_restitution = moved ? std::optional(after / before.velocity) : std::nullopt,
            .rebound_angle = std::atan2(forward * after, rebound),
            .impulse_ratio = tangential.impulse / (effective_mass * (incident + rebound))};
}

double repulsive_impulse(const Impact& impact, double restitution) {
    const double net = impact.contact.mass * (1 + restitution) * impact.velocity;
    return impact.law.is_adhesive() ? net + attraction_impulse(impact) : net;
}

ObliqueResult solve_oblique_impact(const ObliqueImpact& impact) {
    validate(impact.normal);
    return oblique_result(impact, solve_impact(impact.normal));
}

ObliqueResult oblique_result(const ObliqueImpact& impact, const ImpactResult& solved) {
    validate(impact.normal);
    require_tangential(impact.tangential, impact.friction);
    const Impact& normal = impact.normal;
    const double mass = normal.contact.mass;
    ObliqueResult result{.normal = solved, .tangential = {}};
    result.before = energy_of(impact.bodies, mass, normal.velocity, impact.tangential, 0);
    if (result.normal.outcome == Outcome::capture) {
        result.tangential.regime = SlidingRegime::captured;
        result.stopped = result.before.sliding + result.before.spin;
        if (impact.tangential.velocity != 0) result.tangential_restitution = 0;
        return result;
    }
    result.repulsive_impulse = repulsive_impulse(normal, result.normal.restitution);
    result.tangential =
        tangential_rebound(impact.bodies, mass, impact.tangential, impact.friction, result.repulsive_impulse);
    const double rebound = result.normal.rebound_velocity;
    const ReboundRatios ratios =
        rebound_ratios(impact.tangential, result.tangential, mass, normal.velocity, rebound);
    result.tangential_restitution = ratios.tangential_restitution;
    result.rebound_angle = ratios.rebound_angle;
    result.impulse_ratio = ratios.impulse_ratio;
    result.after =
        energy_of(impact.bodies, mass, rebound, result.tangential.after, result.tangential.partner_spin);
    return result;
}

}  // namespace ashimpact

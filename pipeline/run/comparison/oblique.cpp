// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/comparison/oblique.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "solver/oblique/oblique.hpp"

namespace ashimpact {

namespace {

constexpr std::array critical_multiples_at_angles{1.1, 1.5, 2.0, 4.0};
constexpr double angle_step = 2 * std::numbers::pi / 180;
constexpr double above_capture = 1 + 1e-3;  ///< normal velocity over v_c of the last rebound of a curve [1]

/// The damping at a normal velocity: that of v_c, then along the curve of the model.
double damping_along(const LawCriticalVelocity& critical, const LawCurve* curve, double velocity) {
    double from = critical.velocity->value;
    double damping = critical.damping;
    if (curve == nullptr) return damping;
    for (const CurveImpact& next : curve->impacts) {
        if (next.velocity >= velocity && next.velocity > from)
            return damping + (velocity - from) / (next.velocity - from) * (next.damping - damping);
        from = next.velocity;
        damping = next.damping;
    }
    return damping;
}

/// The rebound at an angle; none if the impact is captured.
std::optional<ObliqueRebound> rebound_at(ObliqueImpact impact, double velocity, double angle) {
    impact.normal.velocity = velocity * std::cos(angle);
    impact.tangential.velocity = velocity * std::sin(angle);
    const ObliqueResult result = solve_oblique_impact(impact);
    if (!result.rebound_angle) return std::nullopt;
    return ObliqueRebound{angle, result.normal.restitution, *result.tangential_restitution,
                          *result.rebound_angle};
}

}  // namespace

std::optional<ObliqueCurves> oblique_curves(const ObliqueEvidence& evidence) {
    const auto& [data, contact, velocities, curves, reported] = evidence;
    if (!data.friction || !reported || !reported->law) return std::nullopt;
    const Law law = *reported->law;
    const LawCriticalVelocity* critical = velocities.find(law);
    if (critical == nullptr || !critical->velocity || !(critical->velocity->value > 0)) return std::nullopt;
    const double v_c = critical->velocity->value;
    ObliqueImpact impact{.normal = {law, data.detachment_of(law), {data.damping_law, 0}, contact.pair, v_c},
                         .bodies = {.sphere = {contact.radius.value, contact.mass.value}},
                         .friction = data.friction->value()};
    if (contact.partner)
        impact.bodies.partner = SphereBody{contact.partner->radius.value, contact.partner->mass.value};
    ObliqueCurves all{.law = law, .friction = impact.friction};
    for (const double multiple : critical_multiples_at_angles) {
        ObliqueCurve curve{multiple, multiple * v_c, std::acos(1 / multiple), {}};
        const double last = std::acos(above_capture / multiple);
        for (double step = 1; step * angle_step < last + angle_step; ++step) {
            const double angle = std::min(step * angle_step, last);
            impact.normal.damping.coefficient =
                damping_along(*critical, curves.find(law), curve.velocity * std::cos(angle));
            if (const auto rebound = rebound_at(impact, curve.velocity, angle))
                curve.rebounds.push_back(*rebound);
        }
        all.curves.push_back(std::move(curve));
    }
    return all;
}

}  // namespace ashimpact

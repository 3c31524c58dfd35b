// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/impacts/inversion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/text/error.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/motion/damping_inversion.hpp"

namespace ashimpact {

namespace {

/// Standard uncertainty of the damping from the noise of the velocities, e = v_r/v_in [kg/s].
std::optional<double> propagated(const Measurement& point, double by_restitution, double by_velocity) {
    if (!point.noise) return std::nullopt;
    const double by_rebound = by_restitution / point.velocity;
    const double by_incident = by_velocity - by_rebound * point.restitution();
    const double variance = by_incident * by_incident * point.noise->incident +
                            2.0 * by_incident * by_rebound * point.noise->covariance +
                            by_rebound * by_rebound * point.noise->rebound;
    return std::sqrt(variance);
}

/// An impact for which no damping has been found yet.
InvertedImpact without_damping(std::size_t index, const Measurement& point, double greatest) {
    return {.index = index,
            .velocity = point.velocity,
            .restitution = point.restitution(),
            .greatest_restitution = greatest};
}

}  // namespace

std::vector<InvertedImpact> invert(const ContactModel& model, const MeasurementSet& set) {
    std::vector<InvertedImpact> result(set.points.size());
    const auto invert_one = [&](std::size_t i) {
        const Measurement& point = set.points[i];
        const double e = point.restitution();
        InvertedImpact& inverted = result[i];
        inverted = without_damping(i, point, model.greatest_restitution(point.velocity));
        if (!model.range().contains(point.velocity) || e > inverted.greatest_restitution) return;
        const DampingAt damping = model.damping(point.velocity, e);
        inverted.damping = damping.value;
        inverted.by_restitution = damping.by_restitution;
        inverted.by_velocity = damping.by_velocity;
        inverted.standard_uncertainty = propagated(point, damping.by_restitution, damping.by_velocity);
        if (!point.captured()) inverted.contact_time = model.contact_time(point.velocity, e);
    };
    constexpr std::size_t chunk = 1000;
    batch::for_chunks(result.size(), chunk, 0, [&](std::size_t first, std::size_t size) {
        for (std::size_t i = first; i < first + size; ++i) invert_one(i);
    });
    return result;
}

std::vector<InvertedImpact> invert_by_solving(Law law, Detachment detachment, const ContactPair& contact,
                                              const MeasurementSet& set) {
    constexpr double nudge = 1e-5;  // relative step of the differences
    const auto solved = [&](double velocity, double restitution) {
        return damping_from_restitution(
            {law, detachment, DampingLaw::constant, contact, velocity, restitution});
    };
    const auto damping = [&](double velocity, double restitution) {
        return solved(velocity, restitution).damping.coefficient;
    };
    std::vector<InvertedImpact> result;
    for (std::size_t i = 0; i < set.points.size(); ++i) {
        const Measurement& point = set.points[i];
        const double v = point.velocity;
        const double e = point.restitution();
        const Impact undamped{law, detachment, {DampingLaw::constant, 0.0}, contact, v};
        validate(undamped);
        result.push_back(without_damping(i, point, restitution_of(undamped)));
        InvertedImpact& inverted = result.back();
        if (e >= inverted.greatest_restitution * (1.0 - nudge)) continue;
        const DampingInversion found = solved(v, e);
        inverted.damping = found.damping.coefficient;
        inverted.contact_time = found.impact.contact_time;
        inverted.by_velocity =
            (damping(v * (1.0 + nudge), e) - damping(v * (1.0 - nudge), e)) / (2 * nudge * v);
        const double lower = e * (1.0 - nudge);
        const double upper = e == 0.0 ? nudge : e * (1.0 + nudge);
        inverted.by_restitution = (damping(v, upper) - damping(v, lower)) / (upper - lower);
        inverted.standard_uncertainty = propagated(point, inverted.by_restitution, inverted.by_velocity);
    }
    return result;
}

}  // namespace ashimpact

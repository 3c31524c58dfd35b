// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/quantities/quantity.hpp"
#include "materials/contact_properties.hpp"
#include "pipeline/run/results/contact.hpp"
#include "pipeline/run/results/damping.hpp"

namespace ashimpact {

namespace {

UnreachableImpact unreachable(const InvertedImpact& impact) {
    return {impact.index + 1, impact.velocity, impact.restitution,
            impact.restitution >= impact.greatest_restitution
                ? fmt::format("without any damping the restitution is {} at this velocity",
                              readable_number(impact.greatest_restitution))
                : "no damping gives this restitution at this velocity"};
}

}  // namespace

ContactPair pair_of(const SampleContact& contact) {
    ContactPair pair{.mass = contact.mass.value,
                     .effective_radius = contact.radius.value,
                     .contact_modulus = contact.contact_modulus.value(),
                     .work_of_adhesion = contact.work_of_adhesion.value()};
    if (contact.partner) {
        pair.effective_radius = effective_radius(contact.radius.value, contact.partner->radius.value);
        pair.mass = effective_mass(contact.mass.value, contact.partner->mass.value);
    }
    if (contact.yield_pressure) pair.yield_pressure = contact.yield_pressure->value();
    for (const auto& [parameter, stated] : contact.parameters)
        pair.parameters.set(parameter.name, stated.value());
    return pair;
}

ListedImpacts columns_of(const MeasurementSet& set) {
    ListedImpacts columns;
    for (const Measurement& point : set.points) {
        columns.velocity.push_back(point.velocity);
        columns.restitution.push_back(point.restitution());
        columns.counts.push_back(static_cast<double>(point.count));
        columns.resolution.push_back(point.resolution);
        columns.noted_captures.push_back(point.outcome == NotedOutcome::capture ? 1.0 : 0.0);
        if (point.tangential) columns.tangential.push_back(*point.tangential);
        if (!point.noise) continue;
        columns.velocity_uncertainty.push_back(std::sqrt(point.noise->incident));
        columns.rebound_uncertainty.push_back(std::sqrt(point.noise->rebound));
        columns.correlation.push_back(point.noise->covariance / (columns.velocity_uncertainty.back() *
                                                                 columns.rebound_uncertainty.back()));
    }
    const auto drop_if_all = [](std::vector<double>& values, double usual) {
        if (std::ranges::all_of(values, [&](double value) { return value == usual; })) values.clear();
    };
    drop_if_all(columns.correlation, 0);
    drop_if_all(columns.counts, 1);
    drop_if_all(columns.resolution, 0);
    drop_if_all(columns.noted_captures, 0);
    if (columns.tangential.size() != columns.velocity.size()) columns.tangential.clear();
    return columns;
}

MeasurementSet impacts_of(const ListedImpacts& columns) {
    MeasurementSet set{.source = {}, .points = {}};
    for (std::size_t i = 0; i < columns.velocity.size(); ++i) {
        Measurement point{.velocity = columns.velocity[i],
                          .rebound = columns.restitution[i] * columns.velocity[i]};
        if (!columns.velocity_uncertainty.empty()) {
            const double incident = columns.velocity_uncertainty[i];
            const double rebound = columns.rebound_uncertainty[i];
            point.noise = VelocityNoise::of_velocities(incident, rebound);
            point.noise->covariance =
                (columns.correlation.empty() ? 0.0 : columns.correlation[i]) * incident * rebound;
        }
        if (!columns.resolution.empty()) point.resolution = columns.resolution[i];
        if (!columns.noted_captures.empty() && columns.noted_captures[i] > 0.0)
            point.outcome = NotedOutcome::capture;
        if (!columns.tangential.empty()) point.tangential = columns.tangential[i];
        if (!columns.counts.empty()) point.count = static_cast<std::size_t>(columns.counts[i]);
        set.points.push_back(point);
    }
    return set;
}

DampingSeries inverted_series(const std::vector<InvertedImpact>& impacts) {
    DampingSeries series;
    for (const InvertedImpact& impact : impacts) {
        if (impact.restitution == 0) {
            series.captured_at.push_back(impact.velocity);
            if (impact.damping) series.capturing_damping.push_back(*impact.damping);
            continue;
        }
        if (!impact.damping || !impact.contact_time) {
            series.unreachable.push_back(unreachable(impact));
            continue;
        }
        series.number.push_back(static_cast<double>(impact.index + 1));
        series.velocity.push_back(impact.velocity);
        series.restitution.push_back(impact.restitution);
        series.greatest_restitution.push_back(impact.greatest_restitution);
        series.damping.push_back(*impact.damping);
        series.contact_time.push_back(*impact.contact_time);
        if (impact.standard_uncertainty) series.damping_uncertainty.push_back(*impact.standard_uncertainty);
    }
    if (series.damping_uncertainty.size() != series.damping.size()) series.damping_uncertainty.clear();
    if (series.capturing_damping.size() != series.captured_at.size()) series.capturing_damping.clear();
    return series;
}

void set_parts(const DampingParts& parts, const std::vector<InvertedImpact>& impacts, DampingSeries& series) {
    double slowest = std::numeric_limits<double>::infinity();
    double fastest = 0;
    for (const InvertedImpact& impact : impacts) {
        if (impact.restitution == 0 || !impact.damping) continue;
        slowest = std::min(slowest, impact.velocity);
        fastest = std::max(fastest, impact.velocity);
    }
    const auto boundary = [&](std::size_t i) {
        const PartBoundary& of = parts.boundaries[i];
        const bool is_known = std::isfinite(of.standard_uncertainty);
        return make_quantity(of.velocity, Dimension::velocity,
                             is_known ? std::optional(of.standard_uncertainty) : std::nullopt);
    };
    for (std::size_t i = 0; i < parts.parts.size(); ++i)
        series.parts.push_back(
            {parts.parts[i], i == 0 ? make_quantity(slowest, Dimension::velocity) : boundary(i - 1),
             i == parts.boundaries.size() ? make_quantity(fastest, Dimension::velocity) : boundary(i)});
    for (const std::size_t index : parts.outliers) series.outliers.push_back(index + 1);
    series.parts_note = parts.note;
}

DampingCurveFit with_indices(DampingCurveFit fit, const std::vector<std::size_t>& indices) {
    for (FittedRebound& rebound : fit.rebounds) rebound.index = indices.at(rebound.index);
    for (ExcludedRebound& rebound : fit.excluded) rebound.index = indices.at(rebound.index);
    return fit;
}

DampingEstimate summary_of(const CriticalVelocityEstimate& estimate) {
    const EstimatedDamping& damping = estimate.curve.damping;
    return {.critical_damping = estimate.curve.critical_damping,
            .critical_velocity = estimate.curve.critical_velocity,
            .rebounds = estimate.rebounds,
            .captures = estimate.captures,
            .noise_known = estimate.noise_known,
            .scatter = estimate.curve.scatter.noise,
            .particle_scatter = estimate.curve.damping_scatter,
            .curve = damping.velocity.empty() ? std::nullopt : std::optional(damping)};
}

}  // namespace ashimpact

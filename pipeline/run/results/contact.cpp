// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/results/contact.hpp"

#include <algorithm>
#include <cmath>

namespace ashimpact {

ListedImpacts columns_of(const MeasurementSet& set) {
    ListedImpacts columns;
    for (const Measurement& point : set.points) {
        columns.velocity.push_back(point.velocity);
        columns.restitution.push_back(point.restitution());
        columns.counts.push_back(static_cast<double>(point.count));
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
        if (!columns.counts.empty()) point.count = static_cast<std::size_t>(columns.counts[i]);
        set.points.push_back(point);
    }
    return set;
}

}  // namespace ashimpact

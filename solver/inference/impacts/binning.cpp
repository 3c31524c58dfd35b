// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/impacts/binning.hpp"

#include <algorithm>
#include <cmath>

#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "solver/numeric/gsl/statistics.hpp"

namespace ashimpact {

namespace {

constexpr double least_width = 1e-6;  ///< of a bin, in fastest velocities

Measurement mean_of(const std::vector<Measurement>& bin) {
    std::vector<double> velocities;
    std::vector<double> rebounds;
    std::vector<double> weights;
    Measurement mean{.velocity = 0.0, .rebound = 0.0, .noise = {}, .line = 0, .count = 0};
    VelocityNoise noise{0.0, 0.0, 0.0};
    double sum = 0.0;
    for (const Measurement& point : bin) {
        const double weight = point.noise ? 1.0 / (point.noise->incident + point.noise->rebound) : 1.0;
        velocities.push_back(point.velocity);
        rebounds.push_back(point.rebound);
        weights.push_back(weight);
        sum += weight;
        mean.count += point.count;
        if (!point.noise) continue;
        noise.incident += weight * weight * point.noise->incident;
        noise.rebound += weight * weight * point.noise->rebound;
        noise.covariance += weight * weight * point.noise->covariance;
    }
    mean.velocity = gsl::weighted_mean(velocities, weights);
    mean.rebound = gsl::weighted_mean(rebounds, weights);
    if (bin.front().noise) mean.noise = noise.scaled(1.0 / (sum * sum));
    return mean;
}

}  // namespace

MeasurementSet binned(const MeasurementSet& set, const Binning& binning) {
    if ((binning.impacts_per_bin > 0) == (binning.width > 0.0))
        throw InputError("binning by both or neither of impacts and width", "exactly one, > 0");
    double fastest = 0.0;
    for (const Measurement& point : set.points) fastest = std::max(fastest, point.velocity);
    if (binning.width > 0.0 && binning.width < least_width * fastest)
        throw InputError(
            "bins of " + shortest(binning.width) + " m/s for impacts of up to " + shortest(fastest) + " m/s",
            "a width of at least a millionth of the fastest velocity");
    MeasurementSet result{.source = set.source, .points = {}, .warnings = set.warnings};
    std::vector<Measurement> rebounds;
    for (const Measurement& point : set.points)
        (point.captured() ? result.points : rebounds).push_back(point);
    std::sort(rebounds.begin(), rebounds.end(),
              [](const Measurement& a, const Measurement& b) { return a.velocity < b.velocity; });
    std::vector<Measurement> bin;
    for (const Measurement& point : rebounds) {
        const bool full = binning.impacts_per_bin > 0
                              ? bin.size() == static_cast<std::size_t>(binning.impacts_per_bin)
                              : !bin.empty() && std::floor(point.velocity / binning.width) !=
                                                    std::floor(bin.front().velocity / binning.width);
        if (full) {
            result.points.push_back(mean_of(bin));
            bin.clear();
        }
        bin.push_back(point);
    }
    if (!bin.empty()) result.points.push_back(mean_of(bin));
    return result;
}

}  // namespace ashimpact

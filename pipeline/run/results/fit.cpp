// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/results/fit.hpp"

namespace ashimpact {

DampingCurveFit with_indices(DampingCurveFit fit, const std::vector<std::size_t>& indices) {
    for (FittedRebound& rebound : fit.rebounds) rebound.index = indices.at(rebound.index);
    for (ExcludedRebound& rebound : fit.excluded) rebound.index = indices.at(rebound.index);
    return fit;
}

DampingEstimate summary_of(const CriticalVelocityEstimate& estimate) {
    return {.critical_damping = estimate.curve.critical_damping,
            .critical_velocity = estimate.curve.critical_velocity,
            .rebounds = estimate.rebounds,
            .captures = estimate.captures,
            .noise_known = estimate.noise_known,
            .scatter = estimate.curve.scatter.noise,
            .particle_scatter = estimate.curve.scatter.damping};
}

}  // namespace ashimpact

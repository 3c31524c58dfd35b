#pragma once

#include "solver/measurement/measurement.hpp"

#include <vector>

namespace ashimpact {

/// The data of a fit of eta(e_n). Weights below one reduce the influence of a rebound (robust fits).
struct RestitutionData {
    std::vector<Measurement> rebounds;  ///< each with its noise
    std::vector<double> weights;
    double greatest_restitution;  ///< upper end of the curve

    /// The same with all variances multiplied by @p factor.
    [[nodiscard]] RestitutionData with_noise_scaled(double factor) const;
};

}  // namespace ashimpact

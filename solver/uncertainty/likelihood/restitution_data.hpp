#pragma once

#include "solver/measurement/measurement.hpp"

#include <vector>

namespace ashimpact {

/// What a fit of eta(e_n) sees. Weights below one take a rebound back (robust fits).
struct RestitutionData {
    std::vector<Measurement> rebounds;  ///< each with its noise
    std::vector<double> weights;
    double greatest_restitution;  ///< upper end of the curve

    /// The same with all variances multiplied by @p factor.
    [[nodiscard]] RestitutionData with_noise_scaled(double factor) const;
};

}  // namespace ashimpact

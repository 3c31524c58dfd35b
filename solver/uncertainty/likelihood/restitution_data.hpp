#pragma once

#include "solver/measurement/measurement.hpp"

#include <vector>

namespace ashimpact {

/// An impact that stuck, as evidence on v_c.
struct CapturedImpact {
    double velocity;              ///< v_in as measured [m/s]
    double standard_uncertainty;  ///< of it [m/s]
};

/// What a fit of eta(e_n) sees. Weights below one take a rebound back (robust fits).
struct RestitutionData {
    std::vector<Measurement> rebounds;  ///< each with its noise
    std::vector<double> weights;
    std::vector<CapturedImpact> captures;  ///< empty: which impacts stuck is not used
    double greatest_restitution;           ///< upper end of the curve

    /// The same with all variances multiplied by @p factor.
    [[nodiscard]] RestitutionData with_noise_scaled(double factor) const;
};

}  // namespace ashimpact

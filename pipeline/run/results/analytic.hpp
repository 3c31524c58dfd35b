// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ashimpact {

/// Energy to separate a contact and the velocity that just supplies it.
struct AnalyticVelocity {
    double separation_energy = 0;  ///< W_s [J]
    double critical_velocity = 0;  ///< v_s of Eq. 30 [m/s]
};

/// The same for a cohesion of finite range, between 0 (DMT) and JKR.
struct CohesiveVelocity {
    AnalyticVelocity exact{};
    double transition_parameter = 0;  ///< lambda of Maugis [1]
    AnalyticVelocity fitted{};        ///< by a closed form
    double fitted_error = 0;          ///< relative, of its energy [1]
};

/// Analytic results of a sample: of a JKR contact that ends at pull-off, and variants.
struct SampleAnalytic : AnalyticVelocity {
    std::string name{};
    std::optional<AnalyticVelocity> load_controlled{};
    std::optional<AnalyticVelocity> with_printed_constants{};  ///< of Dong et al. 2013
    std::optional<CohesiveVelocity> maugis_dugdale{};
};

/// Result of the analytic stage, 3-analytic.json.
struct AnalyticResult {
    std::vector<SampleAnalytic> samples{};
};

}  // namespace ashimpact

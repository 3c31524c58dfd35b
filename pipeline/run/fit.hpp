// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/case/law_map.hpp"
#include "pipeline/run/stage.hpp"
#include "solver/damping/damping_polynomial.hpp"
#include "solver/inference/extrapolation/damping_curve_fit.hpp"

namespace ashimpact {

/// The damping that the fit of one law gives.
struct LawFit {
    DampingPolynomial damping;                             ///< eta(e), up to the second power
    double critical_damping;                               ///< eta(0) [unit of the damping law]
    std::optional<double> critical_damping_uncertainty{};  ///< standard [unit of the damping law]
    std::optional<DampingCurveFit> extrapolated{};         ///< of measured impacts; only what v_c needs
    std::optional<Interval> estimate{};                    ///< of the critical damping, from all impacts
};

/// The entry of a sample in 6-fit.json, as later stages read it.
struct SampleFit {
    std::string name;
    LawMap<LawFit> laws;
};

/// eta(e) over the rising branch of e(v), quadratic by default, and the critical damping eta(0); Dong et al.
/// 2013, section 4.3, Tables 2 and 3. Of measured impacts also, under "direct", the critical damping that all
/// of them support, captures included, whatever the form of eta; reconstructed ones are fitted by least
/// squares.
[[nodiscard]] StageOutput fit_stage(const Artifacts& before);

/// @param dimension of the coefficient of the damping law
[[nodiscard]] std::vector<SampleFit> read_fits(const View& result, Dimension dimension);

}  // namespace ashimpact

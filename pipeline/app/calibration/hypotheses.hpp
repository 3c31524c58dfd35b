// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/json/document.hpp"
#include "pipeline/case/case.hpp"
#include "solver/inference/calibration/calibration.hpp"

namespace ashimpact {

/// A set of free constants and what calibration makes of it.
struct CalibrationHypothesis {
    std::string name;
    std::vector<FreeConstant> free;
    std::optional<CalibrationSummary> summary{};
    bool velocities_only = false;  ///< the summary is that of the critical velocities alone
    std::string failure{};         ///< why there is none, or none of all observations
};

/// Calibrates under the hypotheses that a case allows: moduli from XRD or one contact modulus for all, one
/// density or one a size, the wall as given or free; the work of adhesion is free in all of them. A
/// hypothesis that cannot be brought to all observations is calibrated by the critical velocities alone.
/// @param problem of the case; its free constants are not used
/// @param shows_progress on standard error
[[nodiscard]] std::vector<CalibrationHypothesis> compare_hypotheses(const CalibrationProblem& problem,
                                                                    bool elastic_wall,
                                                                    bool shows_progress = false);

/// What was compared: the observations, and the names of the samples they are of.
struct ComparedObservations {
    const CalibrationProblem& problem;
    std::vector<std::string> samples;
};

/// The hypotheses beside one another, the one of least AIC marked, each with its largest residual.
[[nodiscard]] std::string hypotheses_text(const std::vector<CalibrationHypothesis>& hypotheses,
                                          const ComparedObservations& observations);
[[nodiscard]] Json hypotheses_json(const std::vector<CalibrationHypothesis>& hypotheses,
                                   const ComparedObservations& observations);

}  // namespace ashimpact

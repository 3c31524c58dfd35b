#pragma once

#include <string>
#include <vector>

#include "pipeline/case/case.hpp"
#include "pipeline/json/document.hpp"
#include "solver/calibration.hpp"

namespace ashimpact {

/// A set of free constants and what calibration makes of it.
struct CalibrationHypothesis {
    std::string name;
    std::vector<FreeConstant> free;
    std::optional<CalibrationSummary> summary{};
    std::string failure{};  ///< why there is none
};

/// Calibrates under the hypotheses that a case allows: moduli from XRD or one contact modulus for all, one
/// density or one a size, the wall as given or free; the work of adhesion is free in all of them.
/// @param problem of the case; its free constants are not used
[[nodiscard]] std::vector<CalibrationHypothesis> compare_hypotheses(const CalibrationProblem& problem,
                                                                    bool elastic_wall);

/// The hypotheses beside one another, the one of least AIC marked.
[[nodiscard]] std::string hypotheses_text(const std::vector<CalibrationHypothesis>& hypotheses);
[[nodiscard]] Json hypotheses_json(const std::vector<CalibrationHypothesis>& hypotheses);

}  // namespace ashimpact

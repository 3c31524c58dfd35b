// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace ashimpact {

/// An independent input of a computation.
struct UncertainInput {
    std::string what;                 ///< "Young's modulus of mullite"
    double value = 0;                 ///< [SI]
    double standard_uncertainty = 0;  ///< [SI]; 0 if unknown
};

/// How much one input adds to the variance of a result.
struct Contribution {
    std::string what;
    double share = 0;  ///< [1] of the variance
};

/// Uncertainty of one result.
struct PropagatedUncertainty {
    double standard_uncertainty = 0;            ///< [unit of the result]
    std::vector<Contribution> contributions{};  ///< largest first, without zeros
};

/// Propagates uncertainties linearly through a function with several results, each input independent:
/// u^2 = sum (df/dx_i u_i)^2 (JCGM 100:2008, 5.1.2), derivatives by central differences of relative step
/// 6e-6, good to about 1e-9. Validity: functions smooth over that step. Returns one entry for each result of
/// the function.
[[nodiscard]] std::vector<PropagatedUncertainty> propagate_linearly(
    const std::function<std::vector<double>(const std::vector<double>&)>& function,
    const std::vector<UncertainInput>& inputs);

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/json/document.hpp"
#include "solver/contact/law.hpp"

namespace ashimpact::report {

/// Captured impacts among those in which a variable is near one value.
struct CaptureShare {
    double value;                 ///< of the variable [SI]
    double fraction;              ///< captured [1]
    double standard_uncertainty;  ///< of the fraction, by the number of impacts [1]
};

/// Capture by one law against one variable, the other variables as they are spread.
struct CaptureCurve {
    Law law;
    std::vector<CaptureShare> shares{};
};

/// A variable of a sweep with a curve for each law.
struct CaptureVariable {
    std::string name;  ///< "work_of_adhesion"
    std::string unit;  ///< SI
    std::vector<CaptureCurve> curves{};
};

/// Capture against each variable.
struct CaptureFractions {
    std::uint64_t impacts = 0;  ///< that the curves are made of
    std::vector<CaptureVariable> variables{};
};

/// What the share of captures of a law's result rests on: ": 88 % with v_c above 500 m/s, outside the model,
/// 2.4 % within it"; empty if all of it is within the model.
[[nodiscard]] std::string captures_words(const Json& law);

/// Report of a sweep as one HTML file: capture fractions, histograms, sensitivity. The same result gives the
/// same bytes. @param artifact the whole of a sweep's result
[[nodiscard]] std::string sweep_page(const Json& artifact, const CaptureFractions& captured,
                                     const std::string& name);

}  // namespace ashimpact::report

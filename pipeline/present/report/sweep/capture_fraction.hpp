// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "pipeline/app/sweep/spec/spec.hpp"

namespace ashimpact::report {

/// Captured impacts among those in which a variable is near one value.
struct CaptureShare {
    double value;                 ///< of the variable [SI]
    double fraction;              ///< captured [1]
    double standard_uncertainty;  ///< of the fraction, by the number of impacts [1]
};

/// Capture against one variable of a sweep, by one law, the other variables as they are spread.
struct CaptureCurve {
    std::size_t law;       ///< position in the spec
    std::size_t variable;  ///< position in the spec
    std::vector<CaptureShare> shares{};
};

/// Impacts that the curves are made of, at most.
inline constexpr std::uint64_t capture_impacts = 8192;

/// The capture fraction of a sweep against each of its variables, from the first impacts of its design,
/// solved again. A variable of few values is taken value by value, others in sixteen parts of equally many
/// impacts.
[[nodiscard]] std::vector<CaptureCurve> capture_curves(const SweepSpec& spec);

}  // namespace ashimpact::report

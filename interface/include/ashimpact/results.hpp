// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

/// Results of many impacts, as Model returns them. Units: SI, in brackets. Errors: nothing here throws.
/// Threads: plain values, to be shared like any vector. Source of the model: Dong et al. 2013; docs/laws
/// names that of each law.
namespace ashimpact {
inline namespace v1 {

/// What many impacts did.
struct Impacts {
    std::vector<double> restitution;      ///< e_n = v_r/v_in; 0 for a capture [1]
    std::vector<double> contact_time;     ///< first touch to detachment; NaN for a capture [s]
    std::vector<double> approach_time;    ///< first touch to greatest overlap; NaN if never reached [s]
    std::vector<double> maximum_overlap;  ///< greatest overlap, or its limit if never reached [m]
};

/// Dampings from restitutions.
struct Dampings {
    std::vector<double> damping;               ///< NaN where none gives the restitution [unit of the law]
    std::vector<double> greatest_restitution;  ///< restitution without damping [1]
};

}  // namespace v1
}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "solver/statistics/intervals/interval.hpp"

namespace ashimpact {

/// How an interval is read from a profile of -2 ln L.
struct ProfileSearch {
    double best;       ///< position of the minimum
    double deviation;  ///< standard uncertainty there, the first guess of the width
    double rise;       ///< of the profile at the ends of the interval
    double quantile;   ///< half width of the interval in standard uncertainties
    double least;      ///< lower bound of the parameter
    double greatest;   ///< upper bound of the parameter
};

/// Interval of a parameter from its profile: where -2 ln L, minimised over all other parameters, has risen by
/// search.rise above its minimum. An end that is not reached within [least, greatest] is missing. The
/// standard uncertainty is that of a normal distribution with this interval.
/// @param profile rise above the minimum at a value of the parameter
[[nodiscard]] Interval profile_interval(const std::function<double(double)>& profile,
                                        const ProfileSearch& search);

}  // namespace ashimpact

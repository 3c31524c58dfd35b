// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/inference/impacts/measurement.hpp"

namespace ashimpact {

/// How neighbouring rebounds are averaged, in files of thousands of impacts.
struct Binning {
    int impacts_per_bin = 0;  ///< rebounds in each bin; 0: bins have a width
    double width = 0.0;       ///< width of the bins in v_in [m/s]; exactly one of both is given
};

/// The set with the rebounds of each bin replaced by their mean in both velocities and its uncertainty. If
/// noise is known the weight of a rebound is the inverse of the sum of its two variances. Captures stay as
/// they are. A mean of points on a curved e(v) lies beside the curve, so bins should be narrow compared to
/// its structure.
/// @throws InputError unless exactly one option is given
[[nodiscard]] MeasurementSet binned(const MeasurementSet& set, const Binning& binning);

}  // namespace ashimpact

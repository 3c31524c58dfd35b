#pragma once

#include "solver/measurement/measurement.hpp"

namespace ashimpact {

/// How neighbours in velocity are averaged; for files of thousands of impacts. Exactly one of both is given.
struct Binning {
    int impacts_per_bin = 0;  ///< rebounds in each bin
    double width = 0.0;       ///< width of the bins in v_in [m/s]
};

/// The set with the rebounds of each bin replaced by their mean in both velocities, weighted by their noise
/// if known, and its uncertainty; captures stay as they are. A mean of points on a bent curve lies off the
/// curve: bins should be narrow against the structure of e(v).
/// @throws InputError unless exactly one option is given
[[nodiscard]] MeasurementSet binned(const MeasurementSet& set, const Binning& binning);

}  // namespace ashimpact

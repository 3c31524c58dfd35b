// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/run/results/run.hpp"

namespace ashimpact {

/// Tables 2 to 4 of Dong et al. 2013 for a sample by the paper's own steps (Eqs. 31 to 34) beside exact
/// impacts: the dampings of the rebounds on the rising branch, a e^2 + b e + c through them by least squares,
/// and the critical velocity of c. Laws without this scheme are left out; where the step is too long for an
/// impact, a note gives the reason.
/// @return empty unless the case has the step, and for other damping laws than the constant one
[[nodiscard]] LawMap<SchemeBesideExact> paper_scheme(const Case& data, const SampleContact& contact,
                                                     const SampleDamping& dampings, StageRecord& record);

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/case/case.hpp"
#include "pipeline/run/results/contact.hpp"
#include "pipeline/run/results/note.hpp"

namespace ashimpact {

/// Contact modulus, effective radius and mass, and work of adhesion; Dong et al. 2013, Eqs. 6, 7 and 11.
[[nodiscard]] ContactResult contact_stage(const Case& data, const ModulusResult& moduli, StageRecord& record);

}  // namespace ashimpact

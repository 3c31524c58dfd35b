// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/run/results/contact.hpp"
#include "pipeline/run/results/note.hpp"

namespace ashimpact {

/// Energy to separate a JKR contact and the velocity that just supplies it; Dong et al. 2013, Eqs. 28-30,
/// read with the contact modulus and the work of adhesion.
[[nodiscard]] AnalyticResult analytic_stage(const ContactResult& contacts, StageRecord& record);

}  // namespace ashimpact

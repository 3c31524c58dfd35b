// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/run/results/contact.hpp"
#include "pipeline/run/results/damping.hpp"
#include "pipeline/run/results/note.hpp"
#include "pipeline/run/uncertainty/contact_models.hpp"

namespace ashimpact {

/// The damping that gives back each restitution, with its uncertainty and the reachable range, the parts of
/// eta(v_in) and the rising branch; Dong et al. 2013, section 4.2. Captures (restitution 0) bound the damping
/// but do not fix it: they are listed apart.
[[nodiscard]] DampingStageResult damping_stage(const Case& data, const ContactResult& contacts,
                                               const RestitutionResult& restitutions, ContactModels& models,
                                               StageRecord& record);

}  // namespace ashimpact

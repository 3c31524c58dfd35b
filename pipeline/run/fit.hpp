// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/run/results/contact.hpp"
#include "pipeline/run/results/damping.hpp"
#include "pipeline/run/results/note.hpp"
#include "pipeline/run/uncertainty/contact_models.hpp"

namespace ashimpact {

/// eta(e) over the rising branch of e(v), quadratic by default, and the critical damping eta(0); Dong et al.
/// 2013, section 4.3, Tables 2 and 3. Of measured impacts also the critical damping that all of them support,
/// captures included, whatever the form of eta; reconstructed ones are fitted by least squares.
[[nodiscard]] FitResult fit_stage(const Case& data, const ContactResult& contacts,
                                  const RestitutionResult& restitutions, const DampingStageResult& dampings,
                                  ContactModels& models, StageRecord& record);

}  // namespace ashimpact

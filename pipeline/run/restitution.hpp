// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/run/results/contact.hpp"
#include "pipeline/run/results/note.hpp"

namespace ashimpact {

/// The restitution data of each sample: as measured, or reconstructed from published fits eta(e) by searching
/// the velocity at which an impact with eta(e) gives e back.
[[nodiscard]] RestitutionResult restitution_stage(const Case& data, const ContactResult& contacts,
                                                  StageRecord& record);

}  // namespace ashimpact

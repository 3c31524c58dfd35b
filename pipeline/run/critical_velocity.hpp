// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/run/results/contact.hpp"
#include "pipeline/run/results/critical_velocity.hpp"
#include "pipeline/run/results/damping.hpp"
#include "pipeline/run/results/note.hpp"
#include "pipeline/run/uncertainty/contact_models.hpp"

namespace ashimpact {

/// The dynamic critical velocity at the critical damping (Dong et al. 2013, section 4.3, Table 4) with its
/// interval, what dominates it, the regime of the impact, and the measured one beside it.
[[nodiscard]] CriticalVelocityResult critical_velocity_stage(const Case& data, const ModulusResult& moduli,
                                                             const ContactResult& contacts,
                                                             const RestitutionResult& restitutions,
                                                             const FitResult& fits, ContactModels& models,
                                                             StageRecord& record);

/// The critical velocity of one damping and the regime of the impact, without an interval.
[[nodiscard]] LawCriticalVelocity law_critical_velocity(const CriticalVelocityProblem& problem);

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "pipeline/run/results/comparison.hpp"
#include "pipeline/run/results/contact.hpp"
#include "pipeline/run/results/critical_velocity.hpp"
#include "pipeline/run/results/damping.hpp"
#include "pipeline/run/results/histories.hpp"
#include "pipeline/run/results/note.hpp"

namespace ashimpact {

/// The results that are compared.
struct ComparedResults {
    const ModulusResult& moduli;
    const ContactResult& contacts;
    const AnalyticResult& analytic;
    const DampingStageResult& dampings;
    const FitResult& fits;
    const CriticalVelocityResult& velocities;
    const HistoriesResult& histories;
};

/// Compares analytic, dynamic and measured critical velocities, and published values with ours, and states in
/// words what the ratio of dynamic to analytic velocities means.
/// @param reasons stages whose notes explain why a law has no damping, the most telling first
[[nodiscard]] ComparisonResult comparison_stage(const Case& data, const ComparedResults& results,
                                                const std::vector<const StageRecord*>& reasons,
                                                StageRecord& record);

}  // namespace ashimpact

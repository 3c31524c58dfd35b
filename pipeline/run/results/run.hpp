// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pipeline/case/case.hpp"
#include "pipeline/case/input_files.hpp"
#include "pipeline/case/values.hpp"
#include "pipeline/run/results/comparison.hpp"
#include "pipeline/run/results/contact.hpp"
#include "pipeline/run/results/critical_velocity.hpp"
#include "pipeline/run/results/damping.hpp"
#include "pipeline/run/results/histories.hpp"
#include "pipeline/run/results/note.hpp"
#include "solver/inference/critical_velocity_uncertainty.hpp"

namespace ashimpact {

/// A finished run. The samples of every result are those of the case, in its order.
struct Run {
    Case data{};
    std::string version{}, revision{};   ///< of the program that wrote it
    std::vector<InputFile> inputs{};     ///< the case file and what it names
    std::vector<StageRecord> records{};  ///< of the case and the stages, in their order
    ModulusResult modulus{};
    ContactResult contact{};
    AnalyticResult analytic{};
    RestitutionResult restitution{};
    DampingStageResult damping{};
    FitResult fit{};
    CriticalVelocityResult critical_velocity{};
    HistoriesResult histories{};
    ComparisonResult comparison{};

    /// The record of an artifact, or null.
    [[nodiscard]] const StageRecord* record(std::string_view file) const {
        for (const StageRecord& each : records)
            if (each.file == file) return &each;
        return nullptr;
    }
};

}  // namespace ashimpact

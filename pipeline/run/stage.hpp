// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "pipeline/run/results/run.hpp"
#include "pipeline/run/uncertainty/contact_models.hpp"

namespace ashimpact {

/// Files of a run, in the order in which they are written; a run starts from the case.
inline constexpr std::string_view case_artifact = "0-case.json";
inline constexpr std::string_view modulus_artifact = "1-modulus.json";
inline constexpr std::string_view contact_artifact = "2-contact.json";
inline constexpr std::string_view analytic_artifact = "3-analytic.json";
inline constexpr std::string_view restitution_artifact = "4-restitution.json";
inline constexpr std::string_view damping_artifact = "5-damping.json";
inline constexpr std::string_view fit_artifact = "6-fit.json";
inline constexpr std::string_view critical_velocity_artifact = "7-critical-velocity.json";
inline constexpr std::string_view histories_artifact = "8-histories.json";
inline constexpr std::string_view comparison_artifact = "comparison.json";
inline constexpr std::string_view manifest_artifact = "manifest.json";

/// One step of a run: a pure function of the results it reads.
struct Stage {
    std::string_view name;                ///< "modulus"
    std::string_view file;                ///< "1-modulus.json"; its schema is the file's stem
    std::vector<std::string_view> reads;  ///< files of earlier stages
    /// Sets the result of this stage from those of the stages it reads.
    void (*compute)(Run& run, ContactModels& models, StageRecord& record);
};

/// The stages after the case itself, in order.
[[nodiscard]] const std::vector<Stage>& stages();

/// Computes the result of a stage and adds its record to the run.
void compute_stage(const Stage& stage, Run& run, ContactModels& models);

}  // namespace ashimpact

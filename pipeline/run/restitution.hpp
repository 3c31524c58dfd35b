// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/run/stage.hpp"
#include "solver/contact/law.hpp"
#include "solver/inference/impacts/measurement.hpp"

namespace ashimpact {

/// Restitution against incident velocity that stands for some laws.
struct RestitutionSeries {
    std::vector<Law> laws{};
    std::string origin{};  ///< "measured" or "reconstructed"
    std::string source{};
    MeasurementSet impacts{};  ///< in their order; reconstructed ones without noise
    /// Of a reconstructed series: standard uncertainty of each coefficient behind it, its rounding [kg/s].
    std::optional<double> coefficient_uncertainty{};
};

/// The entry of a sample in 4-restitution.json, as later stages read it.
struct SampleRestitution {
    std::string name;
    std::vector<RestitutionSeries> series;

    /// The series of a law, or null.
    [[nodiscard]] const RestitutionSeries* of(Law law) const;
};

/// The restitution data of each sample: as measured, or reconstructed from published fits eta(e) by asking at
/// which velocity an impact with eta(e) gives e back.
[[nodiscard]] StageOutput restitution_stage(const Artifacts& before);

[[nodiscard]] std::vector<SampleRestitution> read_restitutions(const View& result);

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/case/case.hpp"
#include "pipeline/case/listed_impacts.hpp"
#include "solver/contact/law.hpp"
#include "solver/inference/impacts/measurement.hpp"

namespace ashimpact {

/// Restitution against incident velocity that serves several laws.
struct RestitutionSeries {
    std::vector<Law> laws{};
    Origin origin = Origin::measured;  ///< measured or reconstructed
    std::string source{};
    ListedImpacts columns{};
    MeasurementSet impacts{};  ///< the impacts of these columns, in their order
    /// Of a reconstructed series: standard uncertainty of each coefficient behind it, its rounding [kg/s].
    std::optional<double> coefficient_uncertainty{};
};

/// The restitution data of a sample.
struct SampleRestitution {
    std::string name{};
    std::vector<RestitutionSeries> series{};

    /// The series of a law, or null.
    [[nodiscard]] const RestitutionSeries* of(Law law) const {
        for (const RestitutionSeries& each : series)
            if (std::find(each.laws.begin(), each.laws.end(), law) != each.laws.end()) return &each;
        return nullptr;
    }
};

/// Result of the restitution stage, 4-restitution.json.
struct RestitutionResult {
    std::vector<SampleRestitution> samples{};
};

}  // namespace ashimpact

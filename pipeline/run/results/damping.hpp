// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/case/case.hpp"
#include "pipeline/case/law_map.hpp"
#include "solver/inference/impacts/inverted_impacts.hpp"

namespace ashimpact {

/// An impact whose restitution no damping gives.
struct UnreachableImpact {
    std::size_t number = 0;  ///< in the series, from 1 on
    double velocity = 0;     ///< [m/s]
    double restitution = 0;  ///< [1]
    std::string reason{};    ///< in words
};

/// A part of eta(v_in) with the velocities between which it lies.
struct PartRange {
    DampingPart part = DampingPart::flat;
    Quantity from{}, to{};  ///< with a standard uncertainty where it is a boundary between parts [m/s]
};

/// Where restitution rises with velocity.
struct RisingRange {
    double to = 0;              ///< its greatest velocity [m/s]
    bool falls_beyond = false;  ///< restitution falls at faster impacts; else the data end there
};

/// Damping against restitution and velocity, by one law.
struct DampingSeries {
    Origin origin = Origin::measured;            ///< of the restitution data
    std::vector<double> number{};                ///< of each rebound in the series, from 1 on
    std::vector<double> velocity{};              ///< [m/s]
    std::vector<double> restitution{};           ///< above 0 [1]
    std::vector<double> greatest_restitution{};  ///< without damping, at this velocity [1]
    std::vector<double> damping{};               ///< [unit of the damping law]
    std::vector<double> damping_uncertainty{};   ///< standard; empty: not known [unit of the damping law]
    std::vector<double> contact_time{};          ///< [s]
    std::vector<double> captured_at{};           ///< v_in of captures [m/s]
    std::vector<double> capturing_damping{};     ///< least that captures; empty: not known [unit of the law]
    std::vector<UnreachableImpact> unreachable{};
    std::vector<PartRange> parts{};       ///< from slow to fast
    std::string parts_note{};             ///< why there are none
    std::vector<std::size_t> outliers{};  ///< their numbers
    std::optional<RisingRange> rising{};
    std::string rising_note{};  ///< why there is none
    double map_accuracy = 0;    ///< of restitutions read from a map; 0: solved [1]
};

/// The dampings of a sample.
struct SampleDamping {
    std::string name{};
    LawMap<DampingSeries> laws{};
};

/// The columns of inverted impacts: rebounds within reach, captures, and impacts that no damping gives.
[[nodiscard]] DampingSeries inverted_series(const std::vector<InvertedImpact>& impacts);

/// Sets parts and outliers of a series. @param impacts whose range the parts cover
void set_parts(const DampingParts& parts, const std::vector<InvertedImpact>& impacts, DampingSeries& series);

/// Result of the damping stage, 5-damping.json.
struct DampingStageResult {
    std::vector<SampleDamping> samples{};
};

}  // namespace ashimpact

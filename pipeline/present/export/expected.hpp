// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/json/document.hpp"
#include "pipeline/present/export/folder.hpp"

namespace ashimpact {

/// An impact that the other code has to reproduce.
struct ExpectedImpact {
    double diameter;  ///< [m]
    double velocity;  ///< [m/s]
    Outcome outcome;
    double restitution;                     ///< 0 for a capture [1]
    std::optional<double> contact_time;     ///< none for a capture [s]
    std::optional<double> maximum_overlap;  ///< [m]
};

/// Impacts of the smallest, the largest, the reference size and one between, at 0.99 and 1.01 v_c, at
/// multiples of v_c up to the largest velocity, and at the subject's own velocity.
[[nodiscard]] std::vector<ExpectedImpact> expected_impacts(const ExportSubject& subject);

/// expected.json. @p more has what the comparing script of a code needs beside the impacts.
[[nodiscard]] ExportFile expected_json(const ExportSubject& subject, std::string_view code, const Json& more);

}  // namespace ashimpact

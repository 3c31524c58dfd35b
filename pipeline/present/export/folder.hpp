// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/json/document.hpp"
#include "pipeline/present/export/subject.hpp"

namespace ashimpact {

/// A file of an exported folder, its name without any folder.
struct ExportFile {
    std::string name;
    std::string content;
};
using ExportFolder = std::vector<ExportFile>;

/// The text for each @key@ of a template.
using TemplateValues = std::map<std::string, std::string, std::less<>>;

/// The template templates/<path> with every @key@ replaced. Values are numbers and names of this
/// program, never texts of the user, which the other program might read as its own syntax.
/// @throws std::logic_error for a key without a value, a programming error
[[nodiscard]] std::string filled(std::string_view path, const TemplateValues& values);

/// The file templates/<path> as it is.
[[nodiscard]] ExportFile unchanged(std::string_view path);

/// A number that every code reads back as the same double: 17 significant digits.
[[nodiscard]] std::string exact(double value);

/// Values that every template may use: law, detachment, damping, E*, w, sizes, version.
[[nodiscard]] TemplateValues common_values(const ExportSubject& subject);

/// assumptions.md: sources of the numbers, their conversions, limits of the model.
/// @param conversions a line each
[[nodiscard]] ExportFile assumptions(const ExportSubject& subject,
                                     const std::vector<std::string>& conversions);

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

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "core/json/view.hpp"
#include "pipeline/case/case.hpp"
#include "pipeline/case/input_files.hpp"

/// Readers of the parts of a case. The document conforms to the schema; what a schema cannot say is checked
/// here. Errors: InputError with the JSON pointer.
namespace ashimpact {

/// A quantity with its origin.
[[nodiscard]] Stated read_stated(const View& node, Dimension dimension);
/// A quantity with its origin, which must be positive.
[[nodiscard]] Stated read_positive(const View& node, std::string_view name, Dimension dimension);
[[nodiscard]] Stated read_poisson_ratio(const View& node);

[[nodiscard]] Wall read_wall(const View& node);
/// Diameter, and density or mass, of a second sphere.
[[nodiscard]] PartnerSphere read_partner(const View& node);
[[nodiscard]] Adhesion read_adhesion(const View& node);
[[nodiscard]] Porosity read_porosity(const View& node);

/// The analysis of a sample with its source and the warnings of its file.
struct ReadAnalysis {
    Analysis analysis;
    std::string source;
    std::vector<Finding> warnings;
};
[[nodiscard]] ReadAnalysis read_analysis(const View& node, InputFiles& files);

/// Restitution data; @p published serves a reconstruction that names no fits of its own, @p camera impacts
/// whose uncertainty nothing says.
[[nodiscard]] RestitutionSource read_restitution(const View& node,
                                                 const std::optional<PublishedSample>& published,
                                                 InputFiles& files, const std::optional<View>& camera);

/// Published values; those without an uncertainty get that of the rounding of their last digit, u =
/// d/sqrt(12).
[[nodiscard]] PublishedSample read_published(const View& node, const std::string& source,
                                             const std::optional<View>& rounding);

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/tables/coverage.hpp"

namespace ashimpact::xrd {

/// What a column of a table holds.
enum class Role {
    other,
    sample,
    phase,
    weight,
    volume,
    uncertainty,
    density,
    intensity,
    ratio,  ///< reference intensity ratio
    ratio_uncertainty,
    standard,  ///< known weight fraction of an added internal standard
};

/// Whether a heading states per cent or a fraction.
enum class Scale { not_stated, per_cent, fraction };

/// The parts of a heading: "Weight [wt.%]" is a weight in per cent.
struct Heading {
    std::string text;  ///< without the unit in brackets
    std::string unit;  ///< what stood in brackets; may be empty
    Role role = Role::other;
    Scale scale = Scale::not_stated;
    std::string written{};      ///< the whole heading as in the file
    StatedCoverage coverage{};  ///< what it says of its uncertainties
};

[[nodiscard]] Heading read_heading(std::string_view text);

/// Whether a heading or a phase name means the total of all phases, or of the crystalline ones.
[[nodiscard]] bool means_total(std::string_view name);
[[nodiscard]] bool means_crystalline_total(std::string_view name);

/// The phase whose uncertainty a heading such as "Quartz esd" holds; nothing for any other heading.
[[nodiscard]] std::optional<std::string> phase_of_uncertainty(std::string_view heading);

}  // namespace ashimpact::xrd

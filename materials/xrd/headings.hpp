// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core/quantities/names.hpp"
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

/// What a row of a table of fractions holds, by its name.
enum class RowMeaning { phase, total, crystalline_total };

/// Whether a heading states per cent or a fraction.
enum class Scale { not_stated, per_cent, fraction };

/// The parts of a heading: "Weight [wt.%]" is a weight in per cent.
struct Heading {
    std::string text;  ///< without the unit in brackets
    std::string unit;  ///< what stood in brackets; may be empty
    Role role = Role::other;
    Scale scale = Scale::not_stated;
    std::string written{};      ///< the whole heading as in the file
    StatedCoverage coverage{};  ///< of its uncertainties
};

[[nodiscard]] Heading read_heading(std::string_view text);

/// A total, of all phases or of the crystalline ones, unless the name is that of a phase.
[[nodiscard]] RowMeaning meaning_of_row(std::string_view name);

/// The phase whose uncertainty a heading such as "Quartz esd" holds; nothing for any other heading.
[[nodiscard]] std::optional<std::string> phase_of_uncertainty(std::string_view heading);

}  // namespace ashimpact::xrd

template <>
struct ashimpact::Names<ashimpact::xrd::Role> {
    static constexpr std::string_view kind = "column";
    static constexpr std::array<std::string_view, 11> all{
        "other",       "sample",  "phase",     "weight", "volume",
        "uncertainty", "density", "intensity", "ratio",  "ratio_uncertainty",
        "standard"};
};

template <>
struct ashimpact::Names<ashimpact::xrd::RowMeaning> {
    static constexpr std::string_view kind = "row";
    static constexpr std::array<std::string_view, 3> all{"phase", "total", "crystalline_total"};
};

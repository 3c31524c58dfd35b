// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/quantities/names.hpp"
#include "core/quantities/quantity.hpp"
#include "core/tables/number_marks.hpp"
#include "core/tables/text_lines.hpp"
#include "core/tables/vocabulary.hpp"

namespace ashimpact::xrd {

/// What a column of a table contains.
enum class Role {
    other,
    sample,
    phase,
    weight,  ///< fraction by weight
    volume,  ///< fraction by volume
    uncertainty,
    density,
    intensity,
    ratio,  ///< reference intensity ratio
    ratio_uncertainty,
    standard,  ///< known weight fraction of an added internal standard
    measure,   ///< neither a fraction nor the name of a sample: "FWHM", "counts", "Mol-%"
};

/// What a row of a table of fractions contains.
enum class RowMeaning { phase, total, crystalline_total };

/// Whether the numbers under a heading are per cent or fractions.
enum class Scale { not_stated, per_cent, fraction, ppm };

/// What the unit of a heading states of the numbers under it.
enum class HeadingUnit {
    none,      ///< there is no unit
    fraction,  ///< "%", "1": of weight or volume
    weight,    ///< "wt%", "ppm"
    volume,    ///< "vol%"
    other,     ///< "Mol-%", "counts", "mg/g"
};

/// The parts of a heading: "Weight [wt.%]" is a weight in per cent.
struct Heading {
    std::string text;  ///< without unit and coverage
    std::string unit;  ///< without its brackets; may be empty
    HeadingUnit states = HeadingUnit::none;
    Role role = Role::other;
    Scale scale = Scale::not_stated;
    bool of_crystalline = false;  ///< "wt% (crystalline)": fractions of the crystalline part
    std::string written{};        ///< the whole heading as in the file
    StatedCoverage coverage{};    ///< of the uncertainties under it
};

[[nodiscard]] Heading read_heading(std::string_view text);

/// What the row of a name contains: a total of all or of the crystalline phases, else a phase.
[[nodiscard]] RowMeaning meaning_of_row(std::string_view name);

/// The numbers of one phase in one sample, as written except for density; uncertainties are standard ones.
struct Entry {
    std::string sample;
    std::string phase;
    std::size_t line = 0;
    std::optional<PrintedNumber> amount{};  ///< by weight or volume
    std::optional<double> uncertainty{};    ///< of the amount
    std::optional<double> density{};        ///< [kg/m3]
    std::optional<PrintedNumber> intensity{};
    std::optional<PrintedNumber> ratio{};
    std::optional<double> ratio_uncertainty{};
    std::optional<PrintedNumber> standard{};  ///< known weight fraction
};

/// A table cut into cells.
struct Table {
    std::size_t heading_line = 0;  ///< number of the line in the file
    std::vector<Heading> headings;
    std::vector<TableRow> rows;
    char separator = ',';
    NumberMarks marks{};  ///< of the numbers in the rows
    std::vector<Finding> warnings{};

    /// Index of the first column of a role.
    [[nodiscard]] std::optional<std::size_t> column(Role role) const {
        for (std::size_t i = 0; i < headings.size(); ++i)
            if (headings[i].role == role) return i;
        return std::nullopt;
    }
    [[nodiscard]] bool has(Role role) const { return column(role).has_value(); }
};

/// How the entries of a table are arranged.
enum class Layout {
    fractions,            ///< a row per phase: phase, weight or volume
    peaks,                ///< a row per phase: phase, intensity, reference intensity ratio
    one_column_a_phase,   ///< and a row per sample
    one_column_a_sample,  ///< and a row per phase
};

/// Whether one of the first lines can be the heading of a table.
[[nodiscard]] bool has_heading(const TextLines& file);

/// Cuts a file into heading and rows. Errors: InputError at the line.
[[nodiscard]] Table parse_table(const TextLines& file, std::optional<DecimalMark> decimal);

/// Whether the amounts are fractions by volume. Errors: InputError at the heading for amounts in other units,
/// and for fractions of both kinds.
[[nodiscard]] bool by_volume(const Table& table, Layout layout);

/// The layout of a table, from its headings. Errors: InputError at the heading.
[[nodiscard]] Layout layout_of(const Table& table);

/// All entries, row by row. Errors: InputError at the line of the entry.
[[nodiscard]] std::vector<Entry> entries_of(const Table& table, Layout layout);

}  // namespace ashimpact::xrd

template <>
struct ashimpact::Names<ashimpact::xrd::Role> {
    static constexpr std::string_view kind = "column";
    static constexpr std::array<std::string_view, 12> all{
        "other",       "sample",  "phase",     "weight", "volume",
        "uncertainty", "density", "intensity", "ratio",  "ratio_uncertainty",
        "standard",    "measure"};
};

template <>
struct ashimpact::Names<ashimpact::xrd::RowMeaning> {
    static constexpr std::string_view kind = "row";
    static constexpr std::array<std::string_view, 3> all{"phase", "total", "crystalline_total"};
};

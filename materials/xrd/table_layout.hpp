// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/quantities/quantity.hpp"
#include "core/tables/number_marks.hpp"
#include "core/tables/text_lines.hpp"
#include "materials/xrd/table_headings.hpp"

namespace ashimpact::xrd {

/// The numbers of one phase in one sample, as written except for density; uncertainties are standard ones.
struct Entry {
    std::string sample;
    std::string phase;
    std::size_t line = 0;
    std::optional<PrintedNumber> amount{};  ///< by weight or volume
    std::optional<double> uncertainty{};    ///< of the amount
    bool uncertainty_in_per_cent = false;   ///< by a sign in its cell
    std::optional<double> density{};        ///< [kg/m3]
    std::optional<PrintedNumber> intensity{};
    std::optional<PrintedNumber> ratio{};
    std::optional<double> ratio_uncertainty{};
    std::optional<PrintedNumber> standard{};  ///< known weight fraction
    PhaseMark mark = PhaseMark::none;
    std::string without_number{};  ///< the cell of an amount that states none: "< 3", "traces"
};

/// Names of rows with no other cell above rows with numbers, "XRF:", by their lines.
using BlankRows = std::map<std::size_t, std::string>;

/// A table cut into cells.
struct Table {
    std::size_t heading_line = 0;  ///< number of the line in the file
    std::vector<Heading> headings;
    std::vector<TableRow> rows;
    char separator = ',';
    NumberMarks marks{};        ///< of the numbers in the rows
    std::string crystalline{};  ///< what states that the amounts are of the crystalline part; empty: nothing
    std::vector<Finding> warnings{};
    std::vector<TextBeside> texts{};  ///< titles, comments and notes
    BlankRows blank_rows{};

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

/// The coverage that the label of a row of uncertainties states: "esd", "FA1 esd", "2s"; none of other rows.
[[nodiscard]] std::optional<StatedCoverage> coverage_of_row(std::string_view label, std::string_view sample);

/// Takes rows of uncertainties, "esd" or "FA1 esd" behind each sample from the row @p first on, into the
/// cells above them. @param label column of the names of the samples
/// @return by what they are to be divided for standard ones: 2 for "U (k=2)"
[[nodiscard]] double take_rows_of_uncertainties(std::vector<TableRow>& rows, std::size_t first,
                                                std::size_t label, std::string_view code,
                                                std::vector<Finding>& warnings);

/// Whether a row without amounts in a table of phases or oxides heads those below it without another meaning:
/// "Crystalline phases", "Major oxides:". @param kind "phases" or "oxides"
[[nodiscard]] bool heads_alike(std::string_view label, std::string_view kind);

/// Refuses the heading of the names where a part of it is not understood and may change the amounts: "Phase
/// (values / 10)", "Oxide (at.%)", but not "Phase (ICSD)" and "Phase [wt%]". @throws InputError at its line
void refuse_unread_heading(const Heading& heading, std::size_t line);

/// Whether a cell of a row other than its name holds a number.
[[nodiscard]] bool holds_numbers(const TableRow& row, std::size_t label);

/// Refuses an uncertainty without a sign beside an amount with one, "0.012" beside "21.3 %", that may be a
/// fraction or per cent: a spreadsheet shows cells in the format of per cent a hundred times larger.
/// @throws InputError at its cell
void refuse_bare_uncertainty(std::string_view amount_text, std::string_view text, const PrintedNumber& amount,
                             double uncertainty, std::size_t line, std::size_t column);

/// Cuts a file into heading and rows. Errors: InputError at the line.
[[nodiscard]] Table parse_table(const TextLines& file, std::optional<DecimalMark> decimal);

/// Whether the amounts are fractions by volume. Errors: InputError at the heading for amounts in other units,
/// for fractions of both kinds, and where some columns are in ppm or per mille and others are not.
[[nodiscard]] bool by_volume(const Table& table, Layout layout);

/// The layout of a table, from its headings. Errors: InputError at the heading.
[[nodiscard]] Layout layout_of(const Table& table);

/// All entries, row by row. Errors: InputError at the line of the entry.
[[nodiscard]] std::vector<Entry> entries_of(const Table& table, Layout layout);

}  // namespace ashimpact::xrd

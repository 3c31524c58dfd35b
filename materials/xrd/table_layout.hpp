// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/quantities/quantity.hpp"
#include "core/tables/text_lines.hpp"
#include "materials/xrd/headings.hpp"

namespace ashimpact::xrd {

/// One entry of the table, whatever its layout.
struct Entry {
    std::string sample;
    std::string phase;
    std::size_t line = 0;
    std::optional<PrintedNumber> amount{};
    std::optional<double> uncertainty{};
    std::optional<double> density{};  ///< [kg/m3]
    std::optional<PrintedNumber> intensity{};
    std::optional<PrintedNumber> ratio{};
    std::optional<double> ratio_uncertainty{};
    std::optional<PrintedNumber> standard{};  ///< known weight
};

/// A table cut into cells.
struct Table {
    std::size_t heading_line = 0;
    std::vector<Heading> headings;
    std::vector<TableRow> rows;
    char separator = ',';
    std::vector<Finding> warnings{};

    [[nodiscard]] std::optional<std::size_t> column(Role role) const {
        for (std::size_t i = 0; i < headings.size(); ++i)
            if (headings[i].role == role) return i;
        return std::nullopt;
    }
    [[nodiscard]] bool has(Role role) const { return column(role).has_value(); }
};

/// How the entries of a table are arranged.
enum class Layout {
    fractions,            ///< one row a phase: phase, weight or volume
    peaks,                ///< one row a phase: phase, intensity, rir
    one_column_a_phase,   ///< one row a sample
    one_column_a_sample,  ///< one row a phase
};

/// Whether one of the first lines is a heading of a table.
[[nodiscard]] bool has_heading(const TextLines& file);

/// Cuts a file into heading and rows. Errors: InputError at the line.
[[nodiscard]] Table parse_table(const TextLines& file);

/// The arrangement of a table, from its headings. Errors: InputError at the heading.
[[nodiscard]] Layout layout_of(const Table& table);

/// All entries, row by row. Errors: InputError at the line.
[[nodiscard]] std::vector<Entry> entries_of(const Table& table, Layout layout);

}  // namespace ashimpact::xrd

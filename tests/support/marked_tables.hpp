// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "core/text/error.hpp"
#include "tests/support/checks.hpp"

namespace ashimpact::test {

using Cells = std::vector<std::vector<std::string>>;

/// A text that is in no vocabulary.
inline constexpr const char* marker = "QQMARK";

/// A table with semicolons.
inline std::string csv_of(const Cells& rows) {
    std::string text;
    for (const auto& row : rows) {
        for (std::size_t k = 0; k < row.size(); ++k) text += (k > 0 ? ";" : "") + row[k];
        text += '\n';
    }
    return text;
}

/// Calls @p visit with the table for each place that a person may write the marker in: each empty cell, a
/// column behind the others with and without a heading, and a cell of a row of its own, between all others
/// and behind a blank line, whose first cell is empty or one of some labels.
inline void for_each_marked(const Cells& rows, const std::function<void(const std::string& table)>& visit) {
    const std::size_t width = rows.front().size();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (std::size_t k = 0; k < width; ++k) {
            Cells marked = rows;
            if (!rows[i][k].empty()) continue;
            marked[i][k] = marker;
            visit(csv_of(marked));
        }
        for (const char* heading : {"", "Comment"}) {
            if (i == 0) continue;
            Cells marked = rows;
            for (auto& row : marked) row.emplace_back();
            marked[0].back() = heading;
            marked[i].back() = marker;
            visit(csv_of(marked));
        }
    }
    for (const char* label : {"", "Note", "Comment", "Total", "LOI", "Mean", "*", "Rwp", "Date", "xyz"})
        for (std::size_t k = label[0] == '\0' ? 0 : 1; k < width; ++k) {
            std::vector<std::string> row(width);
            row[0] = label;
            row[k] = marker;
            for (std::size_t i = 1; i <= rows.size(); ++i) {
                Cells marked = rows;
                marked.insert(marked.begin() + static_cast<std::ptrdiff_t>(i), row);
                visit(csv_of(marked));
            }
            visit(csv_of(rows) + "\n" + csv_of({row}));
        }
}

/// Checks that each table with the marker is refused, or that the marker is in what its reader returns.
/// @param told names, remarks and the like of a table @throws InputError for one that is refused
inline void check_marked(const Cells& rows, const std::function<std::string(const std::string&)>& told) {
    for_each_marked(rows, [&](const std::string& table) {
        std::string text;
        try {
            text = told(table);
        } catch (const InputError&) {
            return;
        }
        CHECK_MESSAGE(contains(text, marker), table);
    });
}

}  // namespace ashimpact::test

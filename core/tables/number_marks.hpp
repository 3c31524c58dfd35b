// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/finding.hpp"
#include "core/quantities/names.hpp"
#include "core/quantities/quantity.hpp"

namespace ashimpact {

/// The mark before the decimals of a number.
enum class DecimalMark { point, comma };

template <>
struct Names<DecimalMark> {
    static constexpr std::string_view kind = "decimal mark";
    static constexpr std::array<std::string_view, 2> all{"point", "comma"};
};

/// What a user states of a table beside its file.
struct TableOptions {
    std::string sheet{};                   ///< of a spreadsheet; empty: the only one that holds such a table
    std::optional<DecimalMark> decimal{};  ///< none: the numbers of the table decide
};

/// Which mark separates the decimals in the numbers of a table and which one groups their digits. "1.234" and
/// "1,234" alone have two readings; the other numbers of the table decide between them, or nothing does.
/// Blanks and apostrophes between digits group them: "1 234", "1'234,5".
class NumberMarks {
  public:
    /// @param decimal the mark that the user states: it decides between two readings, and a number with the
    /// other one is refused @param of_sheet whether the file is a spreadsheet, most of whose numbers have no
    /// mark
    explicit NumberMarks(std::optional<DecimalMark> decimal = {}, bool of_sheet = false)
        : decimal_(decimal), of_sheet_(of_sheet) {}

    /// States, before its cells are seen, that numbers of a column may be thousands: "1.234" alone, or beside
    /// whole numbers, then has two readings. Of other columns, as of fractions or of velocities in m/s, it is
    /// a little above one.
    void may_hold_thousands(std::size_t column) { columns_[column].thousands = true; }
    /// States that no number of a column reaches a thousand, as no fraction does: "12,500" is 12.5 there.
    void stays_below_thousand(std::size_t column) { columns_[column].below_thousand = true; }
    /// States that a column holds uncertainties: "±0.4" is 0.4 there.
    void holds_uncertainties(std::size_t column) { columns_[column].uncertainties = true; }
    /// Takes the numbers of a cell into account. @param column of the cell, any number
    void see(std::string_view cell, std::size_t column);
    /// Reads a cell as read_number(). @throws InputError with both readings where nothing decides, for a mark
    /// other than the stated one, and for an uncertainty in per cent of a value that is not: "12.3 ± 3 %", or
    /// may be: "12.3 % ± 3 %"
    [[nodiscard]] std::optional<PrintedNumber> read(std::string_view cell, std::size_t column) const;

    /// A remark on the first number read as grouped because of other columns; none without one.
    [[nodiscard]] std::vector<Finding> findings(std::string_view code) const;

  private:
    /// How often the numbers of a column have these forms.
    struct Column {
        std::size_t point_may_group = 0;
        std::size_t comma_may_group = 0;
        std::size_t others = 0;  ///< with a mark that separates decimals for certain
        bool thousands = false;  ///< numbers may be so great
        bool below_thousand = false;
        bool uncertainties = false;
        std::size_t whole = 0;  ///< numbers without a mark, counted if they may be thousands
    };
    [[nodiscard]] bool is_decimal(char mark, std::string_view number, std::size_t column) const;

    std::optional<DecimalMark> decimal_;
    bool of_sheet_;
    std::map<std::size_t, Column> columns_{};
    bool has_decimal_point_ = false;
    bool has_decimal_comma_ = false;
    bool bracket_in_units_ = false;        ///< "30.1 (1.2)", unlike "30.1(12)"
    mutable std::string first_grouped_{};  ///< because of other columns
};

/// A cell without the unit of its column behind its number: "5 um" under "d [um]".
[[nodiscard]] std::string_view without_unit(std::string_view cell, std::string_view unit);

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/tables/text_lines.hpp"
#include "solver/inference/impacts/measurement_headings.hpp"

namespace ashimpact {

/// Which rows of a table hold no measurement, by their labels: rows that sum up others, and rows that the
/// laboratory marked as invalid.
class RowLabels {
  public:
    /// @param lines of the table below its heading
    /// @throws InputError for a column that marks some rows and not others as valid, or all as invalid
    RowLabels(const LabelColumns& heading, std::span<const TextLine> lines, char separator);

    /// The label of a row that sums up others, "Mittel" or "SD (n=3)"; empty for an impact. Words as short as
    /// "SD" count in the rows at the end, in the first column, where the other rows have a number, and behind
    /// groups of other rows. In another column with a text in most rows all words but totals count behind
    /// groups alone.
    /// @throws InputError for one letter behind groups or "Mean A", which may be names, for another text
    /// where the others have a number, for no number there behind them, and for a row that a remark calls
    /// invalid
    [[nodiscard]] std::string summary_in(const TableRow& row) const;

    /// Whether a column numbers the rows.
    [[nodiscard]] bool number_rows() const;

  private:
    /// The cells of a column that holds no quantity.
    struct Column {
        TextColumn column;
        bool is_remark = false;
        bool has_unit = false;     ///< in its heading, "d [um]"
        std::size_t numbers = 0;   ///< whole numbers
        std::size_t measures = 0;  ///< other numbers
        std::size_t texts = 0;     ///< anything else
        std::size_t empty = 0;
        bool in_order = true;         ///< each number is one more than that before
        long last_number = 0;         ///< of the column
        bool repeats = false;         ///< a number equals that before, as sizes of groups do
        bool rises = true;            ///< each number is greater than that before, as of impacts in order,
                                      ///< and not three times as great from the fourth on, as their sum is
        std::size_t inner_empty = 0;  ///< before the last number
        std::string stem{};           ///< of numbered labels, "P" of "P1": that of the first
        std::size_t stemmed = 0;      ///< labels with it
        std::size_t with_digit = 0;   ///< cells with any number, "P1", "2b", "7"
        std::size_t lettered = 0;     ///< of those, with letters
        std::size_t ranges = 0;       ///< of those, "1-4" and dates
        bool has_marks = false;       ///< "no" or "x" in some cell
        std::size_t marks = 0;        ///< of the texts, "x"
        /// Rows with one label that may say that they sum up others.
        struct Label {
            std::size_t rows = 0;
            std::size_t others = 0;  ///< before the last of them
            bool follows = true;     ///< others stand before each of them
        };
        std::map<std::string, Label> labels{};  ///< in small letters
        std::size_t others = 0;                 ///< rows without such a label
        std::size_t named_summaries = 0;        ///< rows with a name and such a word, "Mittelwert A"
        bool has_letters = false;               ///< one letter is the name of some row
        bool describes_rows = false;            ///< "mean of 3" in the first row, which sums up no others
        [[nodiscard]] bool counts_rows() const {
            return numbers >= 2 && numbers > texts + measures && (column.position == 0 || in_order) &&
                   !repeats && !has_unit;
        }
        /// Whether nearly all rows have labels that differ by a number, "P1" and "P2"; in the first column
        /// any labels with a number, "1a" and "B2".
        [[nodiscard]] bool numbers_labels() const {
            constexpr std::size_t fewest = 4;
            if (column.position == 0)
                return with_digit >= fewest && with_digit > 2 * (texts + numbers + measures - with_digit);
            return stemmed >= fewest && stemmed > 2 * (texts - stemmed) && numbers + measures == 0;
        }
        /// Whether the words of the column can be labels of rows, and not a quantity of each.
        [[nodiscard]] bool labels_rows() const {
            return column.position == 0 || texts <= numbers + measures + empty;
        }
        /// Whether each row with a label stands behind others, of which there are at least twice as many.
        [[nodiscard]] bool stands_between(std::string_view label) const;
        /// Whether the label is in some rows, and all rows without such a label have none.
        [[nodiscard]] bool stands_alone(std::string_view label) const;
        void take(std::string_view cell);
    };
    void find_footer(std::span<const TextLine> lines, char separator);
    void find_header(std::span<const TextLine> lines, char separator);
    void require_one_verdict(std::span<const TextLine> lines, char separator, const Column& column,
                             const ValidityColumn* validity) const;
    [[nodiscard]] bool sums_up(const TableRow& row) const;
    [[nodiscard]] bool is_summary_label(const Column& column, const TableRow& row) const;
    static void refuse_sign(const Column& column, const TableRow& row);
    static void require_number(const Column& column, const TableRow& row);
    void refuse_figures_beside(const Column& label, const TableRow& row) const;
    static void refuse_named_summary(const Column& column, const TableRow& row);
    void require_valid(const TableRow& row) const;

    std::vector<Column> columns_;
    std::set<std::string> footer_labels_;  ///< in small letters
    /// First line of the rows at the end that sum up others.
    std::size_t footer_ = std::numeric_limits<std::size_t>::max();
    /// Last line of such rows at the start of the table, of which one has a label longer than three letters.
    std::size_t header_ = 0;
};

/// The two numbers of a row, of which the second is 0 for a capture, and not a number where it is not known.
struct MeasuredRow {
    std::size_t line;
    std::array<double, 2> values;
    bool noted = false;   ///< its outcome, as no row does that sums up others
    std::string label{};  ///< in the first column, if that is no velocity
};

/// A number in its unit, with the digits of the file, which rounding by the unit would change.
[[nodiscard]] double as_written(double value, double unit);

/// Refuses a row that holds what sums up others. @throws InputError at its line
[[noreturn]] void refuse_summary_row(std::size_t line, const std::string& holds,
                                     const std::string& where = "above");

/// Refuses a row that holds the means, sums or standard deviations of the rows above, of all of them or of
/// those since a blank line or another such row: at the end, beside a blank line, or one of several. Doubts
/// one elsewhere. @throws InputError at its line
void refuse_summaries(std::span<const MeasuredRow> rows, std::vector<Finding>& findings);

/// Finds rows that a table holds twice, as one to which a copy of itself was appended. A row whose two
/// numbers and first cell equal those of another is evidence if both of its numbers have two significant
/// digits or more, the second is not zero, and no other row has the same first number beside another second
/// one, as nominal velocities do.
class RepeatedRows {
  public:
    /// Takes a row with a measurement, whose two numbers stand in these columns.
    void take(const TableRow& row, std::size_t first, std::size_t second);

    /// Refuses rows that repeat others in the same order, three or more, or that are a third of all evidence,
    /// five or more and twice as many as chance gives. Fewer may be equal by chance, as velocities in whole
    /// pixels are. @return a doubt about three or more that are twice as many as chance gives
    /// @param row what the numbers of rows are, in messages @param allowed what is allowed instead
    /// @throws InputError at the first such line
    [[nodiscard]] std::optional<Finding> doubtful(
        std::string_view row = "line",
        const std::string& allowed =
            "each row once; or, if they are other measurements, a first column that "
            "numbers all rows") const;

  private:
    struct Row {
        std::size_t line;
        std::size_t cells, number;  ///< hashes of these cells, and of the first number
        bool is_precise;
        double value;  ///< first number; NaN if the cell is not one
    };
    [[nodiscard]] std::vector<std::optional<std::size_t>> earlier() const;
    [[nodiscard]] double pairs_by_chance() const;
    std::vector<Row> rows_;
};

/// What a remark of several words states: nothing where a word is negated in a way that is not known ("not
/// really stuck"), or where it names both outcomes.
[[nodiscard]] OutcomeWord outcome_mentioned(std::string_view remark);

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/impacts/impact_rows.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "solver/inference/impacts/measurement.hpp"
#include "solver/numeric/gsl/statistics.hpp"
#include "solver/statistics/moments.hpp"

namespace ashimpact {

namespace {

/// A number of a row, "7", "7." or "7.0"; none for any other text.
std::optional<long> row_number(std::string_view cell) {
    if (cell.ends_with(".0")) cell.remove_suffix(2);
    if (cell.ends_with('.')) cell.remove_suffix(1);
    constexpr std::size_t longest = 9;
    if (cell.empty() || cell.size() > longest || !std::ranges::all_of(cell, is_digit)) return std::nullopt;
    long number = 0;
    std::from_chars(cell.data(), cell.data() + cell.size(), number);
    return number;
}

/// The label of a row without the nominal velocity behind it: "MW" of "MW 1.5 m/s".
std::string_view label_in(std::string_view cell) {
    const auto number = cell.find_first_of("0123456789");
    if (number == std::string_view::npos || number == 0 || cell[number - 1] != ' ') return cell;
    const auto unit = cell.find_first_not_of("0123456789.,", number);
    if (unit == std::string_view::npos || !is_velocity_unit(trimmed(cell.substr(unit)))) return cell;
    return trimmed(cell.substr(0, number));
}

/// Whether a label may be a name: "n", "min", "avg.".
bool is_short(std::string_view label) {
    constexpr std::size_t longest = 3;
    return label.substr(0, label.find_last_not_of('.') + 1).size() <= longest;
}

/// Whether a label is a sign of a mean or another summary, or a name: "M", "mu", "s".
bool is_sign(std::string_view label) {
    static const WordLists signs("letters of summary rows");
    return signs.holds(label) || (label.size() == 1 && is_summary(label));
}

/// Whether a label begins as a range does: "1-4", and the date "2024-05-01".
bool is_range(std::string_view label) {
    const auto end = label.find_first_not_of("0123456789");
    if (end == std::string_view::npos || end == 0) return false;
    const std::string_view to = trimmed(label.substr(end));
    return to.size() > 1 && to.front() == '-' && is_digit(trimmed(to.substr(1)).front());
}

/// Whether a label with a number in front is that of a statistic, "25 %" or "2s", or a range, "1-4".
bool is_of_several(std::string_view label) {
    if (label.empty() || !is_digit(label.front())) return false;
    if (label.find('%') != std::string_view::npos || label.find("\u03c3") != std::string_view::npos)
        return true;
    const std::string_view behind =
        label.substr(std::min(label.find_first_not_of("0123456789"), label.size()));
    const bool is_quantile = is_summary(trimmed(behind.substr(std::min<std::size_t>(1, behind.size()))));
    return is_range(label) || is_quantile || !read_coverage(label).stated.empty();
}

bool has_letter(std::string_view text) {
    return std::ranges::any_of(text, [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; });
}

bool is_blank(std::string_view cell) {
    return outcome_word(cell) == OutcomeWord::unknown;
}

/// The list of words that judge an impact which holds a cell: "good", "bad", "yes", "no", or "mark".
std::optional<std::string_view> verdict_of(std::string_view cell) {
    static const WordLists words("verdicts", all_marks);
    return words.list_of(as_flag(trimmed(cell)));
}

std::string name_of(const TextColumn& column) {
    return column.name.empty() ? "the column without a heading" : "column " + in_quotes(column.name);
}

/// What a row without a label may hold of the rows above it.
struct Summary {
    std::string_view name;
    double (*of)(const Moments&);
};
constexpr std::array summaries{
    Summary{"means", [](const Moments& above) { return above.mean; }},
    Summary{"sums", [](const Moments& above) { return above.mean * static_cast<double>(above.count); }},
    Summary{"standard deviations", [](const Moments& above) { return std::sqrt(above.variance()); }},
    Summary{"standard deviations",
            [](const Moments& above) { return std::sqrt(above.second / static_cast<double>(above.count)); }},
    Summary{
        "standard errors",
        [](const Moments& above) { return std::sqrt(above.variance() / static_cast<double>(above.count)); }},
    Summary{"variances", [](const Moments& above) { return above.variance(); }},
    Summary{"counts", [](const Moments& above) { return static_cast<double>(above.count); }}};

/// The last digit of a number as written: 0.01 of 0.13.
double last_digit(double value) {
    const std::string digits = shortest(value);
    const auto point = std::min(digits.find('.'), digits.size() - 1);
    return std::pow(10.0, static_cast<double>(point + 1) - static_cast<double>(digits.size()));
}

/// Whether a number is the other one, rounded to its last digit or cut there.
bool is_rounded_to_digits(double value, double exact) {
    return std::abs(value - exact) <= last_digit(value);
}

/// Whether a number is the other one, rounded to a digit; a fine one may be cut there.
bool is_rounded_to(double last, double value, double exact) {
    constexpr double coarsest = 0.2;  // of the value; a number of one digit matches too easily
    constexpr double fine = 0.02;     // of the value
    if (std::abs(value - exact) > coarsest * value) return false;
    return last <= coarsest * value &&
           std::abs(value - exact) <= 1.001 * last * (last <= fine * value ? 1 : 0.5);
}
/// The same for its last digit.
bool is_rounded(double value, double exact) {
    return is_rounded_to(last_digit(value), value, exact);
}

}  // namespace

OutcomeWord outcome_mentioned(std::string_view remark) {
    static const WordLists words("outcomes", " ");
    OutcomeWord outcome = OutcomeWord::none;
    if (remark.find('?') != std::string_view::npos) return outcome;
    for (const Mention& mention : mentions_in(words_in(remark), words)) {
        const auto meaning = named<OutcomeWord>(mention.list);
        if (meaning == OutcomeWord::unknown) continue;
        if (mention.negated || (outcome != OutcomeWord::none && outcome != meaning)) return OutcomeWord::none;
        outcome = meaning;
    }
    return outcome;
}

namespace {

/// Whether a label is a name with a word for a mean or another summary before or behind it: "Mittelwert A",
/// "P1 SD".
bool names_summary(std::string_view label) {
    const std::size_t first = label.find_first_of(" _-");
    if (first == std::string_view::npos || is_summary(label)) return false;
    const std::string_view before = label.substr(0, first);
    const std::string_view behind = label.substr(label.find_last_of(" _-") + 1);
    return std::ranges::any_of(std::array{before, behind}, [](std::string_view word) {
        if (word.starts_with('(') && word.ends_with(')')) word = word.substr(1, word.size() - 2);
        return word.size() > 1 && is_summary(word) && !is_total(word);
    });
}

}  // namespace

void RowLabels::Column::take(std::string_view cell) {
    named_summaries += names_summary(label_in(cell)) ? 1 : 0;
    if (std::ranges::any_of(cell, is_digit)) {
        ++with_digit;
        lettered += has_letter(cell) ? 1 : 0;
        ranges += is_range(cell) ? 1 : 0;
    }
    if (const auto number = row_number(cell)) {
        in_order = in_order && (numbers == 0 || *number == last_number + 1);
        constexpr std::size_t few = 3;
        rises = rises &&
                (numbers == 0 || (*number > last_number && (numbers < few || *number < 3 * last_number)));
        repeats = repeats || (numbers > 0 && *number == last_number);
        ++numbers;
        last_number = *number;
        inner_empty = empty;
    } else {
        if (is_blank(cell))
            ++empty;
        else
            ++(read_number(cell) || read_number(cell, true) ? measures : texts);
        const std::string_view own = cell.substr(0, cell.find_first_of("0123456789"));
        if (!own.empty() && row_number(cell.substr(own.size()))) {
            if (stemmed == 0) stem = own;
            stemmed += own == stem ? 1 : 0;
        }
        const auto verdict = verdict_of(cell);
        has_marks = has_marks || verdict == "no" || verdict == "mark";
        marks += verdict == "mark" ? 1 : 0;
    }
    const std::string_view label = label_in(cell);
    if (!is_summary(label) && !is_sign(label)) {
        ++others;
        has_letters = has_letters || (label.size() == 1 && !is_digit(label.front()));
        return;
    }
    Label& found = labels[lower_case(label)];
    found.follows = found.follows && others > found.others;
    found.others = others;
    ++found.rows;
}

bool RowLabels::Column::stands_between(std::string_view label) const {
    const auto found = labels.find(lower_case(label));
    return found != labels.end() && found->second.follows && others >= 2 * found->second.rows;
}

bool RowLabels::Column::stands_alone(std::string_view label) const {
    const auto found = labels.find(lower_case(label));
    return found != labels.end() && found->second.rows > 1 && others == empty &&
           empty >= 2 * found->second.rows;
}

RowLabels::RowLabels(const LabelColumns& heading, std::span<const TextLine> lines, char separator) {
    for (const auto* all : {&heading.unused, &heading.remarks})
        for (const TextColumn& column : *all)
            columns_.push_back({.column = column,
                                .is_remark = all == &heading.remarks,
                                .has_unit = unit_of_quantity(column.name).has_value()});
    if (columns_.empty()) return;
    std::vector<Column*> at(heading.columns, nullptr);
    for (Column& column : columns_) at[column.column.position] = &column;
    for (const TextLine& line : lines)
        for_each_cell(line, separator, [&](std::string_view cell, std::size_t position) {
            Column* column = position < at.size() ? at[position] : nullptr;
            if (column == nullptr) return;
            if (&line == &lines.front()) column->describes_rows = position != 0 && is_summary(cell);
            column->take(cell);
        });
    find_footer(lines, separator);
    find_header(lines, separator);
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        const Column& column = columns_[i];
        const auto found =
            std::ranges::find(heading.validity, column.column.position, &ValidityColumn::position);
        const bool only_marks =
            column.marks > 0 && column.marks == column.texts && column.numbers + column.measures == 0;
        const bool has_remarks = i >= heading.unused.size() || column.column.name.empty() || only_marks;
        if (found != heading.validity.end() || (has_remarks && column.has_marks))
            require_one_verdict(lines, separator, column,
                                found != heading.validity.end() ? &*found : nullptr);
    }
}

void RowLabels::find_footer(std::span<const TextLine> lines, char separator) {
    for (std::size_t i = lines.size(); i-- > 0;) {
        const TableRow row = cut_row(lines[i], separator);
        const std::size_t below = std::exchange(footer_, row.line);
        if (sums_up(row)) {
            footer_labels_.insert(lower_case(label_in(row.cells.front())));
            continue;
        }
        footer_ = below;
        return;
    }
    footer_ = std::numeric_limits<std::size_t>::max();  // such words are then the names of all rows
    footer_labels_.clear();
}

void RowLabels::find_header(std::span<const TextLine> lines, char separator) {
    std::size_t last = 0;
    bool is_said = false;
    for (const TextLine& line : lines) {
        const TableRow row = cut_row(line, separator);
        if (!is_summary(label_in(row.cells.front()))) {
            header_ = is_said ? last : 0;
            return;
        }
        is_said = is_said || sums_up(row);
        last = row.line;
    }
}

void RowLabels::require_one_verdict(std::span<const TextLine> lines, char separator, const Column& column,
                                    const ValidityColumn* validity) const {
    constexpr const char* allowed = "a file without the rows that do not count, and without this column";
    const std::size_t position = column.column.position;
    const std::string where = name_of(column.column);
    std::optional<std::string> first;
    std::size_t line_of_first = 0;
    for (const TextLine& line : lines) {
        const TableRow row = cut_row(line, separator);
        if (position >= row.cells.size() || sums_up(row)) continue;
        const std::string& cell = row.cells[position];
        if (as_flag(cell).size() > 1 && read_number(cell, true)) return;  // a measured quality
        if (!first) {
            first = cell;
            line_of_first = row.line;
        }
        if (lower_case(cell) == lower_case(*first)) continue;
        const auto marks = [](const std::string& each) {
            return !read_number(each) && (verdict_of(each) == "no" || verdict_of(each) == "mark");
        };
        if (validity == nullptr && !marks(cell) && !marks(*first)) continue;
        throw InputError(where + " marks rows as valid or not, " + in_quotes(*first) + " or " +
                             in_quotes(cell) + ": those with one of the marks may be excluded, or all count",
                         allowed)
            .at(at_cell(row.line, position));
    }
    if (validity == nullptr || !first || is_blank(*first)) return;
    const auto verdict = verdict_of(*first);
    if (verdict != "good" && verdict != (validity->excludes ? "no" : "yes"))
        throw InputError(
            where + " has " + in_quotes(*first) + " in every row: all may be excluded, or all count", allowed)
            .at(at_cell(line_of_first, position));
}

bool RowLabels::number_rows() const {
    return std::ranges::any_of(
        columns_, [](const Column& each) { return each.counts_rows() && each.rises && each.measures == 0; });
}

bool RowLabels::sums_up(const TableRow& row) const {
    return std::ranges::any_of(columns_, [&](const Column& each) { return is_summary_label(each, row); });
}

bool RowLabels::is_summary_label(const Column& column, const TableRow& row) const {
    if (column.column.position >= row.cells.size()) return false;
    const std::string& cell = row.cells[column.column.position];
    const bool at_end = column.column.position == 0 && (row.line >= footer_ || row.line <= header_);
    const std::string_view label = label_in(cell);
    const bool is_numbered = !cell.empty() && is_digit(cell.front()) && read_coverage(label).stated.empty();
    if (cell.empty() || is_numbered || !is_summary(label)) return false;
    if (column.describes_rows) return false;
    const bool between =
        column.stands_between(label) && !is_sign(label) && (column.labels_rows() || !is_total(label));
    return (!is_short(label) && column.labels_rows()) || between || at_end || column.counts_rows();
}

void RowLabels::refuse_sign(const Column& column, const TableRow& row) {
    const std::string& cell = row.cells[column.column.position];
    const std::string_view label = label_in(cell);
    const bool is_label =
        column.column.position == 0 || (column.labels_rows() && column.numbers + column.measures > 0);
    const bool behind_groups = is_sign(label) && !column.has_letters && column.stands_between(label);
    if (!is_label || !(behind_groups || column.stands_alone(label))) return;
    throw InputError(
        in_quotes(cell) + " in " + name_of(column.column) + " may be a name, or the row sums up others",
        "\"mean\" or \"SD\" for such rows, or a longer name")
        .at(at_cell(row.line, column.column.position));
}

void RowLabels::refuse_figures_beside(const Column& label, const TableRow& row) const {
    if (label.column.position == 0) return;
    std::size_t rows = 0;  // with such a label
    for (const auto& [name, of] : label.labels) rows += of.rows;
    for (const Column& beside : columns_)
        if (beside.column.position > label.column.position && beside.texts == 0 &&
            beside.numbers + beside.measures <= rows && read_number(row.cells[beside.column.position]))
            throw InputError(in_quotes(row.cells[label.column.position]) + " stands before " +
                                 row.cells[beside.column.position] +
                                 ": the row may sum up others, or both stand beside the table",
                             "a file without the figures beside the table")
                .at(at_cell(row.line, label.column.position));
}

void RowLabels::refuse_named_summary(const Column& column, const TableRow& row) {
    const std::string& cell = row.cells[column.column.position];
    const std::size_t rows = column.numbers + column.measures + column.texts + column.empty;
    if (column.labels_rows() && !column.is_remark && column.named_summaries < rows &&
        names_summary(label_in(cell)))
        throw InputError(in_quotes(cell) + " in " + name_of(column.column) +
                             " may be the name of an impact, or the row sums up others",
                         "a file without the rows that sum up, or another name")
            .at(at_cell(row.line, column.column.position));
}

void RowLabels::require_number(const Column& column, const TableRow& row) {
    const bool counts = column.counts_rows();
    if (!counts && column.numbers_labels() && !column.is_remark) {
        const std::string& label = row.cells[column.column.position];
        const bool is_stemmed = 3 * column.stemmed > 2 * column.with_digit;  // "P1", "P2"
        const bool is_plain = 3 * column.lettered < column.with_digit;       // "2024-05-01"
        const bool is_other =
            is_stemmed ? !label.starts_with(column.stem) : is_plain && has_letter(label);  // "Q1", "U95"
        const bool are_ranges = 2 * column.ranges > column.with_digit;  // dates, or runs "7-1"
        const bool has_number =
            std::ranges::any_of(label, is_digit) && (are_ranges ? is_range(label) : !is_of_several(label));
        if (is_blank(label) || (has_number && !is_other)) return;
        throw InputError(in_quotes(label) + " is in " + name_of(column.column) + ", where the others have " +
                             (is_stemmed ? in_quotes(column.stem) + " and " : "") +
                             "a number: the row may be a measurement, or sum up others",
                         "a label with a number, or a file without this row")
            .at(at_cell(row.line, column.column.position));
    }
    if (!counts) return;
    const std::string& cell = row.cells[column.column.position];
    const std::string where = name_of(column.column);
    constexpr const char* allowed = "its number, or a file without this row";
    if (is_blank(cell)) {
        const bool names_groups = 2 * column.inner_empty >= column.numbers;  // of impacts of one particle
        if (!column.in_order || names_groups) return;
        throw InputError("the row has no number in " + where +
                             ", where the others have one: it may be a measurement, or sum up others",
                         allowed)
            .at(at_cell(row.line, column.column.position));
    }
    if ((is_digit(cell.front()) && !is_of_several(cell)) || cell.front() == '#') return;  // "7a", "#7"
    throw InputError(in_quotes(cell) + " is in " + where +
                         ", where the others have a number: the row may be a measurement, or sum up others",
                     allowed)
        .at(at_cell(row.line, column.column.position));
}

void RowLabels::require_valid(const TableRow& row) const {
    for (const Column& column : columns_) {
        const std::string& cell = row.cells[column.column.position];
        if (!cell.empty() && (verdict_of(cell) == "bad" || calls_invalid(cell)))
            refuse_invalid_row(cell, name_of(column.column), row.line, column.column.position);
    }
}

void refuse_summary_row(std::size_t line, const std::string& holds, const std::string& where) {
    refuse_line(
        line,
        "the row holds " + holds + " of the rows " + where + ": it may be a measurement, or sum up others",
        "a column that numbers the rows, or a file without this row");
}

namespace {

/// Whether a number is the other one, rounded to its digits, or, as "0.60", to the last of the numbers it
/// sums up, @p finest; with more digits than these it may be that of numbers which were not rounded.
bool is_rounded(double value, double exact, double finest) {
    if (is_rounded(value, exact) || is_rounded_to(std::min(last_digit(value), finest), value, exact))
        return true;
    return last_digit(value) < 0.5 * finest && std::abs(value - exact) <= 0.5 * finest;
}

/// Rows that another one may sum up.
struct Block {
    std::array<Moments, 2> values{};  ///< of all rows
    std::array<double, 2> finest{std::numeric_limits<double>::infinity(),
                                 std::numeric_limits<double>::infinity()};  ///< last digits
    std::array<Moments, 2> rebounds{};                                      ///< of those without the captures

    void take(const MeasuredRow& row) {
        for (std::size_t k = 0; k < values.size(); ++k) {
            if (std::isnan(row.values[k])) continue;
            const Moments one{
                .count = 1, .mean = row.values[k], .minimum = row.values[k], .maximum = row.values[k]};
            values[k].merge(one);
            if (row.values[k] > 0.0) finest[k] = std::min(finest[k], last_digit(row.values[k]));
            if (row.values[1] > 0.0) rebounds[k].merge(one);
        }
    }
    static Block of(std::span<const MeasuredRow> rows) {
        Block block;
        for (const MeasuredRow& row : rows) block.take(row);
        return block;
    }
    /// What a row holds of these: "means"; nothing if it sums up none.
    [[nodiscard]] std::optional<std::string_view> summed_up_in(const MeasuredRow& row) const {
        constexpr std::size_t fewest = 3;
        constexpr double least_spread = 0.05;  // so that equal rows are no mean
        if (values[0].count < fewest || !(row.values[1] > 0.0)) return std::nullopt;
        for (const std::array<Moments, 2>& moments : {values, rebounds, {values[0], rebounds[1]}}) {
            if (moments[0].count < fewest) continue;
            for (const auto& [name, of] : summaries)
                if (moments[0].maximum > (1.0 + least_spread) * moments[0].minimum &&
                    is_rounded(row.values[0], of(moments[0]), finest[0]) &&
                    is_rounded(row.values[1], of(moments[1]), finest[1]))
                    return name;
        }
        return std::nullopt;
    }
};

/// Whether each row sums a block up, or holds its least or greatest values.
bool all_sum_up(std::span<const MeasuredRow> rows, const Block& block) {
    const auto holds = [&](const MeasuredRow& row, double Moments::*end) {
        return row.values[0] == block.values[0].*end && row.values[1] == block.values[1].*end;
    };
    return std::ranges::all_of(rows, [&](const MeasuredRow& row) {
        return holds(row, &Moments::minimum) || holds(row, &Moments::maximum) || block.summed_up_in(row);
    });
}

/// Whether a row holds the medians of others.
bool holds_medians(const MeasuredRow& row, std::span<const MeasuredRow> others) {
    for (std::size_t k = 0; k < row.values.size(); ++k) {
        std::vector<double> values;
        for (const MeasuredRow& other : others)
            if (!std::isnan(other.values[k])) values.push_back(other.values[k]);
        if (!is_rounded(row.values[k], gsl::quantiles(values, std::array{0.5})[0])) return false;
    }
    return true;
}

/// Refuses a first row that holds means, and a first or last one that holds medians of all others.
void refuse_summary_at_end(std::span<const MeasuredRow> rows) {
    constexpr std::size_t fewest = 6;
    if (rows.size() < fewest) return;
    constexpr std::size_t most_between = 2;  // standard deviations, least and greatest values
    for (std::size_t between = 0; between <= most_between; ++between) {
        const Block below = Block::of(rows.subspan(1 + between));
        if (!rows.front().noted && below.summed_up_in(rows.front()) == "means" &&
            all_sum_up(rows.subspan(1, between), below))
            refuse_summary_row(rows.front().line, "the means", "below");
        for (const std::size_t last : {rows.size() - 1, rows.size() - 2}) {
            const Block above = Block::of(rows.first(last - between));
            if (!rows[last].noted && above.summed_up_in(rows[last]) == "means" &&
                all_sum_up(rows.subspan(last - between, between), above))
                refuse_summary_row(rows[last].line, "the means");
        }
    }
    if (!rows.front().noted && holds_medians(rows.front(), rows.subspan(1)))
        refuse_summary_row(rows.front().line, "the medians", "below");
    if (!rows.back().noted && holds_medians(rows.back(), rows.first(rows.size() - 1)))
        refuse_summary_row(rows.back().line, "the medians");
}

/// Refuses rows that hold the means of the others with their labels, if two labels or more have one.
void refuse_means_of_labels(std::span<const MeasuredRow> rows) {
    std::map<std::string_view, std::vector<MeasuredRow>> labelled;
    for (const MeasuredRow& row : rows)
        if (!row.label.empty()) labelled[row.label].push_back(row);
    std::vector<std::size_t> found;  // lines
    for (const auto& [label, all] : labelled) {
        const std::span<const MeasuredRow> of_label(all);
        if (Block::of(of_label.first(all.size() - 1)).summed_up_in(all.back()) == "means")
            found.push_back(all.back().line);
        else if (Block::of(of_label.subspan(1)).summed_up_in(all.front()) == "means")
            found.push_back(all.front().line);
    }
    if (found.size() > 1) refuse_summary_row(*std::ranges::min_element(found), "the means", "with its label");
}

/// Whether a number may be a mean, written with any number of digits.
bool may_be_mean(double value, double mean, double velocity, double finest) {
    constexpr double shown = 0.01;  // of the velocity; a smaller mean may be written as 0
    if (value == 0) return mean < shown * velocity;
    return is_rounded_to_digits(value, mean) || is_rounded(value, mean, finest);
}

/// Whether a row beside each whole group of so many holds their means.
/// @param beside rows behind each group, or in front of it, the first of them with the means
bool holds_means_of_groups(std::span<const MeasuredRow> rows, std::size_t group, std::size_t beside,
                           bool in_front) {
    const std::size_t period = group + beside;
    std::size_t evidence = 0;  // numbers that equal means hardly by chance
    for (std::size_t first = 0; first + period <= rows.size(); first += period) {
        const Block block = Block::of(rows.subspan(in_front ? first + beside : first, group));
        const MeasuredRow& row = rows[in_front ? first : first + group];
        for (std::size_t k = 0; k < row.values.size(); ++k) {
            const auto may_be = [&](const Moments& of) {
                return may_be_mean(row.values[k], of.mean, block.values[0].mean, block.finest[k]);
            };
            const bool leaves_captures_out = k == 1 && !may_be(block.values[k]);  // as spreadsheets do
            const Moments& moments = leaves_captures_out ? block.rebounds[k] : block.values[k];
            if (leaves_captures_out && (moments.count == 0 || !may_be(moments))) return false;
            const bool varies = moments.maximum > moments.minimum;
            evidence += varies && is_rounded(row.values[k], moments.mean, block.finest[k]) ? 1 : 0;
        }
    }
    return evidence >= (group == 2 ? 6 : 4);
}

void refuse_means_of_groups(std::span<const MeasuredRow> rows) {
    constexpr std::size_t fewest = 2;
    constexpr std::size_t most = 20;
    for (std::size_t group = fewest; group <= most; ++group)
        for (const std::size_t beside : {1, 2})
            for (const bool in_front : {false, true})
                if (holds_means_of_groups(rows, group, beside, in_front))
                    refuse_summary_row(rows[in_front ? 0 : group].line, "the means",
                                       in_front ? "below" : "above");
}

}  // namespace

double as_written(double value, double unit) {
    constexpr int digits = 12;
    const auto number = read_number(fmt::format("{:.{}g}", value / unit, digits));
    return number ? number->value : value;
}

void refuse_summaries(std::span<const MeasuredRow> rows, std::vector<Finding>& findings) {
    refuse_summary_at_end(rows);
    refuse_means_of_groups(rows);
    refuse_means_of_labels(rows);
    constexpr std::size_t most_rows = 60;   // in longer files some rows equal such means by chance,
    constexpr std::size_t most_group = 20;  // but not one behind each group of so many rows
    Block all;
    Block block;  // since the last blank line or row that sums up
    std::vector<std::pair<std::size_t, std::string_view>> doubtful;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const MeasuredRow& row = rows[i];
        const auto is_apart = [&](std::size_t k) { return rows[k].line > rows[k - 1].line + 1; };
        const bool at_end = i + 2 >= rows.size();
        const bool begins = i > 0 && is_apart(i);
        const bool stands_out = !row.noted && (at_end || begins || is_apart(i + 1));
        const auto of_all = at_end && !row.noted ? all.summed_up_in(row) : std::nullopt;
        const auto of_block = block.summed_up_in(row);
        if (of_all || (of_block && stands_out))
            refuse_summary_row(row.line, "the " + std::string(of_all ? *of_all : *of_block));
        all.take(row);
        if (of_block || begins) block = {};
        if (of_block)
            doubtful.emplace_back(row.line, *of_block);
        else
            block.take(row);
    }
    const bool is_short = rows.size() <= most_rows;
    const bool is_regular = most_group * doubtful.size() >= rows.size();
    if (doubtful.empty() || !(is_short || is_regular)) return;
    const auto& [line, holds] = doubtful.front();
    if (doubtful.size() > 1) refuse_summary_row(line, "the " + std::string(holds));
    findings.push_back({impacts_code, Severity::doubt,
                        "line " + std::to_string(line) + " holds the " + std::string(holds) +
                            " of the rows above: if it sums them up, it is no impact"});
}

namespace {

/// Whether a cell holds a number of two significant digits or more, other than zero.
bool is_precise(std::string_view cell) {
    const auto first = cell.find_first_of("123456789");
    if (first == std::string_view::npos) return false;
    if (cell.substr(0, first).find_first_not_of("+-.,0 ") != std::string_view::npos) return false;
    const std::string_view number = cell.substr(first, cell.find_first_not_of("0123456789.,", first) - first);
    return std::ranges::count_if(number, is_digit) >= 2;
}

/// "1.72" for "1.720", and for "1.720 m/s".
std::string without_last_zeros(std::string cell) {
    const auto letter = cell.find_first_of("cmk");
    if (letter != std::string::npos && is_velocity_unit(cell.substr(letter)))
        cell = trimmed(cell.substr(0, letter));
    const auto mark = cell.find_first_of(".,");
    if (mark != std::string::npos && cell.find_first_not_of("0123456789", mark + 1) == std::string::npos)
        while (cell.back() == '0') cell.pop_back();
    return cell;
}

}  // namespace

void RepeatedRows::take(const TableRow& row, std::size_t first, std::size_t second) {
    // Other cells may differ in a copy: "Rebound" for "rebound", an uncertainty that was estimated again.
    const std::string label = first == 0 || second == 0 ? std::string() : row.cells.front();
    std::string all;
    for (const std::string& cell : {label, row.cells[first], row.cells[second]})
        (all += without_last_zeros(cell)) += '\n';
    const std::hash<std::string> hash;
    auto number = read_number(row.cells[first]);
    if (!number) number = read_number(row.cells[first], true);
    rows_.push_back({row.line, hash(all), hash(without_last_zeros(row.cells[first])),
                     is_precise(row.cells[first]) && is_precise(row.cells[second]),
                     number ? number->value : std::numeric_limits<double>::quiet_NaN()});
}

namespace {

/// Common step of the numbers, such as one pixel of a camera gives; their last digit if there is none.
/// @param numbers rising
double step_of(const std::vector<double>& numbers) {
    double least = std::numeric_limits<double>::infinity();
    double digit = least;
    for (std::size_t i = 1; i < numbers.size(); ++i) {
        digit = std::min(digit, last_digit(numbers[i]));
        if (numbers[i] > numbers[i - 1]) least = std::min(least, numbers[i] - numbers[i - 1]);
    }
    constexpr int most_parts = 5;  // the least distance may be some steps
    for (int parts = 1; parts <= most_parts; ++parts) {
        const double step = least / parts;
        const auto is_multiple = [&](double number) {
            return std::abs(std::remainder(number - numbers.front(), step)) <= 2 * digit;
        };
        if (step > 8 * digit && std::ranges::all_of(numbers, is_multiple)) return step;
    }
    return std::min(least, digit);
}

}  // namespace

/// Pairs of rows that have the same first number by chance, if numbers are multiples of a step.
double RepeatedRows::pairs_by_chance() const {
    std::vector<double> numbers;
    for (const Row& row : rows_)
        if (std::isfinite(row.value)) numbers.push_back(row.value);
    std::ranges::sort(numbers);
    if (numbers.empty() || numbers.front() == numbers.back()) return 0;
    const auto count = static_cast<double>(numbers.size());
    return 0.5 * count * (count - 1) / (1 + (numbers.back() - numbers.front()) / step_of(numbers));
}

/// For each row that is evidence, the last one before it with the same cells.
std::vector<std::optional<std::size_t>> RepeatedRows::earlier() const {
    std::vector<std::size_t> order(rows_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {},
                      [&](std::size_t i) { return std::tuple(rows_[i].number, rows_[i].cells, i); });
    std::vector<std::optional<std::size_t>> found(rows_.size());
    for (auto from = order.begin(); from != order.end();) {
        const auto to = std::find_if(from, order.end(),
                                     [&](std::size_t i) { return rows_[i].number != rows_[*from].number; });
        const bool is_nominal = rows_[*from].cells != rows_[*(to - 1)].cells;
        for (auto at = from; ++at != to;)
            if (!is_nominal && rows_[*at].is_precise) found[*at] = *(at - 1);
        from = to;
    }
    return found;
}

std::optional<Finding> RepeatedRows::doubtful(std::string_view row, const std::string& allowed) const {
    constexpr double chance_of_row = 1.0 / 200.0;  // that two rows of two digits are equal, or less
    constexpr double chance_of_table = 1e-4;
    constexpr std::size_t fewest_in_order = 3;
    constexpr std::size_t fewest = 5;
    const auto place = [&](const Row& each) { return fmt::format("{} {}", row, each.line); };
    const auto before = earlier();
    const auto count = static_cast<double>(rows_.size());
    const double in_order = std::max(static_cast<double>(fewest_in_order),
                                     std::log(chance_of_table / (count * count)) / std::log(chance_of_row));
    std::size_t copies = 0;
    for (std::size_t i = 0; i < rows_.size();) {
        if (!before[i]) {
            ++i;
            continue;
        }
        const std::size_t distance = i - *before[i];
        const std::size_t begin = i;
        std::size_t evidence = 0;
        for (; i < rows_.size() && i < begin + distance && rows_[i].cells == rows_[i - distance].cells; ++i)
            evidence += before[i] == i - distance ? 1 : 0;
        copies += evidence;
        if (static_cast<double>(evidence) < in_order) continue;
        throw InputError(
            fmt::format("the rows to {0} {1} repeat those from {0} {2} to {3}: they may be there twice, "
                        "or be other measurements",
                        row, rows_[i - 1].line, rows_[begin - distance].line, rows_[i - 1 - distance].line),
            allowed)
            .at(place(rows_[begin]));
    }
    const auto precise = static_cast<std::size_t>(std::ranges::count_if(rows_, &Row::is_precise));
    if (copies < fewest_in_order || static_cast<double>(copies) < 2 * pairs_by_chance()) return std::nullopt;
    const auto first = static_cast<std::size_t>(
        std::ranges::find_if(before, [](const auto& each) { return each.has_value(); }) - before.begin());
    const std::string repeats = fmt::format(
        "the row repeats that of {} {}, and {} of {} rows repeat others: they may be there "
        "twice, or be other measurements",
        row, rows_[*before[first]].line, copies, rows_.size());
    if (copies >= fewest && 3 * copies >= precise) throw InputError(repeats, allowed).at(place(rows_[first]));
    return Finding{impacts_code, Severity::doubt, place(rows_[first]) + ": " + repeats};
}

std::string RowLabels::summary_in(const TableRow& row) const {
    const std::string& first = row.cells.front();  // a label may stand in the column of v_in
    if (!is_short(label_in(first)) && is_summary(first)) return first;
    for (const Column& column : columns_)
        if (is_summary_label(column, row)) {
            refuse_figures_beside(column, row);
            return row.cells[column.column.position];
        }
    const std::string_view label = label_in(first);
    if (!label.empty() && footer_labels_.contains(lower_case(label)))  // "s" behind each group
        throw InputError(in_quotes(label) + " stands at the end for a row that sums up others, and here, too",
                         "\"mean\" or \"SD\" for such rows, or another name")
            .at(at_cell(row.line, 0));
    for (const Column& column : columns_) {
        refuse_sign(column, row);
        require_number(column, row);
        refuse_named_summary(column, row);
    }
    require_valid(row);
    return {};
}

}  // namespace ashimpact

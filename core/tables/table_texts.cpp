// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/table_texts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <regex>
#include <utility>

#include <fmt/format.h>

#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"

namespace ashimpact {

std::vector<TextBeside> texts_beside(const TextLines& file, std::span<const TextLine> table) {
    constexpr std::size_t longest = 20'000;  // its words are compared with those of many statements
    std::vector<TextBeside> texts;
    auto row = table.begin();
    for (const TextLine& line : file.lines()) {
        while (row != table.end() && row->number < line.number) ++row;
        if (row != table.end() && row->number == line.number) continue;
        std::string_view text = trimmed(line.text);
        while (text.starts_with('#')) text = trimmed(text.substr(1));
        if (text.size() > longest)
            refuse_line(line.number, "a text beside the table is longer than 20,000 characters",
                        "the table with shorter texts");
        if (!text.empty())
            texts.push_back({line.number, std::string(text), text.starts_with(sheet_name_mark)});
    }
    return texts;
}

std::optional<Finding> unread_comments(const TextLines& file, std::span<const TextLine> content,
                                       std::string_view code, const std::set<std::string_view>& used) {
    constexpr std::size_t shown = 10;
    std::size_t first = 0;
    std::vector<std::string> comments;
    const auto is_content = [&](std::size_t number) {
        const auto at = std::ranges::lower_bound(content, number, {}, &TextLine::number);
        return at != content.end() && at->number == number;
    };
    for (const TextLine& line : file.lines()) {
        const std::string_view text = trimmed(line.text);
        const std::string_view bare = text.substr(std::min(text.find_first_not_of("# "), text.size()));
        if (!text.starts_with('#') || bare.empty() || is_content(line.number) ||
            makes_statement({line.number, std::string(bare)}, used) ||
            (file.of_sheet() && (bare.starts_with("comment on ") || bare.starts_with(sheet_name_mark))))
            continue;
        if (comments.empty()) first = line.number;
        comments.push_back(title_in_quotes(bare));
    }
    if (comments.empty()) return std::nullopt;
    const std::size_t more = comments.size() - std::min(shown, comments.size());
    comments.resize(comments.size() - more);
    return Finding{code, Severity::remark,
                   fmt::format("{}, a comment, is no part of the table: {}{}", at_line(first),
                               joined(comments), more == 0 ? "" : fmt::format(", and {} more", more))};
}

CutTable cut_table(const TextLines& file, std::vector<TextLine> lines, std::size_t place,
                   std::string_view code, const std::set<std::string_view>& used,
                   const std::function<bool(TableRow&, const TableRow&)>& take_second) {
    CutTable table{.separator = separator_of(lines[place].text)};
    table.heading = cut_row(lines[place], table.separator);
    std::size_t first = place + 1;  // of the rows
    if (first < lines.size()) {
        TableRow second = cut_row(lines[first], table.separator);
        static const WordLists units("unit columns");
        if (units.holds(second.cells.front())) second.cells.front().clear();  // "Unit;wt%;wt%"
        const auto is_unit = [](std::string_view text) { return read_unit(ascii_unit(text)).has_value(); };
        if (take_second ? take_second(table.heading, second) : take_units(table.heading, second, is_unit))
            ++first;
    }
    const auto is_used = [&](const TextLine& line) {
        return makes_statement({line.number, std::string(line.text)}, used);
    };
    for (std::size_t i = 0; i < place; ++i)
        if (!is_used(lines[i]))
            table.findings.push_back({code, Severity::remark,
                                      at_line(lines[i].number) + ", above the heading, is not read: " +
                                          title_in_quotes(trimmed(lines[i].text))});
    if (auto comments = unread_comments(file, lines, code, used))
        table.findings.push_back(std::move(*comments));
    table.rows.assign(lines.begin() + static_cast<std::ptrdiff_t>(first), lines.end());
    std::vector<Finding> notes = take_notes(lines, first, table.separator, code);
    const std::size_t rows = lines.size() - first;
    for (std::size_t i = 0; i < notes.size(); ++i)
        if (!is_used(table.rows[rows + i])) table.findings.push_back(std::move(notes[i]));
    table.notes.assign(table.rows.begin() + static_cast<std::ptrdiff_t>(rows), table.rows.end());
    table.rows.resize(rows);
    table.texts = texts_beside(file, std::span<const TextLine>(lines).subspan(place));
    refuse_factors(table.texts);
    return table;
}

void CutTable::take_unused_cells(const std::function<bool(std::size_t column)>& is_unused) {
    for (const TextLine& row : rows)
        for_each_cell(row, separator, [&](std::string_view cell, std::size_t k) {
            if (cell.empty() || !is_unused(k)) return;
            refuse_sign_of_bound(cell, "a column that is not read", row.number, k);
            texts.push_back({row.number, std::string(cell)});
        });
}

void CutTable::show(NumberMarks& marks) const {
    for (const TextLine& row : rows)
        for_each_cell(row, separator, [&](std::string_view cell, std::size_t k) { marks.see(cell, k); });
}

void refuse_blanks(const std::vector<TextLine>& lines) {
    for (const TextLine& line : lines) {
        std::string_view rest = trimmed(line.text);
        std::size_t numbers = 0;
        double value = 0;
        while (take_decimal(rest, value) == std::errc{} && (rest.empty() || rest.front() == ' ')) {
            ++numbers;
            rest = trimmed(rest);
        }
        if (rest.empty() && numbers > 1)
            refuse_line(line.number, "the numbers are apart by blanks",
                        "tabs, semicolons or commas, as of numpy.savetxt(..., delimiter=\",\")");
    }
}

void require_cells(TableRow& row, std::size_t columns) {
    while (row.cells.size() > columns && row.cells.back().empty()) row.cells.pop_back();
    if (row.cells.size() != columns)
        refuse_line(
            row.line,
            fmt::format("the line has {}, the heading has {}", counted(row.cells.size(), "cell"), columns),
            "as many cells as headings (a decimal comma needs another separator, or quotes)");
}

void refuse_coverage_in_row(const TableRow& row, std::size_t label) {
    const std::string& name = row.cells.at(label);
    for (std::size_t k = 0; k < row.cells.size(); ++k)
        if (k != label && (!coverage_in_cell(name, row.cells[k]).empty() ||
                           (names_coverage_factor(name) && divides_otherwise(row.cells[k], 1))))
            refuse_line(
                row.line,
                fmt::format("{} states a coverage, {}, in a row", in_quotes(name), in_quotes(row.cells[k])),
                "the coverage in the heading of the uncertainties: \"esd (k=2)\"");
}

Finding left_out(std::string_view code, const TableRow& row, std::string_view noun, std::string_view label) {
    return {code, Severity::remark,
            fmt::format("{} is no {} and left out: {}", at_line(row.line), noun, with_texts(label, row))};
}

std::string with_texts(std::string_view label, const TableRow& row) {
    std::vector<std::string> texts;
    for (const std::string& cell : row.cells)
        if (cell != label && !cell.empty() && !says_no_number(cell) && !read_number(cell, true))
            texts.push_back(in_quotes(cell));
    return in_quotes(label) + (texts.empty() ? "" : " (" + joined(texts) + ")");
}

std::set<std::string_view> bases_in(std::string_view text, bool of_fractions) {
    static const WordLists bases("bases", " ");
    static const WordLists shares("words for fractions", "%");
    constexpr std::size_t reach = 2;  // words between "fractions" and "volume"
    const std::vector<std::string> words = words_in(text);
    std::set<std::string_view> found;
    for (const Mention& mention : mentions_in(words, bases)) {
        const auto begin = words.begin() + static_cast<std::ptrdiff_t>(mention.first);
        const auto end = begin + static_cast<std::ptrdiff_t>(mention.count);
        const auto is_share = [&](const std::string& word) { return shares.holds(word); };
        const bool near =
            std::any_of(begin - std::min<std::ptrdiff_t>(reach, begin - words.begin()), begin, is_share) ||
            std::any_of(end, end + std::min<std::ptrdiff_t>(reach, words.end() - end), is_share);
        const auto blank = mention.list.find(' ');  // of "volume share", words for fractions by themselves
        if (mention.list == "other" || mention.negated) continue;
        if ((!of_fractions || near || blank != std::string_view::npos))
            found.insert(mention.list.substr(0, blank));
    }
    return found;
}

void require_basis(const std::vector<TextBeside>& texts, std::string_view own) {
    for (const TextBeside& each : texts) {
        auto bases = bases_in(each.text);
        if (each.is_name)  // unlike "Number 5"
            for (const std::string_view base : bases_in(each.text, false))
                if (base == "volume" || base == "mole") bases.insert(base);
        const auto other = std::ranges::find_if(
            bases, [&](std::string_view base) { return base != own && (!own.empty() || base != "weight"); });
        if (other == bases.end() || (!own.empty() && bases.contains(own))) continue;
        refuse_line(
            each.line,
            fmt::format("{} states fractions by {}, and the headings of the amounts {}", in_quotes(each.text),
                        *other, own.empty() ? "state none" : fmt::format("by {}", own)),
            "one of the two: \"weight %\" or \"volume %\" in the headings, or a file without this text");
    }
}

namespace {

bool states_uncertainty(std::string_view cell) {
    if (cell.find_first_of("(+\xb1") == std::string_view::npos) return false;
    if (!number_behind_plus_minus(cell).empty()) return true;
    const auto number = read_number(cell, true);
    return number && number->standard_uncertainty;
}

/// Whether a text states relative uncertainties, or may: "rel. Fehler", "errors relative", "errors in %".
bool states_relative(std::string_view text) {
    static const WordLists qualifiers("relative quantities");
    constexpr std::size_t reach = 2;  // in words
    const std::vector<std::string> words = words_in(text);
    const auto names_uncertainty = [&](std::size_t k) {
        return is_uncertainty_word(words[k]) ||
               (k + 1 < words.size() && is_uncertainty_word(words[k] + ' ' + words[k + 1]));
    };
    for (std::size_t i = 0; i < words.size(); ++i)
        for (std::size_t k = i + 1; k < std::min(words.size(), i + 1 + reach); ++k)
            if ((qualifiers.holds(words[i]) && names_uncertainty(k)) ||
                (is_uncertainty_word(words[i]) &&
                 (qualifiers.holds(words[k]) || (words[k] == "%" && (k == i + 1 || words[i + 1] == "in")))))
                return true;
    return false;
}

/// Calls @p visitor(column, cell, row) for each cell with an uncertainty until one returns true.
template <class Visitor>
void for_each_uncertain(const UncertainColumns& columns, std::span<const TextLine> rows, char separator,
                        Visitor&& visitor) {
    bool done = false;
    for (const TextLine& row : rows) {
        if (done) return;
        for_each_cell(row, separator, [&](std::string_view cell, std::size_t k) {
            if (!done && k < columns.size() && columns[k] && states_uncertainty(cell))
                done = visitor(k, cell);
        });
    }
}

/// Refuses uncertainties whose coverage only a text beside the table states. @throws InputError at its line
void require_coverage_in_headings(const std::vector<TextBeside>& texts, const UncertainColumns& columns,
                                  std::span<const TextLine> rows, char separator) {
    for (const TextBeside& each : texts) {
        if (states_relative(each.text))
            for (const auto& column : columns)
                if (column && column->is_uncertainty && column->heading.find('%') == std::string::npos)
                    refuse_line(each.line,
                                in_quotes(each.text) +
                                    " states relative uncertainties, or may, and the column " +
                                    in_quotes(column->heading) + " does not",
                                "one of the two: [%] in the heading, or a file without this text");
        if (states_relative(each.text))
            for_each_uncertain(columns, rows, separator, [&](std::size_t k, std::string_view cell) {
                if (cell.find('%') == std::string_view::npos)
                    refuse_line(
                        each.line,
                        fmt::format("{} states relative uncertainties, or may, and {} in column {} "
                                    "does not",
                                    in_quotes(each.text), in_quotes(cell), in_quotes(columns[k]->heading)),
                        "a column of the uncertainties, or a file without this text");
                return false;
            });
        const StatedCoverage coverage = read_coverage(each.text);
        const bool is_other = coverage.stated.empty() && !coverage.problem.empty();  // "FA1 ± range"
        if (!is_other && (coverage.stated.empty() || coverage.factor == 1)) continue;
        const auto refuse = [&](const std::string& what, std::string_view heading) {
            if (is_other)
                refuse_line(each.line,
                            fmt::format("{} may be of {}: {}", in_quotes(each.text), what, coverage.problem),
                            "the kind of the uncertainties in the heading, and a file without this text");
            refuse_line(each.line,
                        fmt::format("{} states {}, and {} does not", in_quotes(each.text),
                                    in_quotes(coverage.stated), what),
                        fmt::format("the coverage in the heading, {}, or a file without this text",
                                    in_quotes(fmt::format("{} ({})", heading, coverage.stated))));
        };
        for (const auto& column : columns)
            if (column && column->is_uncertainty && column->coverage.stated.empty())
                refuse("the column " + in_quotes(column->heading), column->heading);
        for_each_uncertain(columns, rows, separator, [&](std::size_t k, std::string_view cell) {
            if (columns[k]->coverage.stated.empty())
                refuse(fmt::format("the heading {} of {}", in_quotes(columns[k]->heading), in_quotes(cell)),
                       columns[k]->heading);
            return false;
        });
        for (const TextLine& row : rows) {
            const std::string label = cut_row(row, separator).cells.front();
            if (is_uncertainty_word(label.substr(label.rfind(' ') + 1)) &&
                read_coverage(label).stated.empty())
                refuse("the row " + in_quotes(label), label);
        }
    }
}

}  // namespace

namespace {

/// Whether a cell is more than a number with its signs.
bool holds_text(std::string_view cell) {
    return cell.find_first_not_of("+-.,()<0123456789 ") != std::string::npos;
}

}  // namespace

std::string coverage_in_cell(std::string_view heading, std::string_view cell) {
    constexpr std::size_t longest = 40;
    const bool may_state =
        cell.size() <= longest && cell.find_first_of("0123456789") != std::string::npos && holds_text(cell);
    if (!may_state) return {};
    std::string text = fmt::format("{}: {}", heading, cell);
    return read_coverage(text).factor != 1 ? text : std::string();
}

std::vector<std::string> texts_in_column(std::span<const TableRow> rows, std::size_t column) {
    constexpr std::size_t most_words = 3;
    constexpr std::size_t most_remarks = 12;
    std::vector<std::string> texts;
    std::size_t words = 0;
    bool is_whole = true;
    for (const TableRow& row : rows) {
        if (column >= row.cells.size() || !holds_text(row.cells[column])) continue;
        const std::string& cell = row.cells[column];
        const std::string quoted = in_quotes(cell);
        if (std::ranges::find(texts, quoted) != texts.end()) continue;
        const bool is_word = cell.find_first_of(" %/") == std::string::npos;  // "ok", "33-1161"
        if (is_word ? words == most_words : texts.size() - words == most_remarks) {
            is_whole = false;
            continue;
        }
        words += is_word ? 1 : 0;
        texts.push_back(quoted);
    }
    if (!is_whole) texts.emplace_back("...");
    return texts;
}

void take_coverage_of_amounts(const UncertainColumn& amounts, const std::string& heading,
                              StatedCoverage& coverage, std::size_t line) {
    const StatedCoverage& of = amounts.coverage;
    const bool is_standard = of.factor == 1 && of.problem.empty();
    if (is_standard || of.stated.empty() || !coverage.stated.empty() || !coverage.problem.empty()) return;
    static const WordLists words("uncertainty", " ");
    const auto mentions = mentions_in(words_in(heading), words);
    if (uncertainty_words().list_of(heading) == "standard" ||
        std::ranges::any_of(mentions, [](const Mention& each) { return each.list == "standard"; }))
        refuse_line(line,
                    fmt::format("{} states {}, and {} behind it names standard uncertainties",
                                in_quotes(amounts.heading), in_quotes(of.stated), in_quotes(heading)),
                    "the coverage behind that name: " + in_quotes(heading + " (" + of.stated + ")"));
    coverage.factor = of.factor;
    coverage.stated = of.stated;
    coverage.problem = of.problem;
}

std::vector<std::size_t> repeated_sides(const std::vector<std::optional<UncertaintySide>>& sides,
                                        const TableRow& headings, std::span<const TableRow> rows) {
    const auto size_of = [](const TableRow& row, std::size_t k) {
        const std::string cell = k < row.cells.size() ? row.cells[k] : std::string();
        const auto number = cell.empty() ? std::nullopt : read_number(cell, true);
        return number ? shortest(std::abs(number->value)) : cell;
    };
    std::vector<std::size_t> repeated;
    for (std::size_t k = 0; k < sides.size(); ++k) {
        if (!sides[k]) continue;
        const std::string first = in_quotes(headings.cells[k]);
        if (k + 1 == sides.size() || !sides[k + 1] || sides[k]->is_upper == sides[k + 1]->is_upper)
            refuse_line(headings.line, "the column " + first + " holds uncertainties to one side",
                        "the column of the other side behind it, or one of standard uncertainties: \"esd\"");
        for (const TableRow& row : rows)
            if (const std::string one = size_of(row, k), other = size_of(row, k + 1); one != other)
                throw InputError(
                    fmt::format("the uncertainties {} and {} in the columns {} and {} are not "
                                "equal, and one standard uncertainty is read",
                                in_quotes(one), in_quotes(other), first, in_quotes(headings.cells[k + 1])),
                    "a column \"esd\" of standard uncertainties, or equal ones")
                    .at(at_cell(row.line, k));
        repeated.push_back(++k);
    }
    return repeated;
}

void check_coverage(std::string_view code, const std::vector<TextBeside>& texts,
                    const UncertainColumns& columns, std::span<const TextLine> rows, char separator,
                    std::vector<Finding>& findings) {
    require_coverage_in_headings(texts, columns, rows, separator);
    UncertainColumns stated(columns.size());
    for (std::size_t k = 0; k < columns.size(); ++k)
        if (columns[k] && (columns[k]->coverage.factor != 1 || !columns[k]->coverage.problem.empty()))
            stated[k] = columns[k];
    if (!std::ranges::any_of(stated, [](const auto& column) { return column.has_value(); })) return;
    for_each_uncertain(stated, rows, separator, [&](std::size_t k, std::string_view) {
        stated[k]->is_uncertainty = true;
        return std::ranges::all_of(stated, [](const auto& each) { return !each || each->is_uncertainty; });
    });
    std::map<double, std::vector<std::string>> divided;
    for (const auto& column : stated) {
        if (!column) continue;
        const StatedCoverage& coverage = column->coverage;
        const std::size_t next = static_cast<std::size_t>(&column - stated.data()) + 1;
        const bool is_of_next = next < stated.size() && stated[next] &&
                                stated[next]->coverage.stated == coverage.stated;  // "wt% (2s);error"
        if (!column->is_uncertainty && is_of_next) continue;
        if (!column->is_uncertainty && coverage.of_stated_uncertainties)
            throw InputError(
                fmt::format("column {} states {}, and nothing has uncertainties of that coverage",
                            in_quotes(column->heading), in_quotes(coverage.stated)),
                "numbers with \"\u00b1\", a column of uncertainties behind it, or a heading "
                "without this text");
        if (!column->is_uncertainty)
            findings.push_back(
                {code, Severity::remark,
                 fmt::format("column {} {} and holds no uncertainties", in_quotes(column->heading),
                             coverage.stated.empty() ? "has a word beside its name that is not read"
                                                     : "states a coverage")});
        else if (!coverage.problem.empty())
            findings.push_back({code, Severity::doubt,
                                fmt::format("uncertainties of column {} are not read, as {}",
                                            in_quotes(column->heading), coverage.problem)});
        else
            divided[coverage.factor].push_back(in_quotes(column->heading));
    }
    for (const auto& [factor, headings] : divided)
        findings.push_back(
            {code, Severity::remark,
             fmt::format("uncertainties of {} {} are divided by {} for standard ones, as the heading says",
                         headings.size() == 1 ? "column" : "columns", joined(headings), shortest(factor))});
}

namespace {

/// A unit that a text states behind no number: "mm" in "sizes in mm", but not in "a sieve of 200 mm".
struct StatedUnit {
    std::string_view text;
    Unit unit;
};

/// The unit that a text is; none for "in", which is hardly inches.
std::optional<Unit> unit_of_text(std::string_view text) {
    constexpr std::size_t longest = 40;
    if (text.size() > longest || lower_case(text) == "in" || lower_case(text).starts_with("in "))
        return std::nullopt;
    return read_unit(text == "ms-1" ? "m/s" : ascii_unit(text));
}

std::vector<StatedUnit> units_in(std::string_view text) {
    constexpr std::string_view ends = " \t,;:()[]\"";
    std::vector<StatedUnit> units;
    bool behind_number = false;
    for (auto from = text.find_first_not_of(ends); from != std::string_view::npos;) {
        const auto end = std::min(text.find_first_of(ends, from), text.size());
        const std::string_view first = text.substr(from, end - from);
        std::string_view word = first;
        auto unit = first.size() < 2 ? std::nullopt : unit_of_text(first);
        for (std::size_t i = 0, behind = end; i < 2 && behind < text.size(); ++i) {  // "mm s-1", "mm per s"
            behind = std::min(text.find_first_of(ends, behind + 1), text.size());
            const std::string_view longer = trimmed(text.substr(from, behind - from));
            if (const auto of_longer = unit_of_text(longer)) {
                unit = of_longer;
                word = longer;
            }
        }
        from = text.find_first_not_of(ends, from + word.size());
        const bool is_value = std::exchange(behind_number, read_number(first, true).has_value());
        if (unit && !is_value && !behind_number) units.push_back({word, *unit});
    }
    return units;
}

}  // namespace

void require_units(const std::vector<TextBeside>& texts, const std::vector<ColumnUnit>& columns) {
    for (const TextBeside& each : texts) {
        const StatedUnit* other = nullptr;
        const ColumnUnit* its_column = nullptr;
        bool agrees = false;
        const auto units = units_in(each.text);
        for (const StatedUnit& stated : units)
            for (const ColumnUnit& column : columns) {
                if (stated.unit.powers != read_unit(si_unit(column.dimension))->powers) continue;
                const bool same = std::abs(stated.unit.factor / column.unit - 1) < 1e-9;
                agrees = agrees || same;
                if (same || other != nullptr) continue;
                other = &stated;
                its_column = &column;
            }
        if (other != nullptr && !agrees)
            refuse_line(each.line,
                        fmt::format("{} states {}, and column {} is taken in another unit",
                                    in_quotes(each.text), other->text, in_quotes(its_column->heading)),
                        "one of the two: the unit in the heading, or a file without this text");
    }
}

void require_diameters(const std::vector<TextBeside>& texts) {
    static const WordLists words("other sizes", " ");
    for (const TextBeside& each : texts)
        for (const Mention& mention : mentions_in(words_in(each.text), words))
            if (!mention.negated)
                refuse_line(each.line, fmt::format("{} states {}", in_quotes(each.text), mention.list),
                            "diameters of the particles");
}

bool calls_invalid(std::string_view text) {
    if (text.find_first_not_of("+-.,0123456789 ") == std::string_view::npos) return false;
    static const WordLists words("invalid impacts", " ");
    const auto mentions = mentions_in(words_in(text), words);
    return std::ranges::any_of(mentions, [](const Mention& mention) { return !mention.negated; });
}

void refuse_invalid_row(std::string_view cell, const std::string& column, std::size_t line,
                        std::size_t position) {
    throw InputError(
        fmt::format("{} in {} calls the row invalid, and remarks are not read", in_quotes(cell), column),
        "a file without this row, or without the remark if the row counts")
        .at(at_cell(line, position));
}

Finding uncertainties_in_per_cent(std::string_view code) {
    return {
        code, Severity::remark,
        "the uncertainties in % are taken as per cent of the sample, as the amounts are, not of the amounts"};
}

void SmallUncertainties::take(double amount, std::string_view text, double uncertainty) {
    if (!(uncertainty > 0)) return;
    if (first_.empty()) first_ = text;
    greatest_ratio_ = std::max(greatest_ratio_, uncertainty / amount);
}

std::optional<Finding> SmallUncertainties::finding(std::string_view code) const {
    constexpr double least = 0.005;
    if (first_.empty() || greatest_ratio_ > least) return std::nullopt;
    return Finding{
        code, Severity::doubt,
        "the uncertainties, such as " + in_quotes(first_) +
            ", are taken as per cent of the sample: if they are fractions, they are a hundred times "
            "larger (write their unit)"};
}

std::vector<std::optional<Finding>> small_namesakes(std::string_view code,
                                                    const std::vector<NamedSum>& samples) {
    std::vector<std::optional<Finding>> findings(samples.size());
    double greatest = 0;
    for (const NamedSum& sample : samples) greatest = std::max(greatest, sample.sum);
    std::vector<std::vector<std::string>> names(samples.size());
    std::vector<std::string> keys;
    for (const NamedSum& sample : samples) keys.push_back(word_key(sample.name));
    std::size_t whole = samples.size();  // the last one
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (2 * samples[i].sum >= greatest) {
            whole = i;
            continue;
        }
        const auto is_namesake = [&](std::size_t k) {
            return 2 * samples[i].sum < samples[k].sum && !keys[k].empty() &&
                   keys[i].find(keys[k]) != std::string::npos;
        };
        bool named = false;
        for (std::size_t k = 0; k < samples.size(); ++k)
            if (is_namesake(k)) {
                names[k].push_back(in_quotes(samples[i].name));
                named = true;
            }
        if (!named && whole < samples.size()) names[whole].push_back(in_quotes(samples[i].name));
    }
    for (std::size_t i = 0; i < samples.size(); ++i)
        if (!names[i].empty())
            findings[i] = {code, Severity::remark,
                           fmt::format("{} {} not read as uncertainties of {}: write {} for standard ones",
                                       joined(names[i]), names[i].size() == 1 ? "is" : "are",
                                       in_quotes(samples[i].name), in_quotes(samples[i].name + " esd"))};
    return findings;
}

void refuse_two_methods(const std::vector<std::string>& names, std::size_t line) {
    static const WordLists methods("methods");
    const auto names_method = [](const std::string& name) {
        return name.size() <= longest_heading &&
               std::ranges::any_of(words_in(name),
                                   [](const std::string& word) { return methods.holds(word); });
    };
    const auto other = std::ranges::find_if(names, names_method);
    if (other == names.end()) return;
    for (const std::string& name : names)
        if (lower_case(name).starts_with("sem") && words_in(name).front() == "sem" && !names_method(name))
            refuse_line(line,
                        in_quotes(name) + " beside " + in_quotes(*other) +
                            " may be standard errors of the mean, or amounts by scanning electron microscopy",
                        "\"standard error\" or \"SEM-EDX\" in place of \"SEM\"");
}

bool has_sign_of_bound(std::string_view text) {
    for (const std::string_view sign : {"<", ">", "~", "\u2264", "\u2265", "\u2248"})
        for (auto at = text.find(sign); at != std::string_view::npos; at = text.find(sign, at + 1)) {
            const std::string_view behind = trimmed(text.substr(at + sign.size()));
            if (behind.empty() || (!is_digit(behind.front()) && behind.front() != '=')) return true;
        }
    return false;
}

void refuse_sign_of_bound(std::string_view cell, const std::string& column, std::size_t line,
                          std::size_t position) {
    if (cell != "<" && cell != "\u2264") return;
    throw InputError(fmt::format("{} in {} may make the number beside it a bound", in_quotes(cell), column),
                     "\"< 0.6\" in the cell of the number, or a file without this column")
        .at(at_cell(line, position));
}

namespace {

/// The number of a cell that states a coverage: 2 of "k = 2", 95 of "95 %" and of "0.95".
std::optional<double> coverage_number(std::string_view cell) {
    if (const auto sign = cell.find('='); sign != std::string_view::npos)
        cell = trimmed(cell.substr(sign + 1));
    const auto number = cell.empty() ? std::nullopt : read_number(cell, true);
    if (!number) return std::nullopt;
    const bool is_fraction = number->value > 0.5 && number->value < 1;
    return is_fraction ? 100 * number->value : number->value;
}

/// Whether all numbers of a column are accepted, and there are some.
template <class Predicate>
bool all_numbers(std::span<const TableRow> rows, std::size_t column, const Predicate& accepted) {
    bool any = false;
    for (const TableRow& row : rows) {
        const auto number = column < row.cells.size() ? coverage_number(row.cells[column]) : std::nullopt;
        if (number && !accepted(*number)) return false;
        any = any || number;
    }
    return any;
}

/// Whether a column states coverages: by its heading, or, below "k" and "Level", by its numbers as well.
bool states_coverages(std::string_view heading, std::span<const TableRow> rows, std::size_t column) {
    if (may_name_coverages(heading))
        return all_numbers(rows, column,
                           [](double number) { return factor_of_coverage(shortest(number)).has_value(); });
    if (!names_coverage_factor(heading)) return false;
    constexpr double largest = 13;  // of 95 % by two measurements
    return word_key(heading.substr(0, heading.find_first_of("[("))).size() > 1 ||
           all_numbers(rows, column, [](double number) { return number >= 1 && number <= largest; });
}

}  // namespace

bool divides_otherwise(std::string_view cell, double factor) {
    constexpr double rounding = 0.03;  // 2 for 1.96
    const auto number = coverage_number(cell);
    if (!number) return false;
    const double stated = factor_of_coverage(shortest(*number)).value_or(*number);
    return std::abs(stated - factor) > rounding * factor;
}

bool holds_signs(std::string_view name) {
    static const std::regex factor("(?:^| )[xX/] *[0-9]|[0-9] *[xX](?: |$|[0-9])");  // "FA1 x 2"
    return name.find_first_of("()[]{}=#%+*") != std::string_view::npos ||
           std::ranges::any_of(std::array{"\u00b1", "\u00d7", "\u00b7"},
                               [&](const char* sign) { return name.find(sign) != std::string_view::npos; }) ||
           (name.size() <= longest_heading && std::regex_search(std::string(name), factor));
}

/// Whether a label holds more than letters before a number, as the name of an added material: "FA1_10MgO",
/// "FA1-NaCl10", "FA1spiked", "FA1_IS10", unlike "FA1a" and "FlyAsh2".
static bool joins_parts(std::string_view name) {
    static const WordLists plain("names of samples");
    static const std::regex behind_number("[0-9]([A-Za-z\x80-\xff]{2,})");
    static const std::regex formula_or_mark(
        "[A-Z][a-z][A-Z]|[^A-Za-z](?:IS|ISTD|[Ss]td|STD|[Ss]piked?)(?:[^A-Za-z]|$)|[A-Za-z]{7,}[0-9]");
    if (name.size() > longest_heading) return true;
    const std::string text(name);
    std::smatch match;
    if (std::regex_search(text, match, behind_number) && !plain.holds(match.str(1))) return true;
    return words_in(name).size() > 1 && std::regex_search(text, formula_or_mark);
}

bool may_state_more(std::string_view name) {
    static const WordLists plain("names of samples");
    if (joins_parts(name)) return true;
    std::vector<std::string> words = words_in(name);
    std::erase_if(words, [](const std::string& word) {
        return word.size() == 1 || std::ranges::all_of(word, is_digit);
    });
    return holds_signs(name) || (words.size() > 1 && std::ranges::any_of(words, [&](const std::string& word) {
                                     return !plain.holds(word) && !std::ranges::any_of(word, is_digit);
                                 }));
}

std::optional<Finding> names_not_read(std::string_view code, std::vector<std::string> names,
                                      const std::string& counted) {
    if (names.empty()) return std::nullopt;
    for (std::string& name : names) name = in_quotes(name);
    return Finding{code, Severity::remark,
                   "these names are read as names of samples alone: " + joined(names) + "; " + counted};
}

void refuse_coverages(std::string_view heading, std::span<const TableRow> rows, std::size_t column,
                      std::span<const double> factors) {
    if (!states_coverages(heading, rows, column)) return;
    for (const TableRow& row : rows) {
        if (column >= row.cells.size()) continue;
        const std::string& cell = row.cells[column];
        const auto otherwise = [&](double factor) { return divides_otherwise(cell, factor); };
        const bool in_cells = factors.empty() && holds_uncertain_number(row) && otherwise(1);
        if (in_cells || std::ranges::any_of(factors, otherwise))
            throw InputError(fmt::format("column {} states a coverage, {}, and the uncertainties beside it "
                                         "are not divided for it",
                                         in_quotes(heading), cell),
                             "standard uncertainties, divided by their factor; or (k=2) in the heading of "
                             "the uncertainties, for all of them")
                .at(at_cell(row.line, column));
    }
}

bool holds_uncertain_number(const TableRow& row) {
    return std::ranges::any_of(
        row.cells, [](const std::string& cell) { return !number_behind_plus_minus(cell).empty(); });
}

std::map<std::string_view, TextBeside> statements_in(const std::vector<TextBeside>& texts) {
    static const WordLists words("statements", " ");
    std::map<std::string_view, TextBeside> found;
    for (const TextBeside& each : texts)
        for (const Mention& mention : mentions_in(words_in(each.text), words))
            if (mention.list == "amorphous" ? mention.negated : !mention.negated)
                found.emplace(mention.list == "amorphous" ? "crystalline part" : mention.list, each);
    return found;
}

bool makes_statement(const TextBeside& text, const std::set<std::string_view>& statements) {
    const auto made = statements_in({text});
    return std::ranges::any_of(made, [&](const auto& each) { return statements.contains(each.first); });
}

void refuse_factors(const std::vector<TextBeside>& texts) {
    static const std::regex alone("(?:x|\u00d7|[*]|/|\u00f7) *[0-9][0-9.,]*");  // "x10"
    constexpr std::size_t longest = 20;
    for (const TextBeside& each : texts)
        if ((makes_statement(each, {"factor"}) && read_coverage(each.text).stated.empty()) ||
            (each.text.size() <= longest && std::regex_match(each.text, alone)))
            refuse_line(each.line,
                        in_quotes(each.text) + " may state a factor of the numbers, and is not read",
                        "the numbers without a factor, and a file without this text");
}

Finding unused_statement(std::string_view code, const TextBeside& text, std::string_view taken_as) {
    return {code, Severity::remark,
            fmt::format("{}: {} is not read: {}", at_line(text.line), in_quotes(text.text), taken_as)};
}

NameAndUnit cut_heading(std::string_view heading) {
    const auto bracket = heading.find_last_of("[(");
    const auto in = heading.rfind(" in ");
    if (bracket != std::string_view::npos && bracket > 0) {
        const auto end = std::min(heading.find_first_of("])", bracket), heading.size());
        if (end + 1 < heading.size()) return {std::string(heading), {}};  // "passing [%] of each sieve"
        return {std::string(trimmed(heading.substr(0, bracket))),
                std::string(trimmed(heading.substr(bracket + 1, end - bracket - 1)))};
    }
    if (in != std::string_view::npos)
        return {std::string(trimmed(heading.substr(0, in))), std::string(trimmed(heading.substr(in + 4)))};
    if (const auto slash = heading.rfind(" / "); slash != std::string_view::npos)
        return {std::string(trimmed(heading.substr(0, slash))),
                std::string(trimmed(heading.substr(slash + 3)))};
    const auto blank = heading.rfind(' ');
    if (blank != std::string_view::npos && heading.ends_with('%'))
        return {std::string(trimmed(heading.substr(0, blank))), std::string(heading.substr(blank + 1))};
    return {std::string(heading), {}};
}

std::optional<std::string> unused_column(std::string_view heading, std::span<const TextLine> rows,
                                         char separator, std::size_t column) {
    std::vector<TableRow> cut;
    std::string first;
    for (const TextLine& line : rows) {
        cut.push_back(cut_row(line, separator));
        if (first.empty() && column < cut.back().cells.size()) first = cut.back().cells[column];
    }
    if (heading.empty() && first.empty()) return std::nullopt;
    std::vector<std::string> texts = texts_in_column(cut, column);
    if (heading.empty() && texts.empty()) texts.push_back(in_quotes(first));
    const std::string name =
        heading.empty() ? fmt::format("{}, which has no heading,", column + 1) : in_quotes(heading);
    return fmt::format("column {} is not used{}", name, texts.empty() ? "" : ": " + joined(texts));
}

std::optional<Unit> unit_of_quantity(std::string_view heading) {
    const NameAndUnit cut = cut_heading(heading);
    const std::string_view text = cut.unit;
    if (text.substr(0, 2) == "\u00b0") return read_unit("K");
    const auto unit = text.empty() ? std::nullopt : read_unit(ascii_unit(text));
    return unit && unit->powers != Unit{}.powers ? unit : std::nullopt;
}

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "materials/xrd/table_layout.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "core/quantities/checks.hpp"
#include "core/quantities/quantity.hpp"
#include "core/tables/table_texts.hpp"
#include "core/tables/vocabulary.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "core/units/units.hpp"
#include "materials/xrd/readers.hpp"
#include "materials/xrd/xrd.hpp"

namespace ashimpact::xrd {

namespace {

/// Whether the heading of a column beside the phases may be the name of a sample: it has no unit but those of
/// fractions, and no sign of a quantity.
bool may_name_sample(const Heading& heading) {
    static const WordLists qualifiers("XRD qualifiers");
    if (heading.role == Role::measure) return false;
    if (heading.role != Role::other) return true;
    if (qualifiers.holds(heading.text)) return false;
    const std::vector<std::string> words = words_in(heading.text);
    const bool of_peaks = !words.empty() && (words.back() == "peak" || words.back() == "peaks");
    if (of_peaks && heading.states == HeadingUnit::fraction) return false;  // "FA1 peak %"
    constexpr std::array<std::string_view, 15> signs{"%",  "\u2030", "\u221a", "\u00b2", "\u00b3",
                                                     "^",  "\u0394", "\u2206", "\u03c3", "\u00bd",
                                                     "1/", "\u00b0", "\u00c5", "\u03b8", "ppm"};
    const bool is_quotient =
        heading.text.find('/') != std::string::npos && read_unit(ascii_unit(heading.text)).has_value();
    static const std::regex temperature("([0-9]) *\u00b0 *C");  // "FA1 900 °C"
    const std::string name = heading.text.size() > longest_heading
                                 ? heading.text
                                 : std::regex_replace(heading.text, temperature, "$1");
    return heading.states != HeadingUnit::other && !is_quotient &&
           std::none_of(signs.begin(), signs.end(),
                        [&](std::string_view sign) { return name.find(sign) != std::string::npos; });
}

constexpr std::string_view heading_help =
    "a heading line with phase and weight (and sample, uncertainty, density), or phase, intensity and rir, "
    "or sample and one column a phase, or phase and one column a sample";

constexpr std::size_t most_cells = 500'000;

/// Whether a heading of amounts states two bases, "wt%/vol%", or a sign that changes them, "±wt%", "wt% <".
bool is_ambiguous(const Heading& heading) {
    const bool amounts = heading.role == Role::weight || heading.role == Role::volume ||
                         (heading.role == Role::other && heading.states != HeadingUnit::none);
    if (!amounts) return false;
    auto bases = bases_in(heading.written, false);
    for (const char* other : {"number", "intensity", "mode"}) bases.erase(other);
    if (bases.size() > 1) return true;
    return has_sign_of_bound(heading.written);
}

std::vector<Heading> headings_of(const TableRow& row) {
    std::vector<Heading> headings;
    bool has_amounts = false;
    std::string name;  // of the last phase or sample
    for (const std::string& cell : row.cells) {
        headings.push_back(read_heading_beside(cell, name));
        Heading& heading = headings.back();
        if (heading.role == Role::other && !heading.text.empty()) name = heading.text;
        const bool is_amount = heading.role == Role::weight || heading.role == Role::volume;
        const bool is_uncertainty_alone =
            is_amount && !has_amounts && (cell.starts_with("\u00b1") || cell.starts_with("+"));
        const bool is_one_side = heading.role == Role::uncertainty && cell.starts_with('+') &&
                                 !cell.starts_with("+-") && !cell.starts_with("+/");
        if (names_other_basis(heading) || is_ambiguous(heading) || is_uncertainty_alone || is_one_side)
            heading.role = Role::measure;
        has_amounts = has_amounts || is_amount;
    }
    return headings;
}

/// Whether a line can be the heading: it names a sample or phase column and at least one more.
bool is_heading(const std::vector<Heading>& headings) {
    return headings.size() >= 2 && std::any_of(headings.begin(), headings.end(), [](const Heading& heading) {
               return heading.role == Role::phase || heading.role == Role::sample;
           });
}

/// Whether a heading also names a column of amounts, which a title does not.
bool names_amounts(const std::vector<Heading>& headings) {
    return std::any_of(headings.begin(), headings.end(), [](const Heading& heading) {
        return heading.role == Role::weight || heading.role == Role::volume ||
               heading.role == Role::intensity;
    });
}

/// Whether a line names the groups of columns of a heading with the amounts of several samples:
/// "Phase;FA1;;FA2;" above "Phase;wt%;esd;wt%;esd".
bool names_groups(const TextLine& line, const TableRow& heading, const std::vector<Heading>& headings) {
    const auto of_role = [&](Role role) { return std::ranges::count(headings, role, &Heading::role); };
    if (std::max(of_role(Role::weight), of_role(Role::volume)) < 2 || std::ranges::count(line.text, '"') > 0)
        return false;
    const std::vector<std::string> groups = cut_row(line, separator_of(line.text)).cells;
    const auto empty = std::ranges::count(groups, std::string());
    return groups.size() == heading.cells.size() && std::ssize(groups) > empty + 1 &&
           (groups[0].empty() || groups[0] == heading.cells[0]);
}

/// Whether a line can be the heading of columns of samples beside one of phases without a heading, as
/// spreadsheets have them: ";FA1 [wt%];FA2 [wt%]".
bool heads_samples(const TableRow& row) {
    if (row.cells.size() < 2 || !row.cells.front().empty()) return false;
    const auto headings = headings_of(row);
    return std::all_of(headings.begin() + 1, headings.end(), [](const Heading& heading) {
        const bool is_sample = heading.role == Role::other && heading.states != HeadingUnit::none &&
                               heading.states != HeadingUnit::other && !heading.text.empty();
        return is_sample || heading.role == Role::uncertainty;
    });
}

/// Index of the heading line among the first lines. Titles such as "Sample;Fly ash 7" may precede it:
/// the first line that names amounts is preferred to one that may be a title, then the one of most cells,
/// unless there are numbers between them.
std::optional<std::size_t> find_heading(const std::vector<TextLine>& lines) {
    constexpr std::size_t most_titles = 20;
    std::optional<std::size_t> possible;
    std::size_t widest = 0;
    for (std::size_t i = 0; i < std::min(lines.size(), most_titles); ++i) {
        try {
            const TableRow row = cut_row(lines[i], separator_of(lines[i].text));
            const bool holds_number =
                std::any_of(row.cells.begin(), row.cells.end(),
                            [](const std::string& cell) { return read_number(cell, true).has_value(); });
            if (possible && holds_number) return possible;
            const auto headings = headings_of(row);
            if (!possible && heads_samples(row)) return i;
            if (!is_heading(headings)) continue;
            if (names_amounts(headings))
                return i - (i > 0 && names_groups(lines[i - 1], row, headings) ? 1 : 0);
            if (headings.size() > widest) {
                possible = i;
                widest = headings.size();
            }
        } catch (const InputError&) {
            continue;  // a title with an odd quote
        }
    }
    return possible;
}

bool is_uncertainty(const Heading& heading) {
    return heading.role == Role::uncertainty || heading.role == Role::ratio_uncertainty;
}

/// Leaves out uncertainties in another unit than the fractions, such as [rel.%].
void check_units_of_uncertainties(Table& table) {
    if (table.has(Role::intensity)) {
        for (std::size_t k = 1; k < table.headings.size(); ++k)
            if (is_uncertainty(table.headings[k]) && table.headings[k].scale == Scale::per_cent)
                table.headings[k].coverage.problem =
                    table.headings[k - 1].scale == Scale::per_cent
                        ? "[%] may be of the greatest intensity or of the value"
                        : "they are in another unit than the column before them";
        return;
    }
    const auto amounts = std::ranges::find_if(table.headings, [](const Heading& heading) {
        return heading.role == Role::weight || heading.role == Role::volume ||
               (heading.role == Role::other && !heading.unit.empty());
    });
    for (Heading& heading : table.headings) {
        if (heading.role != Role::uncertainty || (heading.unit.empty() && !may_be_relative(heading)))
            continue;
        const bool known = amounts != table.headings.end();
        const bool is_volume =
            known && (amounts->role == Role::volume || amounts->states == HeadingUnit::volume);
        const bool scaled_alike =
            !known || amounts->scale == Scale::not_stated || amounts->scale == heading.scale;
        if (heading.states == HeadingUnit::other || !scaled_alike ||
            heading.states == (is_volume ? HeadingUnit::weight : HeadingUnit::volume))
            heading.coverage.problem = "they are in another unit than the fractions";
        else if (may_be_relative(heading))
            heading.coverage.problem =
                "[%] may be of the whole or of the value (write the unit of the fractions)";
    }
}

/// The cell "12.3 wt%" as "12.3 %", if its heading states no other unit.
std::string without_unit(const std::string& cell, const Heading& heading) {
    if (heading.role == Role::uncertainty) return cell;
    const bool is_volume = heading.role == Role::volume || heading.states == HeadingUnit::volume;
    return without_fraction_unit(cell, is_volume ? HeadingUnit::volume : HeadingUnit::weight);
}

/// The number of a cell, with uncertainties as standard ones; nothing if the cell states that there is none.
std::optional<PrintedNumber> number_in(const TableRow& row, std::size_t column, const Table& table) {
    const std::string& cell = row.cells[column];
    if (says_no_number(cell)) return std::nullopt;
    const Heading& heading = table.headings[column];
    auto number = at_place(at_cell(row.line, column), [&] {
        const auto plain = table.marks.read(cell, column);
        return plain ? plain : table.marks.read(without_unit(cell, heading), column);
    });
    if (!number) throw InputError("cannot read " + in_quotes(cell), "a number").at(at_cell(row.line, column));
    if (number->per_cent && heading.scale != Scale::not_stated && heading.scale != Scale::per_cent)
        throw InputError(in_quotes(cell) + " is per cent, and the heading " + in_quotes(heading.written) +
                             " states another unit",
                         "one of the two")
            .at(at_cell(row.line, column));
    const bool of_ratio = heading.role == Role::ratio || heading.role == Role::ratio_uncertainty;
    if (number->per_cent && of_ratio)
        throw InputError(in_quotes(cell) + " is per cent, and reference intensity ratios have no unit",
                         "a number without a unit, 0.17 for 5 % of 3.4")
            .at(at_cell(row.line, column));
    const auto states_per_cent = [](const Heading& each) { return each.scale == Scale::per_cent; };
    const bool alone = std::ranges::count_if(row.cells, holds_per_cent) == 1;  // unlike "12.3 %;0.4 %"
    if (heading.role == Role::uncertainty && number->per_cent && alone &&
        std::ranges::any_of(table.headings, states_per_cent) && !states_per_cent(heading))
        throw InputError(in_quotes(cell) + " may be per cent of the whole, or of the value before it",
                         "the number alone, or the unit in the heading of the column")
            .at(at_cell(row.line, column));
    if (!heading.coverage.problem.empty()) {  // parse_table() has added a warning
        number->standard_uncertainty.reset();
        return is_uncertainty(heading) ? std::nullopt : number;
    }
    if (number->standard_uncertainty) *number->standard_uncertainty /= heading.coverage.factor;
    if (is_uncertainty(heading)) number->value /= heading.coverage.factor;
    return number;
}

constexpr const char* density_alone =
    "the density alone, or the phase with its uncertainty under \"phases\" of a case";

/// A cell of a number and its unit, "2,65 g/cm3", with a decimal point whatever mark the table has.
std::string with_decimal_point(const std::string& cell, std::size_t column, const NumberMarks& marks) {
    const auto end = std::min(cell.find_first_not_of("0123456789.,"), cell.size());
    if (cell.substr(0, end).find(',') == std::string::npos) return cell;
    const auto number = marks.read(cell.substr(0, end), column);
    return number ? shortest(number->value) + cell.substr(end) : cell;
}

std::optional<double> density_in(const TableRow& row, std::size_t column, const Table& table) {
    const std::string& cell = row.cells[column];
    const Heading& heading = table.headings[column];
    if (says_no_number(cell)) return std::nullopt;
    return at_place(at_cell(row.line, column), [&] {
        if (heading.unit.empty() && read_number(cell, true))
            throw InputError("column " + in_quotes(heading.written) + ": the density has no unit",
                             "density [g/cm3] as the heading, or a unit in each cell");
        const auto number = heading.unit.empty() ? std::nullopt : number_in(row, column, table);
        const Quantity with_unit =
            number ? Quantity{}
                   : quantity_of_text(with_decimal_point(cell, column, table.marks), Dimension::density);
        require_certain(number ? number->standard_uncertainty : with_unit.standard_uncertainty,
                        in_quotes(cell) + " ", density_alone);
        const double density =
            number ? at_place("column " + in_quotes(heading.written),
                              [&] { return to_si(number->value, heading.unit, Dimension::density); })
                   : with_unit.value;
        if (!(density > 0)) throw InputError("the density is not positive", "a positive density");
        return std::optional(density);
    });
}

}  // namespace

void refuse_bare_uncertainty(std::string_view amount_text, std::string_view text, const PrintedNumber& amount,
                             double uncertainty, std::size_t line, std::size_t column) {
    const bool has_unit = std::ranges::any_of(
        amount_text, [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; });  // "wt%"
    const bool may_be_fraction = !has_unit && uncertainty > 0 && uncertainty <= amount.value / 100;
    if (!amount.per_cent || !may_be_fraction) return;
    throw InputError(
        fmt::format("{} has no sign, and the amount beside it is {}: it may be {} % or {} %", in_quotes(text),
                    in_quotes(amount_text), shortest(uncertainty), readable_number(100 * uncertainty)),
        "% in both cells (in a spreadsheet one number format for both), or in neither")
        .at(at_cell(line, column));
}

namespace {

/// Whether a part of the name of a phase, in brackets or behind a comma, may change its amount or the
/// uncertainty of it: "g/kg", "x10", "1/1000", "U = 2u", unlike "low", "3:2" and a unit that the table
/// states.
bool may_change_amount(const std::string& part, const Table& table) {
    static const std::regex factor("(?:[x*/]|\u00d7|\u00f7) *[0-9.,]+|[0-9.,]+ *(?:x|\u00d7)");
    static const std::regex number("[0-9]*[.,][0-9]+|[0-9]+ *[:/] *[0-9]{2,}");
    static const std::regex states_more(  // "ppmw", "mg/100 g", "10\u207b\u00b3", "s x 2", "2 uc", "2-sig"
        ".*(?:=|%|\u2030|\u00b1|\u2248|\u00d7|\u00f7|\u207b|\\^|\u03c3|pp[mb]|per "
        "*(?:mil|cent)|promille|prozent|pct|"
        "parts per|fa[ck]tor| x *[0-9]|[0-9] */ *[0-9]|/ *(?:k?g|[0-9]|oo|\u043a\u0433)).*"
        "|[0-9.,k]+ *(?:-|[*]|\u00b7)? *(?:uc?|sd?|se|de|\u0441\u043a\u043e|k|sig|sigma)",
        std::regex::icase);
    // "added 20 %" has a remark of its own.
    static const std::regex amount("[^=\u00b1\u00d7]*[0-9][0-9.,]* *%[^=\u00b1\u00d7]*");
    if (std::regex_match(part, amount)) return false;
    const Heading unit = read_heading("x [" + part + "]");
    const bool is_unit = unit.states == HeadingUnit::weight || unit.states == HeadingUnit::volume ||
                         unit.states == HeadingUnit::fraction;
    if (is_unit && unit.scale != Scale::not_stated)
        return !std::ranges::any_of(table.headings, [&](const Heading& heading) {
            const bool of_volume = heading.role == Role::volume || heading.states == HeadingUnit::volume;
            return (unit.states == HeadingUnit::fraction ||
                    of_volume == (unit.states == HeadingUnit::volume)) &&
                   heading.scale == unit.scale;
        });
    const Role role = role_of_text(part);
    return is_unit || is_summary(part) || role == Role::intensity || role == Role::measure ||
           (part.size() > 1 && read_unit(ascii_unit(part))) || std::regex_match(part, factor) ||
           std::regex_match(part, number) || std::regex_match(part, states_more);
}

/// Refuses a part of the name of a phase that may change its amount, "Quartz (g/kg)" and "Quartz, x10", or
/// calls it none, "Quartz (excluded)". @throws InputError
void require_plain_name(const std::string& name, const Table& table, std::size_t line, std::size_t column) {
    static const std::regex nothing_said(".*\\([^0-9A-Za-z\\x80-\\xff]*\\)");  // "(~)", "(?)"
    if (calls_invalid(name)) refuse_invalid_row(name, "the names", line, column);
    const auto count = [&](char c) { return std::ranges::count(name, c); };
    if (count('(') != count(')') || count('[') != count(']') || count('"') % 2 != 0)
        throw InputError(
            "a bracket or quote of the name " + in_quotes(name) + " has no other: a part may be missing",
            "the whole name, in quotes where it holds the separator")
            .at(at_cell(line, column));
    const auto refuse = [&](std::string_view part) {
        throw InputError(in_quotes(part) + " in the name " + in_quotes(name) +
                             " may be a part of the name, or change the amount",
                         "the name alone, and the amount in the unit of its column")
            .at(at_cell(line, column));
    };
    const auto states_per_cent = [](const Heading& heading) { return heading.scale == Scale::per_cent; };
    for (const std::string_view sign : {"\u2030", "\uff05", "%"})
        if (name.find(sign) != std::string::npos && !std::ranges::any_of(name, is_digit) &&
            !(sign == "%" && std::ranges::any_of(table.headings, states_per_cent)))
            refuse(sign);
    if (has_sign_of_bound(name) || name.ends_with('?') ||
        (name.size() <= longest_heading && std::regex_match(name, nothing_said)))
        throw InputError(
            "the sign in the name " + in_quotes(name) + " may make its amount a bound or doubtful",
            "the name alone, and \"< 12.3\" in the cell of a bound")
            .at(at_cell(line, column));
    if (name.size() > longest_heading) return;
    if (const auto comma = name.rfind(','); comma != std::string::npos) {
        const std::string part(trimmed(std::string_view(name).substr(comma + 1)));
        if (part.find_first_of("()[]") == std::string::npos && may_change_amount(part, table)) refuse(part);
    }
    const auto open = name.find_last_of("([");
    if (open == std::string::npos || name.find_last_of(")]") != name.size() - 1) return;
    const std::string part(trimmed(std::string_view(name).substr(open + 1, name.size() - open - 2)));
    if (may_change_amount(part, table)) refuse(part);
}

/// Whether the name of a row is set off from those above it: "- Albite", "(Albite)".
bool is_set_off(std::string_view name) {
    constexpr std::array<std::string_view, 8> marks{"-",      "\u2013", "\u2014", "\u2022",
                                                    "\u00b7", "\u2514", "\u251c", "\u21b3"};
    const auto begins_with = [&](std::string_view mark) { return name.starts_with(mark); };
    const bool in_bracket = name.starts_with('(') && name.find(')') == name.size() - 1;
    return in_bracket || std::ranges::any_of(marks, begins_with);
}

/// Refuses rows that may be counted in the row above them. @throws InputError
void refuse_parts_of_rows(const Table& table) {
    const std::size_t label = *table.column(Role::phase);
    bool is_below = false;
    for (const TableRow& row : table.rows) {
        const std::string& name = row.cells[label];
        if (is_below && is_set_off(name))
            throw InputError(in_quotes(name) + " may be a part of the row above it, or a phase beside it",
                             "the name alone, or a table without the row that holds its parts")
                .at(at_cell(row.line, label));
        if (name.empty() || is_set_off(name)) continue;
        is_below = std::ranges::any_of(row.cells, [&](const std::string& cell) {  // unlike "Feldspars;;"
            return &cell != &name && read_number(cell, true).has_value();
        });
    }
}

/// Whether a row names its sample.
bool names_samples(const Table& table) {
    return std::ranges::any_of(
        table.rows, [k = *table.column(Role::sample)](const TableRow& row) { return !row.cells[k].empty(); });
}

/// Gives an entry the uncertainty in a column of its own.
/// @param of what it is of, read from @p of_text @throws InputError for one with two readings: "0.1 %" of a
/// number without that sign, or a number without it beside "12.3 %"
void take_uncertainty(Entry& entry, const std::optional<PrintedNumber>& of, const PrintedNumber& uncertainty,
                      const TableRow& row, std::size_t column, const std::string& of_text,
                      const Table& table) {
    if (of && table.headings[column].scale == Scale::not_stated) {
        if (!of->per_cent && uncertainty.per_cent)
            throw InputError(in_quotes(row.cells[column]) +
                                 " may be per cent of the whole, or of the value "
                                 "before it, which has no such sign",
                             "the number alone, or the sign in both cells")
                .at(at_cell(row.line, column));
        if (!uncertainty.per_cent)
            refuse_bare_uncertainty(of_text, row.cells[column], *of, uncertainty.value, row.line, column);
    }
    if (uncertainty.value < 0) refuse_line(row.line, "the uncertainty is below zero", "zero or more");
    if (uncertainty.value > 0 && !is_computable(uncertainty.value))
        refuse_line(row.line, "the uncertainty is " + shortest(uncertainty.value),
                    "0, or " + std::string(computable_range));
    entry.uncertainty = uncertainty.value;
    entry.uncertainty_in_per_cent = uncertainty.per_cent;
}

/// The column of uncertainties that are read, beside phases.
std::optional<std::size_t> read_uncertainties(const Table& table) {
    for (std::size_t k = 0; k < table.headings.size(); ++k)
        if (table.headings[k].role == Role::uncertainty && table.headings[k].coverage.problem.empty())
            return k;
    return std::nullopt;
}

/// One row a phase: phase and weight, or phase, intensity and RIR.
std::vector<Entry> long_entries(const Table& table, Layout layout) {
    const auto errors = read_uncertainties(table);
    std::vector<Entry> entries;
    for (const TableRow& row : table.rows) {
        const auto cell = [&](Role role) -> std::string {
            const auto column = table.column(role);
            return column ? row.cells[*column] : std::string();
        };
        const auto number = [&](Role role) -> std::optional<PrintedNumber> {
            const auto column = table.column(role);
            return column ? number_in(row, *column, table) : std::nullopt;
        };
        const auto plain = [&](Role role) -> std::optional<double> {
            const auto found = number(role);
            return found ? std::optional(found->value) : std::nullopt;
        };
        const MarkedPhase phase = read_phase_name(cell(Role::phase));
        require_plain_name(phase.name, table, row.line, *table.column(Role::phase));
        Entry entry{.sample = cell(Role::sample), .phase = phase.name, .line = row.line, .mark = phase.mark};
        if (entry.sample.empty() && !entries.empty())
            entry.sample = entries.back().sample;  // named once, above
        else if (entry.sample.empty() && table.has(Role::sample) && names_samples(table))
            refuse_line(row.line, "the line names no sample, and none stands above it", "a sample");
        if (entry.phase.empty()) refuse_line(row.line, "the line names no phase", "a phase");
        const Role amount = table.has(Role::weight) ? Role::weight : Role::volume;
        entry.amount = number(amount);
        if (!entry.amount) entry.without_number = cell(amount);
        if (const auto uncertainty = errors ? number_in(row, *errors, table) : std::nullopt) {
            if (entry.amount && entry.amount->standard_uncertainty)
                refuse_line(row.line, "the cell and a column state an uncertainty of the fraction",
                            "one of them");
            const auto of = table.column(layout == Layout::peaks ? Role::intensity : amount);
            take_uncertainty(entry, of ? number_in(row, *of, table) : std::nullopt, *uncertainty, row,
                             *errors, row.cells[of.value_or(0)], table);
        }
        if (layout == Layout::peaks) {
            entry.intensity = number(Role::intensity);
            entry.ratio = number(Role::ratio);
            entry.ratio_uncertainty = plain(Role::ratio_uncertainty);
        }
        entry.standard = number(Role::standard);
        if (const auto column = table.column(Role::density)) entry.density = density_in(row, *column, table);
        entries.push_back(std::move(entry));
    }
    return entries;
}

/// Whether a column of a wide table holds uncertainties of the value before it. "Quartz (2s)" does so behind
/// a column "Quartz"; else it holds the values of quartz with their uncertainties.
bool is_uncertainty_of(const Table& table, std::size_t column, const std::vector<Entry>& entries) {
    const std::string& name = table.headings[column].text;
    if (table.headings[column].role != Role::uncertainty) return false;
    const bool same = !entries.empty() && (entries.back().phase == name || entries.back().sample == name);
    return name.empty() || is_uncertainty_word(name) || same;
}

/// One column a phase (one row a sample), or one column a sample (one row a phase).
std::vector<Entry> wide_entries(const Table& table, Role row_role) {
    const std::size_t label = *table.column(row_role);
    const auto density = row_role == Role::phase ? table.column(Role::density) : std::nullopt;
    std::vector<Entry> entries;
    for (const TableRow& row : table.rows) {
        if (row.cells[label].empty())
            refuse_line(row.line,
                        "the cell in column " + in_quotes(table.headings[label].written) + " is empty",
                        row_role == Role::sample ? "the name of a sample" : "the name of a phase");
        for (std::size_t i = 0; i < row.cells.size(); ++i) {
            const std::string& name = table.headings[i].text;
            const bool is_named = !name.empty() || table.headings[i].role == Role::uncertainty;
            if (i == label || !is_named || stands_beside(table.headings[i])) continue;  // not read
            const bool uncertainty = is_uncertainty_of(table, i, entries);
            const auto number = number_in(row, i, table);
            if (uncertainty) {
                if (entries.empty() || entries.back().line != row.line)
                    refuse_line(table.heading_line,
                                "the column " + in_quotes(table.headings[i].written) +
                                    " holds uncertainties and follows no column of fractions",
                                "the column of the fractions before it");
                if (!number) continue;
                take_uncertainty(entries.back(), entries.back().amount, *number, row, i, row.cells[i - 1],
                                 table);
                continue;
            }
            const MarkedPhase phase = read_phase_name(row_role == Role::sample ? name : row.cells[label]);
            if (row_role == Role::phase)
                require_plain_name(phase.name, table, row.line, label);
            else
                require_plain_name(phase.name, table, table.heading_line, i);
            entries.push_back({.sample = row_role == Role::sample ? row.cells[label] : name,
                               .phase = phase.name,
                               .line = row.line,
                               .amount = number,
                               .density = density ? density_in(row, *density, table) : std::nullopt,
                               .mark = phase.mark,
                               .without_number = number ? std::string() : row.cells[i]});
        }
    }
    if (entries.empty()) {
        std::vector<std::string> unused;
        for (const Heading& heading : table.headings)
            if (&heading != &table.headings[label] && !heading.written.empty())
                unused.push_back(in_quotes(heading.written));
        refuse_line(table.heading_line,
                    "no column beside " + in_quotes(table.headings[label].written) +
                        (unused.empty() ? " has a heading" : " holds fractions: " + joined(unused)),
                    row_role == Role::sample
                        ? "the name of a phase above each column of fractions"
                        : "\"weight %\" or the name of a sample above each column of fractions");
    }
    return entries;
}

/// Refuses two columns of one quantity, other than uncertainties, which may follow each of several columns.
void refuse_repeated_roles(const Table& table) {
    for (std::size_t i = 0; i < table.headings.size(); ++i) {
        const Role role = table.headings[i].role;
        if (role == Role::other || role == Role::uncertainty || role == Role::measure ||
            *table.column(role) == i)
            continue;
        refuse_line(table.heading_line,
                    "the columns " + in_quotes(table.headings[*table.column(role)].written) + " and " +
                        in_quotes(table.headings[i].written) + " hold the same quantity",
                    "one of the two");
    }
}

}  // namespace

std::optional<StatedCoverage> coverage_of_row(std::string_view label, std::string_view sample) {
    const auto beside = uncertainty_beside(label, sample);
    StatedCoverage coverage = read_coverage(beside ? std::string_view(beside->text) : trimmed(label));
    if (beside && coverage.problem.empty()) coverage.problem = beside->problem;
    if (coverage.rest.find('%') != std::string::npos && coverage.problem.empty())
        coverage.problem = "[%] may be of the whole or of the value";
    const bool bare = coverage.rest.empty() ? !coverage.stated.empty() : is_uncertainty_word(coverage.rest);
    return bare || beside ? std::optional(coverage) : std::nullopt;
}

double take_rows_of_uncertainties(std::vector<TableRow>& rows, std::size_t first, std::size_t label,
                                  std::string_view code, std::vector<Finding>& warnings) {
    const auto label_of = [&](std::size_t i) -> const std::string& { return rows[i].cells[label]; };
    std::vector<StatedCoverage> coverages;
    for (std::size_t i = first; i + 1 < rows.size(); i += 2) {
        if (label >= std::min(rows[i].cells.size(), rows[i + 1].cells.size())) return 1;
        const auto coverage = coverage_of_row(label_of(i + 1), label_of(i));
        if (!coverage || is_uncertainty_word(label_of(i)) || is_summary(label_of(i))) return 1;
        refuse_two_methods({label_of(i), label_of(i + 1)}, rows[i + 1].line);
        coverages.push_back(*coverage);
    }
    if (coverages.empty() || first + 2 * coverages.size() != rows.size()) return 1;
    const double factor = coverages.front().factor;
    for (std::size_t i = 0; i < coverages.size(); ++i) {
        if (i > 0) rows[first + i] = std::move(rows[first + 2 * i]);
        TableRow& sample = rows[first + i];
        const TableRow& row = rows[first + 2 * i + 1];
        if (const std::string told = with_texts(row.cells[label], row); told != in_quotes(row.cells[label]))
            refuse_line(row.line, "the row of uncertainties " + told + " holds a text that may change them",
                        "uncertainties alone");
        if (coverages[i].factor != factor || !coverages[i].problem.empty()) {
            warnings.push_back({code, Severity::doubt,
                                (coverages[i].problem.empty() ? "the uncertainties in " : "the numbers in ") +
                                    at_line(row.line) + " are not read, as " + in_quotes(row.cells[label]) +
                                    (coverages[i].problem.empty() ? " have another coverage than those above"
                                                                  : ": " + coverages[i].problem)});
            continue;
        }
        for (std::size_t k = 0; k < std::min(row.cells.size(), sample.cells.size()); ++k)
            if (k != label && !says_no_number(row.cells[k]) && !says_no_number(sample.cells[k]))
                sample.cells[k] += " \u00b1 " + row.cells[k];
    }
    rows.resize(first + coverages.size());
    return factor;
}

bool heads_alike(std::string_view label, std::string_view kind) {
    static const WordLists words("headings of rows");
    const std::vector<std::string> all = words_in(label);
    return !all.empty() && std::ranges::all_of(all, [&](const std::string& word) {
        const auto list = words.list_of(word);
        return list == "common" || list == kind;
    });
}

void refuse_unread_heading(const Heading& heading, std::size_t line) {
    static const WordLists beside("headings of names");
    static const WordLists methods("methods");
    const auto open = heading.text.find_first_of("([");
    std::string said = heading.states == HeadingUnit::other ? heading.unit : std::string();
    if (open != std::string::npos) said = heading.text.substr(open) + said;
    static const std::regex factor("(?:[*/:^]|\u00d7|\u00b7) *[0-9]");  // "Phase (/10)", "Phase (1:10)"
    const std::vector<std::string> words = words_in(heading.written);   // "Oxide \u00b1 2 SE", "Oxide 95% CI"
    const auto is_of_uncertainty = [](const std::string& word) {
        return is_uncertainty_word(word) || (word.size() > 1 && is_summary(word));
    };
    if (said.empty() && (heading.written.find("\u00b1") != std::string::npos ||
                         std::ranges::any_of(words, is_of_uncertainty) ||
                         (holds_per_cent(heading.written) && std::ranges::any_of(heading.written, is_digit))))
        said = heading.written;
    const auto is_known = [&](const std::string& word) {
        const Role role = role_of_text(word);
        return role == Role::phase || role == Role::sample || beside.holds(word) || methods.holds(word) ||
               std::ranges::all_of(word, is_digit);
    };
    if (said.empty() || beside.holds(said) ||
        (read_phase_name("x " + said).mark != PhaseMark::none && !std::ranges::any_of(said, is_digit)) ||
        (!holds_per_cent(said) && std::ranges::all_of(words_in(said), is_known) &&
         (said.size() > longest_heading || !std::regex_search(said, factor))))
        return;
    refuse_line(line,
                "of the heading " + in_quotes(heading.written) + " of the names " + in_quotes(said) +
                    " is not understood: it may change the amounts",
                "the name of the column alone; units and coverages in the headings of the numbers");
}

bool holds_numbers(const TableRow& row, std::size_t label) {
    for (std::size_t k = 0; k < row.cells.size(); ++k)
        if (k != label && !row.cells[k].empty() && read_number(row.cells[k], true)) return true;
    return false;
}

bool looks_like_table(const TextLines& file) {
    return find_heading(lines_with_content(file)).has_value();
}

namespace {

/// Removes rows that sum up samples or hold uncertainties of some, such as "Mittel", "SD" and "2s". Single
/// letters are names of samples, unless such a row stands before them.
void drop_summaries(Table& table) {
    const std::size_t label = *table.column(Role::sample);
    const auto is_sum = [&](const TableRow& row) {
        return is_summary(row.cells[label]) || coverage_of_row(row.cells[label], {});
    };
    if (std::ranges::all_of(table.rows, is_sum)) return;  // such words are then the names of all samples
    bool follows = false;
    std::erase_if(table.rows, [&](const TableRow& row) {
        follows = is_sum(row) && (follows || row.cells[label].size() > 1);
        if (follows) table.warnings.push_back(left_out(xrd_code, row, "sample", row.cells[label]));
        return follows;
    });
}

/// The names of samples, in cells or headings, as texts.
std::vector<TextBeside> sample_names(const Table& table) {
    std::vector<TextBeside> names;
    for (const Heading& heading : table.headings)  // "Phase (spiked)"
        if (heading.role == Role::phase || heading.role == Role::sample)
            names.push_back({table.heading_line, heading.written, true});
    if (const auto label = table.column(Role::sample))
        for (const TableRow& row : table.rows) names.push_back({row.line, row.cells[*label], true});
    else if (table.has(Role::phase))
        for (const Heading& heading : table.headings)
            if (heading.role == Role::other) names.push_back({table.heading_line, heading.text, true});
    return names;
}

/// The texts in columns that are not used, each once.
std::vector<TextBeside> remarks_in_rows(const Table& table) {
    const bool is_long = table.has(Role::phase) && names_amounts(table.headings);
    const auto is_unused = [&](const Heading& heading) {
        return heading.role == Role::measure ||
               (heading.role == Role::other && (is_long || heading.written.empty()));
    };
    std::vector<TextBeside> remarks;
    std::set<std::string_view> seen;
    for (std::size_t k = 0; k < table.headings.size(); ++k) {
        if (!is_unused(table.headings[k])) continue;
        for (const TableRow& row : table.rows)
            if (row.cells[k].find_first_not_of("+-.,()%<0123456789 ") != std::string::npos &&
                seen.insert(row.cells[k]).second)
                remarks.push_back({row.line, row.cells[k]});
    }
    return remarks;
}

/// Appends " (internal standard)" to the phase that a text beside the table or the name of a sample calls so,
/// unless it is marked: "spiked with 10 % Korund".
void take_texts_on_phases(Table& table, const std::vector<TextBeside>& texts) {
    StandardsInTexts beside;
    for (const TextBeside& text : texts) beside.take(text);
    StandardsInTexts standards = beside;
    for (const TextBeside& name : sample_names(table)) standards.take(name);
    for (const TextBeside& remark : remarks_in_rows(table))
        if (table.has(Role::phase))
            standards.take_named(remark);  // "internal standard" is of the phase of its row
        else
            standards.take(remark);
    if (table.has(Role::standard)) return;
    bool marked = false;
    const auto take = [&](std::string& name) {
        const MarkedPhase phase = read_phase_name(name);
        if (standards.hold(phase.name) && phase.mark == PhaseMark::none) name += " (internal standard)";
        marked = marked || read_phase_name(name).mark == PhaseMark::standard;
    };
    if (const auto label = table.column(Role::phase))
        for (TableRow& row : table.rows) take(row.cells[*label]);
    else
        for (Heading& heading : table.headings)
            if (heading.role == Role::other && !heading.text.empty()) take(heading.text);
    if (beside.any() && !marked)
        table.warnings.push_back({xrd_code, Severity::doubt,
                                  "a text beside the table may state an added standard, and no phase is "
                                  "marked as one"});
}

/// Appends to the name of a phase the remark beside it, "internal standard", and the note below the table
/// that has its mark: "* internal standard" for "Corundum*".
void take_notes_on_phases(Table& table, std::span<const TextLine> notes) {
    const std::size_t label = *table.column(Role::phase);
    for (TableRow& row : table.rows)
        for (std::size_t k = 0; k < row.cells.size(); ++k) {
            const std::string mark = " (" + row.cells[k] + ")";
            const bool beside =
                table.headings[k].role == Role::measure || table.headings[k].role == Role::other;
            if (beside && read_phase_name("x" + mark).mark == PhaseMark::standard &&
                read_phase_name(row.cells[label]).mark == PhaseMark::none)
                row.cells[label] += mark;
        }
    for (const TextLine& note : notes) {
        const std::string_view text = trimmed(note.text.substr(0, note.text.find(table.separator)));
        const auto* const found = std::ranges::find_if(
            footnote_signs, [&](std::string_view each) { return text.starts_with(each); });
        if (found == footnote_signs.end()) continue;
        const std::string_view sign = *found;
        const std::size_t end = sign.size();
        const std::string mark = " (" + std::string(trimmed(text.substr(end))) + ")";
        if (read_phase_name("x" + mark).mark == PhaseMark::none) continue;
        for (TableRow& row : table.rows) {
            std::string& name = row.cells[label];
            const bool signed_so =
                name.ends_with(sign) && !std::string_view(name).substr(0, name.size() - end).ends_with('*');
            if (signed_so) name.replace(name.size() - end, end, mark);
        }
    }
}

/// Whether one name is the other, or its beginning: "Mullite" of "Mullite 2:1".
bool are_alike(std::string_view name, std::string_view other) {
    const std::string a = word_key(name);
    const std::string b = word_key(other);
    return !a.empty() && !b.empty() && (a.starts_with(b) || b.starts_with(a));
}

/// A column "FA1 (2s)" without a column "FA1" before it holds amounts, with their uncertainties in the cells.
void find_amounts_with_uncertainties(Table& table) {
    std::string before;
    for (Heading& heading : table.headings) {
        if (heading.role == Role::uncertainty && !heading.text.empty() && heading.text != before &&
            !is_uncertainty_word(heading.text)) {
            heading.role = Role::other;
            if (names_other_basis(heading)) heading.role = Role::measure;
        }
        if (heading.role == Role::other) before = heading.text;
    }
}

/// Refuses a unit of amounts in the heading of the names, "Phase [vol%]", unless a heading of amounts states
/// it as well. @throws InputError
void require_units_at_amounts(const Table& table) {
    const auto label = table.column(table.has(Role::phase) ? Role::phase : Role::sample);
    if (!label) return;
    const Heading& heading = table.headings[*label];
    const bool of_volume = heading.states == HeadingUnit::volume;
    const bool of_other_scale =  // "Sample [g/kg];Quartz [wt%]"
        heading.scale != Scale::not_stated && std::ranges::any_of(table.headings, [&](const Heading& each) {
            return &each != &heading && each.scale != Scale::not_stated && each.scale != heading.scale;
        });
    if (of_other_scale)
        refuse_line(table.heading_line,
                    "the heading " + in_quotes(heading.written) +
                        " of the names states another unit than the amounts",
                    "the unit of each amount in its own heading");
    if (!of_volume) return;
    for (const Heading& each : table.headings)
        if (&each != &heading && each.states == heading.states) return;
    refuse_line(table.heading_line,
                "the heading " + in_quotes(heading.written) + " of the names states a unit of amounts",
                "the unit in the headings of the amounts: " + in_quotes("FA1 [vol%]"));
}

/// Finds the columns of uncertainties beside those of phases or samples: "esd", "Quartz esd", "u(FA1)" are of
/// the column before. Errors: InputError for one that names no column, or another than the one before it.
void find_uncertainties(Table& table) {
    const Heading* before = nullptr;
    for (Heading& heading : table.headings) {
        const UncertaintyName name = uncertainty_name(heading.text);
        const bool is_amount = heading.role == Role::other && !heading.text.empty();
        const auto is_named = [&](const Heading& each) {
            return &each != &heading && word_key(each.text) == word_key(name.of);
        };
        const bool is_letter =
            heading.written.size() == 1 && std::islower(static_cast<unsigned char>(heading.written[0])) != 0;
        const bool is_deviation = is_letter && is_summary(heading.written);
        if ((is_deviation || heading.written == "MU") && before != nullptr)
            refuse_line(table.heading_line,
                        "the column " + in_quotes(heading.written) +
                            " may be a sample, or hold standard deviations or other "
                            "uncertainties",
                        in_quotes("esd") + " for standard uncertainties, else a longer name");
        if (!is_amount || name.of.empty() ||
            !(name.is_uncertainty || std::ranges::any_of(table.headings, is_named))) {
            if (is_amount && !stands_beside(heading)) before = &heading;
            continue;
        }
        if (before == nullptr)
            refuse_line(table.heading_line,
                        "the column " + in_quotes(heading.written) +
                            " holds uncertainties and follows no column of fractions",
                        "the column of the fractions before it");
        if (!are_alike(name.of, before->text))
            refuse_line(table.heading_line,
                        "the column " + in_quotes(heading.written) + " may hold standard uncertainties of " +
                            in_quotes(before->text) + ", other ones, or fractions of " + in_quotes(name.of),
                        in_quotes("esd") + " or " + in_quotes(before->text + " esd") +
                            " for standard uncertainties, else another name");
        heading.role = Role::uncertainty;
        heading.text.clear();
    }
}

/// Refuses columns whose names differ by letters for a weight and a volume alone: "FA1_m;FA1_v".
/// @throws InputError
void refuse_pairs_of_bases(const Table& table) {
    std::map<std::vector<std::string>, const Heading*> by_volume;
    const auto last_of = [](const Heading& heading, std::vector<std::string>& words) {
        words = heading.role == Role::other ? words_in(heading.text) : std::vector<std::string>();
        const std::string last = words.size() < 2 ? std::string() : words.back();
        if (!words.empty()) words.pop_back();
        return last;
    };
    std::vector<std::string> words;
    for (const Heading& heading : table.headings)
        if (last_of(heading, words) == "v") by_volume.emplace(words, &heading);
    for (const Heading& heading : table.headings) {
        const std::string last = last_of(heading, words);
        const auto found = by_volume.find(words);
        if ((last == "m" || last == "w") && found != by_volume.end())
            refuse_line(table.heading_line,
                        "the columns " + in_quotes(heading.written) + " and " +
                            in_quotes(found->second->written) +
                            " may be two samples, or one by weight and by volume",
                        "names without these letters, with [wt%] or [vol%]");
    }
}

/// Marks columns that sum up samples, such as "Mittelwert" with its uncertainty. Without the samples the
/// first of them is the result, and "Min" and "Max" behind it are none.
void mark_sums(Table& table) {
    const auto sums_up = [](const Heading& heading) {
        return heading.text.size() > 1 && is_summary(heading.text);
    };
    const auto is_sample = [&](const Heading& heading) {
        return heading.role == Role::other && !heading.text.empty() && !sums_up(heading) &&
               !uncertainty_name(heading.text).is_uncertainty;
    };
    // "n;Mean (wt%)": the one column without a unit beside a mean with one is no sample.
    const bool is_counted = std::ranges::count_if(table.headings, is_sample) == 1 &&
                            std::ranges::any_of(table.headings, [&](const Heading& heading) {
                                return sums_up(heading) && names_mean(heading.text) && !heading.unit.empty();
                            });
    for (Heading& heading : table.headings)
        if (is_counted && is_sample(heading) && heading.unit.empty()) heading.role = Role::measure;
    bool is_result = !std::ranges::any_of(table.headings, is_sample);
    bool follows = false;
    for (Heading& heading : table.headings) {
        const bool spread = heading.role == Role::uncertainty || is_summary(heading.text);
        follows = sums_up(heading) ? heading.role == Role::other || follows : follows && spread;
        if (follows && is_result && heading.role == Role::other) follows = is_result = false;
        heading.sums_up = follows;
    }
}

/// Beside columns of phases "crystalline [wt%]" is their sum, not an amount of the crystalline part.
void name_crystalline_totals(Table& table) {
    if (table.has(Role::phase)) return;
    for (Heading& heading : table.headings) {
        const auto unit = heading.written.find_first_of("[(");
        if (!heading.of_crystalline || unit == std::string::npos || unit == 0 ||
            words_in(heading.written.substr(0, unit)).size() != 1)
            continue;
        const std::string written = heading.written;
        heading = read_heading("total crystalline " + written.substr(unit));
        heading.written = written;
    }
}

/// Sets aside trace elements beside phases in another unit: "Cr [ppm]".
void set_aside_traces(Table& table) {
    static const std::regex element("[A-Z][a-z]?(?:[ ,_]*(?:in )?pp[mb])?");
    const auto is_trace = [&](const Heading& each) {
        return (each.scale == Scale::ppm || each.unit == "ppb") && each.text.size() <= longest_heading &&
               std::regex_match(each.text, element);
    };
    const auto is_amount = [&](const Heading& each) {
        return each.role == Role::other && !each.text.empty() && !is_trace(each);
    };
    if (table.has(Role::phase) || !std::ranges::any_of(table.headings, is_amount)) return;
    for (Heading& heading : table.headings)
        if (heading.role == Role::other && is_trace(heading)) heading.role = Role::measure;
}

/// Sets aside quantities of samples beside their phases, "T (°C)" and "d50 [µm]"; masses are refused.
void set_aside_quantities(Table& table) {
    if (table.has(Role::phase)) return;
    for (Heading& heading : table.headings) {
        const auto unit = heading.role == Role::other ? unit_of_quantity(heading.written) : std::nullopt;
        const bool is_fraction = unit_of(cut_heading(heading.written).unit) != HeadingUnit::other;  // "g"
        if (unit && unit->powers[1] == 0 && !is_fraction) heading.role = Role::measure;
    }
}

/// Sets aside the columns of other names beside phases and their amounts, which are not used: their units are
/// not those of the amounts.
void set_aside_others(Table& table) {
    if (!table.has(Role::phase) || !names_amounts(table.headings)) return;
    for (Heading& heading : table.headings)
        if (heading.role == Role::other && !heading.text.empty()) heading.role = Role::measure;
}

/// Leaves out fractions by volume beside those by weight, and the uncertainties of these and of intensities
/// where fractions are stated beside them.
void prefer_fractions(Table& table) {
    const Role preferred = table.has(Role::weight) ? Role::weight : Role::volume;
    const bool has_others =
        table.has(Role::intensity) || (preferred == Role::weight && table.has(Role::volume));
    if (!table.has(Role::phase) || !table.has(preferred) || !has_others) return;
    Role before = Role::other;
    for (Heading& heading : table.headings) {
        const Role role = heading.role;
        if ((role == Role::volume && preferred == Role::weight) ||
            (role == Role::uncertainty && before != preferred))
            heading.role = Role::measure;
        before = role;
    }
}

/// An uncertainty behind the reference intensity ratios is theirs. @throws InputError if it may be that of
/// the intensities before them, which have none: "Int.;RIR;esd"
void find_uncertainties_of_ratios(Table& table) {
    for (std::size_t k = 1; k < table.headings.size(); ++k) {
        Heading& heading = table.headings[k];
        const Heading& before = table.headings[k - 1];
        if (heading.role != Role::uncertainty || before.role != Role::ratio) continue;
        if (k > 1 && table.headings[k - 2].role == Role::intensity)
            refuse_line(table.heading_line,
                        "the uncertainties in column " + in_quotes(heading.written) + " may be of " +
                            in_quotes(before.written) + " or of " + in_quotes(table.headings[k - 2].written),
                        in_quotes("RIR esd") + " as the heading, or the column behind the intensities");
        heading.role = Role::ratio_uncertainty;
    }
}

/// Of each column whether a cell below its heading holds a number.
std::vector<bool> columns_with_numbers(const Table& table, std::span<const TextLine> rows) {
    std::vector<bool> found(table.headings.size(), false);
    for (const TextLine& row : rows)
        for_each_cell(row, table.separator, [&](std::string_view cell, std::size_t k) {
            if (k < found.size() && !cell.empty() && read_number(cell, true)) found[k] = true;
        });
    return found;
}

void leave_out(Heading& heading) {
    heading.role = Role::measure;
    if (heading.text.empty()) heading.text = heading.written;  // "2 sigma"
}

/// Leaves out columns of texts beside phases or samples and a column with numbers: "ICDD" above "46-1045",
/// "Location" above "north".
void leave_texts_out(Table& table, std::span<const TextLine> rows) {
    const auto is_amount = [](const Heading& heading) {
        return heading.role == Role::other && !heading.text.empty();
    };
    const std::vector<bool> holds_numbers = columns_with_numbers(table, rows);
    std::vector<bool> holds_texts(table.headings.size(), false);
    std::vector<bool> states_none(table.headings.size(), false);  // "n.d."
    for (const TextLine& row : rows)
        for_each_cell(row, table.separator, [&](std::string_view cell, std::size_t k) {
            if (k >= table.headings.size() || cell.empty()) return;
            holds_texts[k] = true;
            states_none[k] = states_none[k] || says_no_number(cell);
        });
    bool any = false;
    for (std::size_t k = 0; k < table.headings.size(); ++k)
        any = any || (is_amount(table.headings[k]) && holds_numbers[k]);
    for (std::size_t k = 0; any && k < table.headings.size(); ++k)
        if (is_amount(table.headings[k]) && table.headings[k].unit.empty() && holds_texts[k] &&
            !holds_numbers[k] && !states_none[k])
            leave_out(table.headings[k]);
}

/// Takes the unit that a column states for all rows, "Content;Unit" above "20;wt%", into the headings without
/// one. @return the column; none without one, or where it states several units
std::optional<std::size_t> take_unit_column(TableRow& names, std::span<const TextLine> rows, char separator,
                                            const std::function<bool(std::string_view)>& is_unit) {
    static const WordLists units("unit columns");
    const auto found =
        std::ranges::find_if(names.cells, [](const std::string& cell) { return units.holds(cell); });
    if (found == names.cells.end()) return std::nullopt;
    const auto column = static_cast<std::size_t>(found - names.cells.begin());
    std::set<std::string, std::less<>> stated;
    for (const TextLine& row : rows)
        for_each_cell(row, separator, [&](std::string_view cell, std::size_t k) {
            if (k == column && !cell.empty()) stated.emplace(cell);
        });
    if (stated.size() != 1 || !is_unit(*stated.begin())) return std::nullopt;
    for (std::size_t k = 0; k < names.cells.size(); ++k) {
        const Role role = role_of_text(names.cells[k]);
        if (k != column && !names.cells[k].empty() && role != Role::phase && role != Role::sample &&
            !names.cells[k].ends_with(']'))
            names.cells[k] += " [" + *stated.begin() + "]";
    }
    return column;
}

/// Leaves out uncertainties without a name behind a column that is not used: they are of that column.
void drop_uncertainties_of_unused(Table& table, std::span<const TextLine> rows) {
    const bool is_long = names_amounts(table.headings);
    const bool has_fractions = table.has(Role::weight) || table.has(Role::volume);
    const auto is_unused = [&](const Heading& heading) {
        switch (heading.role) {
            case Role::measure:
            case Role::standard:
                return true;
            case Role::other:
                return is_long;
            case Role::intensity:
            case Role::ratio:
                return has_fractions || !is_long;
            default:
                return false;
        }
    };
    const std::vector<bool> holds_numbers = columns_with_numbers(table, rows);
    for (std::size_t k = 1; k < table.headings.size(); ++k) {
        Heading& heading = table.headings[k];
        const Heading& before = table.headings[k - 1];
        if (heading.role != Role::uncertainty || !is_unused(before) ||
            !is_uncertainty_of_unused(heading, before, holds_numbers[k - 1]))
            continue;
        leave_out(heading);
    }
}

/// Refuses one nameless column of uncertainties behind several columns of amounts, "FA1;FA2;SD".
/// @throws InputError
void require_owner_of_last(const Table& table) {
    const auto is_amount = [](const Heading& heading) {
        return heading.role == Role::other && !heading.text.empty() && !heading.sums_up;
    };
    const auto is_bare = [](const Heading& heading) {
        return heading.role == Role::uncertainty && !heading.sums_up &&
               is_uncertainty_word(cut_heading(read_coverage(heading.written).rest).name);
    };
    const auto last = std::ranges::find_if(table.headings, is_bare);
    if (last - table.headings.begin() < 2 || !is_amount(last[-1]) || !is_amount(last[-2]) ||
        std::ranges::count_if(table.headings, is_uncertainty) != 1)
        return;
    const bool is_last = std::none_of(last, table.headings.end(), is_amount);
    if (last != table.headings.end() && is_last)
        refuse_line(table.heading_line,
                    "the uncertainties in column " + in_quotes(last->written) + " may be of " +
                        in_quotes(last[-1].written) + " alone, or of all amounts",
                    in_quotes(last[-1].text + " esd") + ", or a column behind each of the amounts");
}

/// Refuses uncertainties that may be of two columns: a second column of them behind one, and those behind a
/// density. @throws InputError
void require_owners_of_uncertainties(const Table& table) {
    for (std::size_t k = 1; k < table.headings.size(); ++k) {
        const Heading& heading = table.headings[k];
        const Heading& before = table.headings[k - 1];
        if (heading.role != Role::uncertainty || !heading.coverage.problem.empty()) continue;
        const bool is_second = before.role == Role::uncertainty && before.coverage.problem.empty();
        if (is_second || before.role == Role::density)
            refuse_line(table.heading_line,
                        "the uncertainties in column " + in_quotes(heading.written) + " stand behind " +
                            in_quotes(before.written) + ": they may be of it, or of another column",
                        "each column of uncertainties behind its amounts");
    }
}

/// Refuses uncertainties that are of the mean before them, "wt%;Mittelwert;SD", beside amounts that are read,
/// and those that would be read as amounts, "mean (wt%);2s (wt%)". @throws InputError
void refuse_uncertainties_of_means(const Table& table) {
    if (!table.has(Role::phase)) return;
    const bool is_long = names_amounts(table.headings);
    for (std::size_t k = 1; k < table.headings.size(); ++k) {
        const Heading& heading = table.headings[k];
        const Heading& before = table.headings[k - 1];
        const bool is_read = heading.role == Role::uncertainty
                                 ? is_long && heading.coverage.problem.empty()
                                 : heading.role != Role::measure && !heading.coverage.stated.empty();
        if (is_read && (before.role == Role::measure || before.sums_up) && names_mean(before.text))
            refuse_line(table.heading_line,
                        "the uncertainties in column " + in_quotes(heading.written) + " may be of " +
                            in_quotes(before.written) + ", which is not read, or of the amounts",
                        "one column of amounts, and their uncertainties behind it");
    }
}

/// Of several columns of uncertainties beside phases that behind the amounts counts, and the others are not
/// used. @throws InputError where none stands there
void choose_uncertainties(Table& table) {
    auto owner = table.column(table.has(Role::weight) ? Role::weight : Role::volume);
    if (!owner) owner = table.column(Role::intensity);
    if (!table.has(Role::phase) || !owner) return;
    const auto is_read = [](const Heading& heading) {
        return heading.role == Role::uncertainty && heading.coverage.problem.empty();
    };
    if (std::ranges::count_if(table.headings, is_read) < 2) return;
    const auto behind = table.headings.begin() + static_cast<std::ptrdiff_t>(*owner) + 1;
    const auto chosen = std::find_if(behind, table.headings.end(), [&](const Heading& heading) {
        return is_read(heading) || heading.role != Role::uncertainty;
    });
    if (chosen == table.headings.end() || !is_read(*chosen)) {
        std::vector<std::string> names;
        for (const Heading& heading : table.headings)
            if (is_read(heading)) names.push_back(in_quotes(heading.written));
        refuse_line(
            table.heading_line,
            "several columns hold uncertainties, and none stands behind the amounts: " + joined(names),
            "the column of their uncertainties behind the amounts");
    }
    for (Heading& heading : table.headings)
        if (&heading != &*chosen && is_read(heading)) leave_out(heading);
}

/// Finds the rows that may head those below them: all their cells but the name are blank. @throws InputError
/// for one that names another quantity, "Detection limits:"
void find_blank_rows(Table& table) {
    const std::size_t label = *table.column(Role::phase);
    const auto sample = table.column(Role::sample);
    bool amounts_follow = false;
    bool with_colon = false;  // "Quartz:;20"
    for (std::size_t i = table.rows.size(); i-- > 0;) {
        const TableRow& row = table.rows[i];
        const std::string& name = row.cells[label];
        bool is_blank = !name.empty();
        for (std::size_t k = 0; k < row.cells.size(); ++k)
            is_blank = is_blank && (k == label || k == sample || row.cells[k].empty());
        const PhaseMark mark = read_phase_name(name).mark;
        if (is_blank && amounts_follow && mark == PhaseMark::standard)
            refuse_line(row.line, in_quotes(name) + " has no cells: it may call the rows below it so",
                        "the mark beside the name of the phase: \"Corundum (internal standard)\"");
        const bool heads = is_blank && amounts_follow && !heads_alike(name, "phases") &&
                           !names_loss(name, true) && meaning_of_row(name) == RowMeaning::phase &&
                           mark == PhaseMark::none;
        if (heads) {
            const Heading as_heading = read_heading(name);
            if (as_heading.role == Role::measure &&
                (name.ends_with(':') || !as_heading.unit.empty() || is_summary(name)))
                refuse_line(row.line,
                            in_quotes(name) + " has no cells: the rows below it may be of that quantity",
                            "a file without these rows");
            const bool is_plain = with_colon && name.ends_with(':');
            table.blank_rows.emplace(row.line, is_plain ? name.substr(0, name.size() - 1) : name);
        }
        amounts_follow = amounts_follow || holds_numbers(row, label);
        with_colon = with_colon || (name.ends_with(':') && !is_blank);
    }
}

/// Refuses coverages in a column of their own beside uncertainties that are not divided for them.
/// @throws InputError
void refuse_coverages(const Table& table) {
    std::vector<double> divisors;
    for (const Heading& heading : table.headings)
        if (is_uncertainty(heading) && heading.coverage.problem.empty())
            divisors.push_back(heading.coverage.factor);
    for (std::size_t k = 0; k < table.headings.size(); ++k) {
        const Heading& heading = table.headings[k];
        if (heading.role == Role::other || heading.role == Role::measure)
            ashimpact::refuse_coverages(heading.written, table.rows, k, divisors);
    }
}

/// Removes rows of figures of merit and of other quantities among phases, such as "Rwp" and "LOI".
void drop_measures(Table& table) {
    const std::size_t label = *table.column(Role::phase);
    std::erase_if(table.rows, [&](const TableRow& row) {
        if (read_heading(row.cells[label]).role != Role::measure && !names_coverage_factor(row.cells[label]))
            return false;
        refuse_coverage_in_row(row, label);
        table.warnings.push_back(left_out(xrd_code, row, "phase", row.cells[label]));
        return true;
    });
}

/// A heading over two rows: names of groups that stand over several columns, and names or units below them.
/// Of each column the text below counts, with the group where it is a unit, and the unit of the group.
/// @return whether the second line is one
bool take_second_heading(TableRow& heading, const TableRow& line,
                         const std::function<bool(std::string_view)>& is_unit) {
    std::vector<std::string> names = heading.cells;
    names.resize(std::max(names.size(), line.cells.size()));
    bool merged = false;
    std::string group;
    for (std::size_t i = 0; i < line.cells.size(); ++i) {
        const std::string& below = line.cells[i];
        if (!names[i].empty()) group = names[i];
        if (below.empty()) continue;
        if (i == 0 && names[i].empty() && role_of_text(below) == Role::phase)
            heading.cells[i] = names[i] = below;
        if (i == 0 && below != names[i]) return false;
        const StatedCoverage coverage = read_coverage(below);
        const bool is_coverage =
            !coverage.stated.empty() && (coverage.rest.empty() || is_uncertainty_word(coverage.rest));
        if (says_no_number(below) || read_number(below, true) || (is_digit(below.front()) && !is_coverage))
            return false;
        if (i == 0) continue;
        merged = merged || names[i].empty();
        const std::string_view bare = std::string_view(below).find_first_of("[(") == 0 && below.size() > 2
                                          ? trimmed(std::string_view(below).substr(1, below.size() - 2))
                                          : std::string_view(below);
        if (is_uncertainty_word(bare) || is_coverage) {
            names[i] = group + (is_coverage ? " (" + std::string(bare) + ")" : " " + std::string(bare));
        } else if (is_unit(bare)) {
            names[i] = group + " [" + std::string(bare) + "]";
        } else {
            const Heading above = read_heading(group);
            const bool is_basis = above.role == Role::weight || above.role == Role::volume ||
                                  above.role == Role::intensity || above.role == Role::measure ||
                                  names_other_basis(above);
            std::string unit = above.unit;
            if (is_basis && (unit.empty() || above.states == HeadingUnit::fraction))  // "Volume [%]"
                unit = above.text + (holds_per_cent(unit) ? "%" : "");
            merged = merged || (is_basis && line.cells.front().empty());
            names[i] = below + (unit.empty() || !read_heading(below).unit.empty() ? "" : " [" + unit + "]");
        }
    }
    if (merged) heading.cells = names;
    return merged;
}

/// Of several columns named as those of phases, "Phase ID" and "Phase", those with numbers alone name none.
void drop_numbers_of_phases(Table& table, std::span<const TextLine> rows) {
    std::vector<bool> names(table.headings.size(), false);
    for (const TextLine& row : rows)
        for_each_cell(row, table.separator, [&](std::string_view cell, std::size_t k) {
            if (k < names.size() && !cell.empty() && !read_number(cell)) names[k] = true;
        });
    if (std::ranges::count(table.headings, Role::phase, &Heading::role) < 2) return;
    for (std::size_t k = 0; k < names.size(); ++k)
        if (table.headings[k].role == Role::phase && !names[k]) table.headings[k].role = Role::measure;
}

/// What the headings of amounts state that these are by; empty for "Anteil [%]".
std::string_view stated_basis(const Table& table) {
    std::string_view basis;
    for (const Heading& heading : table.headings) {
        const bool by_volume = heading.role == Role::volume || heading.states == HeadingUnit::volume;
        const bool is_amount = heading.role == Role::weight || by_volume || heading.role == Role::other;
        if (!is_amount) continue;
        if (by_volume) return "volume";
        if (heading.states == HeadingUnit::weight || bases_in(heading.written, false).contains("weight"))
            basis = "weight";
    }
    return basis;
}

/// Whether a cell excludes its row: "no" below "use", "x" below "excluded".
bool rejects(std::string_view heading, std::string_view cell) {
    static const WordLists columns("impact columns");
    static const WordLists verdicts("verdicts");
    const auto column = columns.list_of(heading);
    const auto verdict = verdicts.list_of(trimmed(cell));
    if (column == "exclusion") return verdict == "yes" || verdict == "mark";
    return column == "validity" && (verdict == "no" || verdict == "bad" || trimmed(cell) == "-");
}

/// Refuses a text beside the table that states what the headings do not: a basis of the fractions, or the
/// coverage of the uncertainties. So do cells without a heading, and units in columns that are not used.
/// @param rows the lines below the heading @throws InputError
void require_agreeing_texts(Table& table, std::vector<TextBeside> texts, std::span<const TextLine> rows) {
    const bool is_long = names_amounts(table.headings);
    const auto amounts = std::ranges::find_if(table.headings, [](const Heading& heading) {
        return heading.role == Role::weight || heading.role == Role::volume;
    });
    const Scale scale = amounts == table.headings.end() ? Scale::not_stated : amounts->scale;
    const auto is_unused = [&](const Heading& heading) {
        return heading.role == Role::measure ||
               (heading.role == Role::other && (is_long || heading.written.empty()));
    };
    const auto is_beside = [&](std::string_view cell, std::size_t k) {
        const Heading& heading = table.headings[k];
        if (heading.role == Role::phase || heading.role == Role::sample ||
            (heading.role == Role::other && heading.written.empty()))
            return true;                       // "Quartz (vol%)", "FA1 (2 sigma)", and notes
        constexpr std::size_t most_words = 3;  // of a unit
        return is_unused(heading) && words_in(cell).size() <= most_words &&
               cell.find_first_of("0123456789") == std::string_view::npos;
    };
    std::string sample;  // above
    for (const TextLine& row : rows)
        for_each_cell(row, table.separator, [&](std::string_view cell, std::size_t k) {
            if (k >= table.headings.size() || cell.empty()) return;
            const bool is_name = table.headings[k].role == Role::sample;
            const auto own = is_name ? uncertainty_beside(cell, sample) : std::nullopt;  // "Ash 2 SD"
            if (own) return texts.push_back({row.number, own->text, true});
            if (is_name) sample = cell;
            if ((is_unused(table.headings[k]) || is_name) &&
                (calls_invalid(cell) || (!is_name && rejects(table.headings[k].text, cell))))
                refuse_invalid_row(cell, "column " + in_quotes(table.headings[k].written), row.number, k);
            if (is_unused(table.headings[k]))
                refuse_sign_of_bound(cell, "column " + in_quotes(table.headings[k].written), row.number, k);
            if (is_unused(table.headings[k]) && is_long)
                refuse_other_unit(cell, "column " + in_quotes(table.headings[k].written), scale, row.number,
                                  k);
            if (is_beside(cell, k)) texts.push_back({row.number, std::string(cell), is_name});
            if (is_unused(table.headings[k])) refuse_factors({{row.number, std::string(cell)}});
            if (std::string stated = coverage_in_cell(table.headings[k].written, cell);
                !stated.empty() && is_unused(table.headings[k]))
                texts.push_back({row.number, std::move(stated)});
        });
    UncertainColumns columns(table.headings.size());
    for (std::size_t k = 0; k < columns.size(); ++k) {
        const Heading& heading = table.headings[k];
        if (heading.role == Role::phase || heading.role == Role::sample)
            texts.push_back({table.heading_line, heading.written, true});
        else if (!stands_beside(heading) || heading.role == Role::intensity || heading.role == Role::ratio ||
                 heading.role == Role::ratio_uncertainty)
            columns[k] = {heading.written, heading.coverage, is_uncertainty(heading)};
    }
    const auto statements = statements_in(texts);
    if (const auto found = statements.find("crystalline part"); found != statements.end())
        table.crystalline = at_line(found->second.line);
    if (const auto found = statements.find("ignited sample"); found != statements.end())
        table.warnings.push_back(
            unused_statement(xrd_code, found->second, "the fractions are taken as those of the sample"));
    if (!table.has(Role::intensity)) require_basis(texts, stated_basis(table));
    check_coverage(xrd_code, texts, columns, rows, table.separator, table.warnings);
    for (const Heading& each : table.headings)
        if (each.role == Role::phase || each.role == Role::sample)
            refuse_unread_heading(each, table.heading_line);
}

/// Refuses amounts of an added standard that are no fractions by weight. @throws InputError
void require_unit_of_standard(const Table& table) {
    const auto standard = table.column(Role::standard);
    if (!standard) return;
    const Heading& heading = table.headings[*standard];
    if (heading.states == HeadingUnit::other || heading.states == HeadingUnit::volume)
        refuse_line(table.heading_line, "the column " + in_quotes(heading.written) + " is in another unit",
                    "the weight fraction of the standard in the mixture: [wt%], [g/kg], [1]");
}

/// Refuses the name of a sample that may be a factor of its amounts: "0.1 wt%", "FA7 x10". @throws InputError
void refuse_factor(const std::string& name, const std::string& written, std::size_t line) {
    static const std::regex factor("10+|(?:.* )?0[.]0*1|.*(?:x|\u00d7|[*]) *10+");
    if (name.size() > longest_heading || !std::regex_match(name, factor)) return;
    refuse_line(line,
                "the column " + in_quotes(written) +
                    " may be a sample of that name, or state a factor of its amounts",
                "a name of other letters, and the amounts in [wt%]");
}

/// Refuses "STD" behind a sample where its numbers are as large as those of samples: a reference material, or
/// standard deviations. @throws InputError
void refuse_reference_samples(const Table& table) {
    const auto is_large = [](double sum, double of_sample) { return sum > 0 && sum >= of_sample / 2; };
    const auto value = [](const std::string& cell) {
        const auto number = cell.empty() ? std::nullopt : read_number(cell, true);
        return number ? number->value : 0;
    };
    const auto refuse = [](const std::string& name, std::size_t line) {
        refuse_line(line, in_quotes(name) + " may be a standard, a sample, or hold standard deviations",
                    "\"esd\" for standard uncertainties, else a longer name");
    };
    const auto label = table.column(Role::sample);
    const auto& headings = table.headings;
    for (std::size_t i = 1; label && !table.has(Role::phase) && i < table.rows.size(); ++i) {
        double sum = 0;
        double above = 0;
        for (std::size_t k = 0; k < headings.size(); ++k) {
            if (headings[k].role != Role::other) continue;
            sum += value(table.rows[i].cells[k]);
            above += value(table.rows[i - 1].cells[k]);
        }
        const std::string& name = table.rows[i].cells[*label];
        if (word_key(name) == "std" && is_large(sum, above)) refuse(name, table.rows[i].line);
    }
    for (std::size_t k = 1; !label && k < headings.size(); ++k) {
        double sum = 0;
        double before = 0;
        for (const TableRow& row : table.rows) {
            sum += value(row.cells[k]);
            before += value(row.cells[k - 1]);
        }
        if (headings[k].role == Role::uncertainty && headings[k - 1].role == Role::other &&
            word_key(headings[k].written) == "std" && is_large(sum, before))
            refuse(headings[k].written, table.heading_line);
    }
}

/// Refuses the name of a sample in its cell or heading that may change its amounts: "FA1 at.%", "FA1 (x10)".
/// @throws InputError
void require_plain_sample(const std::string& name, std::size_t line) {
    static const std::regex factor(
        "(?:.*[^A-Za-z])?x *10+|.*(?:\u00d7|[*]) *10+|"
        ".*[(\\[](?:(?:[x/]|\u00d7|\u00f7) *[0-9.,]+|[0-9.,]+ *(?:x|\u00d7))[)\\]]");
    if (name.size() > longest_heading || name.find_first_of("%x*([\xc3") == std::string::npos) return;
    if (std::regex_match(name, factor))
        refuse_line(line, "the name " + in_quotes(name) + " may state a factor of the amounts of its sample",
                    "a name of other letters, and the amounts in [wt%]");
    if (!holds_per_cent(name)) return;
    const Heading heading = read_heading(name);
    const Role unit = role_of_text(heading.unit);
    if (!heading.unit.empty() && holds_per_cent(heading.unit) &&
        (unit == Role::measure || unit == Role::intensity))
        refuse_line(line,
                    "the name " + in_quotes(name) + " may state that the amounts of its sample are in " +
                        heading.unit,
                    "the name alone, and fractions by weight or by volume");
}

/// Removes the sides of uncertainties from headings, "-err;+err". @return the columns that repeat the one
/// before them @throws InputError where the sides differ
std::vector<std::size_t> take_sides(TableRow& headings, std::span<const TextLine> lines, char separator) {
    std::vector<std::optional<UncertaintySide>> sides;
    for (const std::string& cell : headings.cells) sides.push_back(uncertainty_side(cell));
    if (!std::ranges::any_of(sides, [](const auto& side) { return side.has_value(); })) return {};
    std::vector<TableRow> rows;
    for (const TextLine& line : lines) rows.push_back(cut_row(line, separator));
    std::vector<std::size_t> repeated = repeated_sides(sides, headings, rows);
    for (std::size_t k = 0; k < sides.size(); ++k)
        if (sides[k]) headings.cells[k] = sides[k]->text;
    return repeated;
}

/// Refuses a heading that states one uncertainty for all numbers below it: "wt% ± 1". @throws InputError
void require_no_common_uncertainty(std::string_view text, std::string_view written, std::size_t line) {
    if (const std::string number = number_behind_plus_minus(text); !number.empty())
        refuse_line(line,
                    "the heading " + in_quotes(written) + " states one uncertainty, " + number +
                        ", for all numbers of its column",
                    "a column of the uncertainties, with the heading " + in_quotes("esd"));
}

}  // namespace

Table parse_table(const TextLines& file, std::optional<DecimalMark> decimal) {
    std::vector<TextLine> lines = lines_with_content(file);
    const auto heading = find_heading(lines);
    if (!heading)
        refuse_line(lines.empty() ? 1 : lines[0].number, "no heading line was found",
                    std::string(heading_help));
    const auto is_unit = [](std::string_view whole) {
        const std::string text = read_coverage(whole).rest;  // of "wt% ± 2s"
        return !text.empty() && (unit_of(text) != HeadingUnit::other || role_of_text(text) != Role::other ||
                                 read_unit(ascii_unit(text)));
    };
    std::vector<TextBeside> groups;  // headings of several columns, "FA1 to FA5 (2 sigma)"
    CutTable cut =
        cut_table(file, std::move(lines), *heading, xrd_code, {"crystalline part", "ignited sample"},
                  [&](TableRow& names, const TableRow& second) {
                      const std::vector<std::string> first = names.cells;
                      if (!take_second_heading(names, second, is_unit))
                          return take_units(names, second, is_unit);
                      for (std::size_t k = 1; k < first.size(); ++k)
                          if (!first[k].empty() && first[k] != names.cells[k])
                              groups.push_back({names.line, first[k], true});
                      return true;
                  });
    refuse_factors(groups);
    for (const TextBeside& group : groups) {
        require_no_common_uncertainty(group.text, group.text, group.line);
        refuse_factor(group.text, group.text, group.line);
    }
    for (const TextBeside& group : groups) {
        const bool is_name = std::ranges::any_of(
            cut.heading.cells, [&](const std::string& cell) { return cell.starts_with(group.text); });
        const bool holds_more = !bases_in(group.text, false).contains("weight") ||
                                std::ranges::any_of(group.text, is_digit) ||  // "wt% (n=3, P=0.95)"
                                !read_coverage(group.text).problem.empty() ||
                                holds_signs(read_heading(group.text).text);
        if (!is_name && !is_unit(group.text) && holds_more)
            cut.findings.push_back(
                {xrd_code, Severity::remark,
                 "of the heading " + in_quotes(group.text) + " over several columns only the unit is read"});
    }
    std::ranges::move(groups, std::back_inserter(cut.texts));
    TableRow names = cut.heading;
    const auto units = take_unit_column(names, cut.rows, cut.separator, is_unit);
    const std::vector<std::size_t> repeated = take_sides(names, cut.rows, cut.separator);
    Table table{.heading_line = cut.heading.line,
                .headings = headings_of(names),
                .rows = {},
                .separator = cut.separator,
                .marks = NumberMarks(decimal, file.of_sheet())};
    if (heads_samples(names)) table.headings.front().role = Role::phase;
    for (std::size_t k = 0; k < names.cells.size(); ++k)
        if (names.cells[k] != cut.heading.cells[k]) table.headings[k].written = cut.heading.cells[k];
    for (const std::size_t k : repeated) leave_out(table.headings[k]);
    if (units) {
        table.headings[*units].role = Role::measure;
        table.headings[*units].text.clear();
    }
    refuse_two_methods(cut.heading.cells, cut.heading.line);
    name_crystalline_totals(table);
    drop_numbers_of_phases(table, cut.rows);
    const bool is_wide = table.has(Role::phase) != table.has(Role::sample) && !names_amounts(table.headings);
    if (is_wide) {
        leave_texts_out(table, cut.rows);
        find_amounts_with_uncertainties(table);
        find_uncertainties(table);
    }
    require_units_at_amounts(table);
    refuse_pairs_of_bases(table);
    if (table.has(Role::phase) && !table.has(Role::sample)) mark_sums(table);
    set_aside_traces(table);
    set_aside_quantities(table);
    if (is_wide) require_owner_of_last(table);
    set_aside_others(table);
    for (const Heading& each : table.headings)
        if (each.of_crystalline && each.role != Role::measure) table.crystalline = "the heading";
    prefer_fractions(table);
    if (table.has(Role::intensity)) find_uncertainties_of_ratios(table);
    drop_uncertainties_of_unused(table, cut.rows);
    check_units_of_uncertainties(table);
    require_owners_of_uncertainties(table);
    choose_uncertainties(table);
    refuse_uncertainties_of_means(table);
    const Heading* amounts = nullptr;
    for (Heading& each : table.headings) {
        if (each.role == Role::uncertainty && amounts != nullptr)
            take_coverage_of_amounts({amounts->written, amounts->coverage}, each.written, each.coverage,
                                     table.heading_line);
        if (each.role == Role::weight || each.role == Role::volume || each.role == Role::intensity ||
            (each.role == Role::other && !each.text.empty()))
            amounts = &each;
    }
    for (const Heading& each : table.headings)
        if (each.role != Role::measure)
            require_no_common_uncertainty(each.coverage.rest, each.written, table.heading_line);
    table.warnings = cut.findings;
    table.texts = cut.texts;
    bool thousands = false;  // of the amounts, and so of the uncertainties behind them
    for (std::size_t k = 0; k < table.headings.size(); ++k) {
        const Heading& each = table.headings[k];
        const bool uncertain = is_uncertainty(each);
        if (!uncertain)
            thousands =
                each.role == Role::intensity || each.scale == Scale::ppm || each.scale == Scale::per_mille;
        if (uncertain) table.marks.holds_uncertainties(k);
        if (thousands) table.marks.may_hold_thousands(k);
        if (!uncertain && (each.role == Role::weight || each.role == Role::volume) && !thousands)
            table.marks.stays_below_thousand(k);
    }
    require_agreeing_texts(table, cut.texts, cut.rows);
    for (const TextLine& line : cut.rows) {
        table.rows.push_back(cut_row(line, table.separator));
        require_cells(table.rows.back(), table.headings.size());
        for (std::size_t k = 0; k < table.headings.size(); ++k)
            if (table.headings[k].role != Role::phase && table.headings[k].role != Role::sample &&
                table.headings[k].role != Role::measure)
                table.marks.see(table.rows.back().cells[k], k);
        if (table.rows.size() * table.headings.size() > most_cells)
            refuse_line(line.number, "the table is too large for an XRD result",
                        std::to_string(most_cells) + " cells or fewer");
    }
    if (table.rows.empty())
        refuse_line(file.last_line(), "there are no lines below the heading", "one line a phase or a sample");
    for (const TableRow& row : table.rows)  // "Weight fraction;57.0 %" names a quantity, no unit
        for (std::size_t k = 0; k < table.headings.size(); ++k)
            if (table.headings[k].scale == Scale::fraction && table.headings[k].unit.empty() &&
                row.cells[k].ends_with('%'))
                table.headings[k].scale = Scale::not_stated;
    refuse_coverages(table);
    if (table.has(Role::phase)) {
        take_notes_on_phases(table, cut.notes);
        find_blank_rows(table);
        drop_measures(table);
    }
    take_texts_on_phases(table, cut.texts);
    refuse_reference_samples(table);
    if (const auto label = table.column(Role::sample))
        for (const TableRow& row : table.rows) require_plain_sample(row.cells[*label], row.line);
    else
        for (const Heading& each : table.headings)
            if (each.role == Role::other && is_wide) require_plain_sample(each.text, table.heading_line);
    if (table.has(Role::sample) && !table.has(Role::phase)) {
        const double factor =
            take_rows_of_uncertainties(table.rows, 0, *table.column(Role::sample), xrd_code, table.warnings);
        for (Heading& each : table.headings)
            if (each.role == Role::other && each.coverage.factor == 1) each.coverage.factor = factor;
        drop_summaries(table);
    }
    if (table.rows.empty())
        refuse_line(table.heading_line, "no line below the heading names a phase", "one line a phase");
    return table;
}

Layout layout_of(const Table& table) {
    refuse_repeated_roles(table);
    require_unit_of_standard(table);
    const std::size_t line = table.heading_line;
    const bool phase = table.has(Role::phase);
    if (phase && (table.has(Role::weight) || table.has(Role::volume))) return Layout::fractions;
    if (phase && table.has(Role::intensity) && table.has(Role::ratio)) return Layout::peaks;
    if (phase && table.has(Role::intensity))
        refuse_line(line, "there are intensities without reference intensity ratios", "a column rir");
    if (phase && lower_case(table.headings[*table.column(Role::phase)].text) == "name")
        refuse_line(line, "\"name\" may be that of a phase or of a sample", "the heading phase or sample");
    if (phase && !table.has(Role::sample)) {
        const bool named = std::ranges::any_of(table.headings, [](const Heading& heading) {
            return heading.role == Role::other && !heading.text.empty() &&
                   heading.states != HeadingUnit::other;
        });
        const auto other = std::ranges::find_if(table.headings, [&](const Heading& heading) {
            return !heading.text.empty() && !heading.sums_up && !may_name_sample(heading) &&
                   !(named && heading.role == Role::measure);
        });
        if (other != table.headings.end() && bases_in(other->written, false).contains("mode"))
            refuse_line(line,
                        "the column " + in_quotes(other->written) +
                            " may hold fractions by volume, as modes and areas are, or by weight",
                        "\"vol%\" or \"wt%\" as its unit");
        if (other != table.headings.end())
            refuse_line(line,
                        "the column " + in_quotes(other->written) +
                            " holds no weight or volume fractions, and is not the name of a sample",
                        std::string(heading_help));
        const Heading* only = nullptr;
        std::size_t columns = 0;
        for (const Heading& heading : table.headings) {
            if (heading.text.empty() || heading.role != Role::other) continue;
            only = &heading;
            ++columns;
        }
        if (columns == 1 && table.has(Role::ratio))
            refuse_line(line,
                        "the column " + in_quotes(only->written) +
                            " may hold intensities, beside reference intensity ratios, or fractions",
                        "\"intensity\" or \"weight %\" as its heading");
        const auto in_cells = [&](const TableRow& row) {
            const std::string& cell = row.cells[static_cast<std::size_t>(only - table.headings.data())];
            return says_no_number(cell) || without_unit(cell, *only) != cell;
        };
        if (columns == 1 && only->states == HeadingUnit::none && !std::ranges::all_of(table.rows, in_cells))
            refuse_line(line,
                        "the column " + in_quotes(only->written) +
                            " may be a sample, or a quantity that is not known here",
                        "\"weight %\" or \"volume %\" as its heading, or as the unit of the sample: " +
                            in_quotes(only->text + " [wt%]"));
        if (columns == 1) refuse_factor(only->text, only->written, line);
        return Layout::one_column_a_sample;
    }
    if (!phase && table.has(Role::sample)) return Layout::one_column_a_phase;
    refuse_line(line, "no column holds the amounts", std::string(heading_help));
}

bool by_volume(const Table& table, Layout layout) {
    bool weight = false;
    bool volume = false;
    const Heading* stated = nullptr;  // the first with a unit
    const Heading* other = nullptr;   // in another one
    const Heading* without = nullptr;
    const Heading* bare = nullptr;  // without a basis
    for (const Heading& heading : table.headings) {
        const bool amounts =
            heading.role == Role::weight || heading.role == Role::volume ||
            (heading.role == Role::other && !heading.text.empty() && layout != Layout::fractions);
        if (!amounts) continue;
        if (heading.states == HeadingUnit::other)
            refuse_line(table.heading_line,
                        "the column " + in_quotes(heading.written) + " is in another unit",
                        "fractions by weight or by volume: [wt%], [vol%], [ppm], [1]");
        if (heading.scale == Scale::not_stated)
            without = &heading;
        else if (stated == nullptr)
            stated = &heading;
        else if (stated->scale != heading.scale)
            other = &heading;
        const bool by_weight = heading.role == Role::weight || heading.states == HeadingUnit::weight;
        const bool of_volume = heading.role == Role::volume || heading.states == HeadingUnit::volume;
        weight = weight || by_weight;
        volume = volume || of_volume;
        if (!by_weight && !of_volume) bare = &heading;
    }
    if (volume && bare != nullptr)
        refuse_line(table.heading_line,
                    "one column is by volume, and " + in_quotes(bare->written) + " may be by weight",
                    "the unit in the heading of every column");
    if (weight && volume)
        refuse_line(table.heading_line, "there are fractions by weight and by volume", "one of the two");
    const bool is_small =
        stated != nullptr && (stated->scale == Scale::ppm || stated->scale == Scale::per_mille);
    if (is_small && other == nullptr) other = without;
    if (other != nullptr)
        refuse_line(table.heading_line,
                    "the columns " + in_quotes(stated->written) + " and " + in_quotes(other->written) +
                        " are not in one unit",
                    "one unit, stated in the heading of every column");
    return volume;
}

std::vector<Entry> entries_of(const Table& table, Layout layout) {
    if (table.has(Role::phase)) refuse_parts_of_rows(table);
    if (layout == Layout::one_column_a_phase) return wide_entries(table, Role::sample);
    if (layout == Layout::one_column_a_sample) return wide_entries(table, Role::phase);
    return long_entries(table, layout);
}

}  // namespace ashimpact::xrd

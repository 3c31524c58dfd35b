// SPDX-License-Identifier: GPL-3.0-or-later
#include "materials/xrd/table_layout.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "core/quantities/checks.hpp"
#include "core/tables/vocabulary.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "core/units/units.hpp"
#include "materials/xrd/xrd.hpp"

namespace ashimpact::xrd {

namespace {

std::string key_of(std::string_view text) {
    return word_key(text, "%+");
}

std::string without_per_cent(std::string key) {
    std::erase(key, '%');
    for (const std::string_view word : {"percent", "pct", "prozent"}) {
        const auto found = key.find(word);
        if (found != std::string::npos) key.erase(found, word.size());
    }
    return key;
}

/// @param key without per cent signs; the empty one is a bare "%"
Role role_of(const std::string& key) {
    static const WordLists words("XRD columns", "+");
    if (const auto role = meaning<Role>(words, key)) return *role;
    return is_uncertainty_word(key) ? Role::uncertainty : Role::other;
}

bool holds_per_cent(const std::string& key) {
    return without_per_cent(key) != key;
}

/// Whether a heading such as "Quartz esd" ends with a word for an uncertainty behind the name of a phase.
bool ends_with_uncertainty_word(std::string_view heading) {
    const auto blank = heading.find_last_of(" _");
    return blank != std::string_view::npos &&
           role_of(without_per_cent(key_of(heading.substr(blank + 1)))) == Role::uncertainty;
}

/// Whether brackets hold a unit, unlike those of "Mullite (3:2)".
bool is_unit_in_brackets(std::string_view text) {
    const std::string key = key_of(text);
    return holds_per_cent(key) || key.find("m3") != std::string::npos || key == "wt" || key == "vol" ||
           key.find("pp") == 0 || (text.find('/') != std::string_view::npos && read_unit(ascii_unit(text)));
}

/// "Weight [wt.%]", "content, vol%" and "Gehalt in Mol-%" into text and unit.
void split_unit(Heading& heading, std::string_view text) {
    heading.text = std::string(text);
    const auto split = [&](std::size_t end, std::string_view unit) {
        std::string_view name = trimmed(text.substr(0, end));
        while (name.ends_with(',') || name.ends_with(';') || name.ends_with('/'))
            name = trimmed(name.substr(0, name.size() - 1));
        if (name.ends_with(" in")) name = trimmed(name.substr(0, name.size() - 3));
        heading.text = std::string(name);
        heading.unit = std::string(trimmed(unit));
    };
    for (const auto& [open, close] : {std::pair{'[', ']'}, std::pair{'(', ')'}}) {
        const auto start = text.rfind(open);
        if (start == std::string_view::npos || start == 0 || !text.ends_with(close)) continue;
        const std::string_view inside = trimmed(text.substr(start + 1, text.size() - start - 2));
        if (open == '[' || is_unit_in_brackets(inside)) return split(start, inside);
    }
    const auto blank = text.find_last_of(" /");
    if (blank == std::string_view::npos || !holds_per_cent(key_of(text.substr(blank + 1)))) return;
    const std::string_view name = trimmed(text.substr(0, blank));
    const bool is_quotient = text[blank] == '/' || name.ends_with('/');  // "w/%", but not "1/wt%"
    if (!is_quotient || role_of(key_of(name)) != Role::other) split(blank, text.substr(blank + 1));
}

HeadingUnit unit_of(std::string_view text) {
    if (text.empty()) return HeadingUnit::none;
    const std::string key = without_per_cent(key_of(text));
    if (key.empty() || key == "1") return HeadingUnit::fraction;
    if (key == "gg" || key == "kgkg" || key == "g100g") return HeadingUnit::weight;
    if (key == "m3m3" || key == "cm3cm3") return HeadingUnit::volume;
    const Role role = role_of(key);
    return role == Role::weight   ? HeadingUnit::weight
           : role == Role::volume ? HeadingUnit::volume
                                  : HeadingUnit::other;
}

/// Whether the heading of a column beside the phases may be the name of a sample: it has no unit but those of
/// fractions, and no sign of a quantity.
bool may_name_sample(const Heading& heading) {
    if (heading.role == Role::measure) return false;
    if (heading.role != Role::other) return true;
    constexpr std::array<std::string_view, 15> signs{"%",  "\u2030", "\u221a", "\u00b2", "\u00b3",
                                                     "^",  "\u0394", "\u2206", "\u03c3", "\u00bd",
                                                     "1/", "\u00b0", "\u00c5", "\u03b8", "ppm"};
    const bool is_quotient =
        heading.text.find('/') != std::string::npos && read_unit(ascii_unit(heading.text)).has_value();
    return heading.states != HeadingUnit::other && !is_quotient &&
           std::none_of(signs.begin(), signs.end(),
                        [&](std::string_view sign) { return heading.text.find(sign) != std::string::npos; });
}

/// Removes "(crystalline)" or "crystalline" behind a quantity. @return whether it was there
bool take_crystalline(std::string& text) {
    for (const std::string_view word :
         {"(crystalline)", "(cryst.)", "(kristallin)", "crystalline", "kristallin"}) {
        if (text.size() <= word.size() || !lower_case(text).ends_with(word)) continue;
        text = std::string(trimmed(std::string_view(text).substr(0, text.size() - word.size())));
        return true;
    }
    return false;
}

constexpr std::string_view heading_help =
    "a heading line with phase and weight (and sample, uncertainty, density), or phase, intensity and rir, "
    "or sample and one column a phase, or phase and one column a sample";

constexpr std::size_t most_cells = 500'000;

std::vector<Heading> headings_of(const TableRow& row) {
    std::vector<Heading> headings;
    for (const std::string& cell : row.cells) headings.push_back(read_heading(cell));
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
            if (!is_heading(headings)) continue;
            if (names_amounts(headings)) return i;
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

TableRow checked_row(const TextLine& line, const Table& table) {
    TableRow row = cut_row(line, table.separator);
    while (row.cells.size() > table.headings.size() && row.cells.back().empty()) row.cells.pop_back();
    if (row.cells.size() != table.headings.size())
        refuse_line(line.number,
                    "the line has " + std::to_string(row.cells.size()) + " cells, the heading has " +
                        std::to_string(table.headings.size()),
                    "as many cells as headings (a decimal comma needs another separator, or quotes)");
    return row;
}

bool is_uncertainty(const Heading& heading) {
    return heading.role == Role::uncertainty || heading.role == Role::ratio_uncertainty;
}

/// Leaves out uncertainties in another unit than the fractions, such as [rel.%].
void check_units_of_uncertainties(Table& table) {
    if (table.has(Role::intensity)) return;
    const auto amounts = std::ranges::find_if(table.headings, [](const Heading& heading) {
        return heading.role == Role::weight || heading.role == Role::volume ||
               (heading.role == Role::other && !heading.unit.empty());
    });
    for (Heading& heading : table.headings) {
        if (heading.role != Role::uncertainty || heading.unit.empty()) continue;
        const bool known = amounts != table.headings.end();
        const bool is_volume =
            known && (amounts->role == Role::volume || amounts->states == HeadingUnit::volume);
        const bool scaled_alike =
            !known || amounts->scale == Scale::not_stated || amounts->scale == heading.scale;
        if (heading.states == HeadingUnit::other || !scaled_alike ||
            heading.states == (is_volume ? HeadingUnit::weight : HeadingUnit::volume))
            heading.coverage.problem = "they are in another unit than the fractions";
    }
}

/// The number of a cell, with uncertainties as standard ones; nothing if the cell states that there is none.
std::optional<PrintedNumber> number_in(const TableRow& row, std::size_t column, const Table& table) {
    const std::string& cell = row.cells[column];
    if (says_no_number(cell)) return std::nullopt;
    auto number = at_place(at_cell(row.line, column), [&] { return table.marks.read(cell, column); });
    if (!number) throw InputError("cannot read " + in_quotes(cell), "a number").at(at_cell(row.line, column));
    const Heading& heading = table.headings[column];
    if (number->per_cent && (heading.scale == Scale::fraction || heading.scale == Scale::ppm))
        throw InputError(in_quotes(cell) + " is per cent, and the heading " + in_quotes(heading.written) +
                             " states another unit",
                         "one of the two")
            .at(at_cell(row.line, column));
    const auto states_per_cent = [](const Heading& each) { return each.scale == Scale::per_cent; };
    if (heading.role == Role::uncertainty && number->per_cent &&
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

std::optional<double> density_in(const TableRow& row, std::size_t column, const Table& table) {
    const std::string& cell = row.cells[column];
    const Heading& heading = table.headings[column];
    if (says_no_number(cell)) return std::nullopt;
    return at_place(at_cell(row.line, column), [&] {
        if (heading.unit.empty() && read_number(cell))
            throw InputError("the density has no unit",
                             "density [g/cm3] as the heading, or a unit in each cell");
        const auto number = heading.unit.empty() ? std::nullopt : number_in(row, column, table);
        const double density = number ? to_si(number->value, heading.unit, Dimension::density)
                                      : parse_quantity(cell, Dimension::density);
        if (!(density > 0)) throw InputError("the density is not positive", "a positive density");
        return std::optional(density);
    });
}

/// One row a phase: phase and weight, or phase, intensity and RIR.
std::vector<Entry> long_entries(const Table& table) {
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
        Entry entry{.sample = cell(Role::sample), .phase = cell(Role::phase), .line = row.line};
        if (entry.sample.empty() && !entries.empty())
            entry.sample = entries.back().sample;  // named once, above
        if (entry.phase.empty()) refuse_line(row.line, "the line names no phase", "a phase");
        entry.amount = number(table.has(Role::weight) ? Role::weight : Role::volume);
        entry.uncertainty = plain(Role::uncertainty);
        if (entry.uncertainty && *entry.uncertainty < 0)
            refuse_line(row.line, "the uncertainty is below zero", "zero or more");
        if (entry.uncertainty && *entry.uncertainty > 0 && !is_computable(*entry.uncertainty))
            refuse_line(row.line, "the uncertainty is " + shortest(*entry.uncertainty),
                        "0, or " + std::string(computable_range));
        entry.intensity = number(Role::intensity);
        entry.ratio = number(Role::ratio);
        entry.ratio_uncertainty = plain(Role::ratio_uncertainty);
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
    if (ends_with_uncertainty_word(name)) return true;
    if (table.headings[column].role != Role::uncertainty) return false;
    const bool same = !entries.empty() && (entries.back().phase == name || entries.back().sample == name);
    return name.empty() || is_uncertainty_word(name) || same;
}

/// One column a phase (one row a sample), or one column a sample (one row a phase).
std::vector<Entry> wide_entries(const Table& table, Role row_role) {
    const std::size_t label = *table.column(row_role);
    std::vector<Entry> entries;
    for (const TableRow& row : table.rows) {
        if (row.cells[label].empty()) refuse_line(row.line, "the first cell is empty", "a name");
        for (std::size_t i = 0; i < row.cells.size(); ++i) {
            const std::string& name = table.headings[i].text;
            const bool is_named = !name.empty() || table.headings[i].role == Role::uncertainty;
            if (i == label || !is_named) continue;  // a column without a heading is not read
            const bool uncertainty = is_uncertainty_of(table, i, entries);
            const auto number = number_in(row, i, table);
            if (uncertainty) {
                if (entries.empty() || entries.back().line != row.line)
                    refuse_line(table.heading_line,
                                "the column " + in_quotes(table.headings[i].written) +
                                    " holds uncertainties and follows no column of fractions",
                                "the column of the fractions before it");
                if (number) entries.back().uncertainty = number->value;
                continue;
            }
            entries.push_back({.sample = row_role == Role::sample ? row.cells[label] : name,
                               .phase = row_role == Role::sample ? name : row.cells[label],
                               .line = row.line,
                               .amount = number});
        }
    }
    if (entries.empty())
        refuse_line(table.heading_line,
                    "no column beside " + in_quotes(table.headings[label].written) + " has a heading",
                    row_role == Role::sample
                        ? "the name of a phase above each column of fractions"
                        : "\"weight %\" or the name of a sample above each column of fractions");
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
                    "the columns " + in_quotes(table.headings[*table.column(role)].text) + " and " +
                        in_quotes(table.headings[i].text) + " hold the same quantity",
                    "one of the two");
    }
}

}  // namespace

Heading read_heading(std::string_view text) {
    Heading heading;
    StatedCoverage coverage = read_coverage(trimmed(text));
    constexpr std::string_view sign = "\u00b1";  // of "wt% ± 2s": cells hold value and uncertainty
    if (!coverage.stated.empty() && coverage.rest.size() > sign.size() && coverage.rest.ends_with(sign))
        coverage.rest.resize(coverage.rest.size() - sign.size());
    heading.written = text;
    heading.coverage = coverage;
    heading.of_crystalline = take_crystalline(coverage.rest);
    split_unit(heading, coverage.rest);
    heading.states = unit_of(heading.unit);
    const std::string key = key_of(heading.text);
    const std::string unit = key_of(heading.unit);
    heading.role = key.empty() ? Role::other : role_of(without_per_cent(key));
    if (heading.role == Role::weight && heading.states == HeadingUnit::volume) heading.role = Role::volume;
    const HeadingUnit contrary = heading.role == Role::weight ? HeadingUnit::volume : HeadingUnit::weight;
    if ((heading.role == Role::weight || heading.role == Role::volume) &&
        (heading.states == HeadingUnit::other || heading.states == contrary))
        heading.role = Role::measure;
    // "2 sigma" alone, or behind the name of a phase or sample, is the uncertainty of the column before it.
    if (!coverage.stated.empty() && (heading.text.empty() || heading.role == Role::other))
        heading.role = Role::uncertainty;
    if (holds_per_cent(key) || holds_per_cent(unit) || unit == "g100g") heading.scale = Scale::per_cent;
    if (key.ends_with("ppm") || unit.ends_with("ppm")) heading.scale = Scale::ppm;
    if (key.ends_with("fraction") && heading.scale == Scale::not_stated) heading.scale = Scale::fraction;
    if (unit == "1" || heading.unit == "-" || unit == "gg" || unit == "kgkg" || unit == "m3m3" ||
        unit == "cm3cm3")
        heading.scale = Scale::fraction;
    return heading;
}

RowMeaning meaning_of_row(std::string_view name) {
    static const WordLists words("XRD rows", "+");
    return meaning<RowMeaning>(words, without_per_cent(key_of(name))).value_or(RowMeaning::phase);
}

bool has_heading(const TextLines& file) {
    return find_heading(lines_with_content(file)).has_value();
}

namespace {

/// Removes rows that sum up samples, such as "Mittel" and "SD". Single letters are names of samples, unless
/// such a row stands before them.
void drop_summaries(Table& table) {
    const std::size_t label = *table.column(Role::sample);
    const auto is_sum = [&](const TableRow& row) { return is_summary(row.cells[label]); };
    if (std::ranges::all_of(table.rows, is_sum)) return;  // such words are then the names of all samples
    bool follows = false;
    std::erase_if(table.rows, [&](const TableRow& row) {
        follows = is_sum(row) && (follows || row.cells[label].size() > 1);
        if (follows)
            table.warnings.push_back(
                {xrd_code, Severity::remark,
                 at_line(row.line) + " is no sample and left out: " + in_quotes(row.cells[label])});
        return follows;
    });
}

/// Refuses a title that states volume or mole fractions above a heading that does not. @throws InputError
void require_unit_of_title(const TextLine& line, const Table& table) {
    const std::string key = key_of(line.text);
    const bool by_volume = key.find("vol%") != std::string::npos || key.find("volumen%") != std::string::npos;
    const bool by_mole = key.find("mol%") != std::string::npos;
    if (by_mole || (by_volume && !table.has(Role::volume)))
        refuse_line(line.number,
                    "the title states fractions by " + std::string(by_mole ? "mole" : "volume") +
                        ", the heading below it does not",
                    "\"weight %\" or \"volume %\" in the heading");
}

}  // namespace

Table parse_table(const TextLines& file, std::optional<DecimalMark> decimal) {
    std::vector<TextLine> lines = lines_with_content(file);
    const auto heading = find_heading(lines);
    if (!heading)
        refuse_line(lines.empty() ? 1 : lines[0].number, "no heading line was found",
                    std::string(heading_help));
    Table table{.heading_line = lines[*heading].number,
                .headings = {},
                .rows = {},
                .separator = separator_of(lines[*heading].text),
                .marks = NumberMarks(decimal)};
    TableRow headings = cut_row(lines[*heading], table.separator);
    std::size_t first = *heading + 1;  // of the rows
    const auto is_unit = [](std::string_view text) {
        return unit_of(text) != HeadingUnit::other ||
               role_of(without_per_cent(key_of(text))) != Role::other || read_unit(ascii_unit(text));
    };
    if (first < lines.size() && take_units(headings, cut_row(lines[first], table.separator), is_unit))
        ++first;
    table.headings = headings_of(headings);
    check_units_of_uncertainties(table);
    for (std::size_t i = 0; i < *heading; ++i) require_unit_of_title(lines[i], table);
    if (*heading > 0)
        table.warnings.push_back(
            {xrd_code, Severity::background, counted(*heading, "line") + " above the heading not read"});
    std::vector<std::pair<std::string, StatedCoverage>> coverages;
    for (const Heading& each : table.headings) coverages.emplace_back(each.written, each.coverage);
    for (Finding& each : coverage_findings(xrd_code, coverages)) table.warnings.push_back(std::move(each));
    for (Finding& each : take_notes(lines, first, table.separator, xrd_code))
        table.warnings.push_back(std::move(each));
    for (std::size_t i = first; i < lines.size(); ++i) {
        table.rows.push_back(checked_row(lines[i], table));
        for (std::size_t k = 0; k < table.headings.size(); ++k)
            if (table.headings[k].role != Role::phase && table.headings[k].role != Role::sample)
                table.marks.see(table.rows.back().cells[k], k);
        if (table.rows.size() * table.headings.size() > most_cells)
            refuse_line(lines[i].number, "the table is too large for an XRD result",
                        std::to_string(most_cells) + " cells or fewer");
    }
    if (table.rows.empty())
        refuse_line(file.last_line(), "there are no lines below the heading", "one line a phase or a sample");
    if (table.has(Role::sample) && !table.has(Role::phase)) drop_summaries(table);
    return table;
}

Layout layout_of(const Table& table) {
    refuse_repeated_roles(table);
    const std::size_t line = table.heading_line;
    const bool phase = table.has(Role::phase);
    if (phase && table.has(Role::intensity) && table.has(Role::ratio)) return Layout::peaks;
    if (phase && table.has(Role::weight) && table.has(Role::volume))
        refuse_line(line, "there are fractions by weight and by volume", "one of the two");
    if (phase && (table.has(Role::weight) || table.has(Role::volume))) return Layout::fractions;
    if (phase && table.has(Role::intensity))
        refuse_line(line, "there are intensities without reference intensity ratios", "a column rir");
    if (phase && lower_case(table.headings[*table.column(Role::phase)].text) == "name")
        refuse_line(line, "\"name\" may be that of a phase or of a sample", "the heading phase or sample");
    if (phase && !table.has(Role::sample)) {
        const auto other = std::ranges::find_if(table.headings, [](const Heading& heading) {
            return !heading.text.empty() && !may_name_sample(heading);
        });
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
        if (columns == 1 && only->states == HeadingUnit::none)
            refuse_line(line,
                        "the column " + in_quotes(only->written) +
                            " may be a sample, or a quantity that is not known here",
                        "\"weight %\" or \"volume %\" as its heading, or as the unit of the sample: " +
                            in_quotes(only->text + " [wt%]"));
        return Layout::one_column_a_sample;
    }
    if (!phase && table.has(Role::sample)) return Layout::one_column_a_phase;
    refuse_line(line, "no column holds the amounts", std::string(heading_help));
}

bool by_volume(const Table& table, Layout layout) {
    if (const auto standard = table.column(Role::standard);
        standard && table.headings[*standard].states == HeadingUnit::other)
        refuse_line(table.heading_line,
                    "the column " + in_quotes(table.headings[*standard].written) + " is in another unit",
                    "the weight fraction of the standard in the mixture: [wt%], [1]");
    bool weight = false;
    bool volume = false;
    for (const Heading& heading : table.headings) {
        const bool amounts =
            heading.role == Role::weight || heading.role == Role::volume ||
            (heading.role == Role::other && !heading.text.empty() && layout != Layout::fractions);
        if (!amounts) continue;
        if (heading.states == HeadingUnit::other)
            refuse_line(table.heading_line,
                        "the column " + in_quotes(heading.written) + " is in another unit",
                        "fractions by weight or by volume: [wt%], [vol%], [ppm], [1]");
        weight = weight || heading.role == Role::weight || heading.states == HeadingUnit::weight;
        volume = volume || heading.role == Role::volume || heading.states == HeadingUnit::volume;
    }
    if (weight && volume)
        refuse_line(table.heading_line, "there are fractions by weight and by volume", "one of the two");
    return volume;
}

std::vector<Entry> entries_of(const Table& table, Layout layout) {
    if (layout == Layout::one_column_a_phase) return wide_entries(table, Role::sample);
    if (layout == Layout::one_column_a_sample) return wide_entries(table, Role::phase);
    return long_entries(table);
}

}  // namespace ashimpact::xrd

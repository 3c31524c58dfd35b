// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <regex>
#include <set>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "core/plausibility.hpp"
#include "core/tables/table_reading.hpp"
#include "core/tables/table_texts.hpp"
#include "core/tables/text_lines.hpp"
#include "core/tables/vocabulary.hpp"
#include "core/tables/workbook/workbook.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "core/units/units.hpp"
#include "materials/xrd/table_headings.hpp"
#include "pipeline/app/deposit/sizes_choice.hpp"

namespace ashimpact {

/// Columns of a sieve table. A residue is all that is coarser, or what lies on one sieve, which is retained.
/// Classes are both sizes in one cell: "10-20".
enum class SieveColumn { size, from, to, finer, coarser, residue, retained, share, classes };

template <>
struct Names<SieveColumn> {
    static constexpr std::string_view kind = "sieve column";
    static constexpr std::array<std::string_view, 9> all{"size",    "from",     "to",    "finer",  "coarser",
                                                         "residue", "retained", "share", "classes"};
};

namespace {

constexpr TextLimits sieve_limits{.content = "a sieve table"};
constexpr double sum_tolerance = 0.02;   ///< of shares from 1
constexpr double end_tolerance = 0.005;  ///< of a share at the largest size from 1
constexpr double finest_ratio = 0.5;     ///< what passes the finest sieve begins at so much of its size
constexpr double notable_fines = 0.05;   ///< of the mass, finer than the finest sieve
constexpr double small_unit = 1e-7;      ///< of nm: a size may be thousands [m]

/// A heading cut into its name and its unit: "passing [%]", "size in um", "d (mm)".
struct SieveHeading {
    std::optional<SieveColumn> column{};
    std::string unit{};
    std::string written{};
    double scale = 1;  ///< of shares in that unit to parts of 1
};

/// A name without the words for per cent and for the basis, and without those for a sum: "Siebrückstand" of
/// "Siebrückstand kumuliert", "below" of "Volume below".
struct BareName {
    std::string text{};
    bool is_sum = false;
};

BareName bare_name(std::string_view name) {
    static const WordLists bases("bases");
    static const WordLists sums("words for sums");
    BareName bare;
    for (const std::string& word : words_in(name)) {
        const auto base = bases.list_of(word).value_or("");
        const bool is_sum = sums.holds(word);
        bare.is_sum = bare.is_sum || is_sum;
        if (is_sum || word == "%" || base == "weight" || base == "volume") continue;
        (bare.text += bare.text.empty() ? "" : " ") += word;
    }
    return bare;
}

/// The column of a name. A cumulative residue is all that is coarser.
std::optional<SieveColumn> column_of(std::string_view name) {
    static const WordLists words("sieve columns");
    if (const auto column = meaning<SieveColumn>(words, name)) return column;
    const BareName bare = bare_name(name);
    const auto column = meaning<SieveColumn>(words, bare.text);
    switch (column.value_or(SieveColumn::size)) {
        case SieveColumn::finer:
        case SieveColumn::coarser:
            return column;
        case SieveColumn::residue:
        case SieveColumn::retained:
            return bare.is_sum ? SieveColumn::coarser : column;
        default:
            return bare.is_sum && bare.text.empty() ? std::optional(SieveColumn::finer) : std::nullopt;
    }
}

SieveHeading sieve_heading(const std::string& cell) {
    const auto [name, unit] = cut_heading(cell);
    constexpr std::array<double, 5> scales{1, 0.01, 1, 1e-3, 1e-6};  // by xrd::Scale
    const auto scale = static_cast<std::size_t>(xrd::read_heading("x [" + unit + "]").scale);
    SieveHeading heading{.unit = unit, .written = cell, .scale = scales[scale]};
    const bool is_density = name.starts_with("q3");  // unlike Q3
    if (!is_density && !has_sign_of_bound(cell)) heading.column = column_of(name);
    if (unit.empty() && cell.find('%') != std::string::npos) heading = {heading.column, "%", cell, 0.01};
    return heading;
}

/// The headings that are not known, of the first line that may be one of headings: ": \"D / %\" is not
/// known".
std::string unknown_in(const std::vector<TextLine>& lines) {
    for (const TextLine& line : lines) {
        const std::vector<std::string> cells = cut_row(line, separator_of(line.text)).cells;
        const auto is_name = [](const std::string& cell) { return !cell.empty() && !is_digit(cell.front()); };
        if (cells.size() < 2 || !std::ranges::all_of(cells, is_name)) continue;
        std::vector<std::string> unknown;
        for (const std::string& cell : cells)
            if (!sieve_heading(cell).column) unknown.push_back(in_quotes(cell));
        return unknown.empty()
                   ? ": no column holds shares"
                   : fmt::format(": {} {} not known", joined(unknown), unknown.size() == 1 ? "is" : "are");
    }
    return {};
}

bool is_size(SieveColumn column) {
    return column == SieveColumn::size || column == SieveColumn::from || column == SieveColumn::to ||
           column == SieveColumn::classes;
}

/// The two sizes of a class, as texts: "10-20 um", "10 bis 20", "< 45", "> 63"; none of another text.
/// The lower one of "< 45" is "0", the upper one of "> 63" is empty.
struct ClassEnds {
    std::string from;
    std::string to;
};

std::optional<ClassEnds> class_ends(std::string_view cell) {
    constexpr std::size_t longest = 60;  // regular expressions recurse along it
    static const std::regex between(
        "([0-9][0-9.,]* *[^0-9.,<>+-]{0,4}?) *(?:-|\u2013|\u2014|\u2026|\\.\\.+|to|bis|\u00e0|/) *"
        "([0-9][0-9.,]*[^0-9]*)",
        std::regex::icase);
    static const std::regex below("(?:<|\u2264|<=|below|unter|under) *([0-9][0-9.,]*[^0-9]*)",
                                  std::regex::icase);
    static const std::regex above("(?:>|\u2265|>=|above|\u00fcber|over) *([0-9][0-9.,]*)[^0-9]*",
                                  std::regex::icase);
    const std::string text(trimmed(cell));
    std::smatch match;
    if (text.size() > longest) return std::nullopt;
    if (std::regex_match(text, match, between))
        return ClassEnds{std::string(trimmed(match.str(1))), match.str(2)};
    if (std::regex_match(text, match, below)) return ClassEnds{"0", match.str(1)};
    if (std::regex_match(text, match, above)) return ClassEnds{match.str(1), {}};
    return std::nullopt;
}

/// A table with its numbers in SI, cumulative or by classes.
class SieveTable {
  public:
    SieveTable(const TextLines& file, std::optional<DecimalMark> decimal) : marks_(decimal, file.of_sheet()) {
        std::vector<TextLine> lines = lines_with_content(file);
        refuse_blanks(lines);
        const auto heading =
            std::ranges::find_if(lines, [&](const TextLine& line) { return is_heading(line); });
        if (heading == lines.end())
            refuse_line(
                file.lines().front().number, "no line names the columns of a sieve table" + unknown_in(lines),
                "\"size [um]\" with \"passing [%]\" or \"residue [%]\"; or \"from [um]\", \"to [um]\", "
                "\"share [%]\"");
        const auto place = static_cast<std::size_t>(heading - lines.begin());
        CutTable table = cut_table(
            file, std::move(lines), place, "deposition", {},
            [](TableRow& names, const TableRow& second) { return take_units(names, second, is_sieve_unit); });
        const std::size_t heading_line = table.heading.line;
        take_columns(table.heading);
        settle(heading_line);
        std::ranges::move(table.findings, std::back_inserter(notes_));
        const std::span<const TextLine> below(table.rows);
        table.take_unused_cells([&](std::size_t k) { return k < columns_.size() && !columns_[k].column; });
        require_agreeing_texts(table.texts);
        take_units_of_cells(heading_line, below);
        for (std::size_t k = 0; k < columns_.size(); ++k)
            if (columns_[k].column && is_size(*columns_[k].column) &&
                to_si(1, columns_[k].unit, Dimension::length) < small_unit)
                marks_.may_hold_thousands(k);
            else if (columns_[k].column && !is_size(*columns_[k].column) && columns_[k].scale > 1e-3)
                marks_.stays_below_thousand(k);
        table.show(marks_);
        for (const TextLine& line : below) add(cut_row(line, separator_));
        last_line_ = below.empty() ? heading_line : below.back().number;
    }

    [[nodiscard]] ParticleSizes sizes(std::vector<Finding>& notes) const {
        if (rows_.empty())
            refuse_line(last_line_, "there are no rows below the heading", "a size and a share each");
        std::ranges::copy(notes_, std::back_inserter(notes));
        std::ranges::copy(marks_.findings("deposition"), std::back_inserter(notes));
        return kind_ == SieveColumn::share ? by_classes(notes) : cumulative(notes);
    }

    /// What the columns are taken as.
    [[nodiscard]] std::string reading() const {
        static constexpr std::array names{"diameters",
                                          "lower diameters of classes",
                                          "upper diameters of classes",
                                          "finer than the size, by mass",
                                          "coarser than the size, by mass",
                                          "coarser than the size, by mass",
                                          "on each sieve, by mass",
                                          "in the class, by mass",
                                          "classes of diameters"};  // by SieveColumn
        TableReading reading;
        reading.add(counted(rows_.size(), "size"));
        for (std::size_t k = 0; k < columns_.size(); ++k) {
            const SieveHeading& heading = columns_[k];
            if (!heading.column || (!is_size(*heading.column) && k != *place(kind_))) continue;
            const std::string unit = heading.unit.empty() ? "" : " [" + heading.unit + "]";
            reading.take(names.at(static_cast<std::size_t>(*heading.column)) + unit, heading.written);
        }
        return reading.text();
    }

  private:
    struct ShareRow {
        std::size_t line;
        double from, to, share;        ///< from: of classes only [m, m, 1]
        std::vector<double> beside{};  ///< the other columns of shares; not a number: an empty cell
    };

    [[nodiscard]] std::optional<std::size_t> place(SieveColumn column) const {
        for (std::size_t i = 0; i < columns_.size(); ++i)
            if (columns_[i].column == column) return i;
        return std::nullopt;
    }

    void take_columns(const TableRow& headings) {
        columns_.clear();
        for (const std::string& cell : headings.cells) columns_.push_back(sieve_heading(cell));
        const bool has_sizes = place(SieveColumn::size) || place(SieveColumn::from) || place(SieveColumn::to);
        for (SieveHeading& heading : columns_)  // "from;to;fraction", and "class" beside sizes
            if (heading.column == SieveColumn::classes && has_sizes)
                heading.column = bare_name(cut_heading(heading.written).name).text.starts_with("fra")
                                     ? std::optional(SieveColumn::share)
                                     : std::nullopt;
        if ((!place(SieveColumn::from) && !place(SieveColumn::classes)) || place(SieveColumn::share)) return;
        for (SieveHeading& heading : columns_) {  // "from;to;wt%"
            const BareName bare = bare_name(heading.written);
            const bool is_basis = !heading.written.empty() && bare.text.empty() && !bare.is_sum;
            if (heading.column || !is_basis) continue;
            heading.column = SieveColumn::share;
            return;
        }
    }

    /// Whether the line names sizes and shares. Its columns become those of the table, the first kind of
    /// share that it names the one that counts.
    bool is_heading(const TextLine& line) {
        separator_ = separator_of(line.text);
        take_columns(cut_row(line, separator_));
        if (!place(SieveColumn::size) && !place(SieveColumn::to) && !place(SieveColumn::classes))
            return false;
        constexpr std::array kinds{SieveColumn::share, SieveColumn::finer, SieveColumn::coarser,
                                   SieveColumn::residue, SieveColumn::retained};
        const auto* const kind = std::ranges::find_if(kinds, [&](SieveColumn each) {
            return place(each) &&
                   (each != SieveColumn::share || place(SieveColumn::from) || place(SieveColumn::classes));
        });
        if (kind == kinds.end()) return false;
        kind_ = *kind;
        return true;
    }

    /// Decides what each column is used for. @throws InputError
    void settle(std::size_t line) {
        if (kind_ == SieveColumn::retained)
            refuse_line(line, "\"retained\" has two readings",
                        "\"residue\" for all that is coarser; or \"from\", \"to\" and \"share\" for what "
                        "lies on each "
                        "sieve");
        if (const auto classes = place(SieveColumn::classes); classes && kind_ != SieveColumn::share)
            refuse_line(
                line,
                in_quotes(columns_[*place(kind_)].written) + " beside " +
                    in_quotes(columns_[*classes].written) +
                    " may be of the lower size of each class, of the upper one, or of the class",
                "\"from\", \"to\" and \"share\" for what lies in each class; or \"size\" for one size");
        const std::size_t counting = *place(kind_);
        const auto is_size_of_sieve = [](SieveColumn column) {
            return is_size(column) && column != SieveColumn::from;
        };
        for (std::size_t k = 0; k < columns_.size(); ++k) {
            const SieveHeading& heading = columns_[k];
            for (std::size_t i = 0; heading.column && i < k; ++i)
                if (columns_[i].column &&
                    (columns_[i].column == heading.column ||
                     (is_size_of_sieve(*columns_[i].column) && is_size_of_sieve(*heading.column))))
                    refuse_line(line,
                                "the columns " + in_quotes(columns_[i].written) + " and " +
                                    in_quotes(heading.written) + " state one thing twice",
                                "one of them");
            if (heading.column && !is_size(*heading.column) && k != counting) beside_.push_back(k);
        }
        take_scale(line, columns_[counting]);
    }

    /// Takes the unit of sizes from their cells, "10 um", where the heading states none. @throws InputError
    void take_units_of_cells(std::size_t heading_line, std::span<const TextLine> rows) {
        for (std::size_t k = 0; k < columns_.size(); ++k) {
            SieveHeading& heading = columns_[k];
            if (!heading.column)
                if (const auto unused = unused_column(heading.written, rows, separator_, k)) note(*unused);
            if (!heading.column || !is_size(*heading.column) || !heading.unit.empty()) continue;
            for (const TextLine& row : rows)
                for_each_cell(row, separator_, [&](std::string_view cell, std::size_t column) {
                    const auto end = cell.find_last_of("0123456789.");
                    const std::string_view unit =
                        end == std::string_view::npos ? "" : trimmed(cell.substr(end + 1));
                    if (column == k && heading.unit.empty() && !unit.empty() && read_unit(ascii_unit(unit)))
                        heading.unit = unit;
                });
            units_in_cells_ = !heading.unit.empty();
            if (heading.unit.empty())
                refuse_line(heading_line, "a column of sizes has no unit", "such as \"size [um]\"");
        }
    }

    /// Refuses a text beside the table that contradicts its headings: "by number", "radii", "residue".
    void require_agreeing_texts(const std::vector<TextBeside>& texts) const {
        static const WordLists words("sieve titles", " ");
        require_diameters(texts);
        std::vector<ColumnUnit> units;
        for (const SieveHeading& heading : columns_)
            if (heading.column && is_size(*heading.column) && !heading.unit.empty())
                units.push_back(
                    {heading.written, to_si(1, heading.unit, Dimension::length), Dimension::length});
        require_units(texts, units);
        for (const TextBeside& each : texts) {
            std::set<std::string_view> lists;
            for (const Mention& mention : mentions_in(words_in(each.text), words))
                if (!mention.negated) lists.insert(mention.list);
            const bool is_finer = kind_ == SieveColumn::finer;
            const bool other_kind = kind_ != SieveColumn::share && beside_.empty() &&
                                    !lists.contains(is_finer ? "finer" : "coarser") &&
                                    lists.contains(is_finer ? "coarser" : "finer");
            if (lists.contains("number") || bases_in(each.text).contains("number"))
                refuse_line(each.line, in_quotes(each.text) + " states shares by number",
                            "shares by mass or volume");
            if (lists.contains("on each") && kind_ == SieveColumn::residue)
                refuse_line(each.line,
                            in_quotes(each.text) + " states what lies on each sieve, and the heading " +
                                in_quotes(columns_[*place(kind_)].written) + " all that is coarser",
                            "\"from\", \"to\" and \"share\" for what lies on each sieve");
            if (other_kind)
                refuse_line(each.line,
                            in_quotes(each.text) + " states what is " + (is_finer ? "coarser" : "finer") +
                                ", and the heading " + in_quotes(columns_[*place(kind_)].written) +
                                " the contrary",
                            "one of the two");
        }
    }

    static bool is_sieve_unit(std::string_view text) {
        const auto unit = read_unit(ascii_unit(text));
        return (unit && unit->powers == read_unit("m")->powers) ||
               xrd::read_heading(fmt::format("x [{}]", text)).states != xrd::HeadingUnit::other;
    }

    /// The unit of the shares, which are by mass.
    void take_scale(std::size_t line, const SieveHeading& heading) {
        const xrd::Heading unit = xrd::read_heading("x [" + heading.unit + "]");
        unit_given_ = unit.scale != xrd::Scale::not_stated;
        if (!heading.unit.empty() && unit.states == xrd::HeadingUnit::other)
            refuse_line(line, "the unit of " + in_quotes(heading.written) + " is not known",
                        "shares by mass: [%], [wt%], [1], [g/kg]");
        if (unit.states == xrd::HeadingUnit::volume || bases_in(heading.written, false).contains("volume"))
            note("column " + in_quotes(heading.written) +
                 " is by volume: taken as by mass, as of one density");
        scale_ = heading.scale;
    }

    void note(std::string text) { notes_.push_back({"deposition", Severity::remark, std::move(text)}); }

    [[nodiscard]] double number(const TableRow& row, std::size_t column) {
        return number(row, column, row.cells.at(column));
    }
    /// @param text the cell, or a part of it
    [[nodiscard]] double number(const TableRow& row, std::size_t column, std::string_view text) {
        const std::string place = at_cell(row.line, column);
        const std::string& unit = columns_[column].unit;
        const std::string_view cell = without_unit(text, unit);
        if (units_in_cells_ && is_size(*columns_[column].column) && cell.size() == text.size() && cell != "0")
            throw InputError(in_quotes(cell) + " is not in " + unit + ", as other sizes are",
                             "one unit in all cells, or in the heading")
                .at(place);
        const auto read = at_place(place, [&]() { return marks_.read(cell, column); });
        if (read && read->standard_uncertainty && !told_uncertain_) {
            note("uncertainties are not used, the first in " + place);
            told_uncertain_ = true;
        }
        if (!read)
            throw InputError("cannot read " + in_quotes(text),
                             unit.empty() ? "a number" : "a number in " + unit)
                .at(place);
        if (!unit_given_ && !is_size(*columns_[column].column) && read->value != 0) {
            (read->per_cent ? per_cent_in_cells_ : bare_in_cells_) = true;
            if (per_cent_in_cells_ && bare_in_cells_)
                throw InputError("some shares have a per cent sign and others have none, to " +
                                     in_quotes(text) + ": they may be fractions",
                                 "one form for all cells")
                    .at(place);
        }
        if (!read->per_cent || unit_given_) return read->value;
        per_cent_in_cells_ = true;
        return read->value / 100;
    }
    [[nodiscard]] double length(const TableRow& row, SieveColumn column) {
        const std::size_t k = *place(column);
        return at_place(at_cell(row.line, k),
                        [&] { return to_si(number(row, k), columns_[k].unit, Dimension::length); });
    }

    /// The size of a row, or those of its class in two cells [m]; the lower one is 0 for one size.
    [[nodiscard]] std::pair<double, double> sizes_of(const TableRow& row) {
        const double to = length(row, place(SieveColumn::to) ? SieveColumn::to : SieveColumn::size);
        return {kind_ == SieveColumn::share ? length(row, SieveColumn::from) : 0, to};
    }

    /// The two sizes of the class of a row in one cell [m]. @throws InputError
    [[nodiscard]] std::pair<double, double> class_of(const TableRow& row) {
        const std::size_t k = *place(SieveColumn::classes);
        const std::string& cell = row.cells[k];
        const auto ends = class_ends(cell);
        if (!ends)
            throw InputError(in_quotes(cell) + " is no class of two sizes",
                             "\"10-20\", or \"< 45\" for the finest")
                .at(at_cell(row.line, k));
        if (ends->to.empty())
            throw InputError(in_quotes(cell) + " has no upper size",
                             "the largest size of the ash: \"63-200\"")
                .at(at_cell(row.line, k));
        const auto length_of = [&](const std::string& text) {
            return at_place(at_cell(row.line, k),
                            [&] { return to_si(number(row, k, text), columns_[k].unit, Dimension::length); });
        };
        const bool bare = ends->from.find_first_not_of("0123456789.,") == std::string::npos;
        const bool unit_of_both = units_in_cells_ && bare && ends->from != "0";  // "10-20 um"
        return {length_of(unit_of_both ? ends->from + " " + columns_[k].unit : ends->from),
                length_of(ends->to)};
    }

    void add(const TableRow& row) {
        for (std::size_t k = 0; k < std::min(columns_.size(), row.cells.size()); ++k)
            if (!columns_[k].column && calls_invalid(row.cells[k]))
                refuse_invalid_row(row.cells[k], "column " + in_quotes(columns_[k].written), row.line, k);
        if (is_summary(row.cells.front()))
            return notes_.push_back(left_out("deposition", row, "size", row.cells.front()));
        static const WordLists pans("sieve pans");
        const auto is_floor = [&] {
            const auto sieve = place(SieveColumn::to) ? place(SieveColumn::to) : place(SieveColumn::size);
            const auto size = sieve ? read_number(row.cells[*sieve], true) : std::nullopt;
            return (size && size->value == 0) || pans.holds(row.cells.front());
        };
        if (kind_ != SieveColumn::share && row.cells.size() >= columns_.size() && is_floor()) {
            const double share = number(row, *place(kind_)) * scale_;
            const double part = unit_given_ || share <= 1 + sum_tolerance ? share : share / 100;
            const bool is_finer = kind_ == SieveColumn::finer;
            if (std::abs(part - (is_finer ? 0 : 1)) > end_tolerance)
                refuse_line(
                    row.line,
                    in_quotes(row.cells.front()) +
                        " is below every sieve: " + (is_finer ? "nothing passes it" : "all is coarser"),
                    is_finer ? "0 %, or a table without this row" : "100 %, or a table without this row");
            has_floor_ = true;
            return notes_.push_back(left_out("deposition", row, "size", row.cells.front()));
        }
        if (row.cells.size() < columns_.size())
            refuse_line(row.line, counted(row.cells.size(), "cell"),
                        std::to_string(columns_.size()) + " cells");
        for (std::size_t k = 0; k < columns_.size(); ++k) {
            const bool names_samples =
                !columns_[k].column && xrd::role_of_text(columns_[k].written) == xrd::Role::sample;
            if (!names_samples || row.cells[k].empty()) continue;
            if (sample_ && *sample_ != row.cells[k])
                refuse_line(
                    row.line,
                    "there are several samples, " + in_quotes(*sample_) + " and " + in_quotes(row.cells[k]),
                    "a table for each");
            sample_ = row.cells[k];
        }
        const double share = number(row, *place(kind_)) * scale_;
        const bool has_classes = place(SieveColumn::classes).has_value();
        const auto [from, to] = has_classes ? class_of(row) : sizes_of(row);
        if (!(to > 0) || from < 0 || from >= to)
            refuse_line(row.line, "the sizes do not rise", "0 < from < to");
        if (share < 0) refuse_line(row.line, "the share is negative", "zero or more");
        const auto doubt = implausible(*plausible_range("diameter"), {to});
        if (doubt && !told_implausible_) notes_.push_back(*doubt);
        told_implausible_ = told_implausible_ || doubt;
        rows_.push_back({row.line, from, to, share});
        for (const std::size_t k : beside_)
            rows_.back().beside.push_back(row.cells[k].empty() ? std::numeric_limits<double>::quiet_NaN()
                                                               : number(row, k) * columns_[k].scale);
    }

    /// Compares other columns of shares with the one that counts: each is the sum of what is finer, of what
    /// is coarser, or what lies between this sieve and the next below or above. @param finer by row
    /// @throws InputError where it is none of what its heading may mean
    void check_columns_beside(const std::vector<ShareRow>& rows, const std::vector<double>& finer,
                              double bare_scale, std::vector<Finding>& notes) const {
        for (std::size_t j = 0; j < beside_.size(); ++j) {
            const SieveHeading& heading = columns_[beside_[j]];
            const bool may_be_sum = heading.column != SieveColumn::share;
            const bool may_be_class =
                heading.column != SieveColumn::finer && heading.column != SieveColumn::coarser;
            double off_sum = 0;
            double off_below = 0;
            double off_above = 0;
            for (std::size_t i = 0; i < rows.size(); ++i) {
                const double value = rows[i].beside[j] * (heading.unit.empty() ? bare_scale : 1);
                const double below = i > 0 ? finer[i - 1] : 0;
                const double above = i + 1 < finer.size() ? finer[i + 1] : 1;
                const double sum = heading.column == SieveColumn::finer ? finer[i] : 1 - finer[i];
                off_sum = std::fmax(off_sum, std::abs(value - sum));
                off_below = std::fmax(off_below, std::abs(value - (finer[i] - below)));
                off_above = std::fmax(off_above, std::abs(value - (above - finer[i])));
            }
            const std::string& used = columns_[*place(kind_)].written;
            if (!(may_be_sum && off_sum <= sum_tolerance) &&
                !(may_be_class && std::min(off_below, off_above) <= sum_tolerance))
                refuse_line(
                    rows.front().line,
                    "the columns " + in_quotes(used) + " and " + in_quotes(heading.written) + " do not agree",
                    "one of them");
            notes.push_back({"deposition", Severity::remark,
                             "column " + in_quotes(heading.written) + " agrees with " + in_quotes(used) +
                                 ", which is used"});
        }
    }

    /// Shares without a unit are per cent if one exceeds what a fraction may be.
    [[nodiscard]] double bare_scale(double greatest, std::vector<Finding>& notes) const {
        if (unit_given_ || per_cent_in_cells_) return 1;
        const bool per_cent = greatest > 1 + sum_tolerance;
        notes.push_back({"deposition", Severity::remark,
                         std::string("the shares have no unit: by their size they are ") +
                             (per_cent ? "per cent" : "fractions")});
        return per_cent ? 0.01 : 1;
    }

    static void note_fines(double share, std::vector<Finding>& notes) {
        if (share > notable_fines)
            notes.push_back({"deposition", Severity::remark,
                             fmt::format("{:.3g} % is finer than the smallest size of the table; it is taken "
                                         "to lie above half of that size",
                                         100 * share)});
    }

    [[nodiscard]] ParticleSizes by_classes(std::vector<Finding>& notes) const {
        std::vector<ShareRow> rows = rows_;
        std::ranges::sort(rows, {}, &ShareRow::to);
        double sum = 0;
        for (const ShareRow& row : rows) sum += row.share;
        const double scale = bare_scale(sum, notes);
        if (std::abs(sum * scale - 1) > sum_tolerance + 1e-9)  // sums are rounded
            refuse_line(rows.front().line, fmt::format("the shares add up to {:.4g} %", 100 * sum * scale),
                        "98 to 102 %");
        constexpr double rounding = 2e-3;
        if (std::abs(sum * scale - 1) > rounding)
            notes.push_back(
                {"deposition", Severity::remark,
                 fmt::format("the shares add up to {:.4g} % and are scaled to 100 %", 100 * sum * scale)});
        if (rows.front().from == 0) note_fines(rows.front().share / sum, notes);
        const double first = rows.front().from > 0 ? rows.front().from : finest_ratio * rows.front().to;
        std::vector<double> diameters{first};
        std::vector<double> finer{0};
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (i > 0 && std::abs(rows[i].from / rows[i - 1].to - 1) > 1e-6)
                refuse_line(rows[i].line, "the class does not begin where the one below it ends",
                            "classes without gaps");
            diameters.push_back(rows[i].to);
            finer.push_back(finer.back() + rows[i].share / sum);
        }
        finer.back() = 1;
        check_columns_beside(rows, {finer.begin() + 1, finer.end()}, scale, notes);
        return ParticleSizes::tabulated(std::move(diameters), std::move(finer));
    }

    [[nodiscard]] ParticleSizes cumulative(std::vector<Finding>& notes) const {
        std::vector<ShareRow> rows = rows_;
        std::ranges::sort(rows, {}, &ShareRow::to);
        double greatest = 0;
        for (const ShareRow& row : rows) greatest = std::max(greatest, row.share);
        const double scale = bare_scale(greatest, notes);
        double sum = 0;
        for (const ShareRow& row : rows) sum += row.share * scale;
        // What lies on each sieve adds up to 100 %, or less where the pan below is not listed.
        if (kind_ == SieveColumn::residue && sum <= 1 + sum_tolerance && !has_floor_)
            refuse_line(
                rows.front().line,
                fmt::format("the residues may be all that is coarser, or what lies on each sieve: they "
                            "add up to {:.4g} %{}",
                            100 * sum, sum < 1 - sum_tolerance ? ", without a pan" : ""),
                "\"cumulative residue\"; or \"from\", \"to\" and \"share\" for what lies on each");
        std::vector<double> diameters;
        std::vector<double> finer;
        for (const ShareRow& row : rows) {
            const double share = kind_ == SieveColumn::finer ? row.share * scale : 1 - row.share * scale;
            if (!diameters.empty() && row.to == diameters.back())
                refuse_line(row.line, "the size is there twice", "each size once");
            if (share > 1 + 1e-9 || share < -1e-9 || (!finer.empty() && share < finer.back() - 1e-9))
                refuse_line(row.line,
                            kind_ == SieveColumn::finer ? "the share that is finer falls, or exceeds 100 %"
                                                        : "the share that is coarser rises, or exceeds 100 %",
                            "cumulative shares by mass from 0 to 100 %");
            diameters.push_back(row.to);
            finer.push_back(std::clamp(share, 0.0, 1.0));
        }
        check_columns_beside(rows, finer, scale, notes);
        if (finer.back() < 1 - end_tolerance)
            refuse_line(rows.back().line,
                        fmt::format("{:.3g} % is coarser than the largest size", 100 * (1 - finer.back())),
                        "a last size that all is finer than");
        if (finer.back() < 1 - 1e-9)
            notes.push_back(
                {"deposition", Severity::remark,
                 fmt::format("{:.3g} % is coarser than the largest size of the table; it is taken "
                             "to lie below that size",
                             100 * (1 - finer.back()))});
        finer.back() = 1;
        if (finer.front() > 0) {
            note_fines(finer.front(), notes);
            diameters.insert(diameters.begin(), finest_ratio * diameters.front());
            finer.insert(finer.begin(), 0);
        }
        if (diameters.size() < 2)
            refuse_line(last_line_, "there is one size", "two or more; one size as \"20 um\"");
        return ParticleSizes::tabulated(std::move(diameters), std::move(finer));
    }

    NumberMarks marks_;
    char separator_ = ',';
    std::vector<SieveHeading> columns_{};
    SieveColumn kind_ = SieveColumn::finer;
    double scale_ = 1;
    bool unit_given_ = false;            ///< of shares, in the heading
    bool per_cent_in_cells_ = false;     ///< of shares
    bool bare_in_cells_ = false;         ///< shares without a sign or a unit, other than 0
    bool units_in_cells_ = false;        ///< of sizes
    bool has_floor_ = false;             ///< a row of size 0, or of the pan, on which all lies
    std::vector<std::size_t> beside_{};  ///< other columns of shares
    std::vector<ShareRow> rows_{};
    std::vector<Finding> notes_{};
    std::optional<std::string> sample_{};
    bool told_uncertain_ = false;
    bool told_implausible_ = false;
    std::size_t last_line_ = 1;
};

}  // namespace

SieveResult read_sieve_table(std::string_view bytes, const TableOptions& options) {
    const TableFile file(bytes,
                         {.name = options.sheet,
                          .option = "--sheet",
                          .code = "deposition",
                          .limits = sieve_limits,
                          .holds_table = [](const TextLines& lines) { return SieveTable(lines, {}), true; }});
    return file.read([&](const TextLines& lines) {
        const SieveTable table(lines, options.decimal);
        std::vector<Finding> notes;
        ParticleSizes sizes = table.sizes(notes);
        file.add_findings(notes);
        return SieveResult{std::move(sizes), std::move(notes), table.reading()};
    });
}

}  // namespace ashimpact

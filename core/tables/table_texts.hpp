// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/finding.hpp"
#include "core/tables/number_marks.hpp"
#include "core/tables/text_lines.hpp"
#include "core/tables/vocabulary.hpp"
#include "core/units/units.hpp"

/// What the texts beside the numbers of a table state of them: titles, comments, notes, headings of names.
namespace ashimpact {

struct TextBeside {
    std::size_t line = 0;
    std::string text{};
    bool is_name = false;  ///< of a sample or sheet: "Volumen" alone states a basis
};

/// Begins the text that states the name of a sheet.
inline constexpr std::string_view sheet_name_mark = "name of the sheet: ";

/// The lines of a file that do not belong to its table: titles, comments and notes.
/// @param table heading and rows @throws InputError at a text of more than 20,000 characters
[[nodiscard]] std::vector<TextBeside> texts_beside(const TextLines& file, std::span<const TextLine> table);

/// A table in a file, cut at its heading.
struct CutTable {
    char separator = ',';
    TableRow heading{};  ///< with the names or units of a second line, if there is one
    std::vector<TextLine> rows{};
    std::vector<TextLine> notes{};    ///< below the table
    std::vector<TextBeside> texts{};  ///< titles, comments and notes
    std::vector<Finding> findings{};  ///< on titles and notes, which are not read

    /// Adds the cells of columns that are not used to the texts.
    void take_unused_cells(const std::function<bool(std::size_t column)>& is_unused);
    /// Takes the numbers of all cells into account.
    void show(NumberMarks& marks) const;
};

/// A remark on the comments (#) of a file, which are not read but for what they state of the table.
/// @param content lines that are read: a heading or a sample "#1" may begin with "#"
/// @param used statements that the reader uses
[[nodiscard]] std::optional<Finding> unread_comments(const TextLines& file, std::span<const TextLine> content,
                                                     std::string_view code,
                                                     const std::set<std::string_view>& used = {});

/// @param lines of the file with content @param place of the heading among them
/// @param used statements that the reader uses, so that their texts need no finding
/// @param take_second takes a second line into the heading if it is part of it; none: one of units
[[nodiscard]] CutTable cut_table(const TextLines& file, std::vector<TextLine> lines, std::size_t place,
                                 std::string_view code, const std::set<std::string_view>& used = {},
                                 const std::function<bool(TableRow&, const TableRow&)>& take_second = {});

/// Refuses rows of numbers apart by blanks, as numpy.savetxt() writes them. @throws InputError
void refuse_blanks(const std::vector<TextLine>& lines);

/// Refuses a row with another number of cells than the heading; empty ones at its end do not count.
void require_cells(TableRow& row, std::size_t columns);

/// A remark on a row that sums up others, or is none of what the table lists, with its other texts.
/// @param noun such as "sample"
[[nodiscard]] Finding left_out(std::string_view code, const TableRow& row, std::string_view noun,
                               std::string_view label);

/// A label in quotes, with the texts of its row in brackets, numbers left out: "Note" ("by volume").
[[nodiscard]] std::string with_texts(std::string_view label, const TableRow& row);

/// What a text states that fractions are by: "weight", "volume", "mole", "number", "intensity".
/// @param of_fractions counts a word only beside one for fractions: "Vol.-%", "by volume", but not "Vol. 45"
[[nodiscard]] std::set<std::string_view> bases_in(std::string_view text, bool of_fractions = true);

/// Refuses a text that states fractions by something else than the headings do.
/// @param own what the headings state; empty if nothing
/// @throws InputError at the line of the text
void require_basis(const std::vector<TextBeside>& texts, std::string_view own);

/// A column that holds uncertainties, or numbers that may have some in their cells.
struct UncertainColumn {
    std::string heading;
    StatedCoverage coverage{};
    bool is_uncertainty = false;
};
using UncertainColumns = std::vector<std::optional<UncertainColumn>>;  ///< by position; none: of other texts

/// Adds remarks of that code on columns whose uncertainties are not standard ones: one for all that are
/// divided by the same number, one for each that cannot be read, and for each that holds no uncertainties.
/// @throws InputError at the line of a text beside the table that alone states their coverage: "# errors are
/// 2 sigma"
void check_coverage(std::string_view code, const std::vector<TextBeside>& texts,
                    const UncertainColumns& columns, std::span<const TextLine> rows, char separator,
                    std::vector<Finding>& findings);

/// The text "Remark: k=2" of a cell that states a coverage in a column of another name; else empty.
[[nodiscard]] std::string coverage_in_cell(std::string_view heading, std::string_view cell);

/// Refuses a row that is not read and states a coverage: "Coverage factor;2", "Remark;k=2".
/// @param label column of its name @throws InputError at its line
void refuse_coverage_in_row(const TableRow& row, std::size_t label);

/// The texts of a column that are no numbers, in quotes, each once: some words, and more remarks.
[[nodiscard]] std::vector<std::string> texts_in_column(std::span<const TableRow> rows, std::size_t column);

/// Gives uncertainties without a coverage that in the heading of their amounts: "wt% (2s);error". @throws
/// InputError for "wt% (2s);SD", which names standard ones
void take_coverage_of_amounts(const UncertainColumn& amounts, const std::string& heading,
                              StatedCoverage& coverage, std::size_t line);

/// Decides on uncertainties in two columns, "-err;+err": one of them counts if their numbers are equal.
/// @param sides by column @return the columns that repeat the one before them @throws InputError for numbers
/// that differ, and for a column of one side alone
[[nodiscard]] std::vector<std::size_t> repeated_sides(
    const std::vector<std::optional<UncertaintySide>>& sides, const TableRow& headings,
    std::span<const TableRow> rows);

/// A column of a quantity in a unit.
struct ColumnUnit {
    std::string heading;
    double unit;  ///< [SI]
    Dimension dimension;
};

/// Refuses a text that states another unit than all columns of that dimension have: "sizes in mm".
/// @throws InputError at the line of the text
void require_units(const std::vector<TextBeside>& texts, const std::vector<ColumnUnit>& columns);

/// Refuses a text by which sizes are no diameters of the spheres themselves: "radii", "aerodynamic".
/// @throws InputError at the line of the text
void require_diameters(const std::vector<TextBeside>& texts);

/// Whether a text calls a row invalid: "excluded", "Ausreißer!", but not "no outlier".
[[nodiscard]] bool calls_invalid(std::string_view text);

/// Refuses the row of a cell that calls it invalid, where the cells of its column are not read.
[[noreturn]] void refuse_invalid_row(std::string_view cell, const std::string& column, std::size_t line,
                                     std::size_t position);
/// A remark on uncertainties with a per cent sign in their cells beside amounts in per cent.
[[nodiscard]] Finding uncertainties_in_per_cent(std::string_view code);

/// A doubt on uncertainties without a unit that are so small beside amounts in per cent that they may be
/// fractions; none if one of them is above a 200th of its amount.
class SmallUncertainties {
  public:
    /// @param amount [%] @param text of its uncertainty @param uncertainty the number in it
    void take(double amount, std::string_view text, double uncertainty);
    [[nodiscard]] std::optional<Finding> finding(std::string_view code) const;

  private:
    std::string first_{};
    double greatest_ratio_ = 0;
};

/// A sample of a table by the sum of its amounts [in one unit for all].
struct NamedSum {
    std::string name;
    double sum = 0;
};
/// Returns, for each sample, a remark on columns or rows that were read as samples but are probably its
/// uncertainties: their amounts add up to less than half, and their names contain the sample's ("FA1 wet") or
/// they follow it ("rel. esd"). Mostly empty.
[[nodiscard]] std::vector<std::optional<Finding>> small_namesakes(std::string_view code,
                                                                  const std::vector<NamedSum>& samples);

/// Refuses "SEM" beside the name of another method, "XRD wt%": it may be a standard error of the mean, or a
/// result of electron microscopy. @param names headings of columns or of rows @throws InputError
void refuse_two_methods(const std::vector<std::string>& names, std::size_t line);

/// Whether a name or heading has the sign of a bound or an estimate, "Quartz (<)", "v_r >" and "Na2O ~",
/// unlike "ash < 63 um".
[[nodiscard]] bool has_sign_of_bound(std::string_view text);

/// Refuses the sign of an upper bound, "<", alone in a cell: it may be that of the number beside it.
/// @throws InputError
void refuse_sign_of_bound(std::string_view cell, const std::string& column, std::size_t line,
                          std::size_t position);

/// Whether the cell of a coverage, "2" or "95 %", states another one than that factor.
[[nodiscard]] bool divides_otherwise(std::string_view cell, double factor);

/// Refuses coverages in a column of their own, below "k", "coverage" or "Level", beside uncertainties that
/// are not divided for them. Other columns are left. @param factors by which uncertainties are divided
/// @throws InputError at the cell
void refuse_coverages(std::string_view heading, std::span<const TableRow> rows, std::size_t column,
                      std::span<const double> factors);

/// Whether a name holds brackets, a factor ("x 2"), or a sign of a unit or an uncertainty.
[[nodiscard]] bool holds_signs(std::string_view name);

/// Whether the name of a sample may state more than that: it holds such signs, or several words beside
/// numbers, of which one is neither a label ("FA1") nor common in names ("fly ash").
[[nodiscard]] bool may_state_more(std::string_view name);

/// The remark on samples with such names; none if there are none. @param counted how the amounts are read
[[nodiscard]] std::optional<Finding> names_not_read(std::string_view code, std::vector<std::string> names,
                                                    const std::string& counted);

/// Whether a cell of a row holds a number with its uncertainty behind "±".
[[nodiscard]] bool holds_uncertain_number(const TableRow& row);

/// What texts state of all numbers of a table, as the vocabulary lists it: "crystalline part", "ignited
/// sample", "means", "tangential". The first text of each.
[[nodiscard]] std::map<std::string_view, TextBeside> statements_in(const std::vector<TextBeside>& texts);

/// Refuses a text that states a factor of the numbers: "multiplied by 10". @throws InputError at its line
void refuse_factors(const std::vector<TextBeside>& texts);

/// Whether a text makes one of these statements.
[[nodiscard]] bool makes_statement(const TextBeside& text, const std::set<std::string_view>& statements);

/// A remark on a text whose statement is not used, and on what the numbers are taken as.
[[nodiscard]] Finding unused_statement(std::string_view code, const TextBeside& text,
                                       std::string_view taken_as);

/// A heading cut into its name and its unit: "passing [%]", "size in um", "d (mm)", "d / mm", "finer %".
struct NameAndUnit {
    std::string name;
    std::string unit;
};
[[nodiscard]] NameAndUnit cut_heading(std::string_view heading);

/// The note on a column that is not used, with its texts; none for one without a heading and cells.
[[nodiscard]] std::optional<std::string> unused_column(std::string_view heading,
                                                       std::span<const TextLine> rows, char separator,
                                                       std::size_t column);

/// The unit of a quantity in a heading, "d [um]" or "T (°C)"; none for fractions and other words.
[[nodiscard]] std::optional<Unit> unit_of_quantity(std::string_view heading);

}  // namespace ashimpact

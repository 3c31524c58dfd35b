// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <regex>
#include <set>
#include <span>
#include <string>

#include <fmt/format.h>

#include "core/plausibility.hpp"
#include "core/quantities/quantity.hpp"
#include "core/tables/number_marks.hpp"
#include "core/tables/table_reading.hpp"
#include "core/tables/text_lines.hpp"
#include "core/tables/workbook/workbook.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "core/units/units.hpp"
#include "solver/inference/impacts/impact_rows.hpp"
#include "solver/inference/impacts/measurement.hpp"
#include "solver/inference/impacts/measurement_headings.hpp"
#include "solver/statistics/moments.hpp"

namespace ashimpact {

namespace {

/// Whether a cell states that there is no number, or that it is not known: "-", "n.b.".
bool says_nothing(std::string_view cell) {
    return says_no_number(cell) || outcome_word(cell) == OutcomeWord::unknown;
}

/// A number of the table in SI.
struct Entry {
    double value;
    std::optional<double> standard_uncertainty;
};

/// A cell such as "1.4 m/s" or "1.4 ± 0.1 m/s" cut into number and unit; no unit if it has none.
struct CellWithUnit {
    std::string number;
    std::string unit;
};
CellWithUnit cut_unit(std::string_view cell) {
    const auto begin = cell.find_first_not_of("+-.,()0123456789 \u00b1\u00a0'");
    if (begin == std::string_view::npos || begin == 0) return {std::string(cell), {}};
    std::string_view unit = cell.substr(begin);
    unit = trimmed(unit.substr(0, std::min(unit.find("\u00b1"), unit.find("+-"))));
    if (!is_velocity_unit(unit)) return {std::string(cell), {}};
    std::string number(cell);
    for (auto at = number.find(unit); at != std::string::npos; at = number.find(unit))
        number.erase(at, unit.size());
    return {number, std::string(unit)};
}

/// Takes the unit of velocities that have it in their cells and not in the heading of their column.
void take_units_of_cells(MeasurementHeading& heading, std::span<const TextLine> lines, char separator) {
    std::vector<MeasuredColumn*> bare(heading.columns, nullptr);
    bool any = false;
    for (auto* all : {&heading.value, &heading.uncertainty})
        for (auto& column : *all)
            if (column && !column->unit_given) {
                bare[column->position] = &*column;
                any = true;
            }
    if (!any) return;
    for (const TextLine& line : lines)
        for_each_cell(line, separator, [&](std::string_view cell, std::size_t k) {
            if (k >= bare.size() || bare[k] == nullptr || cell.empty() || is_digit(cell.back())) return;
            const std::string unit = cut_unit(cell).unit;
            if (unit.empty()) return;
            bare[k]->to_si = to_si(1.0, unit, Dimension::velocity);
            bare[k]->unit_given = bare[k]->unit_in_cells = true;
            bare[k] = nullptr;
        });
}

/// Gives an uncertainty without a unit that of its column: "u(e_n)" beside "e_n [%]" is in per cent.
void take_units_of_values(MeasurementHeading& heading) {
    for (std::size_t i = 0; i < heading.value.size(); ++i) {
        const auto& value = heading.value[i];
        auto& uncertainty = heading.uncertainty[i];
        if (!value || !value->unit_given || !uncertainty || uncertainty->unit_given) continue;
        uncertainty->to_si = value->to_si;
        uncertainty->unit_given = true;
        if (value->is_fraction && value->to_si == 1.0) continue;
        heading.notes.push_back({impacts_code, Severity::remark,
                                 "column " + in_quotes(uncertainty->name) +
                                     " has no unit: taken in that of column " + in_quotes(value->name)});
    }
}

/// Reads cells of one table.
class TableCells {
  public:
    /// @param lines of the table below its heading
    TableCells(const MeasurementHeading& heading, std::span<const TextLine> lines, char separator,
               NumberMarks marks)
        : heading_(heading), marks_(std::move(marks)) {
        std::vector<bool> holds_numbers(heading.columns, false);
        for (const auto* all : {&heading.value, &heading.uncertainty})
            for (const auto& column : *all)
                if (column) holds_numbers[column->position] = true;
        if (heading.checked) holds_numbers[heading.checked->position] = true;
        if (heading.correlation) holds_numbers[*heading.correlation] = true;
        if (heading.sideways) holds_numbers[heading.sideways->position] = true;
        for (const auto& column : heading.uncertainty)
            if (column) marks_.holds_uncertainties(column->position);
        constexpr double small_unit = 0.05;  // of cm/s, mm/s: a velocity may be thousands
        for (const auto& column : heading.value)
            if (column && !column->is_fraction && column->to_si < small_unit)
                marks_.may_hold_thousands(column->position);
        for (const TextLine& line : lines)
            for_each_cell(line, separator, [&](std::string_view cell, std::size_t column) {
                if (column < heading.columns && holds_numbers[column]) marks_.see(cell, column);
            });
    }

    [[nodiscard]] Entry entry(const TableRow& row, MeasuredQuantity quantity) const {
        const MeasuredColumn& column = *heading_.of(quantity);
        Entry entry = read(row, column);
        refuse_bound(row, quantity);
        if (const auto& uncertainty = heading_.uncertainty_of(quantity);
            uncertainty && !says_nothing(row.cells[uncertainty->position])) {
            if (entry.standard_uncertainty) fail(*uncertainty, row, "is given twice", "one uncertainty");
            require_same_sign(row, column, *uncertainty);
            const double stated = read(row, *uncertainty).value / uncertainty->coverage;
            if (!uncertainty->is_relative)
                entry.standard_uncertainty = stated;
            else if (entry.value != 0.0)  // a capture has no uncertainty relative to its 0
                entry.standard_uncertainty = stated * entry.value;
        }
        if (entry.standard_uncertainty && !(*entry.standard_uncertainty > 0.0))
            fail(column, row, "has an uncertainty that is not positive", "> 0");
        return entry;
    }

    /// Zero with the uncertainty of its own column, for a row without a reading.
    [[nodiscard]] Entry uncertainty(const TableRow& row, MeasuredQuantity quantity) const {
        Entry entry{0.0, std::nullopt};
        refuse_bound(row, quantity);
        const auto& column = heading_.uncertainty_of(quantity);
        if (column && !column->is_relative && !says_nothing(row.cells[column->position]))
            entry.standard_uncertainty = read(row, *column).value / column->coverage;
        return entry;
    }

    /// Refuses "<0.03" as an uncertainty. @throws InputError
    void refuse_bound(const TableRow& row, MeasuredQuantity quantity) const {
        const auto& column = heading_.uncertainty_of(quantity);
        const std::string_view cell = column ? trimmed(row.cells[column->position]) : "";
        if (cell.starts_with('<') || cell.starts_with("\u2264"))
            fail(*column, row, "is a bound", "a number, or an empty cell");
    }

    /// Refuses an e_n that is not v_r over v_in, but for rounding. @throws InputError
    void require_agreement(const TableRow& row, const Measurement& point) const {
        const auto& column = heading_.checked;
        if (!column || outcome_word(row.cells[column->position]) != OutcomeWord::none) return;
        const double rounding = 0.01 + 0.01 / point.velocity;  // of numbers with two decimals
        if (std::abs(read(row, *column).value - point.restitution()) > rounding)
            fail(*column, row, "is not v_r over v_in, which is " + readable_number(point.restitution()),
                 "one of the two columns, or a file without this row");
    }

    /// v_in, normal to the wall.
    [[nodiscard]] Entry normal_velocity(const TableRow& row) const {
        Entry velocity = entry(row, MeasuredQuantity::velocity);
        if (heading_.normal_velocity) return velocity;
        const double share = std::cos(angle(row));
        velocity.value *= share;
        if (velocity.standard_uncertainty) *velocity.standard_uncertainty *= share;
        return velocity;
    }

    /// The velocity along the wall [m/s]; none where the table states none.
    [[nodiscard]] std::optional<double> tangential(const TableRow& row) const {
        if (!heading_.sideways) return std::nullopt;
        const SidewaysColumn& column = *heading_.sideways;
        if (!column.is_angle) return sideways(row, "the velocity alone");
        const double v = entry(row, MeasuredQuantity::velocity).value;
        return heading_.normal_velocity ? v * std::tan(angle(row)) : v * std::sin(angle(row));
    }

    [[nodiscard]] double number(const TableRow& row, std::size_t position, const std::string& name) const {
        const auto number = number_in(row, position);
        if (!number) fail({position, name}, row, "is not a number", "a finite number");
        return number->value;
    }

    [[nodiscard]] const NumberMarks& marks() const { return marks_; }

  private:
    /// The angle [rad] or the velocity along the wall [m/s] of a row. @throws InputError for an uncertainty
    [[nodiscard]] double sideways(const TableRow& row, const std::string& allowed) const {
        const SidewaysColumn& column = *heading_.sideways;
        const double value = number(row, column.position, column.name) * column.to_si;
        at_place(at_cell(row.line, column.position), [&] {
            require_certain(number_in(row, column.position)->standard_uncertainty, subject(column, row) + " ",
                            allowed);
        });
        return value;
    }

    /// Of incidence, from the normal [rad].
    [[nodiscard]] double angle(const TableRow& row) const {
        const SidewaysColumn& column = *heading_.sideways;
        const double angle = sideways(
            row, "the angle alone; an error of all angles counts through velocity_scale_uncertainty");
        if (!(angle >= 0 && angle < 0.5 * std::numbers::pi))
            fail(column, row, "is no angle from the normal", "0 to below 90 degrees");
        return angle;
    }

    [[noreturn]] static void fail(const TextColumn& column, const TableRow& row, const std::string& problem,
                                  const std::string& allowed) {
        throw InputError(subject(column, row) + " " + problem, allowed)
            .at(at_cell(row.line, column.position));
    }

    static std::string subject(const TextColumn& column, const TableRow& row) {
        return in_quotes(row.cells[column.position]) + " in column " + in_quotes(column.name);
    }

    [[nodiscard]] std::optional<PrintedNumber> number_in(const TableRow& row, std::size_t column) const {
        try {
            return marks_.read(row.cells[column], column);
        } catch (const InputError& error) {
            throw error.at(at_cell(row.line, column));
        }
    }
    /// Refuses "0.02" beside "45 %", which may be a fraction, or per cent. @throws InputError
    void require_same_sign(const TableRow& row, const MeasuredColumn& column,
                           const MeasuredColumn& uncertainty) const {
        if (!column.is_fraction || column.to_si != uncertainty.to_si) return;
        const auto value = number_in(row, column.position);
        const auto stated = number_in(row, uncertainty.position);
        if (!value || !stated || value->per_cent == stated->per_cent || stated->value == 0.0) return;
        fail(uncertainty, row,
             "may be a fraction or per cent, beside " + in_quotes(row.cells[column.position]),
             "% in both cells (in a spreadsheet one number format for both), or in neither");
    }

    [[nodiscard]] Entry read(const TableRow& row, const MeasuredColumn& column) const {
        auto number = number_in(row, column.position);
        if (number && column.unit_in_cells && number->value != 0.0)
            fail(column, row, "has no unit, and other cells of the column have one",
                 "a unit in every cell, or in the heading");
        if (!number && !column.is_fraction) number = number_with_unit(row, column);
        const bool is_reading = column.position == heading_.reading().position ||
                                (heading_.checked && column.position == heading_.checked->position);
        if (!number && is_reading)
            fail(column, row,
                 says_no_number(row.cells[column.position]) ? "may be a capture, or an unknown outcome"
                                                            : "is not a number",
                 "a finite number; 0 for a capture; an empty cell for an unknown outcome");
        if (!number) fail(column, row, "is not a number", "a finite number");
        if (number->per_cent && !column.is_fraction)
            fail(column, row, "is in per cent", "the unit of the heading");
        const double greatest = is_reading ? 1.5 : 0.5;  // beyond any noise, and of an uncertainty
        if (column.is_fraction && !number->per_cent && number->value * column.to_si > greatest)
            fail(
                column, row,
                "may be " + shortest(number->value) + " % or a " + (is_reading ? "restitution" : "fraction") +
                    " whose decimal mark was lost",
                "0 to 1; per cent with the unit, \"e_n [%]\"; --decimal point or comma if a mark is misread");
        const double factor = number->per_cent ? 0.01 : column.to_si;
        Entry entry{number->value * factor, std::nullopt};
        if (number->standard_uncertainty && column.coverage > 0)
            entry.standard_uncertainty = *number->standard_uncertainty * factor / column.coverage;
        return entry;
    }

    /// The number of a cell such as "1.4 m/s".
    [[nodiscard]] std::optional<PrintedNumber> number_with_unit(const TableRow& row,
                                                                const MeasuredColumn& column) const {
        const auto [text, unit] = cut_unit(row.cells[column.position]);
        if (unit.empty()) return std::nullopt;
        if (std::abs(to_si(1.0, unit, Dimension::velocity) / column.to_si - 1.0) > 1e-9)
            fail(column, row, "is in another unit than its column", "one unit for all cells of a column");
        return at_place(at_cell(row.line, column.position),
                        [&, &number = text] { return marks_.read(number, column.position); });
    }

    const MeasurementHeading& heading_;
    NumberMarks marks_;
};

std::optional<VelocityNoise> noise_of_rebound(const Entry& velocity, const Entry& rebound) {
    if (!velocity.standard_uncertainty && !rebound.standard_uncertainty) return std::nullopt;
    const double of_either = velocity.standard_uncertainty.value_or(rebound.standard_uncertainty.value_or(0));
    return VelocityNoise::of_velocities(of_either, rebound.standard_uncertainty.value_or(of_either));
}

std::optional<VelocityNoise> noise_of_restitution(const Entry& velocity, const Entry& restitution) {
    const double v = velocity.value;
    const double e = restitution.value;
    if (restitution.standard_uncertainty && velocity.standard_uncertainty)
        return VelocityNoise::of_restitution(v, e, *velocity.standard_uncertainty,
                                             *restitution.standard_uncertainty);
    // If only one is given, both velocities are taken as equally uncertain: u_e = u sqrt(1 + e^2)/v.
    if (restitution.standard_uncertainty) {
        const double u = v * *restitution.standard_uncertainty / std::sqrt(1.0 + e * e);
        return VelocityNoise::of_velocities(u, u);
    }
    if (!velocity.standard_uncertainty) return std::nullopt;
    return VelocityNoise::of_velocities(*velocity.standard_uncertainty, *velocity.standard_uncertainty);
}

/// Tables of impacts may be long: a camera that triggers itself fills a million lines.
constexpr TextLimits impact_table{
    .content = "a table of impacts", .bytes = std::size_t{256} << 20, .lines = 2'000'000};

/// The outcome that a row states; none if it states that the outcome is not known.
std::optional<NotedOutcome> stated_outcome(const MeasurementHeading& heading, const TableRow& row) {
    if (!heading.outcome) return NotedOutcome::from_reading;
    const std::string& cell = row.cells[*heading.outcome];
    if (cell.empty()) return NotedOutcome::from_reading;
    const OutcomeWord word = heading.outcome_is_capture ? capture_flag(cell) : outcome_word(cell);
    if (word == OutcomeWord::none)
        throw InputError(in_quotes(cell) + " in the column of outcomes is none",
                         heading.outcome_is_capture ? "yes or no, unknown, or an empty cell"
                                                    : "rebound, capture, unknown, or an empty cell")
            .at(at_cell(row.line, *heading.outcome));
    if (word == OutcomeWord::unknown) return std::nullopt;
    return word == OutcomeWord::capture ? NotedOutcome::capture : NotedOutcome::rebound;
}

/// The outcome that the remarks of a row state, each in one word. @throws InputError if they differ
OutcomeWord remarked_outcome(const MeasurementHeading& heading, const TableRow& row) {
    OutcomeWord told = OutcomeWord::none;
    for (const TextColumn& column : heading.remarks) {
        const OutcomeWord word = outcome_of_remark(row.cells[column.position]);
        if (word == OutcomeWord::none) continue;
        if (told != OutcomeWord::none && told != word)
            throw InputError("the remarks tell of a capture and of a rebound", "one of them");
        told = word;
    }
    return told;
}

/// How far below zero, or above it beside a remark that states a capture, noise may put a reading [m/s].
double reach_of(const Measurement& point) {
    return point.noise ? 6.0 * std::sqrt(point.noise->rebound) : 0.1 * point.velocity;
}

/// Restitution of a noted rebound that reads zero or less.
constexpr double slow_rebound = 1e-6;

/// Refuses a reading of the rebound that is further below zero than noise explains. @throws InputError
void require_near_zero(const Measurement& point) {
    if (point.rebound >= 0.0) return;
    if (-point.rebound <= reach_of(point)) return;
    throw InputError("v_r is " + shortest(point.rebound) + " m/s, below zero by more than noise explains",
                     ">= 0 m/s, a magnitude; 0 for a capture");
}

VelocityNoise correlated(VelocityNoise noise, const MeasurementHeading& heading, const TableCells& cells,
                         const TableRow& row) {
    if (!heading.correlation) return noise;
    const double correlation = cells.number(row, *heading.correlation, "correlation");
    if (!(std::abs(correlation) < 1.0))
        throw InputError("the correlation is " + shortest(correlation), "between -1 and 1, both excluded");
    noise.covariance = correlation * std::sqrt(noise.incident * noise.rebound);
    return noise;
}

/// Refuses a capture with a reading that is further above zero than noise explains. @throws InputError
void require_no_rebound(const std::string& told_by, const Measurement& point) {
    if (point.rebound > reach_of(point))
        throw InputError("the " + told_by + " tells of a capture, and the rebound velocity is " +
                             shortest(point.rebound) + " m/s",
                         "one of them");
}

/// Which rows with a reading state which uncertainties.
class StatedUncertainties {
  public:
    void take(const TableRow& row, const Entry& velocity, const Entry& reading) {
        if (velocity.standard_uncertainty && reading.standard_uncertainty)
            greatest_ = std::max(greatest_, *reading.standard_uncertainty);
        else if (velocity.standard_uncertainty)
            (reading.value == 0.0 ? bare_zeros_ : of_velocity_).push_back(row.line);
        else if (reading.standard_uncertainty)
            of_reading_.push_back(row.line);
    }

    /// Gives readings of 0 without an uncertainty the greatest of the others. @throws InputError for other
    /// readings without one, where some have one
    void settle(const MeasurementHeading& heading, MeasurementSet& set) const {
        const bool of_some = greatest_ > 0.0;
        if (!of_reading_.empty() && (of_some || !of_velocity_.empty() || !bare_zeros_.empty()))
            refuse(*heading.of(MeasuredQuantity::velocity), of_reading_);
        if (!of_some) return;
        if (!of_velocity_.empty()) refuse(heading.reading(), of_velocity_);
        for (Measurement& point : set.points) {
            if (!std::binary_search(bare_zeros_.begin(), bare_zeros_.end(), point.line)) continue;
            const double scale = heading.reading().is_fraction ? point.velocity : 1.0;
            const double factor = scale * greatest_ / std::sqrt(point.noise->rebound);
            point.noise->rebound *= factor * factor;
            point.noise->covariance *= factor;
        }
        if (!bare_zeros_.empty())
            set.warnings.push_back({impacts_code, Severity::remark,
                                    "readings of 0 without an uncertainty (" + numbered("line", bare_zeros_) +
                                        ") are given the greatest of the others, " + shortest(greatest_) +
                                        (heading.reading().is_fraction ? "" : " m/s")});
    }

    /// The quantity whose uncertainty the table states alone.
    [[nodiscard]] std::optional<MeasuredQuantity> alone(const MeasurementHeading& heading) const {
        if (!of_reading_.empty())
            return heading.of(MeasuredQuantity::rebound) ? MeasuredQuantity::rebound
                                                         : MeasuredQuantity::restitution;
        const bool of_velocities = !of_velocity_.empty() || !bare_zeros_.empty();
        return of_velocities && !(greatest_ > 0.0) ? std::optional(MeasuredQuantity::velocity) : std::nullopt;
    }

  private:
    [[noreturn]] static void refuse(const TextColumn& column, const std::vector<std::size_t>& lines) {
        refuse_line(lines.front(),
                    "only some measurements of " + in_quotes(column.name) + " have an uncertainty",
                    "all of them or none");
    }

    double greatest_ = 0.0;                 ///< of readings, beside one of v_in [SI]
    std::vector<std::size_t> of_velocity_;  ///< lines in which that of v_in is alone
    std::vector<std::size_t> bare_zeros_;   ///< of these, lines with a reading of 0
    std::vector<std::size_t> of_reading_;   ///< lines in which that of the reading is alone
};

/// Readings of the rebound below zero, which are noise or show that v_r has the sign of its direction.
class SignsOfReadings {
  public:
    /// @param point before noise below zero counts as zero
    void take(const Measurement& point) {
        if (point.outcome == NotedOutcome::capture) return;
        if (point.rebound > 0.0) ++positive_;
        if (point.rebound >= 0.0) return;
        below_.push_back(point.line);
        lowest_ = std::min(lowest_, point.rebound);
        beyond_noise_ =
            beyond_noise_ || !point.noise || -point.rebound > likely_noise * std::sqrt(point.noise->rebound);
    }

    /// Refuses readings of which more are below zero than above, unless some are above and noise of the
    /// stated uncertainties explains all: noise around zero puts about half of them on either side. Remarks
    /// those that count as zero. @throws InputError
    void settle(const MeasurementHeading& heading, std::vector<Finding>& findings) const {
        if (below_.empty()) return;
        const std::string name = in_quotes(heading.reading().name);
        if (below_.size() > positive_ && (positive_ == 0 || beyond_noise_))
            refuse_line(
                below_.front(),
                fmt::format("{} of column {} below zero, {} above: they may be rebounds with the sign of "
                            "their direction, or noise of impacts that read 0",
                            counted(below_.size(), "reading"), name, positive_),
                "magnitudes for rebounds; 0 for a capture");
        findings.push_back(
            {impacts_code, Severity::remark,
             fmt::format("{} of column {} below zero ({}) {} as 0", counted(below_.size(), "reading"), name,
                         numbered("line", below_), below_.size() == 1 ? "counts" : "count")});
    }

    [[nodiscard]] double lowest() const { return lowest_; }

  private:
    static constexpr double likely_noise = 3.0;  ///< of a reading [standard uncertainties]
    std::size_t positive_ = 0;
    std::vector<std::size_t> below_;  ///< lines
    double lowest_ = 0;               ///< reading [m/s]
    bool beyond_noise_ = false;       ///< some, or how uncertain they are is not stated
};

/// Reads the noise of a row, and its reading unless it is a capture without one.
void read_rebound(Measurement& point, const MeasurementHeading& heading, const TableCells& cells,
                  const TableRow& row, bool has_reading, StatedUncertainties& stated) {
    const bool as_velocity = heading.of(MeasuredQuantity::rebound).has_value();
    const auto quantity = as_velocity ? MeasuredQuantity::rebound : MeasuredQuantity::restitution;
    const Entry velocity = cells.normal_velocity(row);
    const Entry reading = has_reading ? cells.entry(row, quantity) : cells.uncertainty(row, quantity);
    point.rebound = as_velocity ? reading.value : reading.value * velocity.value;
    point.noise = as_velocity ? noise_of_rebound(velocity, reading) : noise_of_restitution(velocity, reading);
    if (point.noise && as_velocity) point.noise = correlated(*point.noise, heading, cells, row);
    const auto& column = heading.uncertainty_of(quantity);
    const bool share_of_zero = column && column->is_relative && reading.value == 0.0;
    if (share_of_zero && !point.noise)
        throw InputError("the uncertainty in column " + in_quotes(column->name) +
                             " is relative to a reading of 0, and that of v_in is not stated",
                         "a column u(v_in), or uncertainties in the unit of the velocities");
    stated.take(row, velocity, reading);
}

/// Refuses a remark of several words that speaks of another outcome than the reading. @throws InputError
void require_agreeing_remarks(const MeasurementHeading& heading, const TableRow& row,
                              const Measurement& point) {
    for (const TextColumn& column : heading.remarks) {
        const std::string& remark = row.cells[column.position];
        const OutcomeWord mentioned = outcome_mentioned(remark);
        const bool of_capture = mentioned == OutcomeWord::capture && !point.captured();
        const bool of_rebound = mentioned == OutcomeWord::rebound && point.captured();
        if (!of_capture && !of_rebound) continue;
        throw InputError(
            in_quotes(remark) + " in column " + in_quotes(column.name) + " speaks of " +
                (of_capture ? "a capture, and the rebound velocity is " + shortest(point.rebound) + " m/s"
                            : "a rebound, and the reading is a capture"),
            "one of them, or a file without this row")
            .at(at_cell(row.line, column.position));
    }
}

/// Refuses marks in columns that are not read: the sign of a bound, and an outcome that is not that of the
/// reading. @throws InputError
void require_agreeing_marks(const MeasurementHeading& heading, const TableRow& row,
                            const Measurement& point) {
    for (const TextColumn& column : heading.unused) {
        const std::string& cell = row.cells[column.position];
        if (cell.empty() || is_digit(cell.front())) continue;
        const std::string name =
            column.name.empty() ? "a column without heading" : "column " + in_quotes(column.name);
        refuse_sign_of_bound(cell, name, row.line, column.position);
        const OutcomeWord word = outcome_of_remark(cell);
        const bool contradicts = word == (point.captured() ? OutcomeWord::rebound : OutcomeWord::capture);
        if (contradicts)
            throw InputError(in_quotes(cell) + " in " + name + " speaks of another outcome than the reading",
                             "one of them, and \"outcome\" as the heading of the column")
                .at(at_cell(row.line, column.position));
    }
}

/// One row; none where its outcome is not known. @param remark the outcome in its remarks
std::optional<Measurement> measurement_of(const MeasurementHeading& heading, const TableCells& cells,
                                          const TableRow& row, OutcomeWord remark,
                                          StatedUncertainties& stated, SignsOfReadings& signs) {
    const Entry velocity = cells.normal_velocity(row);
    if (!(velocity.value > 0.0))
        throw InputError("v_in is " + shortest(velocity.value) + " m/s", "> 0 m/s, a magnitude");
    auto outcome = stated_outcome(heading, row);
    if (!outcome) return std::nullopt;
    if (outcome != NotedOutcome::from_reading) {
        const bool captured = outcome == NotedOutcome::capture;
        if (remark == (captured ? OutcomeWord::rebound : OutcomeWord::capture))
            throw InputError(fmt::format("the outcome is a {}, but a remark records a {}",
                                         captured ? "capture" : "rebound", captured ? "rebound" : "capture"),
                             "one of them");
        remark = OutcomeWord::none;
    }
    const OutcomeWord cell = outcome_word(row.cells[heading.reading().position]);
    const bool word = cell == OutcomeWord::capture;
    const bool blank = cell == OutcomeWord::unknown;
    if (word && (outcome == NotedOutcome::rebound || remark == OutcomeWord::rebound))
        throw InputError("the outcome is a rebound, and the reading a capture", "one of them");
    if (blank && outcome == NotedOutcome::rebound)
        throw InputError("a rebound without a reading", "a number, or the outcome unknown");
    if (word || (blank && remark == OutcomeWord::capture)) outcome = NotedOutcome::capture;
    if (blank && outcome != NotedOutcome::capture) return std::nullopt;
    Measurement point{.velocity = velocity.value,
                      .rebound = 0.0,
                      .noise = {},
                      .line = row.line,
                      .tangential = cells.tangential(row)};
    read_rebound(point, heading, cells, row, !word && !blank, stated);
    if (!word && !blank && remark != OutcomeWord::none) {
        if (remark != OutcomeWord::rebound) require_no_rebound("remark", point);
        outcome = remark == OutcomeWord::rebound ? NotedOutcome::rebound : NotedOutcome::capture;
    }
    if (outcome == NotedOutcome::capture) require_no_rebound("outcome", point);
    point.outcome = *outcome;
    if (remark == OutcomeWord::none && outcome == NotedOutcome::from_reading)
        require_agreeing_remarks(heading, row, point);
    require_near_zero(point);
    signs.take(point);
    if (outcome == NotedOutcome::capture) point.rebound = 0.0;
    const bool rebounded = outcome == NotedOutcome::rebound;
    point.rebound = std::max(point.rebound, rebounded ? slow_rebound * point.velocity : 0.0);
    return point;
}

std::vector<Finding> warnings_of(const MeasurementHeading& heading) {
    std::vector<Finding> warnings = heading.notes;
    const MeasuredColumn& velocity = *heading.of(MeasuredQuantity::velocity);
    if (const auto& rebound = heading.of(MeasuredQuantity::rebound);
        rebound && rebound->unit_given != velocity.unit_given && rebound->to_si != velocity.to_si)
        throw InputError("only one of the columns " + in_quotes(velocity.name) + " and " +
                             in_quotes(rebound->name) + " has a unit, and it is not m/s",
                         "a unit for both");
    for (const TextColumn& column : heading.unused)
        if (!column.name.empty())
            warnings.push_back(
                {impacts_code, Severity::remark, "column " + in_quotes(column.name) + " is not used"});
    for (const auto* columns : {&heading.value, &heading.uncertainty}) {
        for (const auto& column : *columns)
            if (column && !column->unit_given)
                warnings.push_back({impacts_code, Severity::remark,
                                    "column " + in_quotes(column->name) + " has no unit: taken as m/s"});
    }
    return warnings;
}

/// Whether the reading of an impact without its remark would have another outcome.
bool remark_counts(const MeasurementHeading& heading, const TableRow& row, OutcomeWord remark,
                   const Measurement& point) {
    if (heading.outcome && !row.cells[*heading.outcome].empty()) return false;
    const bool blank = outcome_word(row.cells[heading.reading().position]) == OutcomeWord::unknown;
    const bool reads_zero = point.rebound <= 2.0 * slow_rebound * point.velocity;
    return remark == OutcomeWord::capture ? blank : remark == OutcomeWord::rebound && reads_zero;
}

/// Remarks of the rows without a reading, for one message.
class Unread {
  public:
    explicit Unread(const MeasurementHeading& heading) : heading_(heading) {}

    /// A row whose remark was taken for its outcome.
    void take_remarked(const TableRow& row) { remarked_.push_back(row.line); }

    /// An impact, whose remarks may be other texts than words for an outcome.
    void take_impact(const TableRow& row) {
        static const std::regex marked("[0-9]+ *(?:[*!?#+]+|[xX]|\u2020|\u2021)");  // "8*" in "Nr."
        const auto is_marked = [](const std::string& cell) {
            return !cell.empty() && cell.size() <= longest_heading && is_digit(cell.front()) &&
                   !is_digit(cell.back()) && std::regex_match(cell, marked);
        };
        for (const TextColumn& column : heading_.unused)
            if (const std::string& cell = row.cells[column.position];
                !column.name.empty() && is_marked(cell)) {
                if (marked_.empty()) first_marked_ = in_quotes(cell) + " in column " + in_quotes(column.name);
                marked_.push_back(row.line);
            }
        for (const TextColumn& column : heading_.unused)
            if (column.name.empty() && !row.cells[column.position].empty())
                take_nameless(column, row.cells[column.position]);
            else if (auto& values = values_[column.position]; values.size() <= most_groups)
                ++values[row.cells[column.position]];
        for (const TextColumn& column : heading_.remarks) {
            const std::string& cell = row.cells[column.position];
            if (cell.empty() || outcome_of_remark(cell) != OutcomeWord::none) continue;
            if (not_read_.empty()) first_not_read_ = in_quotes(cell) + " in column " + in_quotes(column.name);
            not_read_.push_back(row.line);
        }
    }

    /// A row whose outcome is not known.
    void take_unknown(const TableRow& row) {
        unknown_.push_back(row.line);
        for (const TextColumn& column : heading_.unused)
            if (auto& values = values_[column.position]; !column.name.empty() && values.size() <= most_groups)
                ++values[row.cells[column.position]];
        for (const TextColumn& column : heading_.unused)
            if (outcome_of_remark(row.cells[column.position]) == OutcomeWord::capture) {
                elsewhere_.push_back(row.line);
                column_elsewhere_ = column.name;
            }
        if (!free_text_.empty()) return;
        for (const TextColumn& column : heading_.remarks)
            if (row.cells[column.position].size() > 1)
                free_text_ = in_quotes(row.cells[column.position]) + " in column " + in_quotes(column.name) +
                             ", line " + std::to_string(row.line);
    }

    /// The name in the column "sample", if all impacts have the same; else empty.
    [[nodiscard]] std::string sample() const {
        static const WordLists words("XRD columns", "%+");
        for (const TextColumn& column : heading_.unused)
            if (const auto found = values_.find(column.position);
                found != values_.end() && found->second.size() == 1 && words.list_of(column.name) == "sample")
                return found->second.begin()->first;
        return {};
    }

    void tell(std::vector<Finding>& warnings) const {
        if (!nameless_.empty())
            warnings.push_back({impacts_code, Severity::remark,
                                numbered("column", {nameless_.begin(), nameless_.end()}) +
                                    (nameless_.size() > 1 ? ", which have no heading, are not used"
                                                          : ", which has no heading, is not used") +
                                    (nameless_texts_.empty() ? "" : ": " + joined(nameless_texts_))});
        for (const TextColumn& column : heading_.unused) tell_groups(column, warnings);
        if (!not_read_.empty())
            warnings.push_back({impacts_code, Severity::remark,
                                first_not_read_ + " is not read (" + numbered("line", not_read_) +
                                    "); only words for an outcome are, such as haftet or rebound"});
        if (!marked_.empty())
            warnings.push_back({impacts_code, Severity::remark,
                                "the mark of " + first_marked_ +
                                    " is not read, and the rows with one count (" +
                                    numbered("line", marked_) + ")"});
        if (!remarked_.empty())
            warnings.push_back({impacts_code, Severity::remark,
                                "column " + names_of(heading_.remarks) + " tells the outcome in " +
                                    numbered("line", remarked_)});
        if (unknown_.empty()) return;
        std::string text = counted(unknown_.size(), "impact") + " of unknown outcome " +
                           (unknown_.size() == 1 ? "is" : "are") + " left out (" +
                           numbered("line", unknown_) + ")";
        const std::string reading = in_quotes(heading_.reading().name);
        if (!elsewhere_.empty())
            text += ", as column " + in_quotes(column_elsewhere_) + ", which tells of captures in " +
                    numbered("line", elsewhere_) + ", is read only if its heading is \"outcome\"";
        else if (!free_text_.empty())
            text +=
                ", as " + free_text_ +
                ", is not just a word such as haftet, stuck, captured, to be written there if the particle "
                "stayed, or 0 in column " +
                reading;
        warnings.push_back({impacts_code, Severity::remark, text});
    }

  private:
    /// A cell without a heading, and its text if it is no number: "u: k=2".
    void take_nameless(const TextColumn& column, const std::string& cell) {
        constexpr std::size_t most = 3;
        nameless_.insert(column.position + 1);
        const std::string text = in_quotes(cell);
        if (nameless_texts_.size() < most && !read_number(cell, true) &&
            std::ranges::find(nameless_texts_, text) == nameless_texts_.end())
            nameless_texts_.push_back(text);
    }

    static std::string names_of(const std::vector<TextColumn>& columns) {
        std::vector<std::string> names;
        names.reserve(columns.size());
        for (const TextColumn& column : columns) names.push_back(in_quotes(column.name));
        return joined(names);
    }

    /// Refuses a column of flags, such as 1 and 0, or yes and no, where no column states the outcomes.
    /// @throws InputError
    void refuse_flags(const TextColumn& column, const std::map<std::string, std::size_t>& values) const {
        static const WordLists flags("flags");
        const auto is_flag = [](const auto& value) { return flags.holds(as_flag(value.first)); };
        if (heading_.outcome || !std::ranges::all_of(values, is_flag)) return;
        throw InputError(
            "column " + in_quotes(column.name) + " has " + in_quotes(values.begin()->first) + " and " +
                in_quotes(values.rbegin()->first) +
                ": it may state which impacts were captured, or which count",
            "\"outcome\", or \"captured\" with yes and no, as the heading of outcomes; or a file "
            "without this column");
    }

    /// A remark on a column that is not read and cuts the impacts into some groups, as samples or walls do.
    void tell_groups(const TextColumn& column, std::vector<Finding>& warnings) const {
        const auto found = values_.find(column.position);
        if (found == values_.end() || found->second.size() < 2 || found->second.size() > most_groups) return;
        refuse_flags(column, found->second);
        std::vector<std::string> names;
        std::size_t filled = 0;
        bool may_be_groups = true;
        for (const auto& [value, count] : found->second) {
            may_be_groups = may_be_groups && !value.empty() && count >= 2;
            if (value.empty()) continue;
            names.push_back(in_quotes(value));
            filled += count;
        }
        const auto empty = found->second.find("");
        if (empty != found->second.end() && empty->second > filled)  // "Literatur" in one row
            warnings.push_back({impacts_code, Severity::remark,
                                "column " + in_quotes(column.name) + " has " + joined(names) +
                                    " in few rows: it is not read, and these rows count"});
        if (!may_be_groups) return;
        warnings.push_back({impacts_code, Severity::remark,
                            "column " + in_quotes(column.name) + " has " + joined(names) +
                                ": all impacts count as those of one particle and wall"});
    }

    static constexpr std::size_t most_groups = 5;
    const MeasurementHeading& heading_;
    std::map<std::size_t, std::map<std::string, std::size_t>> values_{};  ///< of columns that are not read
    std::vector<std::size_t> remarked_;
    std::vector<std::size_t> unknown_;
    std::vector<std::size_t> elsewhere_;
    std::vector<std::size_t> not_read_;
    std::string first_not_read_;
    std::vector<std::size_t> marked_;
    std::string first_marked_;
    std::set<std::size_t> nameless_;  ///< numbers of columns without a heading
    std::vector<std::string> nameless_texts_;
    std::string column_elsewhere_;
    std::string free_text_;
};

/// Index of the heading among the lines, which may follow titles; 0 if there is none.
std::size_t heading_place(const std::vector<TextLine>& lines) {
    constexpr std::size_t most_titles = 20;
    for (std::size_t i = 0; i < std::min(lines.size(), most_titles + 1); ++i)
        if (names_incident_velocity(cut_row(lines[i], separator_of(lines[i].text)).cells)) return i;
    return 0;
}

/// Refuses rebounds without a unit of which each is 0 or 1. @throws InputError
void refuse_flags(const MeasurementHeading& heading, const MeasurementSet& set) {
    const auto& rebound = heading.of(MeasuredQuantity::rebound);
    const auto is_flag = [](const Measurement& point) { return point.captured() || point.rebound == 1; };
    const bool names_outcome = rebound && outcome_word(rebound->name) == OutcomeWord::rebound;
    if (!names_outcome || rebound->unit_given || set.rebounds() == 0 ||
        !std::ranges::all_of(set.points, is_flag))
        return;
    throw InputError(
        "column " + in_quotes(rebound->name) + " may hold velocities of 1 m/s, or 1 for a rebound",
        "\"v_r [m/s]\"; or the velocities with a column \"outcome\"")
        .at(at_line(set.points.front().line));
}

/// Refuses restitutions in per cent that may be fractions: all of them are at most 1, or some cells have a
/// per cent sign, as those of spreadsheets with that format, and some have none. @throws InputError
void refuse_fractions(const MeasuredColumn& column, std::span<const TextLine> rows, char separator) {
    if (!column.is_fraction) return;
    std::optional<double> greatest;
    bool has_sign = false;
    bool has_none = false;
    for (const TextLine& row : rows)
        for_each_cell(row, separator, [&](std::string_view cell, std::size_t place) {
            if (place != column.position) return;
            auto number = read_number(cell);
            if (!number) number = read_number(cell, true);
            if (!number || number->value == 0) return;
            (number->per_cent ? has_sign : has_none) = true;
            greatest = std::max(greatest.value_or(0), number->value);
        });
    const std::string name = "column " + in_quotes(column.name);
    if (has_sign && has_none)
        throw InputError(name + " has numbers with a per cent sign and without, which may be fractions",
                         "one form for all cells");
    constexpr double per_cent = 0.01;
    if (column.to_si == per_cent && !has_sign && greatest && *greatest <= 1)
        throw InputError(name + " is in per cent, and no number is above 1: they may be fractions",
                         "\"e_n\" for fractions; \"0.3 %\" in the cells where it is per cent");
}

/// Puts the doubt about the first velocity outside of its range before the other warnings.
void add_implausible(const MeasuredColumn& column, MeasurementSet& set) {
    if (set.points.empty()) return;
    const PlausibleRange& range = *plausible_range("velocity");
    const auto found = std::ranges::find_if(
        set.points, [&](double v) { return !range.holds(v); }, &Measurement::velocity);
    if (found == set.points.end()) return;
    const Measurement& point = *found;
    Writing written{point.velocity};
    if (!column.unit_given) written.number = point.velocity;
    if (auto doubt = implausible_at(at_line(point.line) + ": v_in", range, written))
        set.warnings.insert(set.warnings.begin(), *std::move(doubt));
}

/// A remark on the first blank line between impacts: those below may be of another table.
std::optional<Finding> blank_line_among(std::span<const TextLine> rows, const TextLines& file) {
    for (const TextLine& line : file.lines())
        if (!rows.empty() && line.number > rows.front().number && line.number < rows.back().number &&
            line.text.find_first_not_of(" \t;,\r") == std::string_view::npos)
            return Finding{impacts_code, Severity::remark,
                           "the impacts below " + at_line(line.number) + ", which is blank, count as well"};
    return std::nullopt;
}

/// The numbers of a row as in the file. @param values v_in and v_r, of fractions their ratio [SI]
MeasuredRow row_as_written(const MeasurementHeading& heading, std::size_t line,
                           const std::array<double, 2>& values) {
    const auto& reading = heading.reading();
    return {line,
            {as_written(values[0], heading.of(MeasuredQuantity::velocity)->to_si),
             as_written(values[1], reading.is_fraction ? 1.0 : reading.to_si)}};
}

/// The doubt that readings so near to 0 that noise explains them are rebounds.
/// @param lowest reading below zero; 0 without one [m/s]
std::optional<Finding> uncertain_rebounds(const MeasurementSet& set, double lowest) {
    constexpr double near = 2;  // standard uncertainties
    const auto count = std::ranges::count_if(set.points, [&](const Measurement& point) {
        const double noise = point.noise ? near * std::sqrt(point.noise->rebound) : 0;
        return point.outcome == NotedOutcome::from_reading && point.rebound > 0 &&
               point.rebound < std::max(noise, -lowest);
    });
    if (count == 0) return std::nullopt;
    return Finding{
        impacts_code, Severity::doubt,
        fmt::format("{} of {} impacts count as rebounds although noise explains their v_r: captures "
                    "among them lower v_c, which its interval does not allow for; a column \"outcome\" "
                    "states them",
                    count, set.points.size())};
}

/// A remark on readings of exactly 0 beside rebounds near 0, where the table states neither outcomes nor
/// uncertainties and noise may have made one of the other: a reading of 0 is faster than a slow rebound, or a
/// rebound is so slow that hardly any velocity above v_c leads to it.
std::optional<Finding> clipped_readings(const MeasurementSet& set) {
    if (set.has_noise()) return std::nullopt;
    constexpr double hardly_any = 0.03;  // e grows with the root of v/v_c - 1
    std::vector<std::size_t> zeros;
    std::vector<std::size_t> slow;
    double greatest_zero = 0;
    double slowest = std::numeric_limits<double>::infinity();
    bool is_tiny = false;
    for (const Measurement& point : set.points) {
        if (point.outcome != NotedOutcome::from_reading || !(point.rebound < reach_of(point))) continue;
        (point.captured() ? zeros : slow).push_back(point.line);
        if (point.captured())
            greatest_zero = std::max(greatest_zero, point.velocity);
        else
            slowest = std::min(slowest, point.velocity);
        is_tiny = is_tiny || (!point.captured() && point.rebound < hardly_any * point.velocity);
    }
    if (zeros.empty() || slow.empty() || !(greatest_zero > slowest || is_tiny)) return std::nullopt;
    return Finding{
        impacts_code, Severity::remark,
        fmt::format("{} of 0 ({}) {} as captured and {} near 0 ({}) as rebounding: where they are noise, or "
                    "readings below 0 were set to 0, v_c is off to either side; a column \"outcome\" "
                    "states which",
                    counted(zeros.size(), "reading"), numbered("line", zeros),
                    zeros.size() == 1 ? "counts" : "count", slow.size(), numbered("line", slow))};
}

/// A remark on readings of 0 without a noted outcome where other impacts have one.
std::optional<Finding> zeros_not_noted(const MeasurementSet& set) {
    std::vector<std::size_t> zeros;
    for (const Measurement& point : set.points)
        if (point.outcome == NotedOutcome::from_reading && point.captured()) zeros.push_back(point.line);
    if (zeros.empty() || std::ranges::all_of(set.points, [](const Measurement& point) {
            return point.outcome == NotedOutcome::from_reading;
        }))
        return std::nullopt;
    return Finding{
        impacts_code, Severity::remark,
        fmt::format("{} of 0 without a noted outcome ({}) {} as captured", counted(zeros.size(), "reading"),
                    numbered("line", zeros), zeros.size() == 1 ? "counts" : "count")};
}

/// "mm/s" of a factor to m/s; "%" of one of fractions.
std::string unit_of(const MeasuredColumn& column) {
    if (column.is_relative) return "% of the value";
    if (column.is_fraction) return column.to_si == 1 ? "1" : "%";
    constexpr std::array units{std::pair{1.0, "m/s"}, std::pair{1e-2, "cm/s"}, std::pair{1e-3, "mm/s"}};
    const auto* const unit = std::ranges::find(units, column.to_si, &std::pair<double, const char*>::first);
    return unit != units.end() ? unit->second : readable_number(column.to_si) + " m/s";
}

/// What the columns are taken as, and what the rows hold. @param alone quantity whose uncertainty alone is
/// stated
std::string reading_of(const MeasurementHeading& heading, const std::vector<std::string>& written,
                       const MeasurementSet& set, std::optional<MeasuredQuantity> alone) {
    TableReading reading;
    const auto [slowest, fastest] =
        std::ranges::minmax(set.points, {}, [](const Measurement& point) { return point.velocity; });
    reading.add(fmt::format("{}, {} captured, v_in {} to {} m/s", counted(set.points.size(), "impact"),
                            set.captures(), readable_number(slowest.velocity),
                            readable_number(fastest.velocity)));
    static constexpr std::array names{"v_in", "v_r", "e_n"};  // by MeasuredQuantity
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto take = [&](const std::string& what, const MeasuredColumn& column,
                              const std::string& behind) {
            reading.take(fmt::format("{}{} [{}]", what, names.at(i), unit_of(column)),
                         written[column.position], behind);
        };
        if (heading.value[i]) take("", *heading.value[i], "");
        const auto& u = heading.uncertainty[i];
        if (u && u->coverage > 0) take("standard uncertainties of ", *u, divided_by(u->coverage));
        const bool is_stated = set.has_noise() && (!alone || static_cast<std::size_t>(*alone) == i);
        if (heading.value[i] && is_stated && !u)
            take("standard uncertainties in cells of ", *heading.value[i],
                 divided_by(heading.value[i]->coverage));
    }
    if (heading.checked) reading.take("e_n, compared with v_r over v_in", written[heading.checked->position]);
    if (heading.sideways)
        reading.take(heading.sideways->is_angle ? "angles from the normal" : "velocities along the wall",
                     written[heading.sideways->position],
                     heading.normal_velocity ? "" : "; v_in is that of the sphere at this angle");
    if (heading.outcome)
        reading.take(heading.outcome_is_capture ? "captures" : "outcomes", written[*heading.outcome]);
    if (heading.correlation) reading.take("correlation of the velocities", written[*heading.correlation]);
    return reading.text();
}

MeasurementSet read_table(const TextLines& file, std::string_view name, std::optional<DecimalMark> decimal) {
    auto lines = lines_with_content(file);
    if (lines.empty()) throw InputError("the file holds no table", "a heading and one line an impact");
    refuse_blanks(lines);
    const std::size_t place = heading_place(lines);
    const CutTable table = cut_table(file, std::move(lines), place, impacts_code, {"means", "tangential"});
    const std::string heading_line = at_line(table.heading.line);
    MeasurementHeading heading =
        at_place(heading_line, [&] { return read_measurement_heading(table.heading.cells); });
    const std::span rows(table.rows);
    take_units_of_cells(heading, rows, table.separator);
    take_units_of_values(heading);
    at_place(heading_line, [&] { refuse_fractions(heading.reading(), rows, table.separator); });
    MeasurementSet set{.source = std::string(name), .points = {}, .warnings = at_place(heading_line, [&] {
                                                                      return warnings_of(heading);
                                                                  })};
    std::ranges::copy(table.findings, std::back_inserter(set.warnings));
    if (auto blank = blank_line_among(rows, file)) set.warnings.push_back(*std::move(blank));
    for (const TextBeside& text : table.texts) {
        require_agreeing_units(text, heading);
        require_stated_angle(text, heading);
    }
    const auto statements = statements_in(table.texts);
    if (const auto means = statements.find("means"); means != statements.end())
        set.warnings.push_back(
            unused_statement(impacts_code, means->second, "each row counts as one impact"));
    if (const auto found = statements.find("tangential"); found != statements.end() && !heading.sideways)
        refuse_line(found->second.line,
                    in_quotes(found->second.text) + " may state that the velocities are those along the wall",
                    "velocities normal to it, and a file without this text; or a column \"v_t [m/s]\"");
    check_coverage(impacts_code, table.texts, heading.coverages, rows, table.separator, set.warnings);
    const TableCells cells(heading, rows, table.separator, NumberMarks(decimal, file.of_sheet()));
    const RowLabels labels(heading, rows, table.separator);
    Unread unread(heading);
    StatedUncertainties stated;
    SignsOfReadings signs;
    RepeatedRows repeated;
    std::vector<MeasuredRow> unknown;
    const bool has_labels =
        std::ranges::find(heading.unused, std::size_t{0}, &TextColumn::position) != heading.unused.end();
    std::vector<std::string> row_labels;  // of the points, in their order
    for (const TextLine& line : rows) {
        TableRow row = cut_row(line, table.separator);
        at_place(at_line(row.line), [&] {
            require_cells(row, heading.columns);
            if (const std::string summary = labels.summary_in(row); !summary.empty()) {
                set.warnings.push_back(left_out(impacts_code, row, "impact", summary));
                return;
            }
            for (const auto* columns : {&heading.unused, &heading.remarks})
                for (const TextColumn& column : *columns)
                    require_agreeing_units({row.line, row.cells[column.position]}, heading);
            const OutcomeWord remark = remarked_outcome(heading, row);
            if (auto point = measurement_of(heading, cells, row, remark, stated, signs)) {
                cells.require_agreement(row, *point);
                require_agreeing_marks(heading, row, *point);
                if (remark_counts(heading, row, remark, *point)) unread.take_remarked(row);
                unread.take_impact(row);
                repeated.take(row, heading.of(MeasuredQuantity::velocity)->position,
                              heading.reading().position);
                set.points.push_back(*point);
                if (has_labels) row_labels.push_back(row.cells.front());
            } else {
                ++set.unknown;
                unread.take_unknown(row);
                unknown.push_back(row_as_written(heading, row.line,
                                                 {cells.entry(row, MeasuredQuantity::velocity).value,
                                                  std::numeric_limits<double>::quiet_NaN()}));
            }
        });
    }
    unread.tell(set.warnings);
    set.sample = unread.sample();
    for (Finding& each : cells.marks().findings(impacts_code)) set.warnings.push_back(std::move(each));
    refuse_flags(heading, set);
    stated.settle(heading, set);
    signs.settle(heading, set.warnings);
    const auto alone = stated.alone(heading);
    set.rebound_alone_uncertain = alone == MeasuredQuantity::rebound;
    if (alone && !set.rebound_alone_uncertain)
        set.warnings.push_back({impacts_code, Severity::remark,
                                "uncertainties of " + in_quotes(heading.of(*alone)->name) +
                                    " alone are stated: v_in and v_r are taken as equally uncertain"});
    if (!labels.number_rows()) {
        std::vector<MeasuredRow> measured;
        for (const Measurement& point : set.points) {
            const double velocity = heading.normal_velocity
                                        ? point.velocity
                                        : std::hypot(point.velocity, point.tangential.value_or(0));
            measured.push_back(row_as_written(
                heading, point.line,
                {velocity, heading.reading().is_fraction ? point.restitution() : point.rebound}));
            measured.back().noted = point.outcome != NotedOutcome::from_reading;
            if (has_labels) measured.back().label = row_labels[measured.size() - 1];
        }
        refuse_summaries(measured, set.warnings);
        if (!unknown.empty()) {  // the mean of v_in may be that of all rows
            std::ranges::move(unknown, std::back_inserter(measured));
            std::ranges::sort(measured, {}, &MeasuredRow::line);
            refuse_summaries(measured, set.warnings);
        }
    }
    if (auto doubt = repeated.doubtful()) set.warnings.push_back(*std::move(doubt));
    if (heading.correlation && !set.has_noise())
        throw InputError(
            "the correlation of two velocities is that of their uncertainties, which are not stated",
            "columns u(v_in) and u(v_r) beside it")
            .at(heading_line);
    add_implausible(*heading.of(MeasuredQuantity::velocity), set);
    if (auto remark = zeros_not_noted(set)) set.warnings.push_back(*std::move(remark));
    if (auto remark = clipped_readings(set)) set.warnings.push_back(*std::move(remark));
    if (auto doubt = uncertain_rebounds(set, signs.lowest())) set.warnings.push_back(*std::move(doubt));
    if (set.points.empty() && set.unknown > 0)
        throw InputError("the outcome of every impact is unknown", "rebounds or captures");
    if (set.points.empty())
        throw InputError("there is no measurement below the heading", "one line an impact")
            .at(at_line(file.last_line()));
    set.reading = reading_of(heading, table.heading.cells, set, alone);
    return set;
}

bool holds_impacts(const TextLines& file) {
    const auto lines = lines_with_content(file);
    if (lines.empty()) return false;
    const TextLine& line = lines[heading_place(lines)];
    return names_incident_velocity(cut_row(line, separator_of(line.text)).cells);
}

}  // namespace

MeasurementSet read_measurements(std::string_view text, std::string_view name, const TableOptions& options) {
    return at_place(FileName{std::string(name)}, [&] {
        const TableFile file(text, {.name = options.sheet,
                                    .option = "the name of a sheet (--sheet, in a case \"sheet\")",
                                    .code = impacts_code,
                                    .limits = impact_table,
                                    .holds_table = holds_impacts});
        return file.read([&](const TextLines& lines) {
            MeasurementSet set = read_table(lines, name, options.decimal);
            for (const Measurement& point : set.points)
                if (const auto where = file.sums_up(point.line))
                    refuse_summary_row(point.line, "a formula", std::string(*where));
            file.add_findings(set.warnings);
            set.sheet = file.sheet().value_or("");
            validate(set);
            return set;
        });
    });
}

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/calibration/size_calibration.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "core/plausibility.hpp"
#include "core/quantities/checks.hpp"
#include "core/quantities/quantity.hpp"
#include "core/tables/number_marks.hpp"
#include "core/tables/table_reading.hpp"
#include "core/tables/table_texts.hpp"
#include "core/tables/text_lines.hpp"
#include "core/tables/workbook/workbook.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "materials/xrd/table_headings.hpp"
#include "pipeline/app/command.hpp"
#include "pipeline/case/case_parts.hpp"
#include "pipeline/case/literature.hpp"
#include "pipeline/files/file.hpp"
#include "solver/inference/impacts/impact_rows.hpp"
#include "solver/motion/scale.hpp"

namespace ashimpact {

/// Columns of a table of sizes, in this order.
enum class SizeColumn { diameter, velocity, uncertainty };

template <>
struct Names<SizeColumn> {
    static constexpr std::string_view kind = "column";
    static constexpr std::array<std::string_view, 3> all{"d", "v_c", "u(v_c)"};
};

namespace {

constexpr double least_probability = 0.05;  ///< of chi^2, below which the constants do not fit

/// A critical velocity of a size.
struct SizedVelocity {
    double diameter = 0, velocity = 0;    ///< [m], [m/s]
    std::optional<double> uncertainty{};  ///< standard [m/s]
};

constexpr TextLimits size_limits{.content = "a table of critical velocities"};
constexpr auto size_headings = "d [um], v_c [m/s], u(v_c) [m/s]";

/// A column of a table of sizes: "d [um]", "critical velocity (m/s)", "u(v_c) [m/s]", "± (2s)".
struct SizeHeading {
    std::optional<SizeColumn> column{};  ///< none: not used
    std::string written{};
    std::string unit_name{};
    StatedCoverage coverage{};
    double unit = 1;           ///< [SI]
    bool is_relative = false;  ///< an uncertainty in per cent of the velocity
};

/// @param before the column before it, whose uncertainty one without a name is
SizeHeading read_size_heading(const std::string& cell, const SizeHeading* before) {
    static const WordLists words("sizes of critical velocities");
    SizeHeading heading{.written = cell, .coverage = read_coverage(cell)};
    auto [name, unit] = cut_heading(heading.coverage.rest);
    if (words.holds(unit)) {  // "u(v_c)"
        name = heading.coverage.rest;
        unit.clear();
    }
    heading.column = meaning<SizeColumn>(words, name);
    if (heading.column && unit.empty())
        throw InputError("column " + in_quotes(cell) + " has no unit", size_headings);
    const xrd::UncertaintyName uncertain = xrd::uncertainty_name(heading.column ? "" : name.c_str());
    const bool follows = before != nullptr && before->column == SizeColumn::velocity;
    const bool is_coverage = !heading.coverage.stated.empty() && (name.empty() || name.starts_with('['));
    if (!heading.column && (uncertain.is_uncertainty || names_uncertainty(name) || is_coverage) &&
        (uncertain.of.empty() ? follows : words.list_of(uncertain.of) == "v_c")) {
        heading.column = SizeColumn::uncertainty;
        if (is_coverage && name.size() > 2) unit = name.substr(1, name.size() - 2);
        heading.is_relative = xrd::holds_per_cent(name + unit);
        if (unit.empty() && before != nullptr) unit = before->unit_name;
    }
    if (!heading.column) return heading;
    if (has_sign_of_bound(cell))
        throw InputError("column " + in_quotes(cell) + " may hold bounds",
                         "measured values, without that sign");
    if (heading.column == SizeColumn::uncertainty && !heading.coverage.problem.empty())
        throw InputError("the uncertainties in column " + in_quotes(cell) + ": " + heading.coverage.problem,
                         "u(v_c) [m/s], U(v_c) [m/s] (k=2)");
    heading.unit_name = heading.is_relative ? "%" : unit;
    heading.unit = at_place("column " + in_quotes(cell), [&] {
        return to_si(1, heading.unit_name,
                     heading.is_relative                      ? Dimension::fraction
                     : heading.column == SizeColumn::diameter ? Dimension::length
                                                              : Dimension::velocity);
    });
    return heading;
}

/// The columns of the heading of a table; none if the line is not one.
std::vector<SizeHeading> size_headings_in(const TableRow& row) {
    std::vector<SizeHeading> headings;
    for (const std::string& cell : row.cells)
        headings.push_back(read_size_heading(cell, headings.empty() ? nullptr : &headings.back()));
    return headings;
}

/// Position of a column; the number of columns if there is none.
std::size_t place_of(const std::vector<SizeHeading>& headings, SizeColumn column) {
    return static_cast<std::size_t>(std::ranges::find(headings, column, &SizeHeading::column) -
                                    headings.begin());
}

bool holds_size(const std::vector<SizeHeading>& headings, SizeColumn column) {
    return place_of(headings, column) < headings.size();
}

/// Index of the heading: the first line that names a size or a velocity.
std::size_t size_heading_place(const std::vector<TextLine>& lines) {
    static const WordLists words("sizes of critical velocities");
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto cells = cut_row(lines[i], separator_of(lines[i].text)).cells;
        if (cells.size() > 1 && std::ranges::any_of(cells, [&](const std::string& cell) {
                return words.holds(cut_heading(read_coverage(cell).rest).name);
            }))
            return i;
    }
    refuse_line(lines.empty() ? 1 : lines.front().number,
                "no line names the columns of a table of critical velocities", size_headings);
}

/// Critical velocities of sizes, and how their table was read.
struct SizeTable {
    std::vector<SizedVelocity> rows{};
    std::string reading{};
};

/// What the columns are taken as.
std::string reading_of(const std::vector<SizeHeading>& headings, const std::vector<SizedVelocity>& rows) {
    TableReading reading;
    reading.add(counted(rows.size(), "size"));
    static constexpr std::array names{"diameters", "v_c", "standard uncertainties of v_c"};  // by SizeColumn
    for (const SizeHeading& heading : headings)
        if (heading.column)
            reading.take(fmt::format("{} [{}]", names.at(static_cast<std::size_t>(*heading.column)),
                                     heading.unit_name),
                         heading.written, divided_by(heading.coverage.factor));
    const bool in_cells =
        !holds_size(headings, SizeColumn::uncertainty) &&
        std::ranges::any_of(rows, [](const SizedVelocity& row) { return row.uncertainty.has_value(); });
    if (in_cells) reading.add("standard uncertainties in the cells of v_c");
    return reading.text();
}

SizeTable read_size_lines(const TextLines& file, std::optional<DecimalMark> decimal,
                          std::vector<Finding>& findings) {
    constexpr auto code = "calibration";
    std::vector<TextLine> lines = lines_with_content(file);
    const auto note = [&](std::string text) {
        findings.push_back({code, Severity::remark, std::move(text)});
    };
    const std::size_t place = size_heading_place(lines);
    CutTable table = cut_table(file, std::move(lines), place, code);
    const TableRow& names = table.heading;
    const char separator = table.separator;
    LabelColumns labels{.columns = names.cells.size()};
    const std::vector<SizeHeading> headings = at_place(at_line(names.line), [&] {
        auto found = size_headings_in(names);
        for (const SizeHeading& heading : found) {
            if (!heading.column) {
                labels.take({static_cast<std::size_t>(&heading - found.data()), heading.written},
                            heading.written);
            } else if (std::ranges::count(found, heading.column, &SizeHeading::column) > 1) {
                throw InputError(fmt::format("{} columns hold {}, the first {}",
                                             std::ranges::count(found, heading.column, &SizeHeading::column),
                                             name_of(*heading.column), in_quotes(heading.written)),
                                 "each column once");
            }
        }
        for (const SizeColumn needed : {SizeColumn::diameter, SizeColumn::velocity})
            if (!holds_size(found, needed))
                throw InputError(fmt::format("the column {} is missing", name_of(needed)), size_headings);
        return found;
    });
    std::ranges::move(table.findings, std::back_inserter(findings));
    const std::span<const TextLine> rows(table.rows);
    UncertainColumns uncertain(headings.size());
    std::vector<ColumnUnit> units;
    NumberMarks marks(decimal, file.of_sheet());
    for (std::size_t k = 0; k < headings.size(); ++k) {
        const SizeHeading& heading = headings[k];
        if (!heading.column) {
            if (const auto unused = unused_column(heading.written, rows, separator, k)) note(*unused);
            continue;
        }
        uncertain[k] = {heading.written, heading.coverage, heading.column == SizeColumn::uncertainty};
        if (heading.column == SizeColumn::uncertainty) marks.holds_uncertainties(k);
        const bool is_size = heading.column == SizeColumn::diameter;
        if (!heading.is_relative && heading.unit < (is_size ? 1e-7 : 0.05))
            marks.may_hold_thousands(k);  // of nm, mm/s
        if (!heading.is_relative)
            units.push_back(
                {heading.written, heading.unit, is_size ? Dimension::length : Dimension::velocity});
    }
    check_coverage(code, table.texts, uncertain, rows, separator, findings);
    table.take_unused_cells([&](std::size_t k) { return k < headings.size() && !headings[k].column; });
    require_units(table.texts, units);
    require_diameters(table.texts);
    table.show(marks);
    std::vector<SizedVelocity> found;
    std::vector<MeasuredRow> measured;
    RepeatedRows repeated;
    std::vector<TextLine> of_sizes;
    for (const TextLine& line : rows) {
        const TableRow row = cut_row(line, separator);
        if (is_summary(row.cells.front()))
            findings.push_back(left_out(code, row, "size", row.cells.front()));
        else
            of_sizes.push_back(line);
    }
    const RowLabels row_labels(labels, of_sizes, separator);
    bool told_uncertain = false;
    bool told_implausible = false;
    for (const TextLine& line : of_sizes) {
        TableRow row = cut_row(line, separator);
        require_cells(row, headings.size());
        if (const std::string label = row_labels.summary_in(row); !label.empty()) {
            findings.push_back(left_out(code, row, "size", label));
            continue;
        }
        SizedVelocity sized;
        bool relative = false;  // the uncertainty
        for (std::size_t k = 0; k < headings.size(); ++k)
            at_place(at_cell(row.line, k), [&] {
                const SizeHeading& heading = headings[k];
                if (!heading.column) return;
                const auto number = marks.read(without_unit(row.cells[k], heading.unit_name), k);
                if (!number || !(number->value > 0) || (number->per_cent && !heading.is_relative))
                    throw InputError(fmt::format("{} in column {} is not a positive number",
                                                 in_quotes(row.cells[k]), in_quotes(heading.written)),
                                     "a number above 0 in " + heading.unit_name);
                const double value = number->value * heading.unit;
                if (heading.column == SizeColumn::uncertainty) {
                    sized.uncertainty = value / heading.coverage.factor;
                    relative = heading.is_relative;
                    return;
                }
                const bool is_size = heading.column == SizeColumn::diameter;
                auto doubt = implausible(*plausible_range(is_size ? "diameter" : "velocity"), {value});
                if (doubt && !std::exchange(told_implausible, true)) findings.push_back(*std::move(doubt));
                (is_size ? sized.diameter : sized.velocity) = value;
                if (!number->standard_uncertainty) return;
                if (is_size) {
                    if (!std::exchange(told_uncertain, true))
                        note("uncertainties of sizes are not used, the first in " + at_cell(row.line, k));
                } else if (holds_size(headings, SizeColumn::uncertainty)) {
                    throw InputError(in_quotes(row.cells[k]) + " and a column state its uncertainty",
                                     "one of them");
                } else {
                    sized.uncertainty =
                        *number->standard_uncertainty * heading.unit / heading.coverage.factor;
                }
            });
        if (relative) *sized.uncertainty *= sized.velocity;
        const auto written = [&](double value, SizeColumn column) {
            return as_written(value, headings[place_of(headings, column)].unit);
        };
        measured.push_back(
            {row.line,
             {written(sized.diameter, SizeColumn::diameter), written(sized.velocity, SizeColumn::velocity)}});
        if (!headings.front().column) measured.back().label = row.cells.front();
        repeated.take(row, place_of(headings, SizeColumn::diameter),
                      place_of(headings, SizeColumn::velocity));
        found.push_back(sized);
    }
    for (Finding& each : marks.findings(code)) findings.push_back(std::move(each));
    if (!row_labels.number_rows()) refuse_summaries(measured, findings);
    if (auto doubt = repeated.doubtful()) findings.push_back(*std::move(doubt));
    if (found.empty()) refuse_line(file.last_line(), "there are no rows below the heading", size_headings);
    std::string reading = reading_of(headings, found);
    return {std::move(found), std::move(reading)};
}

SizeTable read_size_table(const std::string& bytes, const TableOptions& options,
                          std::vector<Finding>& findings) {
    const TableFile file(bytes, {.name = options.sheet,
                                 .option = "--sheet",
                                 .code = "calibration",
                                 .limits = size_limits,
                                 .holds_table = [](const TextLines& lines) {
                                     return size_heading_place(lines_with_content(lines)), true;
                                 }});
    return file.read([&](const TextLines& lines) {
        SizeTable table = read_size_lines(lines, options.decimal, findings);
        file.add_findings(findings);
        return table;
    });
}

/// The measured velocities of a source that are single values of a known size. Warns of the others.
std::vector<SizedVelocity> sized_velocities(const LiteratureSource& source) {
    std::vector<SizedVelocity> rows;
    std::map<std::string_view, std::size_t> unused;  // by the reason
    for (const LiteratureVelocity& each : source.velocities)
        if (each.basis != VelocityBasis::measured)
            ++unused["not measured by these authors"];
        else if (!each.value())
            ++unused["a range or a bound, no single value"];
        else if (!each.diameter)
            ++unused["without a size"];
        else
            rows.push_back({*each.diameter, *each.value()});
    std::vector<std::string> reasons;
    for (const auto& [reason, count] : unused) reasons.push_back(fmt::format("{} {}", count, reason));
    if (!reasons.empty())
        spdlog::warn("warning: --sizes: {}: {} of {} critical velocities used; left out: {}", source.key,
                     rows.size(), source.velocities.size(), joined(reasons));
    return rows;
}

std::vector<SizedVelocity> read_sizes(const CommandOptions& options) {
    const std::string& name = options["--sizes"];
    const auto& sources = literature();
    const auto source = std::ranges::find(sources, name, &LiteratureSource::key);
    if (source != sources.end() && !std::filesystem::exists(name)) {
        if (options.has("--decimal")) warn_idle("--decimal", "no table is read");
        return sized_velocities(*source);
    }
    const std::string bytes = read_file(name);
    std::vector<Finding> findings;
    SizeTable table =
        at_place(FileName{name}, [&] { return read_size_table(bytes, table_options(options), findings); });
    warn_of(findings, name);
    print_reading(name, table.reading);
    return std::move(table.rows);
}

/// Sets standard uncertainties that the table does not state.
void complete_uncertainties(std::vector<SizedVelocity>& rows, const CommandOptions& options) {
    if (options.has("--uncertainty") &&
        std::ranges::all_of(rows, [](const SizedVelocity& row) { return row.uncertainty.has_value(); }))
        warn_idle("--uncertainty", "the table states that of each velocity");
    for (SizedVelocity& row : rows) {
        if (row.uncertainty) continue;
        if (!options.has("--uncertainty"))
            throw InputError(
                "is missing: the table states no uncertainty of v_c, and nothing can be said of a fit "
                "without one",
                "a column u(v_c), or --uncertainty \"10 %\"")
                .at("--uncertainty");
        const double relative = options.positive("--uncertainty", Dimension::fraction);
        const bool is_bare = whole_decimal(options["--uncertainty"]).has_value();
        at_place("--uncertainty", [&] { require_relative(relative, is_bare, 1); });
        row.uncertainty = relative * row.velocity;
    }
}

/// Ratios from one number to another, each the same factor above the last.
std::vector<double> ratios_between(double from, double to, int steps) {
    std::vector<double> ratios;
    for (int i = 0; i <= steps; ++i)
        ratios.push_back(from * std::pow(to / from, static_cast<double>(i) / steps));
    return ratios;
}

/// The material with the free constants at the middle of their search.
struct SizeModel {
    MaterialChoice material;
    std::optional<Damping> damping;
    std::vector<std::vector<double>> ratios;  ///< of each free constant
};

SizeModel read_size_model(CommandOptions options, const std::vector<FreeConstant>& free,
                          const SizedVelocity& largest) {
    const auto is_free = [&](CalibrationQuantity quantity) {
        return std::ranges::find(free, quantity, &FreeConstant::quantity) != free.end();
    };
    const auto search = [&](const char* option, double middle) {  // an order of magnitude that is not read
        if (options.has(option)) warn_idle(option, "it is free");
        options.text_of(option) = fmt::format("{}", middle);
    };
    constexpr double typical_adhesion = 0.1;   // [J/m2]
    constexpr double yield_of_modulus = 0.01;  // p_y/E*
    if (is_free(CalibrationQuantity::work_of_adhesion)) search("--work-of-adhesion", typical_adhesion);
    if (is_free(CalibrationQuantity::yield_pressure))
        search("--yield-pressure",
               yield_of_modulus * options.positive("--contact-modulus", Dimension::pressure));
    SizeModel model{.material = read_material(options), .damping = Damping{}, .ratios = {}};
    const ContactPair contact = model.material.contact(largest.diameter);
    const DampingLaw damping = read_damping_law(options);
    if (is_free(CalibrationQuantity::damping))
        search("--damping", Scale::of(contact, largest.velocity).damping_unit(damping));
    model.damping = read_damping(options, contact);
    for (const FreeConstant& each : free) {
        if (each.quantity == CalibrationQuantity::work_of_adhesion)
            model.ratios.push_back(ratios_between(1e-3, 30, 7));
        else if (each.quantity == CalibrationQuantity::yield_pressure)
            model.ratios.push_back(ratios_between(1e-2, 30, 7));
        else if (each.quantity == CalibrationQuantity::damping)
            model.ratios.push_back(ratios_between(1e-4, 10, 20));
        else
            model.ratios.push_back({1});
    }
    return model;
}

/// Refuses a constant that changes no velocity of the law.
void require_effect(const std::vector<FreeConstant>& free, Law law, DampingLaw damping) {
    for (const FreeConstant& each : free)
        if (const auto reason = idle_reason(law, damping, name_of(each.quantity)))
            throw InputError(fmt::format("{} is free, and {}", name_of(each.quantity), *reason),
                             "a constant that the law uses")
                .at("--free");
}

}  // namespace

SizeCalibration read_size_calibration(const CommandOptions& options, const std::vector<FreeConstant>& free) {
    if (options.has("case") || options.has("--compare"))
        throw InputError("is given beside a case or --compare", "one of them").at("--sizes");
    if (free.empty())
        throw InputError("is missing", "work_of_adhesion, yield_pressure, damping ...").at("--free");
    for (const FreeConstant& each : free)
        if (each.per_sample || each.quantity == CalibrationQuantity::time_step ||
            each.quantity == CalibrationQuantity::wall_young_modulus)
            throw InputError(
                in_quotes(name_of(each.quantity)) + " cannot follow from velocities over sizes",
                "work_of_adhesion, yield_pressure, damping, contact_modulus or density, each for all sizes")
                .at("--free");
    if (options.has("--allow-outside")) warn_idle("--allow-outside", "there is no case");
    std::vector<SizedVelocity> rows = read_sizes(options);
    if (rows.empty())
        throw InputError(in_quotes(options["--sizes"]) + " has no measured v_c of one stated diameter",
                         "a table of d and v_c, or a source with both: `ashimpact literature`")
            .at("--sizes");
    complete_uncertainties(rows, options);
    std::ranges::sort(rows, {}, &SizedVelocity::diameter);
    const SizeModel model = read_size_model(options, free, rows.back());
    const Law law = model.material.reference.law;
    require_effect(free, law, model.damping->law);
    SizeCalibration sizes{
        .data = {}, .problem = {.samples = {}, .free = free, .critical_velocities = {}, .contact_times = {}}};
    for (const SizedVelocity& row : rows) {
        const ContactPair contact = model.material.contact(row.diameter);
        sizes.data.samples.push_back({.name = readable(row.diameter, "m"), .diameter = {}});
        sizes.problem.critical_velocities.push_back({.sample = sizes.problem.samples.size(),
                                                     .law = law,
                                                     .critical_damping = 0,
                                                     .critical_damping_uncertainty = 0,
                                                     .value = row.velocity,
                                                     .standard_uncertainty = *row.uncertainty});
        sizes.problem.samples.push_back({.diameter = row.diameter,
                                         .density = model.material.density,
                                         .work_of_adhesion = contact.work_of_adhesion,
                                         .particle = {},
                                         .wall = {},
                                         .contact_modulus = contact.contact_modulus,
                                         .yield_pressure = contact.yield_pressure,
                                         .parameters = contact.parameters,
                                         .damping = model.damping});
    }
    sizes.problem = with_best_start(std::move(sizes.problem), model.ratios);
    return sizes;
}

std::optional<bool> fits_the_data(const CalibrationSummary& summary) {
    if (summary.degrees_of_freedom < 1) return std::nullopt;
    return summary.probability >= least_probability;
}

std::string probability_text(double probability) {
    constexpr double least_stated = 1e-6;
    return probability < least_stated ? "below 1e-6" : readable_number(probability, 2);
}

std::string conclusion_of_sizes(const CalibrationSummary& summary) {
    const auto fits = fits_the_data(summary);
    if (!fits)
        return "There are as many constants as velocities: nothing is left that could contradict the law.";
    if (!*fits)
        return fmt::format(
            "No value of these constants fits: the probability of chi^2 is {}. The law or an "
            "uncertainty is wrong, and the intervals mean nothing.",
            probability_text(summary.probability));
    return "The law with these constants does not contradict the velocities.";
}

}  // namespace ashimpact

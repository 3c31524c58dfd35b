// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/calibration/size_calibration.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "core/plausibility.hpp"
#include "core/quantities/checks.hpp"
#include "core/quantities/quantity.hpp"
#include "core/tables/number_marks.hpp"
#include "core/tables/text_lines.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "pipeline/app/command.hpp"
#include "pipeline/case/literature.hpp"
#include "pipeline/files/file.hpp"
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

/// A heading "d [um]" as the column and its unit.
struct SizeHeading {
    SizeColumn column;
    double unit;  ///< [SI]
    std::string unit_name;
};

SizeHeading read_size_heading(const std::string& cell) {
    const auto bracket = cell.find('[');
    const std::string name(trimmed(std::string_view(cell).substr(0, bracket)));
    const auto column = named<SizeColumn>(name);
    if (bracket == std::string::npos || !cell.ends_with(']'))
        throw InputError(in_quotes(cell) + " has no unit", "d [um], v_c [m/s], u(v_c) [m/s]");
    const auto dimension = column == SizeColumn::diameter ? Dimension::length : Dimension::velocity;
    const std::string unit = cell.substr(bracket + 1, cell.size() - bracket - 2);
    return {column, to_si(1, unit, dimension), unit};
}

std::vector<SizedVelocity> read_size_table(const std::string& bytes, std::optional<DecimalMark> decimal,
                                           std::vector<Finding>& doubts) {
    const TextLines file(bytes, {.content = "a table of critical velocities"});
    const std::vector<TextLine> lines = lines_with_content(file);
    const char separator = separator_of(lines.front().text);
    std::vector<SizeHeading> headings;
    at_place(at_line(lines.front().number), [&] {
        for (const std::string& cell : cut_row(lines.front(), separator).cells) {
            headings.push_back(read_size_heading(cell));
            if (std::ranges::count(headings, headings.back().column, &SizeHeading::column) > 1)
                throw InputError(in_quotes(cell) + " is the same column again", "each column once");
        }
        for (const SizeColumn needed : {SizeColumn::diameter, SizeColumn::velocity})
            if (std::ranges::find(headings, needed, &SizeHeading::column) == headings.end())
                throw InputError(fmt::format("the column {} is missing", name_of(needed)),
                                 "d [um], v_c [m/s], u(v_c) [m/s]");
    });
    NumberMarks marks(decimal);
    for (std::size_t k = 0; k < headings.size(); ++k)
        if (headings[k].unit < (headings[k].column == SizeColumn::diameter ? 1e-7 : 0.05))
            marks.may_hold_thousands(k);  // of nm, mm/s
    for (std::size_t i = 1; i < lines.size(); ++i)
        for_each_cell(lines[i], separator,
                      [&](std::string_view cell, std::size_t column) { marks.see(cell, column); });
    std::vector<SizedVelocity> rows;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        const TableRow row = cut_row(lines[i], separator);
        if (row.cells.size() != headings.size())
            refuse_line(row.line, fmt::format("has {} cells", row.cells.size()),
                        fmt::format("{}, as the heading", headings.size()));
        SizedVelocity sized;
        for (std::size_t k = 0; k < headings.size(); ++k)
            at_place(at_cell(row.line, k), [&] {
                const std::string& unit = headings[k].unit_name;
                const auto number = marks.read(without_unit(row.cells[k], unit), k);
                if (!number || !(number->value > 0) || number->per_cent)
                    throw InputError(in_quotes(row.cells[k]) + " is no size or velocity",
                                     "a number > 0 in " + unit);
                const double value = number->value * headings[k].unit;
                if (headings[k].column != SizeColumn::uncertainty)
                    if (auto doubt = implausible(
                            *plausible_range(headings[k].column == SizeColumn::diameter ? "diameter"
                                                                                        : "velocity"),
                            {value}))
                        doubts.push_back(*std::move(doubt));
                if (headings[k].column == SizeColumn::diameter)
                    sized.diameter = value;
                else if (headings[k].column == SizeColumn::velocity)
                    sized.velocity = value;
                else
                    sized.uncertainty = value;
                const bool is_column = std::ranges::find(headings, SizeColumn::uncertainty,
                                                         &SizeHeading::column) != headings.end();
                if (number->standard_uncertainty && is_column)
                    throw InputError(in_quotes(row.cells[k]) + " and a column state its uncertainty", "one");
                if (headings[k].column == SizeColumn::velocity && number->standard_uncertainty)
                    sized.uncertainty = *number->standard_uncertainty * headings[k].unit;
            });
        rows.push_back(sized);
    }
    return rows;
}

/// The measured velocities of a source that are single values of a known size.
std::vector<SizedVelocity> sized_velocities(const LiteratureSource& source) {
    std::vector<SizedVelocity> rows;
    for (const LiteratureVelocity& each : source.velocities)
        if (each.diameter && each.value() && each.basis == VelocityBasis::measured)
            rows.push_back({*each.diameter, *each.value()});
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
    std::vector<Finding> doubts;
    const auto rows = at_place(
        FileName{name}, [&] { return read_size_table(bytes, table_options(options).decimal, doubts); });
    if (!doubts.empty()) warn_of({doubts.front()}, name);
    return rows;
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
        if (relative > 1)
            throw InputError("is " + shortest(100 * relative) + " % of v_c", "up to 100 %, such as \"10 %\"")
                .at("--uncertainty");
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
    if (rows.empty()) throw InputError("has no velocity with a size", "rows of d and v_c").at("--sizes");
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

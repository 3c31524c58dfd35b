// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "core/json/document.hpp"
#include "core/json/view.hpp"
#include "core/plausibility.hpp"
#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "pipeline/app/calibration/hypotheses.hpp"
#include "pipeline/app/calibration/size_calibration.hpp"
#include "pipeline/app/command.hpp"
#include "pipeline/app/run_stages.hpp"
#include "pipeline/app/terminal.hpp"
#include "pipeline/document/values_json.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/present/report/figures/figures.hpp"
#include "pipeline/present/text/result_text.hpp"
#include "pipeline/run/uncertainty/calibration.hpp"
#include "solver/inference/calibration/calibration.hpp"
#include "solver/statistics/distribution.hpp"

namespace ashimpact {

namespace {

/// "density" or "density:each".
FreeConstant read_free(const std::string& text) {
    const auto colon = text.find(':');
    const bool each = colon != std::string::npos;
    return at_place("--free", [&]() -> FreeConstant {
        if (each && text.substr(colon) != ":each")
            throw InputError("the constant " + in_quotes(text) + " ends in " + in_quotes(text.substr(colon)),
                             ":each, for one value a sample");
        return {named<CalibrationQuantity>(text.substr(0, colon)), each};
    });
}

/// One observation beside what the calibrated model says.
struct Row {
    std::string sample;
    std::string law;
    std::string unit;
    CalibrationResidual residual;
};

template <class Observations>
std::vector<Row> rows_of(const Case& data, const Observations& observations,
                         const std::vector<CalibrationResidual>& residuals, Dimension dimension) {
    std::vector<Row> rows;
    for (std::size_t i = 0; i < observations.size(); ++i)
        rows.push_back({data.samples[observations[i].sample].name, std::string(observations[i].law.name()),
                        std::string(si_unit(dimension)), residuals[i]});
    return rows;
}

Json rows_json(const std::vector<Row>& rows) {
    Json list = Json::array();
    for (const Row& row : rows)
        list.push_back({{"sample", row.sample},
                        {"law", row.law},
                        {"published", quantity_json(row.residual.observed, row.unit)},
                        {"calibrated", quantity_json(row.residual.predicted, row.unit)},
                        {"relative_difference", row.residual.relative_difference()},
                        {"relative_standard_uncertainty", row.residual.relative_uncertainty}});
    return list;
}

/// "density of 88 um", "work_of_adhesion".
std::string title_of(const Case& data, const CalibratedConstant& constant) {
    const std::string name(name_of(constant.quantity));
    return constant.sample ? fmt::format("{} of {}", name, data.samples[*constant.sample].name) : name;
}

Json profile_json(const Case& data, const CalibrationSummary& summary, const ConstantProfile& profile,
                  std::string_view unit) {
    Json traded = Json::array();
    for (const std::size_t other : profile.traded_with)
        traded.push_back(title_of(data, summary.constants[other]));
    return {{"interval", interval_json(profile.interval, unit)},
            {"identifiable", profile.identifiable},
            {"traded_with", traded},
            {"statement", profile.statement}};
}

/// Unit of a constant [SI].
std::string_view unit_of_constant(const CalibrationSummary& summary, const CalibratedConstant& constant) {
    const Damping damping = summary.samples.front().damping.value_or(Damping{});
    return si_unit(dimension_of(constant.quantity, damping.law));
}

Json constants_json(const Case& data, const CalibrationSummary& summary,
                    const std::vector<ConstantProfile>& profiles) {
    Json list = Json::array();
    for (std::size_t i = 0; i < summary.constants.size(); ++i) {
        const CalibratedConstant& constant = summary.constants[i];
        const std::string_view unit = unit_of_constant(summary, constant);
        Json value = quantity_json(constant.value, unit);
        value["standard_uncertainty"] = std::isfinite(constant.standard_uncertainty)
                                            ? Json(constant.standard_uncertainty)
                                            : Json(nullptr);
        const auto end = [&](double bound) {  // none of a constant that is not identifiable
            return std::isfinite(bound) ? quantity_json(bound, unit) : Json(nullptr);
        };
        list.push_back(
            {{"quantity", name_of(constant.quantity)},
             {"sample", constant.sample ? Json(data.samples[*constant.sample].name) : Json(nullptr)},
             {"value", value},
             {"interval_95", {end(constant.lower), end(constant.upper)}},
             {"profile", profile_json(data, summary, profiles[i], unit)}});
    }
    return list;
}

std::string interval_text(const Interval& interval, std::string_view unit) {
    if (!interval.lower && !interval.upper) return "not identifiable";
    return bounds_text(interval.lower, interval.upper, unit);
}

/// Correlations of the constants with those before them, and what the data do not fix.
std::string identification_text(const Case& data, const CalibrationSummary& summary,
                                const std::vector<ConstantProfile>& profiles) {
    std::string text;
    for (std::size_t i = 0; i < profiles.size(); ++i) {
        const std::string name = title_of(data, summary.constants[i]);
        for (std::size_t j = 0; j < i; ++j)
            text += fmt::format(
                "correlation of {} with {}: {:+.3f}\n", name, title_of(data, summary.constants[j]),
                summary.correlation(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
        if (!profiles[i].statement.empty()) text += fmt::format("{}: {}\n", name, profiles[i].statement);
    }
    return text;
}

/// Under which assumptions the uncertainties of a calibration hold.
std::string conditions_text(const CalibrationSummary& summary) {
    const bool step = std::ranges::any_of(summary.constants, [](const CalibratedConstant& constant) {
        return constant.quantity == CalibrationQuantity::time_step;
    });
    return fmt::format(
        "The uncertainties hold if the published numbers come from {}, the wall is as stated and each "
        "contact "
        "time is of the law beside it; --compare shows what other assumptions change.",
        step ? "Eq. 31 at a finite step" : "exact impacts");
}

std::string calibration_text(const Case& data, const CalibrationSummary& summary,
                             const std::vector<ConstantProfile>& profiles, const std::vector<Row>& velocities,
                             const std::vector<Row>& times, const std::string& conclusion) {
    TextTable constants({"constant", "sample", "value", "95 % interval", "by profile likelihood"});
    for (std::size_t i = 0; i < summary.constants.size(); ++i) {
        const CalibratedConstant& constant = summary.constants[i];
        const std::string_view unit = unit_of_constant(summary, constant);
        Interval curvature{constant.value, constant.standard_uncertainty};
        if (std::isfinite(constant.lower) && std::isfinite(constant.upper))
            curvature = {constant.value, constant.standard_uncertainty, constant.lower, constant.upper};
        constants.add({std::string(name_of(constant.quantity)),
                       constant.sample ? data.samples[*constant.sample].name : "all",
                       readable(constant.value, unit), interval_text(curvature, unit),
                       interval_text(profiles[i].interval, unit)});
    }
    TextTable residuals({"sample", "law", "published", "calibrated", "difference", "in u"});
    for (const auto* rows : {&velocities, &times})
        for (const Row& row : *rows)
            residuals.add({row.sample, row.law, readable(row.residual.observed, row.unit),
                           value_text(row.residual.predicted, row.unit),
                           fmt::format("{:+.2f} %", 100 * row.residual.relative_difference()),
                           fmt::format("{:+.1f}", std::log(row.residual.predicted / row.residual.observed) /
                                                      row.residual.relative_uncertainty)});
    return constants.text() + "\n" + identification_text(data, summary, profiles) + "\n" + residuals.text() +
           fmt::format("\nchi^2 {} with {} degrees of freedom, probability {}; AIC {}\n",
                       readable_number(summary.chi_squared), summary.degrees_of_freedom,
                       probability_text(summary.probability), readable_number(summary.akaike)) +
           wrapped(conclusion, output_width(), 2) + "\n";
}

/// The constants that --free names. @throws InputError naming the option
std::vector<FreeConstant> free_constants(const CommandOptions& options) {
    std::vector<FreeConstant> all;
    for (const std::string& text : options.list("--free")) {
        const FreeConstant free = read_free(text);
        if (std::ranges::find(all, free.quantity, &FreeConstant::quantity) != all.end())
            throw InputError(in_quotes(text.substr(0, text.find(':'))) + " is given twice",
                             "each constant once")
                .at("--free");
        all.push_back(free);
    }
    return all;
}

/// The doubts about constants that are far from plausible.
std::vector<Finding> implausible_constants(const Case& data, const CalibrationSummary& summary) {
    std::vector<Finding> doubts;
    for (const CalibratedConstant& constant : summary.constants)
        if (const PlausibleRange* range = plausible_range(name_of(constant.quantity)))
            if (auto doubt = implausible_at(title_of(data, constant), *range, {constant.value}))
                doubts.push_back(*std::move(doubt));
    return doubts;
}

/// The doubt about intervals that leave out the stated uncertainties of what is not free; none if there are
/// none. They hold at the values of these inputs.
std::optional<Finding> held_uncertainties(const Case& data, const ContactResult& contacts) {
    const auto is_free = [&](CalibrationQuantity quantity) {
        return std::ranges::find(data.calibration, quantity, &FreeConstant::quantity) !=
               data.calibration.end();
    };
    std::vector<std::string> held;
    const auto add = [&](const char* name, Quantity (*of)(const SampleContact&)) {
        double greatest = 0;
        for (const SampleContact& contact : contacts.samples) {
            const Quantity quantity = of(contact);
            greatest =
                std::max(greatest, quantity.standard_uncertainty.value_or(0) / std::abs(quantity.value));
        }
        if (greatest > 0) held.push_back(fmt::format("{} (up to {:.2g} %)", name, 100 * greatest));
    };
    add("diameter", [](const SampleContact& contact) { return contact.radius; });
    if (!is_free(CalibrationQuantity::density))
        add("density", [](const SampleContact& contact) { return contact.density.quantity; });
    if (!is_free(CalibrationQuantity::work_of_adhesion))
        add("work of adhesion",
            [](const SampleContact& contact) { return contact.work_of_adhesion.quantity; });
    if (!is_free(CalibrationQuantity::contact_modulus))
        add("contact modulus", [](const SampleContact& contact) { return contact.contact_modulus.quantity; });
    if (held.empty()) return std::nullopt;
    return Finding{
        "held", Severity::doubt,
        "the intervals leave out the standard uncertainties of what is held fixed: " + joined(held)};
}

/// Calibrates and prints. @param conclusion the sentence below the table @param doubts that are known before
CalibrationSummary print_calibration(const Case& data, CalibrationProblem problem,
                                     std::string (*conclusion)(const CalibrationSummary&), bool json,
                                     std::ostream& out, std::vector<Finding> doubts = {}) {
    warn_of(doubts);
    CalibrationSummary summary;
    const auto profiles = [&] {
        Progress progress(0, 0, on_terminal(), "trials");
        std::uint64_t done = 0;
        problem.on_trial = [&] { progress.update(++done); };
        summary = calibrate(problem);
        return profile_constants(problem, summary);
    }();
    const auto implausible = implausible_constants(data, summary);
    warn_of(implausible);
    doubts.insert(doubts.end(), implausible.begin(), implausible.end());
    const auto velocities =
        rows_of(data, problem.critical_velocities, summary.critical_velocities, Dimension::velocity);
    const auto times = rows_of(data, problem.contact_times, summary.contact_times, Dimension::time);
    if (!json) {
        out << calibration_text(data, summary, profiles, velocities, times, conclusion(summary));
        return summary;
    }
    const auto fits = fits_the_data(summary);
    Json document{{"constants", constants_json(data, summary, profiles)},
                  {"correlation", matrix_json(summary.correlation)},
                  {"critical_velocities", rows_json(velocities)},
                  {"contact_times", rows_json(times)},
                  {"chi_squared", summary.chi_squared},
                  {"degrees_of_freedom", summary.degrees_of_freedom},
                  {"probability", summary.probability},
                  {"fits", fits ? Json(*fits) : Json(nullptr)},
                  {"akaike", summary.akaike},
                  {"iterations", summary.iterations}};
    add_notes(document, doubts);
    out << write_json(document, Digits::seventeen);
    return summary;
}

/// Draws velocities over sizes with the line of the calibrated constants, to half and double the sizes.
void draw_calibration(const CalibrationProblem& problem, const CalibrationSummary& summary,
                      const std::string& file) {
    constexpr std::size_t sizes_of_line = 60;
    const auto [least, greatest] =
        std::ranges::minmax_element(problem.samples, {}, &CalibrationSample::diameter);
    const auto line = velocities_over_sizes(
        problem, summary, logarithmic_grid(least->diameter / 2, 2 * greatest->diameter, sizes_of_line));
    const auto format = report::format_of(file);
    write_file(file, report::figure_bytes(
                         report::calibrated_velocities_figure(problem, line, conclusion_of_sizes(summary)),
                         report::Width::wide, format));
}

void run_calibrate_command(const CommandOptions& options, std::ostream& out) {
    std::vector<FreeConstant> free = free_constants(options);
    if (on_terminal()) spdlog::info("calibrating: this takes some seconds");
    if (options.has("--sizes")) {
        const SizeCalibration sizes = read_size_calibration(options, free);
        if (options.has("--output")) report::require_converter(report::format_of(options["--output"]));
        const CalibrationSummary summary = at_place(FileName{options["--sizes"]}, [&] {
            return print_calibration(sizes.data, sizes.problem, conclusion_of_sizes, options.has("--json"),
                                     out);
        });
        if (!options.has("--output")) return;
        draw_calibration(sizes.problem, summary, options["--output"]);
        if (!options.has("--json")) out << options["--output"] << '\n';
        return;
    }
    refuse_material(options, "--sizes");
    const Run run = compute_run(options.if_given("case"), "contact", options.has("--allow-outside"));
    print_readings(run.inputs);
    Case data = run.data;
    if (!free.empty()) data.calibration = std::move(free);
    at_place(FileName{options.if_given("case").value_or("built-in case")}, [&] {
        const auto whole_problem = [&] {
            CalibrationProblem problem = calibration_problem(data, run.modulus, run.contact);
            std::ranges::sort(data.samples, {}, calibration_key);  // like those of the problem
            return problem;
        };
        if (options.has("--compare")) {
            data.calibration.clear();
            const CalibrationProblem problem = whole_problem();
            if (problem.critical_velocities.empty() && problem.contact_times.empty())
                throw InputError("nothing is published for these samples that constants could be found from",
                                 "critical velocities with their damping, contact times")
                    .at("/samples");
            print_hypotheses(data, problem, options.has("--json"), out);
            return;
        }
        if (data.calibration.empty())
            throw InputError("nothing is free", "calibration.free in the case, or --free").at("/calibration");
        const CalibrationProblem problem = whole_problem();
        std::vector<Finding> doubts = doubts_of_published(data);
        if (auto held = held_uncertainties(data, run.contact)) doubts.push_back(*std::move(held));
        print_calibration(data, problem, conditions_text, options.has("--json"), out, std::move(doubts));
    });
}

}  // namespace

void add_calibrate(const CommandLine& line) {
    Command command = line.add(
        "calibrate",
        "Unknown constants of a case, from published critical velocities and contact times; or of a law, "
        "from critical velocities of several sizes",
        "ashimpact calibrate --free density:each --free work_of_adhesion\n"
        "  ashimpact calibrate --sizes arffman2015 --uncertainty \"10 %\" --law thornton-ning --density "
        "\"10490 kg/m3\" "
        "--contact-modulus \"43 GPa\" --free work_of_adhesion --free yield_pressure",
        run_calibrate_command);
    command.add_case_argument();
    command
        .add_list("--free", "NAME[:each]",
                  "a constant to find: density, work_of_adhesion, contact_modulus, wall_young_modulus, "
                  "time_step; with --sizes yield_pressure and damping; with "
                  ":each one value a sample; default: what the case says")
        ->allow_extra_args(false);
    command
        .add_flag("--compare",
                  "hypotheses beside one another: one modulus or those from XRD, one density or one a size, "
                  "wall known, free or rigid, Eq. 31 exact or at a finite step, contact times by each law")
        ->excludes("--free");
    CLI::Option* sizes =
        command.add("--sizes", "FILE",
                    "critical velocities of several sizes instead of a case: columns d [um], v_c [m/s] "
                    "and, if known, u(v_c) [m/s]; or a source of `ashimpact literature`");
    command.add("--uncertainty", "X", "relative standard one of v_c where the table states none, \"10 %\"")
        ->needs(sizes);
    command.add_table_options(sizes);
    command.add("-o,--output", "FILE", "draws the velocities and the law over the sizes: .svg, .pdf or .png")
        ->needs(sizes);
    command.add_material_options(false);
    command.add_allow_outside_flag();
    command.add_json_flag();
}

}  // namespace ashimpact

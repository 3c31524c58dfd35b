// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "core/json/document.hpp"
#include "core/json/view.hpp"
#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "pipeline/app/calibration/hypotheses.hpp"
#include "pipeline/app/command.hpp"
#include "pipeline/app/run_stages.hpp"
#include "pipeline/app/terminal.hpp"
#include "pipeline/document/values_json.hpp"
#include "pipeline/present/text/result_text.hpp"
#include "pipeline/run/uncertainty/calibration.hpp"
#include "solver/inference/calibration/calibration.hpp"

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

Json constants_json(const Case& data, const CalibrationSummary& summary,
                    const std::vector<ConstantProfile>& profiles) {
    Json list = Json::array();
    for (std::size_t i = 0; i < summary.constants.size(); ++i) {
        const CalibratedConstant& constant = summary.constants[i];
        const std::string_view unit = si_unit(dimension_of(constant.quantity));
        Json value = quantity_json(constant.value, unit);
        value["standard_uncertainty"] = constant.standard_uncertainty;
        list.push_back(
            {{"quantity", name_of(constant.quantity)},
             {"sample", constant.sample ? Json(data.samples[*constant.sample].name) : Json(nullptr)},
             {"value", value},
             {"interval_95", {quantity_json(constant.lower, unit), quantity_json(constant.upper, unit)}},
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
                             const std::vector<Row>& times) {
    TextTable constants({"constant", "sample", "value", "95 % interval", "by profile likelihood"});
    for (std::size_t i = 0; i < summary.constants.size(); ++i) {
        const CalibratedConstant& constant = summary.constants[i];
        const std::string_view unit = si_unit(dimension_of(constant.quantity));
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
                           readable(row.residual.predicted, row.unit),
                           fmt::format("{:+.2f} %", 100 * row.residual.relative_difference()),
                           fmt::format("{:+.1f}", row.residual.relative_difference() /
                                                      row.residual.relative_uncertainty)});
    return constants.text() + "\n" + identification_text(data, summary, profiles) + "\n" + residuals.text() +
           fmt::format("\nchi^2 {} with {} degrees of freedom, probability {}; AIC {}\n",
                       readable_number(summary.chi_squared), summary.degrees_of_freedom,
                       readable_number(summary.probability, 2), readable_number(summary.akaike)) +
           wrapped(conditions_text(summary), output_width(), 2) + "\n";
}

void run_calibrate_command(const CommandOptions& options, std::ostream& out) {
    const Run run = compute_run(options.if_given("case"), "contact", options.has("--allow-outside"));
    Case data = run.data;
    if (options.has("--free")) data.calibration.clear();
    for (const std::string& text : options.list("--free")) {
        const FreeConstant free = read_free(text);
        for (const FreeConstant& other : data.calibration)
            if (other.quantity == free.quantity)
                throw InputError(in_quotes(text.substr(0, text.find(':'))) + " is given twice",
                                 "each constant once")
                    .at("--free");
        data.calibration.push_back(free);
    }

    at_place(FileName{options.if_given("case").value_or("built-in case")}, [&] {
        const auto whole_problem = [&] {
            CalibrationProblem problem = calibration_problem(data, run.modulus, run.contact);
            std::ranges::sort(data.samples, {}, calibration_key);  // like those of the problem
            return problem;
        };
        if (on_terminal()) spdlog::info("calibrating: this takes some seconds");
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
        const auto problem = whole_problem();
        const CalibrationSummary summary = calibrate(problem);
        const auto profiles = [&] {  // what takes most of the time
            Progress progress(summary.constants.size(), 0, on_terminal(), "constants");
            return profile_constants(problem, summary, [&](std::size_t done) { progress.update(done); });
        }();
        const auto velocities =
            rows_of(data, problem.critical_velocities, summary.critical_velocities, Dimension::velocity);
        const auto times = rows_of(data, problem.contact_times, summary.contact_times, Dimension::time);
        if (!options.has("--json")) {
            out << calibration_text(data, summary, profiles, velocities, times);
            return;
        }
        out << write_json({{"constants", constants_json(data, summary, profiles)},
                           {"correlation", matrix_json(summary.correlation)},
                           {"critical_velocities", rows_json(velocities)},
                           {"contact_times", rows_json(times)},
                           {"chi_squared", summary.chi_squared},
                           {"degrees_of_freedom", summary.degrees_of_freedom},
                           {"probability", summary.probability},
                           {"akaike", summary.akaike},
                           {"iterations", summary.iterations}},
                          Digits::seventeen);
    });
}

}  // namespace

void add_calibrate(const CommandLine& line) {
    Command command = line.add(
        "calibrate", "Unknown constants of a case, from published critical velocities and contact times",
        "ashimpact calibrate --free density:each --free work_of_adhesion", run_calibrate_command);
    command.add_case_argument();
    command
        .add_list("--free", "NAME[:each]",
                  "a constant to find: density, work_of_adhesion, contact_modulus, wall_young_modulus, "
                  "time_step; with "
                  ":each one value a sample; default: what the case says")
        ->allow_extra_args(false);
    command
        .add_flag("--compare",
                  "hypotheses beside one another: one modulus or those from XRD, one density or one a size, "
                  "wall known, free or rigid, Eq. 31 exact or at a finite step, contact times by each law")
        ->excludes("--free");
    command.add_allow_outside_flag();
    command.add_json_flag();
}

}  // namespace ashimpact

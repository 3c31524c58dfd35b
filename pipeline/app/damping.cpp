// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <ostream>
#include <vector>

#include <fmt/format.h>

#include "core/json/document.hpp"
#include "core/json/view.hpp"
#include "core/plausibility.hpp"
#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "pipeline/app/command.hpp"
#include "pipeline/app/contact/single_contact.hpp"
#include "pipeline/case/case_parts.hpp"
#include "pipeline/document/results_json.hpp"
#include "pipeline/document/values_json.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/present/text/result_text.hpp"
#include "pipeline/run/dampings.hpp"
#include "solver/inference/impacts/measurement.hpp"
#include "solver/inference/measured_damping.hpp"
#include "solver/motion/damping_inversion.hpp"
#include "solver/motion/explicit_scheme.hpp"

namespace ashimpact {

namespace {

double read_relative(const CommandOptions& options, const char* name) {
    const double value = options.number(name, Dimension::fraction);
    const bool is_bare = whole_decimal(options[name]).has_value();
    at_place(name, [&] { require_relative(value, is_bare); });
    return value;
}

/// The impacts of the file, with camera and bins where they are asked for.
MeasurementSet read_impacts(const CommandOptions& options) {
    MeasurementSet set =
        read_measurements(read_file(options["--impacts"]), options["--impacts"], table_options(options));
    if (options.has("--frame-rate")) {
        const Camera camera{
            .frame_rate = at_place("--frame-rate", [&] { return read_frame_rate(options["--frame-rate"]); }),
            .pixel_size = options.number("--pixel-size", Dimension::length),
            .frames = options.whole("--frames", Camera{}.frames)};
        set = at_place("--frame-rate, --pixel-size", [&] { return with_camera(std::move(set), camera); });
    }
    warn_of(set.warnings, options["--impacts"]);
    print_reading(options["--impacts"], set.reading);
    at_place(FileName{options["--impacts"]}, [&] { check_impacts(set); });
    return options.has("--bin") ? binned(set, {.impacts_per_bin = options.whole("--bin")}) : set;
}

/// The critical velocity that the impacts support.
Json headline_json(const Interval& velocity) {
    Json json = estimate_json(velocity, si_unit(Dimension::velocity));
    json["interval"] = interval_json(velocity, si_unit(Dimension::velocity));
    json["method"] = estimate_method;
    return json;
}

Json measured_damping_json(const MeasuredDamping& result, const MeasurementSet& set) {
    DampingSeries series = inverted_series(result.impacts);
    set_parts(result.parts, result.impacts, series);
    Json json{{"law", result.law.name()},
              {"detachment", name_of(result.detachment)},
              {"impacts", set.points.size()},
              {"captures", set.captures()},
              {"inversion", inversion_json(series, DampingLaw::constant)}};
    json.update(parts_json(series));
    json["rising_branch"] = result.rising && !result.rising->is_hidden()
                                ? rising_branch_json(result.rising->upper, result.rising->falls_beyond)
                                : Json(nullptr);
    const auto* const curve = result.estimate ? &result.estimate->curve : nullptr;
    json["critical_velocity"] = curve != nullptr ? headline_json(curve->critical_velocity) : Json(nullptr);
    json["extrapolated"] = result.extrapolated
                               ? damping_fit_json(with_indices(*result.extrapolated, result.rising->indices))
                               : Json(nullptr);
    if (result.extrapolated)
        json["extrapolated"]["check"] =
            check_json(checked(result.extrapolated->critical_velocity, result.measured, true));
    json["direct"] = curve != nullptr ? damping_estimate_json(summary_of(*result.estimate)) : Json(nullptr);
    json["comparison"] = result.comparison ? comparison_json(*result.comparison) : Json(nullptr);
    json["measured"] = measured_velocity_json(result.measured);
    json["notes"] = texts_of(result.findings);
    return json;
}

std::string range_text(const Interval& interval, const char* unit) {
    return fmt::format("{} ({})", value_text(interval.value, unit),
                       bounds_text(interval.lower, interval.upper, unit));
}

std::string fit_text(const DampingCurveFit& fit) {
    const std::string misfit =
        fit.noise_known
            ? fmt::format("; chi^2 {} of {}", readable_number(fit.chi_squared), fit.degrees_of_freedom)
            : std::string{};
    return fmt::format("eta of order {} in e, {} rebounds: v_c {}, eta_c {}{}", fit.options.order,
                       fit.rebounds.size(), range_text(fit.critical_velocity, "m/s"),
                       range_text(fit.critical_damping, "kg/s"), misfit);
}

std::string estimate_text(const CriticalVelocityEstimate& estimate) {
    return fmt::format(
        "{}, eta_c {}; of {} rebounds and {} captures", range_text(estimate.curve.critical_velocity, "m/s"),
        range_text(estimate.curve.critical_damping, "kg/s"), estimate.rebounds, estimate.captures);
}

std::string parts_text(const DampingParts& parts) {
    if (parts.parts.empty()) return parts.note;
    std::string text(name_of(parts.parts.front()));
    for (std::size_t i = 0; i < parts.boundaries.size(); ++i) {
        const PartBoundary& boundary = parts.boundaries[i];
        text += fmt::format(" to {}, {}",
                            readable(Quantity{.value = boundary.velocity,
                                              .unit = "m/s",
                                              .standard_uncertainty = boundary.standard_uncertainty}),
                            name_of(parts.parts[i + 1]));
    }
    return text;
}

std::string measured_text(const MeasuredCriticalVelocity& measured) {
    const auto& lower = measured.lower;
    const auto& upper = measured.upper;
    if (measured.value)
        return range_text({*measured.value, measured.standard_uncertainty.value_or(0), lower, upper}, "m/s") +
               ": " + measured.note;
    if (lower) return fmt::format("v_c > {}: {}", readable(*lower, "m/s"), measured.note);
    return upper ? fmt::format("v_c < {}: {}", readable(*upper, "m/s"), measured.note) : measured.note;
}

std::string contact_time_text(const InvertedImpact& impact) {
    if (impact.contact_time) return readable_number(1e9 * *impact.contact_time);
    return impact.restitution > 0 ? "-" : "captured";
}

std::string result_text(const MeasuredDamping& result, const MeasurementSet& set,
                        const std::optional<DampingStudy>& dampings) {
    TextTable impacts({"#", "v_in [m/s]", "e_n", "at most", "damping [kg/s]", "contact time [ns]"});
    constexpr std::size_t most_rows = 12;
    const std::size_t stride = (result.impacts.size() + most_rows - 1) / most_rows;
    for (std::size_t i = 0; i < result.impacts.size(); i += stride) {
        const InvertedImpact& impact = result.impacts[i];
        const std::string damping = impact.damping ? readable_number(*impact.damping) : "none gives it";
        impacts.add({std::to_string(i + 1), readable_number(impact.velocity),
                     readable_number(impact.restitution), readable_number(impact.greatest_restitution),
                     (impact.restitution == 0 && impact.damping ? "at least " : "") + damping,
                     contact_time_text(impact)});
    }
    TextList list;
    list.add("law", fmt::format("{}, contact ends at {}", result.law.name(), name_of(result.detachment)));
    list.add("impacts", fmt::format("{}, {} of them captured", set.points.size(), set.captures()));
    list.add("parts of eta(v_in)", parts_text(result.parts));
    if (result.rising)
        list.add("rising branch", result.rising->is_hidden()
                                      ? "hidden by outliers"
                                      : fmt::format("to {}", readable(result.rising->upper, "m/s")));
    list.add("critical velocity",
             result.estimate ? estimate_text(*result.estimate) : "none, see the warnings");
    if (result.extrapolated) list.add("extrapolated", fit_text(*result.extrapolated));
    if (result.comparison) list.add("of one another", result.comparison->statement);
    list.add("measured v_c", measured_text(result.measured));
    const std::string rows =
        stride > 1 ? fmt::format("every {} of {} rows\n", stride, result.impacts.size()) : std::string{};
    const std::string text = list.text(0);
    return impacts.text() + rows + "\n" + text + uncertainty_legend(text) +
           "Intervals are of 95 % and hold for the contact as given.\n" +
           (dampings ? "\n" + dampings_text(dampings->comparison) : "");
}

/// Warns where the law does not suit the contact. That impacts yield is among the findings of the series.
void warn_of_law(const ContactChoice& choice, const MeasurementSet& set) {
    const double fastest = std::ranges::max_element(set.points, {}, &Measurement::velocity)->velocity;
    const Impact impact = choice.impact({DampingLaw::constant, 0}, fastest);
    for (const Finding& finding : regime_of(impact, solve_impact(impact).maximum_overlap).warnings)
        if (finding.severity == Severity::background) warn_of({finding});
}

/// `damping --impacts FILE`: intervals are those of the impacts; the contact counts as exactly known.
void run_measured_damping_command(const CommandOptions& options, std::ostream& out) {
    if (options["--method"] != "taylor" || options.has("--time-step"))
        throw InputError("is for one impact", "--velocity and --restitution").at("--method");
    const ContactChoice choice = read_contact(options);
    if (read_damping_law(options) != DampingLaw::constant)
        throw InputError("a series of impacts is read with constant damping", "constant").at("--damping-law");
    const MeasurementSet set = read_impacts(options);
    MeasuredDampingOptions how;
    how.extrapolated = {.order = options.whole("--order", 2), .robust = options.has("--robust")};
    if (options.has("--size-scatter")) how.estimate.size_scatter = read_relative(options, "--size-scatter");
    if (options.has("--velocity-scale-uncertainty"))
        how.estimate.scale_uncertainty = read_relative(options, "--velocity-scale-uncertainty");
    const MeasuredDamping result = analyse_impacts(choice.law, choice.detachment, choice.contact, set, how);
    const auto dampings = study_dampings({choice.law, choice.detachment}, {{choice.contact, set.points}},
                                         {"impacts"}, how.estimate.scale_uncertainty);
    std::vector<Finding> doubts = options.doubts();
    for (const auto* option : {"--size-scatter", "--velocity-scale-uncertainty"})
        if (options.has(option) && !result.estimate)
            warn_idle(option, "there is no estimate, which it is for");
    if (result.estimate)
        if (const auto doubt = outside_model(result.estimate->curve.critical_velocity.value)) {
            warn_of({*doubt}, options["--impacts"]);
            doubts.push_back(*doubt);
        }
    warn_of(result.findings, options["--impacts"]);
    warn_of_law(choice, set);
    Json json = measured_damping_json(result, set);
    json["dampings"] = dampings ? dampings_json(dampings->comparison) : Json(nullptr);
    add_notes(json, doubts);
    out << (options.has("--json") ? write_json(json, Digits::seventeen) : result_text(result, set, dampings));
}

void run_damping_command(const CommandOptions& options, std::ostream& out) {
    if (options.has("--impacts")) {
        run_measured_damping_command(options, out);
        return;
    }
    const ContactChoice choice = read_contact(options);
    if (!options.has("--velocity"))
        throw InputError("neither is given",
                         "the velocity of one impact with its --restitution, or a file of impacts")
            .at("--velocity, --impacts");
    const DampingProblem problem{.law = choice.law,
                                 .detachment = choice.detachment,
                                 .damping_law = read_damping_law(options),
                                 .contact = choice.contact,
                                 .velocity = options.positive("--velocity", Dimension::velocity),
                                 .restitution = options.number("--restitution", Dimension::fraction)};
    const DampingInversion inversion =
        at_place("--restitution", [&] { return damping_from_restitution(problem); });
    const Impact impact = choice.impact(inversion.damping, problem.velocity);
    warn_of(regime_of(impact, inversion.impact.maximum_overlap).warnings);
    Json json = impact_json(impact, inversion.impact);
    std::string text = impact_text(impact, inversion.impact);
    if (const auto step = read_explicit_step(options, impact)) {
        const double coefficient = at_place("--method, --time-step", [&] {
            return explicit_damping(impact, problem.restitution, {.time_step = *step});
        });
        json["paper_explicit"] = {{"damping", quantity_json(coefficient, unit_of(problem.damping_law))},
                                  {"time_step", quantity_json(*step, Dimension::time)}};
        text += fmt::format("by the paper's scheme, time step {}: damping {}\n", readable(*step, "s"),
                            readable(coefficient, unit_of(problem.damping_law)));
    }
    json["greatest_restitution"] = quantity_json(inversion.greatest_restitution, Dimension::fraction);
    add_notes(json, options.doubts());
    out << (options.has("--json") ? write_json(json, Digits::seventeen) : text);
}

}  // namespace

void add_damping(const CommandLine& line) {
    Command command = line.add("damping", "The damping that gives back a measured restitution",
                               "ashimpact damping --law dmt --radius \"44 um\" --density \"2600 kg/m3\" "
                               "--contact-modulus \"90 GPa\" --work-of-adhesion \"0.3 J/m2\" "
                               "--velocity \"2 m/s\" --restitution 0.2\n"
                               "  (the same with --impacts impacts.csv instead of the last two)",
                               run_damping_command);
    command.add_contact_options(true);
    CLI::Option* velocity = command.add("--velocity", "Q", "at first touch, \"2 m/s\"");
    CLI::Option* restitution =
        command.add("--restitution", "X", "e_n; 0: the smallest damping that captures");
    CLI::Option* table =
        command
            .add("--impacts", "FILE",
                 "instead of one impact a table of many (CSV, .xlsx, .ods), with a heading such as "
                 "\"v_in [m/s], v_r [m/s]\": damping of each, fits, critical velocity with its interval")
            ->excludes(velocity, restitution);
    command.add_table_options(table);
    CLI::Option* rate = command.add("--frame-rate", "X", "of the camera, frames per second")->needs(table);
    CLI::Option* pixel =
        command.add("--pixel-size", "Q", "of the camera, in the object, \"2 um\"")->needs(table)->needs(rate);
    rate->needs(pixel);
    command.add("--frames", "N", "positions that each velocity is the slope of; default 2")
        ->check(whole_number(2, 10'000))
        ->needs(rate);
    command
        .add("--size-scatter", "X",
             "relative standard deviation of single diameters, such as of a sieve, \"5 %\"")
        ->needs(table);
    command
        .add("--velocity-scale-uncertainty", "X",
             "relative standard uncertainty of a factor that all velocities have in common, \"3 %\"")
        ->needs(table);
    command.add("--order", "N", "of the polynomial that is extrapolated; default 2")
        ->check(whole_number(1, 6))
        ->needs(table);
    command.add_flag("--robust", "bisquare weights in the extrapolated polynomial")->needs(table);
    command.add("--bin", "N", "rebounds to be put into one point")
        ->check(whole_number(1, 1'000'000))
        ->needs(table);
    command.add_method_options();
    command.add_json_flag();
}

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/measured_damping.hpp"

#include <ostream>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "core/json/view.hpp"
#include "core/json/writer.hpp"
#include "core/quantities/readable.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "pipeline/case/measurement_json.hpp"
#include "pipeline/document/results_json.hpp"
#include "pipeline/document/values_json.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/present/text/table.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/inference/impacts/measurement.hpp"
#include "solver/inference/measured_damping.hpp"

namespace ashimpact {

namespace {

double read_frame_rate(const std::string& text) {
    try {
        return read_option("--frame-rate", text, Dimension::fraction);
    } catch (const InputError& error) {
        throw InputError(error.problem(), "frames per second, e.g. 80000").at("--frame-rate");
    }
}

double read_size_scatter(const std::string& text) {
    const double scatter = read_option("--size-scatter", text, Dimension::fraction);
    if (!(scatter > 0 && scatter <= 0.5))
        throw InputError("is " + readable_number(scatter),
                         "a relative standard deviation above 0, at most 0.5")
            .at("--size-scatter");
    return scatter;
}

/// The impacts of the file, with camera and bins where they are asked for.
MeasurementSet read_impacts(const DampingOptions& options) {
    MeasurementSet set = read_measurements(read_file(options.impacts), options.impacts, options.sheet);
    for (const Finding& warning : set.warnings)
        spdlog::warn("warning: {}: {}", options.impacts, warning.text);
    if (options.frame_rate.empty() != options.pixel_size.empty())
        throw InputError("one of the two is missing", "both or neither").at("--frame-rate, --pixel-size");
    if (options.frames > 0 && options.frame_rate.empty())
        throw InputError("says how a camera was used, and there is none",
                         "with --frame-rate and --pixel-size")
            .at("--frames");
    if (!options.frame_rate.empty()) {
        const Camera camera{.frame_rate = read_frame_rate(options.frame_rate),
                            .pixel_size = read_option("--pixel-size", options.pixel_size, Dimension::length),
                            .frames = options.frames > 0 ? options.frames : Camera{}.frames};
        set = at_place("--frame-rate, --pixel-size", [&] { return with_camera(std::move(set), camera); });
    }
    at_place(FileName{options.impacts}, [&] { check_impacts(set); });
    return options.bin > 0 ? binned(set, {.impacts_per_bin = options.bin}) : set;
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
    json["critical_velocity"] =
        result.estimate ? headline_json(result.estimate->curve.critical_velocity) : Json(nullptr);
    json["extrapolated"] = nullptr;
    if (result.extrapolated) {
        json["extrapolated"] = damping_fit_json(with_indices(*result.extrapolated, result.rising->indices));
        json["extrapolated"]["check"] =
            check_json(checked(result.extrapolated->critical_velocity, result.measured, true));
    }
    json["direct"] = nullptr;
    if (result.estimate) {
        json["direct"] = damping_estimate_json(summary_of(*result.estimate));
        json["direct"]["check"] =
            check_json(checked(result.estimate->curve.critical_velocity, result.measured, true));
    }
    json["comparison"] = result.comparison ? comparison_json(*result.comparison) : Json(nullptr);
    json["measured"] = measured_velocity_json(result.measured);
    json["notes"] = texts_of(result.findings);
    return json;
}

std::string range_text(const Interval& interval, const char* unit) {
    const auto end = [&](const std::optional<double>& value) {
        return value ? readable(*value, unit) : std::string("open");
    };
    return fmt::format("{} ({} to {})", readable(interval.value, unit), end(interval.lower),
                       end(interval.upper));
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
    if (!measured.value && measured.lower)
        return fmt::format("v_c > {}: {}", readable(*measured.lower, "m/s"), measured.note);
    if (!measured.value && measured.upper)
        return fmt::format("v_c < {}: {}", readable(*measured.upper, "m/s"), measured.note);
    if (!measured.value) return measured.note;
    return fmt::format("{}: {}",
                       range_text({*measured.value, measured.standard_uncertainty.value_or(0), measured.lower,
                                   measured.upper},
                                  "m/s"),
                       measured.note);
}

std::string result_text(const MeasuredDamping& result, const MeasurementSet& set) {
    TextTable impacts({"#", "v_in [m/s]", "e_n", "at most", "damping [kg/s]", "contact time [ns]"});
    constexpr std::size_t most_rows = 12;
    const std::size_t stride = (result.impacts.size() + most_rows - 1) / most_rows;
    for (std::size_t i = 0; i < result.impacts.size(); i += stride) {
        const InvertedImpact& impact = result.impacts[i];
        const std::string damping = impact.damping ? readable_number(*impact.damping) : "none gives it";
        impacts.add({std::to_string(i + 1), readable_number(impact.velocity),
                     readable_number(impact.restitution), readable_number(impact.greatest_restitution),
                     (impact.restitution == 0 && impact.damping ? "at least " : "") + damping,
                     impact.contact_time ? readable_number(1e9 * *impact.contact_time) : "captured"});
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
           "Intervals are of 95 % and hold for the contact as given; a case propagates its uncertainty.\n";
}

}  // namespace

void run_measured_damping_command(const DampingOptions& options, std::ostream& out) {
    const ContactChoice choice = read_contact(options.contact);
    if (read_damping(options.contact).law != DampingLaw::constant)
        throw InputError("a series of impacts is read with constant damping", "constant").at("--damping-law");
    const MeasurementSet set = read_impacts(options);
    MeasuredDampingOptions how;
    how.extrapolated = {.order = options.order, .robust = options.robust};
    if (!options.size_scatter.empty()) how.size_scatter = read_size_scatter(options.size_scatter);
    const MeasuredDamping result = analyse_impacts(choice.law, choice.detachment, choice.contact, set, how);
    for (const Finding& finding : result.findings)
        spdlog::warn("warning: {}: {}", options.impacts, finding.text);
    out << (options.json ? write_json(measured_damping_json(result, set), Digits::seventeen)
                         : result_text(result, set));
}

}  // namespace ashimpact

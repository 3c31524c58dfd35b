// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/json/view.hpp"
#include "core/quantities/checks.hpp"
#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "core/units/units.hpp"
#include "pipeline/case/case_parts.hpp"
#include "solver/inference/impacts/impact_rows.hpp"
#include "solver/inference/impacts/measurement.hpp"

namespace ashimpact {

namespace {

void apply_camera(const View& node, MeasuredRestitution& data) {
    const Camera camera = read_camera(node);
    data.impacts = at_place(node.pointer(), [&] { return with_camera(std::move(data.impacts), camera); });
    data.source += fmt::format("; velocities of a camera with {} frames/s and {} a pixel, u = {}",
                               readable_number(camera.frame_rate, 6), readable(camera.pixel_size, "m"),
                               readable(camera.velocity_uncertainty(), "m/s"));
}

void apply_binning(const View& node, MeasuredRestitution& data) {
    Binning binning;
    if (const auto count = node.find("impacts_per_bin")) binning.impacts_per_bin = count->integer();
    if (const auto width = node.find("width")) {
        binning.width = positive_quantity(*width, "width", Dimension::velocity).value;
        static_cast<void>(width->certain_number(Dimension::velocity, "the width alone"));
    }
    const std::size_t before = data.impacts.rebounds();
    data.impacts = at_place(node.pointer(), [&] { return binned(data.impacts, binning); });
    data.source += fmt::format("; {} rebounds in {} bins", before, data.impacts.rebounds());
}

/// A column that must be as long as that of the velocities.
std::vector<double> read_column(const View& parent, const char* key, Dimension dimension,
                                std::size_t length) {
    const View node = parent.at(key);
    std::vector<double> values = node.column(dimension);
    if (values.size() != length)
        node.fail("has " + std::to_string(values.size()) + " values, velocity has " + std::to_string(length),
                  "one value for each velocity");
    return values;
}

/// Whether one of two columns is given. @throws InputError if both are
bool has_either(const View& node, const char* first, const char* second) {
    if (node.has(first) && node.has(second))
        node.at(second).fail(in_quotes(first) + " is given too", "one of the two");
    return node.has(first) || node.has(second);
}

void read_rebounds(const View& node, MeasurementSet& set) {
    constexpr auto by_ratio = "restitution";
    constexpr auto by_velocity = "rebound_velocity";
    if (!has_either(node, by_ratio, by_velocity))
        node.fail("neither restitution nor rebound_velocity is given", "one of the two");
    const bool ratio = node.has(by_ratio);
    const std::vector<double> values =
        read_column(node, ratio ? by_ratio : by_velocity, ratio ? Dimension::fraction : Dimension::velocity,
                    set.points.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        set.points[i].rebound = ratio ? values[i] * set.points[i].velocity : values[i];
}

void read_noise(const View& node, MeasurementSet& set) {
    constexpr auto of_ratio = "restitution_uncertainty";
    constexpr auto of_velocity = "rebound_uncertainty";
    const std::size_t length = set.points.size();
    const bool known = node.has("velocity_uncertainty");
    if (has_either(node, of_velocity, of_ratio) != known)
        node.fail("an uncertainty of the velocities before and after belongs to the other one",
                  "velocity_uncertainty with rebound_uncertainty or restitution_uncertainty");
    if (!known && node.has("velocity_correlation"))
        node.fail("the correlation of two velocities is that of their uncertainties, which are not stated",
                  "velocity_uncertainty with rebound_uncertainty or restitution_uncertainty");
    if (!known) return;
    const std::vector<double> incident =
        read_column(node, "velocity_uncertainty", Dimension::velocity, length);
    const bool ratio = node.has(of_ratio);
    if (ratio && node.has("velocity_correlation"))
        node.at("velocity_correlation")
            .fail("may be that of v_in with v_r, or of v_in with e_n", "rebound_uncertainty beside it");
    const std::vector<double> second = read_column(node, ratio ? of_ratio : of_velocity,
                                                   ratio ? Dimension::fraction : Dimension::velocity, length);
    std::vector<double> correlation(length, 0.0);
    if (node.has("velocity_correlation"))
        correlation = read_column(node, "velocity_correlation", Dimension::fraction, length);
    for (std::size_t i = 0; i < length; ++i) {
        Measurement& point = set.points[i];
        point.noise = VelocityNoise::of_velocities(incident[i], second[i]);
        point.noise->covariance = correlation[i] * incident[i] * second[i];
        if (ratio)
            point.noise =
                VelocityNoise::of_restitution(point.velocity, point.restitution(), incident[i], second[i]);
    }
}

/// Whether three standard uncertainties explain a rebound as fast as the impact or faster.
bool explained(const Measurement& point) {
    if (!point.noise) return false;
    const double variance = point.noise->incident + point.noise->rebound - 2 * point.noise->covariance;
    return point.rebound - point.velocity <= 3 * std::sqrt(variance);
}

/// Refuses impacts that the columns of a case hold twice, or doubts them, as those of a file: "line 21" is
/// the 21st value. @throws InputError
void check_repeated(const View& node, MeasurementSet& set) {
    RepeatedRows repeated;
    for (std::size_t i = 0; i < set.points.size(); ++i)
        repeated.take({i + 1, {shortest(set.points[i].velocity), shortest(set.points[i].rebound)}}, 0, 1);
    at_place(node.pointer(), [&] {
        if (auto doubt = repeated.doubtful("value",
                                           "each impact once; or a table with a first column that numbers "
                                           "all rows, as \"file\""))
            set.warnings.push_back(*std::move(doubt));
    });
}

std::string place_of(const Measurement& point, std::size_t index) {
    return point.line > 0 ? "line " + std::to_string(point.line) : "point " + std::to_string(index + 1);
}

}  // namespace

/// Refuses a bare number of frames per second that a camera of impacts seldom has. @throws InputError
static double plausible_frame_rate(double bare) {
    constexpr double least = 500, kilo = 1000;
    if (bare > 0 && bare < least)
        throw InputError(
            shortest(bare) + " has no unit and is " + shortest(bare) + " frames per second, did you mean " +
                shortest(bare) + " kHz?",
            shortest(kilo * bare) + ", or a number with its unit, \"" + shortest(bare) + " Hz\"");
    return bare;
}

double read_frame_rate(std::string_view text) {
    std::string_view rest = trimmed(text);
    double number = 0;
    const bool is_number = take_decimal(rest, number) == std::errc{};
    rest = trimmed(rest);
    const std::string unit = rest == "fps" || rest == "1/s" ? "Hz" : ascii_unit(rest);
    const auto known = rest.empty() ? Unit{} : read_unit(unit);
    const bool is_frequency =
        rest.empty() || (known && unit != "rpm" && known->powers == read_unit("Hz")->powers);
    if (!is_number || !is_frequency)
        throw InputError("is " + in_quotes(text), "frames per second, e.g. 80000, \"80 kHz\"");
    if (known->factor == 1) refuse_thousands_point(trimmed(text), PointDigits::any);
    return rest.empty() ? plausible_frame_rate(number) : number * known->factor;
}

/// Refuses an uncertainty, which would be one of scale. @throws InputError
const View& certain(const View& node, Dimension dimension) {
    static_cast<void>(node.certain_number(dimension, "\"velocity_scale_uncertainty\" under \"fit\" for it"));
    return node;
}

Camera read_camera(const View& node) {
    const View rate = node.at("frame_rate");
    Camera camera{
        .frame_rate = rate.is_string()
                          ? at_place(rate.pointer(), [&] { return read_frame_rate(rate.text()); })
                          : at_place(rate.pointer(),
                                     [&] { return plausible_frame_rate(rate.number(Dimension::fraction)); }),
        .pixel_size = positive_quantity(certain(node.at("pixel_size"), Dimension::length), "pixel size",
                                        Dimension::length)
                          .value};
    if (const auto frames = node.find("frames")) camera.frames = frames->integer();
    if (const auto position = node.find("position_in_pixels"))
        camera.position_in_pixels = position->number(Dimension::fraction);
    at_place(node.pointer(), [&] { static_cast<void>(camera.velocity_uncertainty()); });
    return camera;
}

MeasuredRestitution read_measured(const View& node, InputFiles& files, const std::optional<View>& camera) {
    MeasuredRestitution data{.source = "the case file"};
    if (const auto file = node.find("file")) {
        const std::string name = file->text();
        data.source = name;
        data.impacts = at_place(file->pointer(), [&] {
            return files.impacts(name, read_table_options(node, "sheet", "decimal"));
        });
    } else {
        data.impacts = read_measurement_columns(node);
        check_repeated(node, data.impacts);
    }
    if (const auto source = node.find("source")) data.source = source->text();
    if (const auto own = node.find("camera")) {
        apply_camera(*own, data);
    } else if (camera && !data.impacts.has_noise()) {
        apply_camera(*camera, data);
        data.by_camera_of_case = true;
    }
    const auto place = node.find("file");
    at_place((place ? *place : node).pointer(), [&] {
        if (!place) return check_impacts(data.impacts);
        at_place(FileName{files.shown(place->text())}, [&] { check_impacts(data.impacts); });
    });
    if (const auto binning = node.find("binning")) apply_binning(*binning, data);
    return data;
}

MeasuredDampingOptions read_fit_options(const std::optional<View>& node) {
    MeasuredDampingOptions options;
    if (!node) return options;
    const auto set_fraction = [&](const char* key, const auto& set) {
        const auto member = node->find(key);
        if (!member) return;
        const double value = member->certain_number(Dimension::fraction, "a number without one");
        const bool is_bare =
            !member->is_string() ? member->json().is_number() : whole_decimal(member->text()).has_value();
        at_place(member->pointer(), [&] { require_relative(value, is_bare); });
        set(value);
    };
    const auto set_number = [&](const char* key, auto& option) {
        if (const auto number = node->find(key)) option = number->number(Dimension::fraction);
    };
    if (const auto order = node->find("order")) options.extrapolated.order = order->integer();
    if (const auto robust = node->find("robust")) options.extrapolated.robust = robust->truth();
    set_fraction("size_scatter", [&](double value) { options.estimate.size_scatter = value; });
    set_fraction("velocity_scale_uncertainty",
                 [&](double value) { options.estimate.scale_uncertainty = value; });
    set_number("flatness", options.parts.flatness);
    set_number("outlier", options.parts.outlier);
    return options;
}

void require_relative(double value, bool is_bare, double most) {
    constexpr double most_bare = 0.1;  // above it a % left out is likelier
    const std::string as_fraction = readable_number(100 * value) + " %";
    const std::string as_per_cent = shortest(value) + " %";
    if (is_bare && value > most_bare)
        throw InputError(shortest(value) + " without a unit is " + as_fraction + " or " + as_per_cent,
                         in_quotes(value > most ? as_per_cent : as_fraction) +
                             (value > most ? "" : " or " + in_quotes(as_per_cent)));
    if (!(value > 0 && value <= most))
        throw InputError("is " + readable_number(value),
                         "a relative standard one above 0, at most " + shortest(most));
}

UncertaintyChoices read_uncertainty_choices(const std::optional<View>& node) {
    UncertaintyChoices choices;
    if (!node) return choices;
    if (const auto samples = node->find("samples")) choices.propagation.samples = samples->integer();
    if (const auto count = node->find("replicates")) choices.propagation.replicates = count->integer();
    if (const auto seed = node->find("seed"))
        choices.propagation.seed = static_cast<unsigned long>(seed->integer());
    if (const auto damping = node->find("damping")) choices.reread = damping->text() == "reread";
    return choices;
}

MeasurementSet read_measurement_columns(const View& node) {
    MeasurementSet set{.source = "the case file", .points = {}};
    for (const double velocity : node.at("velocity").column(Dimension::velocity))
        set.points.push_back({.velocity = velocity, .rebound = 0.0});
    read_rebounds(node, set);
    read_noise(node, set);
    if (node.has("tangential_velocity")) {
        const std::vector<double> along =
            read_column(node, "tangential_velocity", Dimension::velocity, set.points.size());
        for (std::size_t i = 0; i < along.size(); ++i) set.points[i].tangential = along[i];
    }
    if (node.has("rebound_resolution")) {
        const std::vector<double> seen =
            read_column(node, "rebound_resolution", Dimension::velocity, set.points.size());
        for (std::size_t i = 0; i < seen.size(); ++i) {
            at_place(node.at("rebound_resolution").pointer(),
                     [&] { require_not_negative("rebound resolution", seen[i], Dimension::velocity); });
            set.points[i].resolution = seen[i];
        }
    }
    if (node.has("noted_capture")) {
        const std::vector<double> noted =
            read_column(node, "noted_capture", Dimension::fraction, set.points.size());
        for (std::size_t i = 0; i < noted.size(); ++i) {
            Measurement& point = set.points[i];
            if (!(noted[i] == 0 || (noted[i] == 1 && point.rebound == 0)))
                node.at("noted_capture")
                    .fail("value " + std::to_string(i + 1) + " is " + shortest(noted[i]),
                          "1 for an impact without rebound that was seen to stick, else 0");
            if (noted[i] == 1) point.outcome = NotedOutcome::capture;
        }
    }
    if (node.has("impacts")) {
        const std::vector<double> counts =
            read_column(node, "impacts", Dimension::fraction, set.points.size());
        for (std::size_t i = 0; i < counts.size(); ++i) {
            if (!(counts[i] >= 1 && counts[i] == std::round(counts[i])))
                node.at("impacts").fail("value " + std::to_string(i + 1) + " is " + shortest(counts[i]),
                                        "whole numbers from 1 on");
            set.points[i].count = static_cast<std::size_t>(counts[i]);
        }
    }
    return set;
}

MeasurementSet read_impacts(std::string_view text, const std::string& name, const TableOptions& options) {
    MeasurementSet set = read_measurements(text, name, options);
    at_place(FileName{name}, [&] { check_impacts(set); });
    return set;
}

void check_impacts(const MeasurementSet& set) {
    if (set.rebound_alone_uncertain)
        throw InputError("the uncertainty of the velocities after the impact belongs to one of those before",
                         "a column u(v_in) beside u(v_r), or the camera of both");
    for (std::size_t i = 0; i < set.points.size(); ++i) {
        const Measurement& point = set.points[i];
        at_place(place_of(point, i), [&] {
            require_positive("velocity", point.velocity, Dimension::velocity);
            const double e = point.restitution();
            if (!(e >= 0)) throw InputError("restitution is " + shortest(e), "0 <= restitution < 1");
            if (e >= 1 && !explained(point))
                throw InputError("restitution is " + shortest(e),
                                 "0 <= restitution < 1, or uncertainties that explain it");
        });
    }
    validate(set);
}

}  // namespace ashimpact

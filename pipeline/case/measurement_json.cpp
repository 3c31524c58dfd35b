// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/case/measurement_json.hpp"

#include <algorithm>
#include <cmath>

#include "core/json/view.hpp"
#include "core/quantities/checks.hpp"
#include "core/text/text.hpp"

namespace ashimpact {

namespace {

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
    if (!known) return;
    const std::vector<double> incident =
        read_column(node, "velocity_uncertainty", Dimension::velocity, length);
    const bool ratio = node.has(of_ratio);
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

std::string place_of(const Measurement& point, std::size_t index) {
    return point.line > 0 ? "line " + std::to_string(point.line) : "point " + std::to_string(index + 1);
}

}  // namespace

MeasurementSet read_measurement_columns(const View& node) {
    MeasurementSet set{.source = "the case file", .points = {}};
    for (const double velocity : node.at("velocity").column(Dimension::velocity))
        set.points.push_back({.velocity = velocity, .rebound = 0.0});
    read_rebounds(node, set);
    read_noise(node, set);
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

void check_impacts(const MeasurementSet& set) {
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

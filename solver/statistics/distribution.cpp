// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/statistics/distribution.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "solver/numeric/gsl/statistics.hpp"
#include "solver/statistics/normal_lanes.hpp"

namespace ashimpact {

namespace {

/// The standard normal distribution between two cuts.
CutNormal cut_normal(double lower, double upper) {
    // Probabilities round to 1 in the upper tail, so a range there is mirrored, which keeps its digits.
    const bool mirrored = lower > 0;
    const double below = gsl::normal_probability(mirrored ? -upper : lower);
    return {below, gsl::normal_probability(mirrored ? -lower : upper) - below, mirrored};
}

void convert(const Choice& choice, std::span<double> values) {
    const auto count = static_cast<double>(choice.values.size());
    for (double& value : values) value = choice.values[static_cast<std::size_t>(value * count)];
}

void convert(const Uniform& uniform, std::span<double> values) {
    Eigen::Map<Eigen::ArrayXd> all(values.data(), std::ssize(values));
    all = uniform.from + all * (uniform.to - uniform.from);
}

void convert(const LogUniform& uniform, std::span<double> values) {
    const double from = std::log(uniform.from);
    const double width = std::log(uniform.to) - from;
    for (double& value : values) value = std::clamp(std::exp(from + value * width), uniform.from, uniform.to);
}

void convert(const Normal& normal, std::span<double> values) {
    const auto standard = [&](double x) { return (x - normal.mean) / normal.standard_deviation; };
    to_normal_quantiles(cut_normal(standard(normal.minimum), standard(normal.maximum)),
                        {normal.mean, normal.standard_deviation, false, normal.minimum, normal.maximum},
                        values);
}

void convert(const LogNormal& normal, std::span<double> values) {
    const double spread = std::log(normal.geometric_standard_deviation);
    const auto standard = [&](double x) { return std::log(x / normal.median) / spread; };
    to_normal_quantiles(cut_normal(standard(normal.minimum), standard(normal.maximum)),
                        {spread, normal.median, true, normal.minimum, normal.maximum}, values);
}

void convert(const Triangular& triangular, std::span<double> values) {
    const double width = triangular.to - triangular.from;
    const double rising = triangular.mode - triangular.from;
    const double falling = triangular.to - triangular.mode;
    for (double& value : values)
        value = value * width < rising ? triangular.from + std::sqrt(value * width * rising)
                                       : triangular.to - std::sqrt((1 - value) * width * falling);
}

template <class Kind>
Support support(const Kind& kind) {
    if constexpr (requires { kind.from; }) {
        return {kind.from, kind.to};
    } else if constexpr (requires { kind.minimum; }) {
        return {kind.minimum, kind.maximum};
    } else {
        const auto [lowest, highest] = std::minmax_element(kind.values.begin(), kind.values.end());
        return {*lowest, *highest};
    }
}

/// @param place value at point 1, 2, ...; both ends are met exactly
template <class Place>
std::vector<double> points_between(double from, double to, int points, const Place& place) {
    std::vector<double> result(static_cast<std::size_t>(points), from);
    for (int i = 1; i < points; ++i) result[static_cast<std::size_t>(i)] = place(i);
    if (points > 1) result.back() = to;
    return result;
}

}  // namespace

Distribution normal_around(double value, double standard_uncertainty) {
    return Normal{.mean = value, .standard_deviation = standard_uncertainty};
}

Distribution lognormal_around(double value, double standard_uncertainty) {
    return LogNormal{.median = value, .geometric_standard_deviation = std::exp(standard_uncertainty / value)};
}

Distribution uniform_around(double value, double standard_uncertainty) {
    const double half = std::sqrt(3.0) * standard_uncertainty;
    return Uniform{.from = value - half, .to = value + half};
}

void to_quantiles(const Distribution& distribution, std::span<double> probabilities) {
    std::visit([&](const auto& kind) { convert(kind, probabilities); }, distribution);
}

Support support_of(const Distribution& distribution) {
    return std::visit([](const auto& kind) { return support(kind); }, distribution);
}

std::vector<double> linear_grid(double from, double to, int points) {
    return points_between(from, to, points, [&](int i) { return from + (to - from) * i / (points - 1); });
}

std::vector<double> logarithmic_grid(double from, double to, int points) {
    return points_between(from, to, points, [&](int i) {
        return from * std::pow(to / from, static_cast<double>(i) / (points - 1));
    });
}

}  // namespace ashimpact

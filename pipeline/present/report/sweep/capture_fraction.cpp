// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/report/sweep/capture_fraction.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "pipeline/app/sweep/spec/impacts.hpp"
#include "solver/statistics/design.hpp"

namespace ashimpact::report {

namespace {

constexpr std::size_t slices = 16;
constexpr std::size_t few = 24;  ///< values that are shown one by one

using Values = std::vector<std::vector<double>>;

Values variable_values(const SweepSpec& spec) {
    std::vector<Distribution> distributions;
    for (const SweepVariable& variable : spec.variables) distributions.push_back(variable.distribution);
    Sampling sampling = spec.sampling;
    if (sampling.method != SamplingMethod::grid) sampling.points = std::min(sampling.points, capture_impacts);
    const Design design(distributions, sampling);
    const auto points = static_cast<std::size_t>(std::min(design.points(), 8 * capture_impacts));
    Values values(design.variables(), std::vector<double>(points));
    for (std::size_t i = 0; i < values.size(); ++i) design.fill(0, i, 0, values[i]);
    return values;
}

/// 1 for each impact that is captured.
std::vector<double> captured(const SweepSpec& spec, const Values& values, const LawChoice& choice) {
    const ImpactColumns impacts(spec, values, values.front().size());
    const ImpactBatchResult result =
        solve_impacts(batch_of({choice.law, choice.detachment, spec.damping_law}, impacts),
                      {.threads = 0, .turning_point = false});
    std::vector<double> flags(static_cast<std::size_t>(result.restitution.size()));
    for (std::size_t i = 0; i < flags.size(); ++i)
        flags[i] = result.restitution[static_cast<Eigen::Index>(i)] > 0 ? 0 : 1;
    return flags;
}

CaptureShare share_of(double value, double captures, double count) {
    const double fraction = captures / count;
    return {value, fraction, std::sqrt(std::max(fraction * (1 - fraction), 0.25 / count) / count)};
}

std::vector<CaptureShare> shares_of(const std::vector<double>& variable, const std::vector<double>& flags) {
    std::vector<std::size_t> order(variable.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return variable[a] < variable[b]; });
    const bool listed = std::set<double>(variable.begin(), variable.end()).size() <= few;
    std::vector<CaptureShare> shares;
    for (std::size_t first = 0; first < order.size();) {
        std::size_t end = std::min(order.size(), (shares.size() + 1) * order.size() / slices);
        if (listed)
            for (end = first + 1; end < order.size() && variable[order[end]] == variable[order[first]];)
                ++end;
        end = std::max(end, first + 1);
        double captures = 0;
        for (std::size_t i = first; i < end; ++i) captures += flags[order[i]];
        shares.push_back(
            share_of(variable[order[(first + end) / 2]], captures, static_cast<double>(end - first)));
        first = end;
    }
    return shares;
}

}  // namespace

std::vector<CaptureCurve> capture_curves(const SweepSpec& spec) {
    std::vector<CaptureCurve> curves;
    if (spec.variables.empty()) return curves;
    const Values values = variable_values(spec);
    for (std::size_t law = 0; law < spec.laws.size(); ++law) {
        const std::vector<double> flags = captured(spec, values, spec.laws[law]);
        for (std::size_t variable = 0; variable < spec.variables.size(); ++variable)
            curves.push_back({law, variable, shares_of(values[variable], flags)});
    }
    return curves;
}

}  // namespace ashimpact::report

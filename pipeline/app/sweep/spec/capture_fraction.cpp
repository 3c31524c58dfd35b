// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/sweep/spec/capture_fraction.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "pipeline/app/sweep/spec/impacts.hpp"
#include "solver/statistics/design.hpp"

namespace ashimpact {

namespace {

using report::CaptureShare;

constexpr std::uint64_t capture_impacts = 8192;
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

report::CaptureFractions capture_fractions(const SweepSpec& spec) {
    report::CaptureFractions fractions{
        .impacts =
            std::min<std::uint64_t>(capture_impacts, std::max<std::uint64_t>(spec.sampling.points, 1))};
    for (const SweepVariable& variable : spec.variables)
        fractions.variables.push_back(
            {.name = std::string(name_of(variable.input)),
             .unit = std::string(si_unit(dimension_of(variable.input, spec.damping_law)))});
    if (spec.variables.empty()) return fractions;
    const Values values = variable_values(spec);
    for (const LawChoice& choice : spec.laws) {
        const std::vector<double> flags = captured(spec, values, choice);
        for (std::size_t i = 0; i < values.size(); ++i)
            fractions.variables[i].curves.push_back({choice.law, shares_of(values[i], flags)});
    }
    return fractions;
}

report::CaptureFractions capture_fractions(const Json& artifact) {
    return capture_fractions(read_sweep_spec(artifact.at("provenance").at("options").dump()).spec);
}

}  // namespace ashimpact

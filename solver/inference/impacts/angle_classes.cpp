// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/impacts/angle_classes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "solver/numeric/gsl/statistics.hpp"

namespace ashimpact {

namespace {

constexpr std::size_t fewest_in_class = 4;
constexpr std::size_t most_classes = 3;
constexpr double apart = 3 * std::numbers::pi / 180;  ///< of the mean angles of neighbours
constexpr double outlying = 4;                        ///< robust standard deviations

/// The residual of a rebound.
struct AtAngle {
    double angle;
    double residual;  ///< of ln eta
};

std::vector<AtAngle> residuals_by_angle(const MeasurementSet& set,
                                        const std::vector<InvertedImpact>& inverted,
                                        const DampingSmoothing& smoothing) {
    std::set<std::size_t> outliers;
    for (const auto& residual : smoothing.residuals())
        if (std::abs(residual.value) > outlying) outliers.insert(residual.index);
    std::vector<AtAngle> all;
    for (const InvertedImpact& impact : inverted) {
        const Measurement& point = set.points[impact.index];
        if (!point.tangential || !(impact.restitution > 0) || !impact.damping || !(*impact.damping > 0) ||
            outliers.contains(impact.index))
            continue;
        const double curve = smoothing.at(impact.velocity).damping;
        if (!(curve > 0)) continue;
        all.push_back(
            {std::atan2(std::abs(*point.tangential), point.velocity), std::log(*impact.damping / curve)});
    }
    std::ranges::sort(all, {}, [](const AtAngle& each) { return std::pair(each.angle, each.residual); });
    return all;
}

/// Ends of classes in rebounds sorted by angle: equal numbers, moved to the widest gap nearby.
std::vector<std::size_t> ends_of_classes(const std::vector<AtAngle>& all) {
    const std::size_t classes = std::min(most_classes, all.size() / fewest_in_class);
    std::vector<std::size_t> ends;
    for (std::size_t k = 1; k < classes; ++k) {
        const std::size_t middle = k * all.size() / classes;
        const std::size_t reach = std::max<std::size_t>(1, all.size() / (3 * classes));
        std::size_t best = middle;
        for (std::size_t i = middle - std::min(reach, middle - 1);
             i <= std::min(middle + reach, all.size() - 1); ++i)
            if (all[i].angle - all[i - 1].angle > all[best].angle - all[best - 1].angle) best = i;
        const std::size_t before = ends.empty() ? 0 : ends.back();
        if (best >= before + fewest_in_class) ends.push_back(best);
    }
    if (!ends.empty() && all.size() < ends.back() + fewest_in_class) ends.pop_back();
    ends.push_back(all.size());
    return ends;
}

double mean_of(const std::vector<AtAngle>& all, std::size_t from, std::size_t to, double AtAngle::*member) {
    double sum = 0;
    for (std::size_t i = from; i < to; ++i) sum += all[i].*member;
    return sum / static_cast<double>(to - from);
}

}  // namespace

std::optional<AngleComparison> compare_angles(const MeasurementSet& set,
                                              const std::vector<InvertedImpact>& inverted,
                                              const std::optional<DampingSmoothing>& smoothing) {
    if (!smoothing) return std::nullopt;
    const std::vector<AtAngle> all = residuals_by_angle(set, inverted, *smoothing);
    if (all.size() < 2 * fewest_in_class) return std::nullopt;
    std::vector<std::size_t> ends;
    double last = -1;
    for (const std::size_t end : ends_of_classes(all)) {
        const double mean = mean_of(all, ends.empty() ? 0 : ends.back(), end, &AtAngle::angle);
        if (!ends.empty() && mean - last < apart) ends.pop_back();  // joined with the class before
        last = mean;
        ends.push_back(end);
    }
    if (ends.size() < 2) return std::nullopt;
    const double total = mean_of(all, 0, all.size(), &AtAngle::residual);
    double between = 0;
    double within = 0;
    std::size_t first = 0;
    AngleComparison comparison{{}, 1};
    for (const std::size_t end : ends) {
        const double mean = mean_of(all, first, end, &AtAngle::residual);
        between += static_cast<double>(end - first) * (mean - total) * (mean - total);
        for (std::size_t i = first; i < end; ++i)
            within += (all[i].residual - mean) * (all[i].residual - mean);
        comparison.classes.push_back({all[first].angle, all[end - 1].angle, end - first, mean - total, 0});
        first = end;
    }
    const auto groups = static_cast<double>(ends.size());
    const double freedom = static_cast<double>(all.size()) - groups;
    const double variance = within / freedom;
    for (AngleClass& each : comparison.classes)
        each.standard_uncertainty = std::sqrt(variance / static_cast<double>(each.rebounds));
    comparison.probability =
        variance > 0 ? gsl::variance_ratio_exceedance(between / (groups - 1) / variance, groups - 1, freedom)
                     : 1;
    return comparison;
}

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/curve/recorded_impacts.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace ashimpact {

namespace {

/// Sums over impacts that are merged into one.
struct Sums {
    double count = 0.0;
    double velocity = 0.0;
    double rebound = 0.0;
    double incident_variance = 0.0;
    double rebound_variance = 0.0;
    double covariance = 0.0;

    void add(const RecordedImpact& impact) {
        count += impact.count;
        velocity += impact.count * impact.velocity;
        rebound += impact.count * impact.rebound;
        incident_variance += impact.count * impact.incident_u * impact.incident_u;
        rebound_variance += impact.count * impact.rebound_u * impact.rebound_u;
        covariance += impact.count * impact.correlation * impact.incident_u * impact.rebound_u;
    }
    /// The merged impact. @param share of the variance that it has: 1, or 1/n for a mean @param counts its
    /// weight
    [[nodiscard]] RecordedImpact impact(RecordedImpact like, double share, double counts) const {
        like.velocity = velocity / count;
        like.log_velocity = std::log(like.velocity);
        like.rebound = rebound / count;
        like.incident_u = std::sqrt(share * incident_variance / count);
        like.rebound_u = std::sqrt(share * rebound_variance / count);
        like.correlation = covariance / std::sqrt(incident_variance * rebound_variance);
        like.count = counts;
        return like;
    }
};

/// The cell of a value. Widths are rounded down to a power of the fourth root of two, so that values whose
/// widths differ little share the borders of their cells.
std::tuple<long, long> cell_of(double value, double width) {
    const double level = std::floor(4.0 * std::log2(width));
    return {std::lround(level), std::lround(value / std::exp2(0.25 * level))};
}

/// Merges impacts in cells at most half as wide as the noise, but at least a thousandth of the velocity.
std::vector<RecordedImpact> in_cells(const std::vector<RecordedImpact>& impacts) {
    using Cell = std::tuple<long, long>;
    std::map<std::tuple<Recorded, Cell, Cell>, std::pair<RecordedImpact, Sums>> cells;
    for (const RecordedImpact& impact : impacts) {
        const double width = std::max(0.5 * impact.incident_u, 1e-3 * impact.velocity);
        const double height = std::max(0.5 * impact.rebound_u, 1e-3 * impact.velocity);
        const bool reading = impact.recorded == Recorded::rebound;
        const auto key = std::tuple(impact.recorded, cell_of(impact.velocity, width),
                                    reading ? cell_of(impact.rebound, height) : Cell{});
        auto& cell = cells.try_emplace(key, impact, Sums{}).first->second;
        cell.second.add(impact);
    }
    std::vector<RecordedImpact> result;
    result.reserve(cells.size());
    for (const auto& [key, cell] : cells)
        result.push_back(cell.second.impact(cell.first, 1.0, cell.second.count));
    return result;
}

}  // namespace

std::vector<RecordedImpact> recorded_impacts(const MeasurementSet& set) {
    std::vector<RecordedImpact> impacts;
    impacts.reserve(set.points.size());
    for (const Measurement& point : set.sorted()) {
        const Recorded recorded = point.outcome == NotedOutcome::capture ? Recorded::capture
                                  : point.captured()                     ? Recorded::zero
                                                                         : Recorded::rebound;
        const auto count = static_cast<double>(point.count);
        const VelocityNoise noise = point.noise.value_or(VelocityNoise{1.0, 1.0});
        impacts.push_back({.recorded = recorded,
                           .velocity = point.velocity,
                           .log_velocity = std::log(point.velocity),
                           .rebound = point.rebound,
                           .incident_u = std::sqrt(noise.incident),
                           .rebound_u = std::sqrt(noise.rebound),
                           .correlation = noise.covariance / std::sqrt(noise.incident * noise.rebound),
                           .resolution = point.resolution,
                           .count = recorded == Recorded::rebound ? 1.0 : count});
    }
    return impacts;
}

double noise_of_neighbours(const std::vector<RecordedImpact>& impacts, double share) {
    constexpr std::size_t fewest = 12;
    std::vector<RecordedImpact> rebounds;
    for (const RecordedImpact& impact : impacts)
        if (impact.recorded == Recorded::rebound) rebounds.push_back(impact);
    std::ranges::sort(rebounds, {}, &RecordedImpact::velocity);
    const auto slowest = static_cast<std::size_t>(share * static_cast<double>(rebounds.size()));
    if (const std::size_t kept = std::max(slowest, fewest); kept < rebounds.size())
        rebounds.erase(rebounds.begin() + static_cast<std::ptrdiff_t>(kept), rebounds.end());
    // Squared distance of each middle rebound from the line through its two neighbours.
    std::vector<double> squares;
    for (std::size_t i = 1; i + 1 < rebounds.size(); ++i) {
        const RecordedImpact& a = rebounds[i - 1];
        const RecordedImpact& b = rebounds[i + 1];
        const double span = b.velocity - a.velocity;
        const double t = span > 0.0 ? (rebounds[i].velocity - a.velocity) / span : 0.5;
        const double distance = rebounds[i].rebound - (1.0 - t) * a.rebound - t * b.rebound;
        // The slope of v_r over v_in is taken as 0.5: noise of v_in counts a quarter.
        squares.push_back(distance * distance / (1.25 * (1.0 + (1.0 - t) * (1.0 - t) + t * t)));
    }
    if (squares.empty()) return 1.0;
    const auto middle = squares.begin() + static_cast<std::ptrdiff_t>(squares.size() / 2);
    std::nth_element(squares.begin(), middle, squares.end());
    constexpr double median_of_chi_squared = 0.4549;
    return std::sqrt(*middle / median_of_chi_squared);
}

std::vector<RecordedImpact> grouped(std::vector<RecordedImpact> impacts) {
    std::ranges::sort(impacts, {}, &RecordedImpact::velocity);
    std::vector<double> captures;
    std::vector<double> rebounds;
    for (const RecordedImpact& impact : impacts)
        (impact.recorded == Recorded::rebound ? rebounds : captures).push_back(impact.velocity);
    if (rebounds.empty()) return in_cells(impacts);
    // Below this velocity captures occur, apart from half a per cent of outliers.
    const double slowest = rebounds[rebounds.size() / 200];
    const double fastest_capture =
        captures.empty() ? 0.0 : captures[captures.size() - 1 - captures.size() / 200];
    const double end = 1.3 * std::max(slowest, fastest_capture);
    std::vector<RecordedImpact> slow;
    std::vector<RecordedImpact> result;
    const double width = (impacts.back().velocity - end) / 600.0;
    Sums sums;
    const RecordedImpact* first = nullptr;
    const auto close = [&] {
        if (first != nullptr) result.push_back(sums.impact(*first, 1.0 / sums.count, 1.0));
        sums = {};
        first = nullptr;
    };
    for (const RecordedImpact& impact : impacts) {
        if (impact.velocity < end || impact.recorded != Recorded::rebound) {
            slow.push_back(impact);
            continue;
        }
        if (first != nullptr && impact.velocity > first->velocity + width) close();
        if (first == nullptr) first = &impact;
        sums.add(impact);
    }
    close();
    const auto cells = in_cells(slow);
    result.insert(result.end(), cells.begin(), cells.end());
    return result;
}

}  // namespace ashimpact

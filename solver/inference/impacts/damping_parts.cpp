// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/impacts/damping_parts.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/text/error.hpp"
#include "core/text/text.hpp"

namespace ashimpact {

namespace {

constexpr int steps = 400;  ///< of the grid on which parts are looked for

/// Velocities of the smoothed range, evenly spaced in their logarithm [m/s].
std::vector<double> grid_of(const DampingSmoothing& smooth) {
    std::vector<double> velocities;
    for (int i = 0; i <= steps; ++i) {
        const double share = static_cast<double>(i) / steps;
        velocities.push_back(smooth.slowest() * std::pow(smooth.fastest() / smooth.slowest(), share));
    }
    return velocities;
}

std::size_t least_damping(const DampingSmoothing& smooth, const std::vector<double>& grid) {
    const auto least = std::min_element(grid.begin(), grid.end(), [&](double a, double b) {
        return smooth.at(a).damping < smooth.at(b).damping;
    });
    return static_cast<std::size_t>(least - grid.begin());
}

/// The boundary of the flat part, searched from the least damping on.
/// @param direction -1: towards the falling part, +1: towards the rising part
std::optional<PartBoundary> boundary_of(const DampingSmoothing& smooth, const std::vector<double>& grid,
                                        double flatness, int direction) {
    const auto last = direction > 0 ? grid.size() - 1 : std::size_t{0};
    auto i = least_damping(smooth, grid);
    while (i != last && direction * smooth.at(grid[i]).elasticity < flatness)
        i = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + direction);
    if (i == last) return std::nullopt;
    const auto here = smooth.at(grid[i]);
    const auto end = smooth.at(grid[last]);
    if (end.damping - here.damping < 2.0 * std::hypot(end.standard_uncertainty, here.standard_uncertainty))
        return std::nullopt;
    const auto next = smooth.at(grid[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + direction)]);
    const double bend =
        std::abs(next.elasticity - here.elasticity) / (std::log(smooth.fastest() / smooth.slowest()) / steps);
    return PartBoundary{grid[i], grid[i] * here.elasticity_uncertainty / std::max(bend, 1e-3)};
}

[[noreturn]] void refuse_falling(const MeasurementSet& set, double from) {
    throw InputError(
        "there is no rising branch: restitution falls with velocity from " + shortest(from) + " m/s on",
        "impacts from below the velocity of greatest restitution")
        .at(FileName{set.source});
}

/// Whether the restitution of a few rebounds falls with velocity: with three or more it falls in every pair,
/// or in so many pairs that the probability of chance is below 5 % (Kendall's rank test; Mann 1945).
bool falls(const std::vector<Measurement>& rebounds) {
    const auto n = static_cast<double>(rebounds.size());
    if (n < 3.0) return false;
    double score = 0.0;
    for (std::size_t i = 0; i < rebounds.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const double product = (rebounds[i].velocity - rebounds[j].velocity) *
                                   (rebounds[i].restitution() - rebounds[j].restitution());
            score += product > 0.0 ? 1.0 : product < 0.0 ? -1.0 : 0.0;
        }
    }
    if (score <= -0.5 * n * (n - 1.0)) return true;
    constexpr double one_sided = 1.645;
    return score + 1.0 < -one_sided * std::sqrt(n * (n - 1.0) * (2.0 * n + 5.0) / 18.0);
}

/// Refuses a series too short for smoothing whose restitution falls. @throws InputError
void refuse_short_falling(const MeasurementSet& set) {
    std::vector<Measurement> rebounds;
    for (const Measurement& point : set.points)
        if (!point.captured()) rebounds.push_back(point);
    if (!falls(rebounds)) return;
    const auto slower = [](const Measurement& a, const Measurement& b) { return a.velocity < b.velocity; };
    refuse_falling(set, std::min_element(rebounds.begin(), rebounds.end(), slower)->velocity);
}

}  // namespace

DampingParts find_parts(const std::optional<DampingSmoothing>& smooth, const PartOptions& options) {
    DampingParts result;
    if (!smooth) {
        result.note = "fewer than " + std::to_string(least_smoothed) +
                      " rebounds within reach, or too few velocities, for parts to be told apart";
        return result;
    }
    for (const auto& residual : smooth->residuals()) {
        if (std::abs(residual.value) > options.outlier) result.outliers.push_back(residual.index);
    }
    std::sort(result.outliers.begin(), result.outliers.end());
    const std::vector<double> grid = grid_of(*smooth);
    const auto falling = boundary_of(*smooth, grid, options.flatness, -1);
    const auto rising = boundary_of(*smooth, grid, options.flatness, +1);
    const double from = falling ? falling->velocity : grid.front();
    const double to = rising ? rising->velocity : grid.back();
    if (falling) result.parts.push_back(DampingPart::falling);
    if (from < to) result.parts.push_back(DampingPart::flat);
    if (rising) result.parts.push_back(DampingPart::rising);
    if (falling && result.parts.size() > 1) result.boundaries.push_back(*falling);
    if (rising && from < to) result.boundaries.push_back(*rising);
    return result;
}

RisingBranch rising_branch(const ContactModel& model, const MeasurementSet& set,
                           const std::optional<DampingSmoothing>& smooth) {
    double upper = 0.0;
    for (const Measurement& point : set.points) upper = std::max(upper, point.velocity);
    if (smooth) {
        const std::vector<double> grid = grid_of(*smooth);
        std::vector<double> restitution;
        restitution.reserve(grid.size());
        for (const double v : grid) restitution.push_back(model.restitution(v, smooth->at(v).damping));
        const auto top = std::max_element(restitution.begin(), restitution.end());
        const auto lowest = std::min_element(top, restitution.end());
        const double v_top = grid[static_cast<std::size_t>(top - restitution.begin())];
        const double v_low = grid[static_cast<std::size_t>(lowest - restitution.begin())];
        const auto uncertainty = [&](double v, double e) {
            return smooth->at(v).standard_uncertainty / std::abs(model.damping(v, e).by_restitution);
        };
        const bool falls_beyond =
            *top - *lowest > 2.0 * std::hypot(uncertainty(v_top, *top), uncertainty(v_low, *lowest));
        if (falls_beyond) upper = v_top;
        if (falls_beyond && top == restitution.begin()) refuse_falling(set, smooth->slowest());
    } else {
        refuse_short_falling(set);
    }
    return impacts_up_to(set, upper);
}

RisingBranch impacts_up_to(const MeasurementSet& set, double upper) {
    RisingBranch branch{
        .set = {set.source, {}, set.warnings}, .indices = {}, .upper = upper, .falls_beyond = false};
    for (std::size_t i = 0; i < set.points.size(); ++i) {
        if (set.points[i].velocity > upper) {
            branch.falls_beyond = true;
            continue;
        }
        branch.set.points.push_back(set.points[i]);
        branch.indices.push_back(i);
    }
    return branch;
}

}  // namespace ashimpact

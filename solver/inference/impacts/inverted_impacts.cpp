// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/impacts/inverted_impacts.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <numeric>
#include <set>
#include <span>
#include <tuple>

#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/motion/damping_inversion.hpp"
#include "solver/numeric/gsl/solvers.hpp"
#include "solver/numeric/gsl/statistics.hpp"
#include "solver/statistics/distribution.hpp"
#include "solver/statistics/moments.hpp"

namespace ashimpact {

namespace {

/// Standard uncertainty of the damping from the noise of the velocities, e = v_r/v_in [kg/s].
std::optional<double> propagated(const Measurement& point, const DampingAt& damping) {
    if (!point.noise) return std::nullopt;
    const double by_rebound = damping.by_restitution / point.velocity;
    const double by_incident = damping.by_velocity - by_rebound * point.restitution();
    const double variance = by_incident * by_incident * point.noise->incident +
                            2.0 * by_incident * by_rebound * point.noise->covariance +
                            by_rebound * by_rebound * point.noise->rebound;
    return std::sqrt(variance);
}

/// An impact for which no damping has been found yet.
InvertedImpact without_damping(std::size_t index, const Measurement& point, double greatest) {
    return {.index = index,
            .velocity = point.velocity,
            .restitution = point.restitution(),
            .greatest_restitution = greatest};
}

constexpr std::size_t rows_per_interval = 8;
constexpr std::size_t most_rows = 200;  ///< more rebounds are averaged in groups before the curve is fitted

double root_mean_square(const std::vector<double>& values) {
    return std::sqrt(std::inner_product(values.begin(), values.end(), values.begin(), 0.0) /
                     static_cast<double>(values.size()));
}

constexpr int grid_steps = 400;  ///< of the grid on which parts are looked for

/// Velocities of the smoothed range, evenly spaced in their logarithm [m/s].
std::vector<double> grid_of(const DampingSmoothing& smooth) {
    return logarithmic_grid(smooth.slowest(), smooth.fastest(), grid_steps + 1);
}

/// The boundary of the flat part, searched from the least damping on.
/// @param direction -1: towards the falling part, +1: towards the rising part
std::optional<PartBoundary> boundary_of(const DampingSmoothing& smooth, const std::vector<double>& grid,
                                        double flatness, int direction) {
    const auto last = direction > 0 ? grid.end() - 1 : grid.begin();
    auto place = std::ranges::min_element(grid, {}, [&](double v) { return smooth.at(v).damping; });
    while (place != last && direction * smooth.at(*place).elasticity < flatness) place += direction;
    if (place == last) return std::nullopt;
    const auto here = smooth.at(*place);
    const auto end = smooth.at(*last);
    if (end.damping - here.damping < 2.0 * std::hypot(end.standard_uncertainty, here.standard_uncertainty))
        return std::nullopt;
    const double bend = std::abs(smooth.at(place[direction]).elasticity - here.elasticity) /
                        (std::log(smooth.fastest() / smooth.slowest()) / grid_steps);
    return PartBoundary{*place, *place * here.elasticity_uncertainty / std::max(bend, 1e-3)};
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
    std::ranges::copy_if(set.points, std::back_inserter(rebounds), std::not_fn(&Measurement::captured));
    if (falls(rebounds))
        refuse_falling(set, std::ranges::min_element(rebounds, {}, &Measurement::velocity)->velocity);
}

}  // namespace

std::vector<InvertedImpact> invert(const ContactModel& model, const MeasurementSet& set) {
    std::vector<InvertedImpact> result(set.points.size());
    const auto invert_one = [&](std::size_t i) {
        const Measurement& point = set.points[i];
        const double e = point.restitution();
        InvertedImpact& inverted = result[i];
        inverted = without_damping(i, point, model.greatest_restitution(point.velocity));
        if (!model.range().contains(point.velocity) || e > inverted.greatest_restitution) return;
        const DampingAt damping = model.damping(point.velocity, e);
        inverted.damping = damping.value;
        inverted.standard_uncertainty = propagated(point, damping);
        if (!point.captured()) inverted.contact_time = model.contact_time(point.velocity, e);
    };
    constexpr std::size_t chunk = 1000;
    batch::for_chunks(result.size(), chunk, 0, [&](std::size_t first, std::size_t size) {
        for (std::size_t i = first; i < first + size; ++i) invert_one(i);
    });
    return result;
}

std::vector<InvertedImpact> invert_by_solving(Law law, Detachment detachment, const ContactPair& contact,
                                              const MeasurementSet& set) {
    constexpr double nudge = 1e-5;  // relative step of the differences
    const auto solved = [&](double velocity, double restitution) {
        return damping_from_restitution(
            {law, detachment, DampingLaw::constant, contact, velocity, restitution});
    };
    const auto damping = [&](double velocity, double restitution) {
        return solved(velocity, restitution).damping.coefficient;
    };
    std::vector<InvertedImpact> result;
    for (std::size_t i = 0; i < set.points.size(); ++i) {
        const Measurement& point = set.points[i];
        const double v = point.velocity;
        const double e = point.restitution();
        const Impact undamped{law, detachment, {DampingLaw::constant, 0.0}, contact, v};
        validate(undamped);
        result.push_back(without_damping(i, point, restitution_of(undamped)));
        InvertedImpact& inverted = result.back();
        if (e >= inverted.greatest_restitution * (1.0 - nudge)) continue;
        const DampingInversion found = solved(v, e);
        inverted.damping = found.damping.coefficient;
        inverted.contact_time = found.impact.contact_time;
        const double lower = e * (1.0 - nudge);
        const double upper = e == 0.0 ? nudge : e * (1.0 + nudge);
        inverted.standard_uncertainty = propagated(
            point, {.value = *inverted.damping,
                    .by_restitution = (damping(v, upper) - damping(v, lower)) / (upper - lower),
                    .by_velocity =
                        (damping(v * (1.0 + nudge), e) - damping(v * (1.0 - nudge), e)) / (2 * nudge * v)});
    }
    return result;
}

/// The data of the smoothing, ordered by velocity.
struct DampingSmoothing::Rows {
    std::vector<double> position;  ///< ln v
    std::vector<double> damping;
    std::vector<double> weight;  ///< 1/u
    std::vector<std::size_t> index;

    void add(double x, double value, double inverse, std::size_t from) {
        position.push_back(x);
        damping.push_back(value);
        weight.push_back(inverse);
        index.push_back(from);
    }
    [[nodiscard]] Rows averaged() const;
    [[nodiscard]] std::vector<double> misfit_of_neighbours() const;
};

/// Difference of each row, but for two at either end, from the cubic through its four neighbours, in units of
/// its uncertainty.
std::vector<double> DampingSmoothing::Rows::misfit_of_neighbours() const {
    std::vector<double> misfit;
    for (std::size_t i = 2; i + 2 < position.size(); ++i) {
        const std::array around{i - 2, i - 1, i + 1, i + 2};
        double cubic = 0.0;
        for (const std::size_t a : around) {
            double share = damping[a];
            for (const std::size_t b : around)
                if (a != b) share *= (position[i] - position[b]) / (position[a] - position[b]);
            cubic += share;
        }
        misfit.push_back((damping[i] - cubic) * weight[i]);
    }
    return misfit;
}

DampingSmoothing::Rows DampingSmoothing::Rows::averaged() const {
    if (position.size() <= most_rows) return *this;
    const std::size_t group = (position.size() + most_rows - 1) / most_rows;
    Rows result;
    for (std::size_t i = 0; i < position.size(); i += group) {
        const std::size_t size = std::min(group, position.size() - i);
        const auto part = [&](const std::vector<double>& all) { return std::span(all).subspan(i, size); };
        const double root = std::sqrt(static_cast<double>(size));
        std::vector<double> middle(part(damping).begin(), part(damping).end());
        constexpr std::array half{0.5};  // the median, so that outliers do not spoil their group
        result.add(Moments::of(part(position)).mean, gsl::quantiles(middle, half).front(),
                   root * Moments::of(part(weight)).mean, index[i]);
    }
    return result;
}

DampingSmoothing::DampingSmoothing(const Rows& rows, const std::vector<double>& breaks)
    : splines_(breaks), first_(rows.position.front()), last_(rows.position.back()) {}

std::optional<DampingSmoothing> DampingSmoothing::with_intervals(const Rows& rows, int intervals) {
    std::vector<double> fractions;
    for (int i = 0; i <= intervals; ++i) fractions.push_back(static_cast<double>(i) / intervals);
    const std::vector<double> breaks = gsl::quantiles(rows.position, fractions);
    if (std::adjacent_find(breaks.begin(), breaks.end(), std::greater_equal<>()) != breaks.end())
        return std::nullopt;
    DampingSmoothing result(rows, breaks);
    const auto count = static_cast<Eigen::Index>(rows.position.size());
    const Eigen::Index size = result.splines_.size();
    if (count < size + 3) return std::nullopt;
    Eigen::MatrixXd design(count, size);
    Eigen::VectorXd observed(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const auto row = static_cast<std::size_t>(i);
        design.row(i) = rows.weight[row] * result.splines_.values(rows.position[row]).transpose();
        observed[i] = rows.weight[row] * rows.damping[row];
    }
    gsl::LinearFit fit;
    try {
        fit = gsl::fit_linear_robust(design, observed);
    } catch (const ConvergenceError&) {
        return std::nullopt;  // too many knots for the data
    }
    result.coefficients_ = fit.parameters;
    result.covariance_ = fit.covariance;
    if (!fit.covariance.allFinite()) {  // most rows are equal: their deviation vanishes
        const double squares = (observed - design * fit.parameters).squaredNorm();
        const Eigen::MatrixXd normal = design.transpose() * design;
        result.covariance_ = normal.completeOrthogonalDecomposition().pseudoInverse() *
                             (squares / static_cast<double>(count - size));
    }
    const auto n = static_cast<double>(count);
    const double p = static_cast<double>(size) + 1.0;
    const double least = 1e-12 * observed.norm();
    const double deviation = std::max(fit.deviation, least);
    result.criterion_ =
        2.0 * n * std::log(deviation) + 2.0 * p + 2.0 * p * (p + 1.0) / std::max(1.0, n - p - 1.0);
    return result;
}

/// The robust spline whose number of knots the corrected Akaike criterion prefers.
std::optional<DampingSmoothing> DampingSmoothing::robust(const Rows& rows) {
    std::optional<DampingSmoothing> best;
    const auto most =
        static_cast<int>(std::clamp<std::size_t>(rows.position.size() / rows_per_interval, 1, 40));
    for (int tried = 1; tried <= most; tried += 1 + tried / 3) {
        auto candidate = with_intervals(rows, tried);
        if (candidate && (!best || candidate->criterion_ < best->criterion_)) best = std::move(candidate);
    }
    return best;
}

/// The spline through all rows, with knots at all of them but the second and the last but one.
DampingSmoothing DampingSmoothing::through(const Rows& rows) {
    std::vector<double> breaks = rows.position;
    breaks.erase(breaks.end() - 2);
    breaks.erase(breaks.begin() + 1);
    DampingSmoothing result(rows, breaks);
    const Eigen::Index size = result.splines_.size();
    Eigen::MatrixXd design(size, size);
    for (Eigen::Index i = 0; i < size; ++i)
        design.row(i) = result.splines_.values(rows.position[static_cast<std::size_t>(i)]).transpose();
    result.coefficients_ =
        design.partialPivLu().solve(Eigen::Map<const Eigen::VectorXd>(rows.damping.data(), size));
    result.covariance_ = Eigen::MatrixXd::Zero(size, size);
    return result;
}

/// Residuals in units of the uncertainty of each row.
std::vector<double> DampingSmoothing::scaled_residuals(const Rows& rows) const {
    std::vector<double> scaled;
    for (std::size_t i = 0; i < rows.position.size(); ++i) {
        const double x = std::clamp(rows.position[i], first_, last_);
        scaled.push_back((rows.damping[i] - splines_.values(x).dot(coefficients_)) * rows.weight[i]);
    }
    return scaled;
}

std::optional<DampingSmoothing> DampingSmoothing::of(const std::vector<InvertedImpact>& inverted) {
    std::vector<const InvertedImpact*> ordered;
    constexpr std::size_t least_velocities = 4;
    std::set<double> velocities;
    for (const InvertedImpact& impact : inverted) {
        if (!impact.damping || impact.restitution == 0.0) continue;
        ordered.push_back(&impact);
        if (velocities.size() < least_velocities) velocities.insert(impact.velocity);
    }
    if (ordered.size() < least_smoothed || velocities.size() < least_velocities) return std::nullopt;
    std::ranges::sort(ordered, {}, [](const InvertedImpact* impact) {
        return std::tuple(impact->velocity, impact->damping, impact->standard_uncertainty);
    });
    Rows rows;
    for (const InvertedImpact* impact : ordered)
        rows.add(std::log(impact->velocity), *impact->damping,
                 1.0 / impact->standard_uncertainty.value_or(*ordered.front()->damping), impact->index);
    auto smooth = robust(rows.averaged());
    if (!smooth) return std::nullopt;
    std::vector<double> scaled = smooth->scaled_residuals(rows);
    // Of noisy data the difference from the neighbours is 1.4 times the noise.
    constexpr double clearly = 0.5;
    const bool distinct = std::adjacent_find(rows.position.begin(), rows.position.end(),
                                             std::greater_equal<>()) == rows.position.end();
    if (distinct && rows.position.size() <= most_rows &&
        root_mean_square(rows.misfit_of_neighbours()) < clearly * root_mean_square(scaled)) {
        smooth = through(rows);
        std::ranges::fill(scaled, 0.0);
    }
    // The misfit of the spline itself must not make outliers of data that hardly scatter.
    const bool known = ordered.front()->standard_uncertainty.has_value();
    const double least = known ? 0.5 : 1e-3;  // in standard uncertainties, or of the damping
    const double deviation = std::max(gsl::robust_deviation(scaled), least);
    for (std::size_t i = 0; i < scaled.size(); ++i)
        smooth->residuals_.push_back({rows.index[i], scaled[i] / deviation});
    return smooth;
}

DampingSmoothing::Value DampingSmoothing::at(double velocity) const {
    const double x = std::clamp(std::log(velocity), first_, last_);
    const Eigen::VectorXd values = splines_.values(x);
    const Eigen::VectorXd slopes = splines_.values(x, 1);
    const double damping = values.dot(coefficients_);
    return {.damping = damping,
            .standard_uncertainty = std::sqrt(std::max(0.0, values.dot(covariance_ * values))),
            .elasticity = slopes.dot(coefficients_) / damping,
            .elasticity_uncertainty = std::sqrt(std::max(0.0, slopes.dot(covariance_ * slopes))) / damping};
}

DampingParts find_parts(const std::optional<DampingSmoothing>& smooth, const PartOptions& options) {
    DampingParts result;
    if (!smooth) {
        result.note = "fewer than " + std::to_string(least_smoothed) +
                      " rebounds within reach, or too few velocities, for parts to be told apart";
        return result;
    }
    for (const auto& residual : smooth->residuals())
        if (std::abs(residual.value) > options.outlier) result.outliers.push_back(residual.index);
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
    double upper = std::ranges::max_element(set.points, {}, &Measurement::velocity)->velocity;
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

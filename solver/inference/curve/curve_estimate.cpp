// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/curve/curve_estimate.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/text.hpp"
#include "solver/statistics/intervals/importance_sampling.hpp"

namespace ashimpact {

namespace {

using Vector = CurvePosterior::Vector;
using Matrix = CurvePosterior::Matrix;
using Draws = ImportanceSampling<CurvePosterior::size>;

constexpr double least_effective = 50.0;  ///< independent draws; fewer give no reliable ends of an interval

struct Mode {
    Draws::NormalDensity normal;
    double value = 0.0;       ///< -ln posterior
    double log_weight = 0.0;  ///< ln of the posterior's integral around it
};

/// Adds the covariance, the inverse of a Hessian. Directions of small or negative curvature get the width of
/// a prior.
Mode with_covariance(Mode mode, const Matrix& hessian) {
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(hessian);
    const Vector values = solver.eigenvalues().cwiseAbs().cwiseMax(0.5);
    mode.normal.covariance =
        solver.eigenvectors() * values.cwiseInverse().asDiagonal() * solver.eigenvectors().transpose();
    mode.log_weight = -mode.value - 0.5 * values.array().log().sum();
    return mode;
}

/// Holds noise and scatter: the posterior has a narrow peak where both are small, which holds little of its
/// weight. They get widths of about their priors.
void hold_scales(CurvePosterior::Curvature& curvature) {
    constexpr double noise_deviation = 0.5;
    for (const int scale : {CurvePosterior::noise, CurvePosterior::scatter}) {
        curvature.gradient[scale] = 0.0;
        curvature.hessian.row(scale).setZero();
        curvature.hessian.col(scale).setZero();
        curvature.hessian(scale, scale) = 1.0;
    }
    curvature.hessian(CurvePosterior::noise, CurvePosterior::noise) /= noise_deviation * noise_deviation;
}

/// The mode at the noise and scatter of @p start, by Newton's method with a Hessian made positive definite.
/// It need not be exact: the weights of the draws correct for it.
Mode find_mode(const CurvePosterior& posterior, const Vector& start) {
    Mode mode;
    mode.normal.mean = start;
    mode.value = posterior(start);
    Vector differences = Vector::Constant(0.03);
    differences[CurvePosterior::critical] = 2e-3;
    for (int i = 0; i < 25; ++i) {
        Vector& point = mode.normal.mean;
        auto curvature = posterior.curvature(point, mode.value, differences);
        hold_scales(curvature);
        mode = with_covariance(mode, curvature.hessian);
        const Vector deviations = mode.normal.covariance.diagonal().cwiseSqrt();
        differences = (0.2 * deviations).cwiseMin(0.03).cwiseMax(1e-7);
        differences[CurvePosterior::critical] = std::min(2e-3, differences[CurvePosterior::critical]);
        Vector step = -(mode.normal.covariance * curvature.gradient);
        step *= std::min(1.0, 2.0 / step.cwiseAbs().maxCoeff());
        step *= std::min(1.0, 0.5 / std::abs(step[CurvePosterior::critical]));
        constexpr double enough = 0.02;
        const double before = mode.value;
        double length = 1.0;
        for (int shortened = 0; shortened < 9; ++shortened, length *= 0.35) {
            const double value = posterior(point + length * step);
            if (value >= mode.value) continue;
            point += length * step;
            mode.value = value;
            break;
        }
        if (before - mode.value < enough) break;
    }
    return mode;
}

/// Whether the curve of a mode explains the impacts better with less noise yet.
bool asks_for_less_noise(const CurvePosterior& posterior, const Mode& mode, double less) {
    constexpr double clearly = 1.0;
    Vector point = mode.normal.mean;
    point[CurvePosterior::noise] -= less;
    return posterior(point) < mode.value - clearly;
}

/// Gives the curve of a mode at least half the widths of the one at more noise: with little noise v_c may
/// stand at the edge of a single impact, where curvature tells nothing of what lies beyond.
void widen(Draws::NormalDensity& normal, const Draws::NormalDensity& at_more_noise) {
    constexpr int curve = CurvePosterior::noise;  // the parameters before noise and scatter
    normal.covariance.topLeftCorner<curve, curve>() +=
        0.25 * at_more_noise.covariance.topLeftCorner<curve, curve>();
}

/// Modes at ever less noise, each found from the one before. Where the noise is large, no impact is an
/// outlier that the curve can do without, so that there are hardly any false modes. Below the stated noise
/// there are modes only where the impacts scatter by far less than it says.
std::vector<Mode> modes_from(const CurvePosterior& posterior, Vector point) {
    constexpr double step = 0.8;
    constexpr double most_below = -4.0;
    std::vector<Mode> modes;
    const auto add_at = [&](double noise) {
        point[CurvePosterior::noise] = noise;
        modes.push_back(find_mode(posterior, point));
        point = modes.back().normal.mean;
    };
    for (const double noise : {2.0 * step, step, 0.0}) add_at(noise);
    for (double noise = -step;
         noise >= most_below && posterior.noise_known() && asks_for_less_noise(posterior, modes.back(), step);
         noise -= step) {
        add_at(noise);
        widen(modes.back().normal, modes[modes.size() - 2].normal);
    }
    return modes;
}

/// The modes found from the two best starting velocities, the one of greatest weight first.
std::vector<Mode> modes_of(const CurvePosterior& posterior, const std::vector<double>& velocities) {
    std::vector<std::pair<double, Vector>> starts;
    for (const double v : velocities) {
        Vector point = Vector::Zero();
        point[CurvePosterior::critical] = std::log(v);
        starts.emplace_back(posterior(point), point);
    }
    std::sort(starts.begin(), starts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Mode> modes = modes_from(posterior, starts[0].second);
    for (Mode& mode : modes_from(posterior, starts[1].second)) modes.push_back(std::move(mode));
    std::sort(modes.begin(), modes.end(),
              [](const Mode& a, const Mode& b) { return a.log_weight > b.log_weight; });
    return modes;
}

/// Mean, standard deviation and interval of v_c.
Interval critical_velocity(const Draws& draws) {
    const MarginalSample velocity =
        draws.marginal(CurvePosterior::critical, [](double logarithm) { return std::exp(logarithm); });
    const double tail = 0.5 * (1.0 - confidence);
    return {velocity.mean(), velocity.standard_deviation(), velocity.quantile(tail),
            velocity.quantile(1.0 - tail)};
}

}  // namespace

CurveEstimate estimate_curve(const CurveTable& table, const std::vector<RecordedImpact>& impacts,
                             const CurvePrior& prior, const std::vector<double>& starts) {
    const CurvePosterior posterior(table, impacts, prior);
    std::vector<Mode> modes = modes_of(posterior, starts);
    if (!(modes.front().value < 1e9)) throw ConvergenceError("no curve of damping explains the impacts");
    std::erase_if(modes, [most = modes.front().log_weight](const Mode& mode) {
        return !(mode.log_weight > most - 5.0);
    });
    Draws draws(posterior);
    for (const Mode& mode : modes) draws.add(mode.normal, 250);
    draws.add(draws.moments(), 300);
    for (int i = 0; i < 12 && (i < 2 || draws.effective() < 500.0); ++i) draws.add(draws.moments(), 400);
    // Where noise and scatter leave much open, the posterior is no normal density: its modes help.
    for (std::size_t i = 0; i < 40 && draws.effective() < least_effective; ++i)
        draws.add(i % 2 == 0 ? draws.moments() : modes[i / 2 % modes.size()].normal, 400);
    if (draws.effective() < least_effective)
        throw ConvergenceError(
            std::string(prior.noise_known ? "the stated uncertainties are so small that " : "") +
            "hardly any smooth damping explains all impacts (the curves drawn are worth " +
            shortest(std::round(draws.effective())) + " independent ones, " +
            shortest(std::round(least_effective)) +
            " are needed); remedies: " + (prior.noise_known ? "larger uncertainties, or " : "") +
            "the scatter of particle sizes (--size-scatter, in a case \"size_scatter\" under \"fit\")");
    const Interval velocity = critical_velocity(draws);
    const auto damping = [&](double at) { return std::exp(table.log_capture_damping(std::log(at))); };
    const double v = velocity.value;
    const double slope = (damping(1.001 * v) - damping(0.999 * v)) / (0.002 * v);
    double fastest = -1e300;
    for (const RecordedImpact& impact : impacts) fastest = std::max(fastest, impact.log_velocity);
    return {.critical_velocity = velocity,
            .critical_damping = {damping(velocity.value), slope * velocity.standard_uncertainty,
                                 damping(*velocity.lower), damping(*velocity.upper)},
            .parameters = draws.likeliest(),
            .effective = draws.effective(),
            .scatter = posterior.scatter_of(draws.likeliest()),
            .fastest = fastest};
}

}  // namespace ashimpact

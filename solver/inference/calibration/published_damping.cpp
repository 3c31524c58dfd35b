// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/calibration/published_damping.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <set>
#include <string>

#include "core/text/error.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/numeric/gsl/solvers.hpp"
#include "solver/surrogate/rebound_table.hpp"

namespace ashimpact {

namespace {

constexpr int coefficient_count = 3;

void require_usable(std::span<const DampingPoint> points) {
    std::set<double> distinct;
    std::size_t weighted = 0;
    for (const DampingPoint& point : points) {
        if (!std::isfinite(point.restitution) || !std::isfinite(point.damping) ||
            !(point.standard_uncertainty >= 0.0) || !std::isfinite(point.standard_uncertainty)) {
            throw InputError("a point of the damping fit is not finite or has a negative uncertainty",
                             "finite numbers");
        }
        distinct.insert(point.restitution);
        weighted += point.standard_uncertainty > 0.0 ? 1 : 0;
    }
    if (distinct.size() < coefficient_count)
        throw InputError("the damping fit has " + std::to_string(distinct.size()) + " distinct restitutions",
                         "at least 3 for a quadratic");
    if (weighted != 0 && weighted != points.size())
        throw InputError("only some points of the damping fit have an uncertainty", "all of them or none");
}

/// Step in restitution; the curve of a parabola eta(e) has no two turns as close as this.
constexpr double branch_step = 0.02;

/// Position of the only minimum of a function between @p a and @p b, by golden sections down to the width
/// that its rounding allows.
double least_argument(const std::function<double(double)>& function, double a, double b) {
    constexpr double golden = 0.61803398874989485;
    constexpr double narrowest = 1e-8;
    double left = b - golden * (b - a);
    double right = a + golden * (b - a);
    double at_left = function(left);
    double at_right = function(right);
    while (b - a > narrowest) {
        if (at_left < at_right) {
            b = right;
            right = left;
            at_right = at_left;
            left = b - golden * (b - a);
            at_left = function(left);
        } else {
            a = left;
            left = right;
            at_left = at_right;
            right = a + golden * (b - a);
            at_right = function(right);
        }
    }
    return (a + b) / 2.0;
}

[[noreturn]] void not_reached(double restitution, const std::string& allowed) {
    throw InputError("restitution " + std::to_string(restitution) + " is not reached at any velocity",
                     allowed);
}

/// v_c at the impact's damping [m/s]. @throws InputError for @p restitution if there is none
double finite_critical_velocity(const Impact& impact, double restitution) {
    const CriticalVelocity critical = critical_velocity(
        {impact.law, impact.detachment, impact.damping, impact.contact}, Precision::standard);
    if (critical.verdict != CaptureVerdict::finite)
        not_reached(restitution, "a damping with a finite critical velocity; here: " +
                                     std::string(name_of(critical.verdict)));
    return *critical.value;
}

/// Relative step of Newton's method, with the slope of a table, whose error is lost in rounding.
constexpr double newton_reach = 1e-9;

/// A root of the restitution over sqrt(ln(v/v_c)) with the slope there.
struct TabulatedRoot {
    double value;
    double slope;
};
/// Where restitution is @p restitution between v_c and a faster impact, by a table of the contact; none next
/// to its ends.
std::optional<TabulatedRoot> root_by_table(const Impact& impact, const VelocityRange& velocities,
                                           double restitution) {
    const ReboundTable table(impact, velocities);
    const double critical = std::log(velocities.lower);
    const auto miss = [&](double root) {
        return std::sqrt(std::max(0.0, table.energy_ratio(critical + root * root))) - restitution;
    };
    const double width = std::sqrt(std::log(velocities.upper) - critical);
    if (!(miss(0.0) < 0.0 && miss(width) > 0.0)) return std::nullopt;
    const double root = gsl::brent(miss, 0.0, width).root;
    const double aside = 1e-3 * root;
    const double slope = (miss(root + aside) - miss(root - aside)) / (2.0 * aside);
    // In single precision, so that it is the same by all instruction sets, whose batches differ in rounding.
    return TabulatedRoot{static_cast<float>(root), static_cast<float>(slope)};
}

}  // namespace

DampingFit fit_damping(std::span<const DampingPoint> points) {
    require_usable(points);
    const auto count = static_cast<Eigen::Index>(points.size());
    const bool weighted = points.front().standard_uncertainty > 0.0;
    Eigen::MatrixXd design(count, coefficient_count);
    Eigen::VectorXd observations(count);
    Eigen::VectorXd weights(weighted ? count : 0);
    for (Eigen::Index i = 0; i < count; ++i) {
        const DampingPoint& point = points[static_cast<std::size_t>(i)];
        design.row(i) << point.restitution * point.restitution, point.restitution, 1.0;
        observations[i] = point.damping;
        if (weighted) weights[i] = 1.0 / (point.standard_uncertainty * point.standard_uncertainty);
    }
    const gsl::LinearFit linear = gsl::fit_linear(design, observations, weights);

    DampingFit fit{};
    fit.damping.coefficients = linear.parameters.reverse();
    fit.chi_squared = linear.chi_squared;
    fit.degrees_of_freedom = static_cast<int>(count) - coefficient_count;
    const double freedom = std::max(1, fit.degrees_of_freedom);
    fit.residual_deviation = (observations - design * linear.parameters).norm() / std::sqrt(freedom);
    const double scatter = weighted ? 1.0 : linear.chi_squared / freedom;
    fit.covariance = scatter * linear.covariance.reverse();
    return fit;
}

double velocity_of_restitution(const Impact& impact, double restitution) {
    if (impact.damping.law != DampingLaw::constant)
        throw InputError("restitution need not rise with velocity for damping law '" +
                             std::string(name_of(impact.damping.law)) + "'",
                         std::string(name_of(DampingLaw::constant)));
    if (can_yield(impact.law, impact.contact))
        throw InputError("restitution need not rise with velocity where the contact yields",
                         "a contact without yield pressure");
    if (!(restitution > 0.0 && restitution < 1.0)) not_reached(restitution, "0 < e < 1");
    const double critical = finite_critical_velocity(impact, restitution);
    // Over the root of ln(v/v_c) restitution rises about linearly, from 0.
    const auto velocity_at = [&](double root) { return critical * std::exp(root * root); };
    const auto miss = [&](double root) {
        Impact at = impact;
        at.velocity = velocity_at(root);
        return root > 0.0 ? restitution_of(at) - restitution : -restitution;
    };
    double width = 1.0;
    while (miss(width) < 0.0) {
        width *= std::numbers::sqrt2;
        if (width > 16.0) not_reached(restitution, "a smaller restitution for this damping law");
    }
    auto root = root_by_table(impact, {critical, velocity_at(width)}, restitution);
    for (int i = 0; root && i < 3; ++i) {
        const double step = -miss(root->value) / root->slope;
        root->value += step;
        if (std::abs(step) < newton_reach * root->value) return velocity_at(root->value);
    }
    return velocity_at(gsl::brent(miss, 0.0, width, {.relative = 1e-14, .absolute = 1e-14}).root);
}

double reconstructed_velocity(const PublishedDamping& published, double e) {
    const double quickening = published.quickening(e);
    return velocity_of_restitution(published.impact(e, 1.0), e / quickening) / quickening;
}

CurvePoint least_rebound(const PublishedDamping& published) {
    const CurvePoint onset{
        finite_critical_velocity(published.impact(0.0, 1.0), 0.0) / published.quickening(0.0), 0.0};
    CurvePoint least = onset;
    double lower = 0.0;
    double upper = branch_step;
    while (upper < 1.0) {  // as far as the curve runs back
        const double velocity = reconstructed_velocity(published, upper);
        if (velocity >= least.velocity) break;
        lower = std::max(0.0, upper - branch_step);
        least = {velocity, upper};
        upper += branch_step;
    }
    const double e = least_argument([&](double at) { return reconstructed_velocity(published, at); }, lower,
                                    std::min(upper, 0.999));
    least = {reconstructed_velocity(published, e), e};
    return least.velocity < onset.velocity ? least : onset;
}

double reconstructed_restitution(const PublishedDamping& published, double velocity) {
    const auto excess = [&](double e) {
        return restitution_of(published.impact(e, velocity)) * published.quickening(e) - e;
    };
    double from = 0.0;
    if (excess(0.0) <= 0.0) {
        const CurvePoint least = least_rebound(published);
        if (velocity < least.velocity || least.restitution == 0.0) return 0.0;
        from = least.restitution;
        if (excess(from) <= 0.0) return from;  // the fold itself, to rounding
    }
    double to = from + branch_step;
    while (to < 1.0 && excess(to) > 0.0) {
        from = to;
        to += branch_step;
    }
    return gsl::brent(excess, from, std::min(to, 1.0), {.relative = 0.0, .absolute = 1e-13}).root;
}

}  // namespace ashimpact

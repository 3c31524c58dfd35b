// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/surrogate/rebound_table.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "solver/batch/batch.hpp"
#include "solver/batch/kernels/kernel.hpp"

namespace ashimpact {

namespace {

bool in_lanes(const Impact& impact) {
    return !can_yield(impact.law, impact.contact) && batch::has_kernels(impact.law, impact.damping.law);
}

/// Restitutions of the impact at each velocity.
Eigen::ArrayXd restitutions_at(const Impact& impact, const std::vector<double>& velocities) {
    std::vector<Impact> impacts(velocities.size(), impact);
    for (std::size_t i = 0; i < impacts.size(); ++i) impacts[i].velocity = velocities[i];
    if (in_lanes(impact))
        return solve_impacts(ImpactList(impacts).batch(), {.turning_point = false, .contact_time = false})
            .restitution;
    Eigen::ArrayXd e(static_cast<Eigen::Index>(impacts.size()));
    std::transform(impacts.begin(), impacts.end(), e.begin(), restitution_of);
    return e;
}

/// v_c of a contact that can yield, if it is elastic up to v_c or, where that is greater, up to @p fastest.
std::optional<CriticalVelocity> elastic_critical_velocity(const CriticalVelocityProblem& problem,
                                                          double fastest) {
    CriticalVelocityProblem elastic = problem;
    elastic.contact.yield_pressure = std::numeric_limits<double>::infinity();
    const CriticalVelocity critical = tabulated_critical_velocity(elastic);
    const double velocity = std::min(critical.value.value_or(fastest), fastest);
    if (!std::isfinite(velocity) || critical.verdict == CaptureVerdict::never_captured) return std::nullopt;
    const ImpactResult impact =
        solve_impact({problem.law, problem.detachment, problem.damping, problem.contact, velocity});
    return impact.yielded ? std::nullopt : std::optional(critical);
}

CriticalVelocity critical_velocity_up_to(const CriticalVelocityProblem& problem, double fastest) {
    if (can_yield(problem.law, problem.contact))
        if (const auto critical = elastic_critical_velocity(problem, fastest)) return *critical;
    return tabulated_critical_velocity(problem);
}

/// ln v_c; minus infinity if nothing is captured, infinite if everything is.
double log_critical_velocity(const Impact& impact) {
    const CriticalVelocity critical = critical_velocity_up_to(
        {impact.law, impact.detachment, impact.damping, impact.contact}, impact.velocity);
    if (critical.value) return std::log(*critical.value);
    const double infinite = std::numeric_limits<double>::infinity();
    return critical.verdict == CaptureVerdict::never_captured ? -infinite : infinite;
}

/// ln v from which the contact yields, within [lower, upper]; upper if it does not.
double log_yield_velocity(Impact impact, double lower, double upper, int halvings) {
    const auto yields = [&](double log_velocity) {
        impact.velocity = std::exp(log_velocity);
        return solve_impact(impact).yielded;
    };
    if (!yields(upper)) return upper;
    if (yields(lower)) return lower;
    double elastic = lower;
    double yielded = upper;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (elastic + yielded);
        (yields(middle) ? yielded : elastic) = middle;
    }
    return 0.5 * (elastic + yielded);
}

}  // namespace

CriticalVelocity quick_critical_velocity(const CriticalVelocityProblem& problem) {
    return critical_velocity_up_to(problem, std::numeric_limits<double>::infinity());
}

ReboundTable::ReboundTable(Impact impact, const VelocityRange& velocities, const Options& options) {
    impact.velocity = velocities.upper;
    const bool elastic = !can_yield(impact.law, impact.contact);
    // A search for v_c takes long where there is none; all these impacts are captured if the fastest one is.
    std::optional<double> fastest;
    if (elastic) fastest = restitutions_at(impact, {impact.velocity})[0];
    log_critical_ = fastest == 0.0 ? std::numeric_limits<double>::infinity() : log_critical_velocity(impact);
    const double upper = std::log(velocities.upper);
    if (log_critical_ >= upper) return;
    const double lower = std::max(log_critical_, std::log(velocities.lower));
    const int degree = in_lanes(impact) ? options.lane_degree : options.scalar_degree;
    double yield = upper;
    if (!elastic) yield = log_yield_velocity(impact, lower, upper, options.yield_halvings);
    if (yield > lower) add_piece(impact, lower, yield, degree, fastest);
    if (yield <= lower || yield < upper) add_piece(impact, yield, upper, degree, std::nullopt);
}

double ReboundTable::position(double log_velocity) const {
    return std::isfinite(log_critical_) ? std::sqrt(std::max(0.0, log_velocity - log_critical_))
                                        : log_velocity;
}

void ReboundTable::add_piece(const Impact& impact, double slowest, double fastest, int degree,
                             std::optional<double> last) {
    const ChebyshevAxis axis{position(slowest), position(fastest), fastest > slowest ? degree : 0};
    const int captured = slowest == log_critical_ ? 1 : 0;  // the impact at v_c itself
    std::vector<double> velocities;
    for (int i = captured; i <= axis.degree - (last ? 1 : 0); ++i) {
        const double node = axis.node(i);
        velocities.push_back(std::exp(std::isfinite(log_critical_) ? log_critical_ + node * node : node));
    }
    Eigen::VectorXd values = Eigen::VectorXd::Zero(axis.degree + 1);
    if (!velocities.empty())
        values.segment(captured, std::ssize(velocities)) = restitutions_at(impact, velocities);
    if (last) values[axis.degree] = *last;
    pieces_.push_back({axis, axis.analysis() * values});
    if (captured == 0 || axis.degree == 0) return;
    const double by_root = ChebyshevBasis(axis, 0).slope.dot(pieces_.back().coefficients);
    slope_at_capture_ = std::max(slope_at_capture_, by_root * by_root);
}

double ReboundTable::energy_ratio(double log_velocity) const {
    if (pieces_.empty() || log_velocity < log_critical_)
        return std::isfinite(log_critical_) ? slope_at_capture_ * std::min(0.0, log_velocity - log_critical_)
                                            : -1.0;
    const double x = position(log_velocity);
    const auto piece = std::find_if(pieces_.begin(), pieces_.end() - 1,
                                    [&](const Piece& each) { return x <= each.axis.upper; });
    const double e = ChebyshevBasis(piece->axis, x).value.dot(piece->coefficients);
    return e * e;
}

}  // namespace ashimpact

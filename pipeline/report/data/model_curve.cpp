#include "pipeline/report/data/model_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "materials/base/error.hpp"
#include "solver/batch/critical_batch.hpp"
#include "solver/batch/impact_batch.hpp"

namespace ashimpact::report {

namespace {

constexpr int curve_points = 28;
constexpr double normal_quantile_95 = 1.959963984540054;  // two-sided

using Values = Eigen::ArrayXd;

/// Standard uncertainty of eta(e).
double uncertainty_at(const CurveProblem& problem, double e) {
    const Eigen::VectorXd powers = DampingPolynomial::powers(e, problem.damping_fit.order());
    const double variance = powers.dot(problem.covariance * powers);
    return variance > 0 ? std::sqrt(variance) : 0;
}

/// The contact as columns of one value; they refer to it.
struct ContactValues {
    explicit ContactValues(const ContactPair& pair)
        : mass(Values::Constant(1, pair.mass)),
          radius(Values::Constant(1, pair.effective_radius)),
          modulus(Values::Constant(1, pair.contact_modulus)),
          adhesion(Values::Constant(1, pair.work_of_adhesion)),
          yield(Values::Constant(1, pair.yield_pressure)) {}

    Values mass, radius, modulus, adhesion, yield;
};

Values restitutions(const CurveProblem& problem, const Values& damping, const Values& velocity) {
    const BatchOptions options{.threads = 1, .turning_point = false};
    const ContactValues contact(problem.contact);
    return solve_impacts(
               {.law = problem.choice.law,
                .detachment = problem.choice.detachment,
                .damping_law = problem.damping_law,
                .contact = {contact.mass, contact.radius, contact.modulus, contact.adhesion, contact.yield},
                .damping = damping,
                .velocity = velocity},
               options)
        .restitution;
}

/// The velocities at which impacts of these dampings give these restitutions, all at once: the method of
/// false position (Illinois) in the logarithm of the velocity, from v_c up. NaN where there is none within a
/// factor 1000.
Values velocities_of(const CurveProblem& problem, const Values& e, const Values& damping) {
    const ContactValues contact(problem.contact);
    const Values critical = critical_velocities({.law = problem.choice.law,
                                                 .detachment = problem.choice.detachment,
                                                 .damping_law = problem.damping_law,
                                                 .contact = {contact.mass, contact.radius, contact.modulus,
                                                             contact.adhesion, contact.yield},
                                                 .damping = damping})
                                .value;
    Values low = critical.log();
    Values below = -e;
    Values high = low + std::log(1.3);
    Values above = restitutions(problem, damping, high.exp()) - e;
    for (int i = 0; i < 16 && (above < 0).any(); ++i) {
        const auto short_of = (above < 0).eval();
        low = short_of.select(high, low);
        below = short_of.select(above, below);
        high = short_of.select(high + std::log(1.6), high);
        above = restitutions(problem, damping, high.exp()) - e;
    }
    const auto unreached = (above < 0).eval();
    Values middle = high;
    for (int i = 0; i < 40; ++i) {
        middle = (low * above - high * below) / (above - below);
        const Values found = restitutions(problem, damping, middle.exp()) - e;
        const auto over = (found >= 0).eval();
        const Values left = over.select(low, middle);  // keeps the root between the two
        const Values weight = over.select(below * 0.5, found);
        above = over.select(found, above * 0.5);
        high = over.select(middle, high);
        low = left;
        below = weight;
        if ((found.abs() < 1e-9).all() || ((high - low).abs() < 1e-12).all()) break;
    }
    return unreached.select(std::numeric_limits<double>::quiet_NaN(), middle.exp());
}

CurveImpact impact_at(const CurveProblem& problem, double e, double damping, double velocity, double lower,
                      double upper) {
    const ImpactResult result = solve_impact({problem.choice.law,
                                              problem.choice.detachment,
                                              {problem.damping_law, damping},
                                              problem.contact,
                                              velocity});
    const double whole = result.energy.incident;
    return {.velocity = velocity,
            .lower = lower,
            .upper = upper,
            .restitution = e,
            .damping = damping,
            .contact_time = result.contact_time.value_or(std::numeric_limits<double>::quiet_NaN()),
            .dissipated = result.energy.dissipated / whole,
            .adhesion = (result.energy.potential - result.energy.at_touch) / whole,
            .plastic = result.energy.plastic / whole};
}

}  // namespace

ModelCurve model_curve(const CurveProblem& problem) {
    ModelCurve curve;
    if (problem.damping_law != DampingLaw::constant || !(problem.greatest_restitution > 0)) return curve;
    Values e(curve_points);
    Values eta(curve_points);
    Values half(curve_points);
    for (int i = 0; i < curve_points; ++i) {
        e[i] = problem.greatest_restitution * std::pow((i + 1.0) / curve_points, 1.6);
        eta[i] = problem.damping_fit(e[i]);
        half[i] = std::min(normal_quantile_95 * uncertainty_at(problem, e[i]), 0.9 * eta[i]);
    }
    if (!(eta > 0).all()) return curve;
    try {
        const Values velocity = velocities_of(problem, e, eta);
        const bool banded = (half > 0).any();
        const double none = std::numeric_limits<double>::quiet_NaN();
        const Values lower =
            banded ? velocities_of(problem, e, eta - half) : Values::Constant(curve_points, none);
        const Values upper =
            banded ? velocities_of(problem, e, eta + half) : Values::Constant(curve_points, none);
        for (int i = 0; i < curve_points; ++i)
            if (std::isfinite(velocity[i]))
                curve.push_back(impact_at(problem, e[i], eta[i], velocity[i], lower[i], upper[i]));
    } catch (const InputError&) {  // a damping or velocity that has no impact: no curve
        curve.clear();
    } catch (const ConvergenceError&) {
        curve.clear();
    }
    return curve;
}

}  // namespace ashimpact::report

// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/curves/model_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/text/error.hpp"
#include "pipeline/run/curves/impact_search.hpp"
#include "solver/motion/scaled_impact.hpp"
#include "solver/numeric/gsl/interpolation.hpp"
#include "solver/statistics/interval.hpp"

namespace ashimpact::curves {

namespace {

constexpr int curve_points = 28;
// Of law maugis-dugdale, whose impacts no vector kernel solves: fewer points, and the ends of the band solved
// at every fourth of them and interpolated.
constexpr int costly_curve_points = 13;
constexpr int costly_band_stride = 4;
// Changes of ln v that end a search: the step after one of 1e-5 is below 1e-9, that after 1e-3 below 1e-5.
constexpr double enough_for_curve = 1e-5;
constexpr double enough_for_costly_band = 1e-3;
static_assert((costly_curve_points - 1) % costly_band_stride == 0, "the band ends where the curve does");

using Values = Eigen::ArrayXd;

/// Standard uncertainty of eta(e).
double uncertainty_at(const CurveProblem& problem, double e) {
    const Eigen::VectorXd powers = DampingPolynomial::powers(e, problem.damping_fit.order());
    const double variance = powers.dot(problem.covariance * powers);
    return variance > 0 ? std::sqrt(variance) : 0;
}

/// Velocities, with the greatest in the place of those not found.
Values solvable(const Values& velocity) {
    return velocity.isFinite().select(velocity, velocity.maxCoeff<Eigen::PropagateNumbers>());
}

/// Where the energy of an impact goes [J]; what surfaces lose that jump together and apart counts as
/// adhesion.
struct Losses {
    double adhesion;
    double plastic;
};

Losses losses_of(const CurveProblem& problem, double damping, double velocity) {
    const Impact impact{problem.choice.law,
                        problem.choice.detachment,
                        {problem.damping_law, damping},
                        problem.contact,
                        velocity};
    const EnergyLedger energy = solve_impact(impact, Precision::standard).energy;
    return {energy.potential - energy.at_touch + energy.jumps, energy.plastic};
}

/// Loss over the incident energy [1]; 0 where it is no more than the rounding of that energy.
double share_of(double loss, double whole) {
    const double share = loss / whole;
    return std::abs(share) < std::numeric_limits<double>::epsilon() ? 0 : share;
}

/// Fills in the shares of the incident energy. Without yielding the adhesive loss is that of the static law,
/// the same for all impacts.
void add_shares(const CurveProblem& problem, ModelCurve& curve) {
    if (curve.empty()) return;
    const bool yields = std::isfinite(problem.contact.yield_pressure);
    const CurveImpact& fastest = curve.back();
    const Losses of_all = losses_of(problem, fastest.damping, fastest.velocity);
    for (CurveImpact& impact : curve) {
        const Losses losses = yields ? losses_of(problem, impact.damping, impact.velocity) : of_all;
        const double whole = 0.5 * problem.contact.mass * impact.velocity * impact.velocity;
        impact.adhesion = share_of(losses.adhesion, whole);
        impact.plastic = share_of(losses.plastic, whole);
        impact.dissipated = 1 - impact.restitution * impact.restitution - impact.adhesion - impact.plastic;
    }
}

/// Velocity over restitution through the known impacts of the curve, for a first guess [m/s].
Values guessed_velocities(const CurveProblem& problem, const Values& e) {
    std::vector<CurveKnot> knots = problem.knots;
    std::sort(knots.begin(), knots.end(),
              [](const CurveKnot& a, const CurveKnot& b) { return a.restitution < b.restitution; });
    Values guess(e.size());
    for (Eigen::Index i = 0; i < e.size(); ++i) {
        const auto after = std::find_if(knots.begin(), knots.end(),
                                        [&](const CurveKnot& k) { return k.restitution >= e[i]; });
        if (after == knots.begin() || after == knots.end()) {
            guess[i] = (after == knots.end() ? knots.back() : knots.front()).velocity;
            continue;
        }
        const CurveKnot& a = *std::prev(after);
        const double share = (e[i] - a.restitution) / (after->restitution - a.restitution);
        guess[i] = a.velocity * std::pow(after->velocity / a.velocity, share);
    }
    return guess;
}

/// Exponent of v over damping at equal restitution: 5 for Hertz, less with adhesion.
double exponent_of_damping(const CurveProblem& problem) {
    return problem.choice.law.is_adhesive() ? 1 : 5;
}

SearchedContact contact_of(const CurveProblem& problem) {
    return {problem.choice, problem.damping_law, problem.contact};
}

/// A curve v(e) with the ends of its 95 % band; NaN where nothing was found.
struct Band {
    FoundImpacts impacts;
    Values lower, upper;
};

/// ln of a ratio of velocities at @p every restitution, from those solved at some of them. All NaN where one
/// of these was not found.
Values interpolated(const Values& e, const Values& log_ratio, const Values& every) {
    if (!log_ratio.isFinite().all())
        return Values::Constant(every.size(), std::numeric_limits<double>::quiet_NaN());
    const MeasuredCurve curve(std::span(e.data(), static_cast<std::size_t>(e.size())),
                              std::span(log_ratio.data(), static_cast<std::size_t>(log_ratio.size())));
    return every.unaryExpr([&](double each) { return curve(each); });
}

/// @param e increasing
Band band_at(const CurveProblem& problem, const Values& e) {
    const Values nothing = Values::Constant(e.size(), std::numeric_limits<double>::quiet_NaN());
    const auto damping_at = [&](double each) { return problem.damping_fit(each); };
    Band band{impacts_with(e, contact_of(problem), e.unaryExpr(damping_at), guessed_velocities(problem, e),
                           enough_for_curve),
              nothing, nothing};
    const Values& found = band.impacts.velocity;
    const bool costly = is_cohesive(problem.choice.law, problem.contact);
    const Eigen::Index stride = costly ? costly_band_stride : 1;
    const auto some = Eigen::seq(0, e.size() - 1, stride);
    const Values at = e(some);
    const Values eta = at.unaryExpr(damping_at);
    const Values half = at.binaryExpr(eta, [&](double each, double damping) {
        return std::min(confidence_quantile() * uncertainty_at(problem, each), 0.9 * damping);
    });
    if (!found.isFinite().any() || !(half > 0).any()) return band;
    Values damping(2 * at.size());
    damping << eta - half, eta + half;
    const Values velocity = solvable(found)(some);
    const Values guess =
        velocity.replicate(2, 1) * (damping / eta.replicate(2, 1)).pow(exponent_of_damping(problem));
    const Values ends = impacts_with(at.replicate(2, 1), contact_of(problem), damping, guess,
                                     costly ? enough_for_costly_band : enough_for_curve)
                            .velocity;
    band.lower = ends.head(at.size());
    band.upper = ends.tail(at.size());
    if (!costly) return band;
    for (Values* end : {&band.lower, &band.upper})
        *end = found * interpolated(at, (*end / velocity).log(), e).exp();
    return band;
}

}  // namespace

ModelCurve model_curve(const CurveProblem& problem) {
    ModelCurve curve;
    if (problem.damping_law != DampingLaw::constant || !(problem.greatest_restitution > 0) ||
        problem.knots.empty())
        return curve;
    const int points = is_cohesive(problem.choice.law, problem.contact) ? costly_curve_points : curve_points;
    Values e(points);
    for (int i = 0; i < points; ++i) e[i] = problem.greatest_restitution * std::pow((i + 1.0) / points, 1.6);
    const Values eta = e.unaryExpr([&](double each) { return problem.damping_fit(each); });
    if (!(eta > 0).all()) return curve;
    try {
        const Band band = band_at(problem, e);
        const auto& [velocity, contact_time] = band.impacts;
        for (int i = 0; i < points; ++i)
            if (velocity[i] <= problem.greatest_velocity)
                curve.push_back({.velocity = velocity[i],
                                 .lower = std::min(band.lower[i], problem.greatest_velocity),
                                 .upper = band.upper[i] > problem.greatest_velocity
                                              ? problem.greatest_velocity
                                              : band.upper[i],
                                 .restitution = e[i],
                                 .damping = eta[i],
                                 .contact_time = contact_time[i]});
        add_shares(problem, curve);
    } catch (const InputError&) {  // a damping or velocity that has no impact: no curve
        curve.clear();
    } catch (const ConvergenceError&) {
        curve.clear();
    }
    return curve;
}

}  // namespace ashimpact::curves

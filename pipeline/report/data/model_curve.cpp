#include "pipeline/report/data/model_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "materials/base/error.hpp"
#include "pipeline/report/data/velocity_search.hpp"
#include "solver/batch/impact_batch.hpp"
#include "solver/measurement/interpolation.hpp"
#include "solver/motion/maugis/cohesive_impact.hpp"

namespace ashimpact::report {

namespace {

constexpr int curve_points = 28;
// Of law maugis-dugdale, whose impacts no vector kernel solves: fewer points, and the ends of the band solved
// at every fourth of them and interpolated.
constexpr int costly_curve_points = 13;
constexpr int costly_band_stride = 4;
static_assert((costly_curve_points - 1) % costly_band_stride == 0, "the band ends where the curve does");
constexpr double normal_quantile_95 = 1.959963984540054;  // two-sided

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

ImpactBatchResult impacts(const CurveProblem& problem, const Values& damping, const Values& velocity) {
    const BatchOptions options{.threads = 1, .turning_point = false};
    const ContactValues contact(problem.contact);
    return solve_impacts({.law = problem.choice.law,
                          .detachment = problem.choice.detachment,
                          .damping_law = problem.damping_law,
                          .contact = {contact.mass, contact.radius, contact.modulus, contact.adhesion,
                                      contact.yield, single_columns(problem.contact.parameters)},
                          .damping = damping,
                          .velocity = velocity},
                         options);
}

/// The velocities at which impacts of these dampings give these restitutions, all at once. NaN where none was
/// found.
/// @param guess of the velocities [m/s]
Values velocities_of(const CurveProblem& problem, const Values& e, const Values& damping,
                     const Values& guess) {
    const Eigen::Index count = e.size();
    const bool adhesive = problem.contact.work_of_adhesion > 0 && problem.choice.law != Law::of<Hertz>();
    std::vector<VelocitySearch> searches;
    std::vector<Eigen::Index> open;
    for (Eigen::Index i = 0; i < count; ++i) {
        searches.emplace_back(e[i], std::log(guess[i]), adhesive);
        open.push_back(i);
    }
    const auto search = [&](Eigen::Index i) -> VelocitySearch& {
        return searches[static_cast<std::size_t>(i)];
    };
    while (!open.empty()) {
        Values velocity(static_cast<Eigen::Index>(open.size()));
        for (Eigen::Index k = 0; k < velocity.size(); ++k)
            velocity[k] = std::exp(search(open[static_cast<std::size_t>(k)]).place());
        const Values found = impacts(problem, damping(open), velocity).restitution;
        for (Eigen::Index k = 0; k < found.size(); ++k)
            search(open[static_cast<std::size_t>(k)]).observe(found[k]);
        open.erase(
            std::remove_if(open.begin(), open.end(), [&](Eigen::Index i) { return !search(i).is_open(); }),
            open.end());
    }
    Values velocity(count);
    for (Eigen::Index i = 0; i < count; ++i)
        velocity[i] =
            search(i).is_found() ? std::exp(search(i).place()) : std::numeric_limits<double>::quiet_NaN();
    return velocity;
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
    const bool costly = is_cohesive(problem.choice.law, problem.contact);
    const EnergyLedger energy =
        (costly ? solve_cohesive_impact(impact, Precision::standard) : solve_impact(impact)).energy;
    return {energy.potential - energy.at_touch + energy.jumps, energy.plastic};
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
        impact.adhesion = losses.adhesion / whole;
        impact.plastic = losses.plastic / whole;
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
    return problem.choice.law == Law::of<Hertz>() ? 5 : 1;
}

/// A curve v(e) with the ends of its 95 % band; NaN where nothing was found.
struct Band {
    Values velocity, lower, upper;
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
    Band band{velocities_of(problem, e, e.unaryExpr(damping_at), guessed_velocities(problem, e)), nothing,
              nothing};
    const bool costly = is_cohesive(problem.choice.law, problem.contact);
    const Eigen::Index stride = costly ? costly_band_stride : 1;
    const auto some = Eigen::seq(0, e.size() - 1, stride);
    const Values at = e(some);
    const Values eta = at.unaryExpr(damping_at);
    const Values half = at.binaryExpr(eta, [&](double each, double damping) {
        return std::min(normal_quantile_95 * uncertainty_at(problem, each), 0.9 * damping);
    });
    if (!band.velocity.isFinite().any() || !(half > 0).any()) return band;
    Values damping(2 * at.size());
    damping << eta - half, eta + half;
    const Values velocity = solvable(band.velocity)(some);
    const Values guess =
        velocity.replicate(2, 1) * (damping / eta.replicate(2, 1)).pow(exponent_of_damping(problem));
    const Values ends = velocities_of(problem, at.replicate(2, 1), damping, guess);
    band.lower = ends.head(at.size());
    band.upper = ends.tail(at.size());
    if (!costly) return band;
    for (Values* end : {&band.lower, &band.upper})
        *end = band.velocity * interpolated(at, (*end / velocity).log(), e).exp();
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
        if (!band.velocity.isFinite().any()) return curve;
        const Values contact_time = impacts(problem, eta, solvable(band.velocity)).contact_time;
        for (int i = 0; i < points; ++i)
            if (std::isfinite(band.velocity[i]))
                curve.push_back({.velocity = band.velocity[i],
                                 .lower = band.lower[i],
                                 .upper = band.upper[i],
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

}  // namespace ashimpact::report

// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/curves/model_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

#include "core/text/error.hpp"
#include "pipeline/run/uncertainty/contact_models.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/contact/law.hpp"
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

Losses losses_of(const SearchedContact& contact, double damping, double velocity) {
    const Impact impact{contact.choice.law,
                        contact.choice.detachment,
                        {contact.damping_law, damping},
                        contact.pair,
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
void add_shares(const SearchedContact& contact, ModelCurve& curve) {
    if (curve.empty()) return;
    const bool yields = std::isfinite(contact.pair.yield_pressure);
    const CurveImpact& fastest = curve.back();
    const Losses of_all = losses_of(contact, fastest.damping, fastest.velocity);
    for (CurveImpact& impact : curve) {
        const Losses losses = yields ? losses_of(contact, impact.damping, impact.velocity) : of_all;
        const double whole = 0.5 * contact.pair.mass * impact.velocity * impact.velocity;
        impact.adhesion = share_of(losses.adhesion, whole);
        impact.plastic = share_of(losses.plastic, whole);
        impact.dissipated = 1 - impact.restitution * impact.restitution - impact.adhesion - impact.plastic;
    }
}

/// Velocity over restitution through the known impacts of the curve, for a first guess [m/s].
Values guessed_velocities(const CurveProblem& problem, const Values& e) {
    std::vector<CurveKnot> knots = problem.knots;
    std::ranges::sort(knots, {}, [](const CurveKnot& k) { return std::pair(k.restitution, k.velocity); });
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

/// Exponent x in v ~ eta^x at equal restitution, for a first guess: 5 for Hertz; less with adhesion, 1 is
/// taken.
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

/// Curves end at so many times the greatest velocity of the impacts: a fit that needs more for the greatest
/// restitution would take the whole figure.
constexpr double beyond_impacts = 1.25;
constexpr int instants = 41;        ///< of a history that is drawn
constexpr int fine_instants = 641;  ///< of an impact at v_c, which may creep far longer than it is drawn
constexpr double shown_end = 1.02;  ///< of the time axis, in longest times of the other histories

/// One law of one sample; null where there is no such result.
struct CurveSources {
    const Sample* sample;
    LawChoice choice;
    const ContactPair* contact;
    const DampingSeries* damping;
    const LawFit* fit;
    const LawCriticalVelocity* velocity;
};

double greatest_in(const std::vector<double>& values) {
    return values.empty() ? 0.0 : *std::ranges::max_element(values);
}

/// Covariance of the coefficients; of a reconstructed series the rounding of the printed ones.
Eigen::MatrixXd covariance_of(const CurveSources& in) {
    const Eigen::Index count = in.fit->along_rising_branch().coefficients.size();
    const auto* plan =
        in.sample->restitution ? std::get_if<Reconstruction>(&*in.sample->restitution) : nullptr;
    if (plan != nullptr && plan->coefficient_uncertainty) {
        const double u = *plan->coefficient_uncertainty;
        return u * u * Eigen::MatrixXd::Identity(count, count);
    }
    if (in.fit->extrapolated) return in.fit->extrapolated->covariance;
    return Eigen::MatrixXd::Zero(count, count);
}

/// Impacts near the rising model curve: where it begins, and the points up to the greatest restitution.
std::vector<CurveKnot> knots_of(const CurveSources& in) {
    std::vector<CurveKnot> knots;
    if (const double start = in.velocity->velocity->value; start > 0) knots.push_back({0, start});
    const std::vector<double>& e = in.damping->restitution;
    const std::vector<double>& v = in.damping->velocity;
    if (e.empty()) return knots;
    std::pair<double, double> top{};  // the greatest restitution, and minus the least velocity there
    for (std::size_t i = 0; i < v.size(); ++i) top = std::max(top, std::pair(e[i], -v[i]));
    const double fastest = -top.second;
    for (std::size_t i = 0; i < v.size(); ++i)
        if (v[i] <= fastest) knots.push_back({e[i], v[i]});
    return knots;
}

/// The curve of the points that @p add_points adds, with their shares; empty where one has no impact.
template <class AddPoints>
ModelCurve solved_curve(const SearchedContact& contact, const AddPoints& add_points) {
    ModelCurve curve;
    try {
        add_points(curve);
        add_shares(contact, curve);
    } catch (const InputError&) {
        curve.clear();
    } catch (const ConvergenceError&) {
        curve.clear();
    }
    return curve;
}

/// The impacts along the estimate's curve of damping; none if it is of another v_c, as after an edit.
ModelCurve estimated_curve(const Case& data, const CurveSources& in) {
    constexpr double same = 1e-3;
    const auto& known = in.fit->estimate->curve;
    if (!known || !(std::abs(known->velocity.front() / in.velocity->velocity->value - 1) < same)) return {};
    const auto from_second = [](const std::vector<double>& values) {  // the first one is at capture
        return Values(Eigen::Map<const Values>(values.data() + 1, std::ssize(values) - 1));
    };
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const SearchedContact contact{in.choice, data.damping_law, *in.contact};
    const Values damping = from_second(known->damping);
    const Values velocity = from_second(known->velocity);
    return solved_curve(contact, [&](ModelCurve& curve) {
        const ImpactBatchResult found = impacts_at(contact, damping, velocity);
        for (Eigen::Index i = 0; i < velocity.size(); ++i)
            if (found.restitution[i] > 0)
                curve.push_back({.velocity = velocity[i],
                                 .lower = unknown,
                                 .upper = unknown,
                                 .restitution = found.restitution[i],
                                 .damping = damping[i],
                                 .contact_time = found.contact_time[i]});
    });
}

ModelCurve curve_of(const Case& data, const CurveSources& in) {
    const bool known = in.velocity != nullptr && in.velocity->velocity;
    if (in.damping == nullptr || in.fit == nullptr || !known) return {};
    if (in.fit->estimate) return estimated_curve(data, in);
    return model_curve({.choice = in.choice,
                        .damping_law = data.damping_law,
                        .contact = *in.contact,
                        .damping_fit = in.fit->along_rising_branch(),
                        .covariance = covariance_of(in),
                        .greatest_restitution = greatest_in(in.damping->restitution),
                        .greatest_velocity = beyond_impacts * greatest_in(in.damping->velocity),
                        .knots = knots_of(in)});
}

/// The points up to a time, no more of them than are drawn.
std::vector<TrajectoryPoint> points_until(double time, const std::vector<TrajectoryPoint>& points) {
    const auto end =
        std::find_if(points.begin(), points.end(), [&](const TrajectoryPoint& p) { return p.time > time; });
    const auto count = static_cast<std::size_t>(end - points.begin());
    const std::size_t every = std::max<std::size_t>(1, count / static_cast<std::size_t>(instants));
    std::vector<TrajectoryPoint> kept;
    for (std::size_t i = 0; i < count; i += every) kept.push_back(points[i]);
    return kept;
}

/// The impact at v_c, and one of the falling branch.
std::vector<History> drawn_histories(const Case& data, const CurveSources& in) {
    std::vector<History> histories;
    const auto add = [&](HistoryPart part, double velocity, double damping, int points) {
        try {
            histories.push_back({.part = part,
                                 .velocity = velocity,
                                 .damping = damping,
                                 .trajectory = trajectory({.law = in.choice.law,
                                                           .detachment = in.choice.detachment,
                                                           .damping = {data.damping_law, damping},
                                                           .contact = *in.contact,
                                                           .velocity = velocity},
                                                          points)});
        } catch (const ConvergenceError&) {  // nothing to draw
            return;
        }
    };
    if (in.velocity != nullptr && in.velocity->velocity)
        add(HistoryPart::at_critical, in.velocity->velocity->value, in.velocity->damping, fine_instants);
    if (in.damping != nullptr && in.damping->rising)
        if (const auto point =
                median_impact(*in.damping, in.damping->rising->to, std::numeric_limits<double>::infinity()))
            add(HistoryPart::falling, point->first, point->second, instants);
    return histories;
}

/// Cuts the histories at v_c off where the others of the sample end.
void cut_off(const SampleHistories& sample, std::span<LawCurve> curves) {
    double longest = 0;
    const auto observe = [&](const std::vector<History>& histories) {
        for (const History& history : histories)
            if (history.part != HistoryPart::at_critical && !history.trajectory.empty())
                longest = std::max(longest, history.trajectory.back().time);
    };
    for (const auto& [law, histories] : sample.laws) observe(histories);
    for (const LawCurve& curve : curves) observe(curve.histories);
    for (LawCurve& curve : curves)
        for (History& history : curve.histories)
            if (history.part == HistoryPart::at_critical)
                history.trajectory = points_until(shown_end * longest, history.trajectory);
}

}  // namespace

std::optional<std::pair<double, double>> median_impact(const DampingSeries& series, double from, double to) {
    std::vector<std::pair<double, double>> impacts;
    for (std::size_t i = 0; i < series.velocity.size(); ++i)
        if (series.velocity[i] > from && series.velocity[i] <= to)
            impacts.emplace_back(series.velocity[i], series.damping[i]);
    if (impacts.empty()) return std::nullopt;
    std::ranges::sort(impacts);
    return impacts[impacts.size() / 2];
}

ModelCurve model_curve(const CurveProblem& problem) {
    if (!restitution_rises(problem.damping_law) || !(problem.greatest_restitution > 0) ||
        problem.knots.empty())
        return {};
    const int points = is_cohesive(problem.choice.law, problem.contact) ? costly_curve_points : curve_points;
    Values e(points);
    for (int i = 0; i < points; ++i) e[i] = problem.greatest_restitution * std::pow((i + 1.0) / points, 1.6);
    const Values eta = e.unaryExpr([&](double each) { return problem.damping_fit(each); });
    if (!(eta > 0).all()) return {};
    return solved_curve(contact_of(problem), [&](ModelCurve& curve) {
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
    });
}

void add_curves(const Case& data, const ContactResult& contacts, const DampingStageResult& dampings,
                const FitResult& fits, const CriticalVelocityResult& velocities, HistoriesResult& result) {
    std::vector<CurveSources> inputs;
    for (std::size_t i = 0; i < data.samples.size(); ++i)
        for (const LawChoice& choice : data.laws)
            inputs.push_back({.sample = &data.samples[i],
                              .choice = choice,
                              .contact = &contacts.samples[i].pair,
                              .damping = dampings.samples[i].laws.find(choice.law),
                              .fit = fits.samples[i].laws.find(choice.law),
                              .velocity = velocities.samples[i].laws.find(choice.law)});
    std::vector<std::size_t> order(inputs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    // The slowest curves first, so that no core waits for one at the end.
    std::stable_partition(order.begin(), order.end(), [&](std::size_t i) {
        return is_cohesive(inputs[i].choice.law, *inputs[i].contact);
    });
    auto curves = in_parallel(order, [&](std::size_t i) -> LawCurve {
        const LawCriticalVelocity* velocity = inputs[i].velocity;
        const bool finite = velocity != nullptr && velocity->velocity;
        return {finite ? std::optional(velocity->velocity->value) : std::nullopt, curve_of(data, inputs[i]),
                drawn_histories(data, inputs[i])};
    });
    std::vector<LawCurve> sorted(curves.size());
    for (std::size_t k = 0; k < order.size(); ++k) sorted[order[k]] = std::move(curves[k]);
    const std::size_t laws = data.laws.size();
    for (std::size_t i = 0; i < data.samples.size(); ++i) {
        cut_off(result.samples[i], std::span(sorted).subspan(i * laws, laws));
        for (std::size_t k = 0; k < laws; ++k)
            if (LawCurve& curve = sorted[i * laws + k]; !curve.impacts.empty() || !curve.histories.empty())
                result.samples[i].curves.set(data.laws[k].law, std::move(curve));
    }
}

}  // namespace ashimpact::curves

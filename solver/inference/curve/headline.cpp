// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/curve/headline.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "solver/inference/curve/recorded_impacts.hpp"
#include "solver/numeric/gsl/statistics.hpp"
#include "solver/statistics/importance_sampling.hpp"

namespace ashimpact {

namespace {

using Vector = CurvePosterior::Vector;
using Matrix = CurvePosterior::Matrix;
using Draws = ImportanceSampling<CurvePosterior::size>;

/// Newton's search for a mode. It need not be exact: the weights of the draws correct for it.
namespace mode_search {
constexpr int most_steps = 25;             ///< far more than the ten or so that it takes
constexpr double enough = 0.02;            ///< decrease of -ln posterior that ends it: 2 % of the weight
constexpr double first_difference = 0.03;  ///< of the differences, in standard deviations of the priors
constexpr double first_velocity = 2e-3;    ///< of ln v_c: well below the noise of any camera
constexpr double of_deviation = 0.2;       ///< later differences, in standard deviations of the mode
constexpr double least_difference = 1e-7;  ///< of the same; smaller ones are rounding
constexpr double longest_step = 2.0;       ///< of any parameter, in standard deviations of its prior
constexpr double longest_velocity = 0.5;   ///< of ln v_c
constexpr double shorter = 0.35;           ///< factor on a step that leads uphill
constexpr int most_shortened = 9;          ///< after which a step is 1e-4 of itself
constexpr double least_curvature = 0.5;    ///< of a direction: flatter ones get about the width of a prior
}  // namespace mode_search

/// Noises from which modes are searched, as logarithms of their ratio to the expected one.
namespace noise_steps {
constexpr double step = 0.8;         ///< of the noise: a factor of 2.2
constexpr double most_below = -4.0;  ///< a fiftieth of the stated noise
constexpr double clearly = 1.0;      ///< gain of ln posterior for which less noise is tried
}  // namespace noise_steps

/// The draws of adaptive importance sampling.
namespace sampling {
constexpr std::size_t from_each_mode = 250;
constexpr std::size_t from_first_moments = 300;
constexpr std::size_t from_moments = 400;
constexpr double furthest_mode = 5.0;  ///< of the logarithm of its weight, below the greatest
constexpr int least_rounds = 2;        ///< from moments, so that the ends of the interval are covered
constexpr int most_rounds = 12;
constexpr double enough_effective = 500;  ///< independent draws: ends of the interval good to some per cent
constexpr double least_effective = 50;    ///< fewer give no reliable ends
constexpr std::size_t most_rescues = 40;  ///< further rounds where even these are not reached
}  // namespace sampling

struct Mode {
    Draws::NormalDensity normal;
    double value = 0.0;       ///< -ln posterior
    double log_weight = 0.0;  ///< ln of the posterior's integral around it
};

/// Adds the covariance, the inverse of a Hessian. Directions of small or negative curvature get the width of
/// a prior.
Mode with_covariance(Mode mode, const Matrix& hessian) {
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(hessian);
    const Vector values = solver.eigenvalues().cwiseAbs().cwiseMax(mode_search::least_curvature);
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
Mode find_mode(const CurvePosterior& posterior, const Vector& start) {
    using namespace mode_search;
    constexpr int critical = CurvePosterior::critical;
    Mode mode;
    mode.normal.mean = start;
    mode.value = posterior(start);
    Vector differences = Vector::Constant(first_difference);
    differences[critical] = first_velocity;
    for (int i = 0; i < most_steps; ++i) {
        Vector& point = mode.normal.mean;
        auto curvature = posterior.curvature(point, mode.value, differences);
        hold_scales(curvature);
        mode = with_covariance(mode, curvature.hessian);
        const Vector deviations = mode.normal.covariance.diagonal().cwiseSqrt();
        differences = (of_deviation * deviations).cwiseMin(first_difference).cwiseMax(least_difference);
        differences[critical] = std::min(first_velocity, differences[critical]);
        Vector step = -(mode.normal.covariance * curvature.gradient);
        step *= std::min(1.0, longest_step / step.cwiseAbs().maxCoeff());
        step *= std::min(1.0, longest_velocity / std::abs(step[critical]));
        const double before = mode.value;
        double length = 1.0;
        for (int shortened = 0; shortened < most_shortened; ++shortened, length *= shorter) {
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

/// Whether the curve of a mode is clearly more likely with one step less noise.
bool prefers_less_noise(const CurvePosterior& posterior, const Mode& mode) {
    Vector point = mode.normal.mean;
    point[CurvePosterior::noise] -= noise_steps::step;
    return posterior(point) < mode.value - noise_steps::clearly;
}

/// Gives the curve of a mode at least half the widths of the one at more noise. With little noise v_c may lie
/// at the edge of a single impact, where curvature shows nothing of what lies beyond.
void widen(Draws::NormalDensity& normal, const Draws::NormalDensity& at_more_noise) {
    constexpr int curve = CurvePosterior::noise;  // the parameters before noise and scatter
    normal.covariance.topLeftCorner<curve, curve>() +=
        0.25 * at_more_noise.covariance.topLeftCorner<curve, curve>();
}

/// Adds modes at ever less noise, each found from the one before. Where the noise is large, the curve cannot
/// treat any impact as an outlier, so there are hardly any false modes. Modes below the stated noise are
/// searched only if the impacts scatter by far less than stated.
void add_modes(std::vector<Mode>& modes, const CurvePosterior& posterior, Vector point) {
    using namespace noise_steps;
    const auto add_at = [&](double noise) {
        point[CurvePosterior::noise] = noise;
        modes.push_back(find_mode(posterior, point));
        point = modes.back().normal.mean;
    };
    for (const double noise : {2.0 * step, step, 0.0}) add_at(noise);
    for (double noise = -step;
         noise >= most_below && posterior.noise_known() && prefers_less_noise(posterior, modes.back());
         noise -= step) {
        add_at(noise);
        widen(modes.back().normal, modes[modes.size() - 2].normal);
    }
}

/// The modes found from the two best starting velocities, the one of greatest weight first, without those of
/// negligible weight. @throws ConvergenceError if no curve is possible
std::vector<Mode> modes_of(const CurvePosterior& posterior, const std::vector<double>& velocities) {
    std::vector<std::pair<double, Vector>> starts;
    for (const double v : velocities) {
        Vector point = Vector::Zero();
        point[CurvePosterior::critical] = std::log(v);
        starts.emplace_back(posterior(point), point);
    }
    std::ranges::sort(starts, {}, &std::pair<double, Vector>::first);
    std::vector<Mode> modes;
    for (std::size_t best = 0; best < 2; ++best) add_modes(modes, posterior, starts[best].second);
    std::ranges::sort(modes, std::ranges::greater(), &Mode::log_weight);
    if (!(modes.front().value < 1e9)) throw ConvergenceError("no curve of damping explains the impacts");
    std::erase_if(modes, [most = modes.front().log_weight](const Mode& mode) {
        return !(mode.log_weight > most - sampling::furthest_mode);
    });
    return modes;
}

/// Draws from the posterior, effectively as many as an interval needs. @throws ConvergenceError
Draws sampled(const CurvePosterior& posterior, const std::vector<Mode>& modes) {
    using namespace sampling;
    Draws draws(posterior);
    for (const Mode& mode : modes) draws.add(mode.normal, from_each_mode);
    draws.add(draws.moments(), from_first_moments);
    for (int i = 0; i < most_rounds && (i < least_rounds || draws.effective() < enough_effective); ++i)
        draws.add(draws.moments(), from_moments);
    // Where noise and scatter are hardly determined, the posterior is no normal density: its modes help.
    for (std::size_t i = 0; i < most_rescues && draws.effective() < least_effective; ++i)
        draws.add(i % 2 == 0 ? draws.moments() : modes[i / 2 % modes.size()].normal, from_moments);
    if (draws.effective() >= least_effective) return draws;
    const bool stated = posterior.noise_known();
    throw ConvergenceError(
        std::string(stated ? "the stated uncertainties are so small that " : "") +
        "hardly any smooth damping explains all impacts (the curves drawn are worth " +
        shortest(std::round(draws.effective())) + " independent ones, " +
        shortest(std::round(least_effective)) +
        " are needed); remedies: " + (stated ? "larger uncertainties, or " : "") +
        "the scatter of particle sizes (--size-scatter, in a case \"size_scatter\" under \"fit\")");
}

/// The damping along the mean of the curves drawn, begun at the estimated v_c.
/// @param fastest impact [m/s]
EstimatedDamping mean_damping(const CurveTable& table, const CurvePosterior& posterior, const Draws& draws,
                              double critical_velocity, double fastest) {
    constexpr int points = 40;
    EstimatedDamping damping;
    Vector parameters = draws.moments().mean;
    const double critical = parameters[CurvePosterior::critical] = std::log(critical_velocity);
    const SmoothDamping curve = posterior.curve(parameters);
    const double range = std::log(fastest) - critical;
    for (int i = 0; i <= points && range > 0; ++i) {
        const double share = static_cast<double>(i) / points;
        const double x = critical + share * share * range;  // e begins with a root of ln v
        damping.velocity.push_back(i == 0 ? critical_velocity : std::exp(x));
        damping.damping.push_back(std::exp(table.log_capture_damping(x) - curve.at_log_velocity(x).distance));
    }
    return damping;
}

/// v_c of the draws with a common error of scale: each at the middles of equal parts of its distribution.
MarginalSample with_scale(const Draws& draws, double uncertainty) {
    if (!(uncertainty > 0.0))
        return draws.marginal(CurvePosterior::critical, [](double logarithm) { return std::exp(logarithm); });
    constexpr int parts = 9;
    const MarginalSample logarithms = draws.marginal(CurvePosterior::critical, [](double x) { return x; });
    constexpr int places = 400;
    std::vector<std::pair<double, double>> values;
    for (int i = 0; i < places; ++i)
        for (int k = 0; k < parts; ++k)
            values.emplace_back(std::exp(logarithms.quantile((i + 0.5) / places) +
                                         uncertainty * gsl::normal_quantile((k + 0.5) / parts)),
                                1.0 / (places * parts));
    return MarginalSample(std::move(values));
}

/// v_c and the curve from the draws of a posterior. @param scale relative uncertainty of all velocities [1]
/// @param fastest impact [m/s]
CurveEstimate curve_estimate(const CurveTable& table, const CurvePosterior& posterior, const Draws& draws,
                             double scale, double fastest) {
    const MarginalSample velocity = with_scale(draws, scale);
    const double tail = 0.5 * (1.0 - confidence);
    const Interval estimate{velocity.mean(), velocity.standard_deviation(), velocity.quantile(tail),
                            velocity.quantile(1.0 - tail)};
    const auto damping = [&](double at) { return std::exp(table.log_capture_damping(std::log(at))); };
    const double v = estimate.value;
    const double slope = (damping(1.001 * v) - damping(0.999 * v)) / (0.002 * v);
    return {.critical_velocity = estimate,
            .critical_damping = {damping(v), slope * estimate.standard_uncertainty, damping(*estimate.lower),
                                 damping(*estimate.upper)},
            .parameters = draws.likeliest(),
            .damping = mean_damping(table, posterior, draws, v, fastest),
            .effective = draws.effective(),
            .scatter = posterior.scatter_of(draws.likeliest())};
}

/// Starting values of v_c, around the slowest rebounds and the fastest captures [m/s].
std::vector<double> starts_of(const std::vector<RecordedImpact>& impacts) {
    std::vector<double> rebounds;
    std::vector<double> captures;
    for (const RecordedImpact& impact : impacts)
        (impact.recorded == Recorded::rebound ? rebounds : captures).push_back(impact.velocity);
    std::sort(rebounds.begin(), rebounds.end());
    std::sort(captures.begin(), captures.end());
    const double slowest = rebounds[rebounds.size() / 20];
    std::vector<double> starts{0.97 * slowest, 0.8 * slowest, 0.6 * slowest, 0.4 * slowest, 1.2 * slowest};
    if (!captures.empty()) starts.push_back(std::sqrt(captures[(captures.size() - 1) * 19 / 20] * slowest));
    return starts;
}

/// Refuses rebounds that are too few for a curve. @throws InputError
void require_enough(const std::vector<RecordedImpact>& impacts, bool noise_known) {
    const std::size_t needed = noise_known ? 3 : 5;
    std::set<double> distinct;
    for (const RecordedImpact& impact : impacts) {
        if (impact.recorded == Recorded::rebound) distinct.insert(impact.rebound / impact.velocity);
        if (distinct.size() >= needed) return;
    }
    throw InputError(counted(distinct.size(), "different restitution") +
                         (noise_known ? "" : " without stated uncertainties") + ", where at least " +
                         std::to_string(needed) + " are needed",
                     "more rebounds");
}

/// Note on recorded captures that may be slow rebounds, as the curve gives them a rebound within the noise.
std::optional<Finding> slow_rebound_note(const CurveEstimate& estimate, const SmoothDamping& curve,
                                         const std::vector<RecordedImpact>& impacts) {
    double doubtful = 0.0;
    double end = 0.0;
    for (const RecordedImpact& impact : impacts) {
        if (impact.recorded != Recorded::zero) continue;
        const double r = impact.velocity * curve.at_log_velocity(impact.log_velocity).restitution;
        const double seen = std::max(impact.resolution, estimate.scatter.noise * impact.rebound_u);
        if (impact.velocity < estimate.critical_velocity.value || r > 3.0 * seen) continue;
        doubtful += impact.count;
        end = std::max(end, seen);
    }
    if (doubtful == 0.0) return std::nullopt;
    return Finding{"slow-rebounds", Severity::doubt,
                   shortest(doubtful) + " of the recorded captures may be " +
                       (doubtful == 1.0 ? "a rebound" : "rebounds") + " slower than the " +
                       shortest(std::round(1e3 * end) / 1e3) + " m/s that can be told from rest"};
}

/// Note on a noise that had to be enlarged to fit, with its factor.
std::optional<Finding> misfit_note(const Scatter& scatter, bool noise_known) {
    if (!noise_known || scatter.noise < 1.25) return std::nullopt;
    return Finding{"estimate-scatter", Severity::doubt,
                   "the impacts scatter " + shortest(std::round(100.0 * scatter.noise) / 100.0) +
                       " times as much as stated about any smooth damping: the interval is widened by that"};
}

/// Note on impacts that bound v_c from above alone.
std::optional<Finding> no_captures_note(const MeasurementSet& set) {
    if (set.captures() > 0) return std::nullopt;
    return Finding{
        "no-captures", Severity::doubt,
        "no impact was captured: v_c below the slowest rebound rests on the assumption that damping "
        "goes on as it does above it"};
}

/// Note on damping that is greater at faster impacts, which the prior hardly expects.
std::optional<Finding> rising_note(const EstimatedDamping& curve) {
    constexpr double reach = 2.5;  // of v_c
    constexpr double rise = 0.1;   // of ln eta
    if (curve.velocity.empty()) return std::nullopt;
    const double critical = curve.velocity.front();
    for (std::size_t i = 1; i < curve.velocity.size() && curve.velocity[i] <= reach * critical; ++i)
        if (curve.damping[i] > std::exp(rise) * curve.damping.front())
            return Finding{
                "damping-rises", Severity::doubt,
                "damping rises with velocity above v_c, where it mostly falls: the interval has held "
                "less often then"};
    return std::nullopt;
}

}  // namespace

CriticalVelocityEstimate estimate_critical_velocity(const ContactModel& model, const MeasurementSet& set,
                                                    const EstimateOptions& options) {
    std::vector<RecordedImpact> impacts = recorded_impacts(set);
    bool noise_known = set.has_noise();
    require_enough(impacts, noise_known);
    const double neighbours = noise_known ? 0.0 : noise_of_neighbours(impacts);
    if (impacts.size() > few_impacts) {
        if (!noise_known)
            for (RecordedImpact& impact : impacts) impact.incident_u = impact.rebound_u = neighbours;
        noise_known = true;
        impacts = grouped(std::move(impacts));
    }
    const auto [slowest, fastest] = std::ranges::minmax_element(impacts, {}, &RecordedImpact::velocity);
    const CurveTable table(model, {0.1 * slowest->velocity, 2.0 * fastest->velocity});
    CurvePrior prior{.noise_known = noise_known,
                     .noise = std::clamp(neighbours, 1e-6 * fastest->velocity, 0.2 * fastest->velocity),
                     .scatter = {}};
    if (options.size_scatter) prior.scatter = std::max(1e-6, 2.0 * *options.size_scatter);
    const CurvePosterior posterior(table, impacts, prior);
    const Draws draws = sampled(posterior, modes_of(posterior, starts_of(impacts)));
    CriticalVelocityEstimate estimate{
        .curve = curve_estimate(table, posterior, draws, options.scale_uncertainty, fastest->velocity),
        .rebounds = set.rebounds(),
        .captures = set.captures(),
        .noise_known = set.has_noise()};
    const Interval& v = estimate.curve.critical_velocity;
    constexpr double widest = 40.0;
    if (*v.upper > widest * *v.lower)
        throw InputError("the impacts bound v_c no closer than " + shortest(*v.lower) + " to " +
                             shortest(*v.upper) + " m/s",
                         "impacts closer to v_c");
    const SmoothDamping curve = posterior.curve(estimate.curve.parameters);
    const bool grouped_without_noise = noise_known && !set.has_noise();
    for (const auto& note : {slow_rebound_note(estimate.curve, curve, impacts),
                             misfit_note(estimate.curve.scatter, set.has_noise()), no_captures_note(set),
                             rising_note(estimate.curve.damping)})
        if (note) estimate.findings.push_back(*note);
    if (grouped_without_noise) estimate.curve.scatter.noise *= neighbours;  // a velocity, as without groups
    return estimate;
}

}  // namespace ashimpact

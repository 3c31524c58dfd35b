// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/curve/headline.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/inference/curve/curve_posterior.hpp"
#include "solver/inference/curve/recorded_impacts.hpp"
#include "solver/numeric/gsl/statistics.hpp"
#include "solver/numeric/interpolation.hpp"

namespace ashimpact {

namespace {

/// Places in ln v_c at which its density is computed.
namespace places {
constexpr std::size_t first = 36;    ///< over all v_c that the impacts allow
constexpr std::size_t refined = 24;  ///< over those of some weight
constexpr int refinements = 2;
constexpr double furthest = 11.0;   ///< of the logarithm of a density that counts, below the greatest
constexpr std::size_t between = 8;  ///< points between two places
}  // namespace places

/// Standard deviation of ln v_c by what no curve of this form describes.
constexpr double form_error_of_velocity = 0.006;

/// Weight of what captures and rebounds tell of v_c without any curve.
constexpr double outcomes_share = 0.15;

/// Least v_c below the slowest impact, in ln v.
constexpr double below_slowest = 2.2;

/// Even places in ln v_c and the logarithm of the density there.
struct Density {
    double lower;
    double step;
    std::vector<double> logarithm;

    Density(const std::function<double(double)>& function, double from, double to, std::size_t count)
        : lower(from), step((to - from) / static_cast<double>(count - 1)), logarithm(count) {
        batch::for_each_item(count,
                             [&](std::size_t i) { logarithm[i] = function(at(static_cast<double>(i))); });
    }
    [[nodiscard]] double at(double place) const { return lower + step * place; }
    [[nodiscard]] double greatest() const { return *std::ranges::max_element(logarithm); }
    /// ln density between places, by cubic interpolation.
    [[nodiscard]] double between(std::size_t i, double t) const {
        const std::size_t last = logarithm.size() - 1;
        const auto w = cubic_weights(t);
        return w[0] * logarithm[i == 0 ? 0 : i - 1] + w[1] * logarithm[i] + w[2] * logarithm[i + 1] +
               w[3] * logarithm[std::min(i + 2, last)];
    }
    /// Ends of the places of some weight.
    [[nodiscard]] std::pair<double, double> ends() const {
        const double least = greatest() - places::furthest;
        std::size_t first = 0;
        while (logarithm[first] < least) ++first;
        std::size_t last = logarithm.size() - 1;
        while (logarithm[last] < least) --last;
        return {at(static_cast<double>(first == 0 ? 0 : first - 1)),
                at(static_cast<double>(std::min(last + 1, logarithm.size() - 1)))};
    }
};

Density density_of(const std::function<double(double)>& function, const std::pair<double, double>& range) {
    Density density(function, range.first, range.second, places::first);
    for (int i = 0; i < places::refinements; ++i) {
        const auto [lower, upper] = density.ends();
        density = Density(function, lower, upper, places::refined);
    }
    return density;
}

/// Adds the v_c of a density. @param share of all weight
void add_velocities(std::vector<LogNormalPart>& velocities, const Density& density, double share) {
    const std::size_t first = velocities.size();
    const double greatest = density.greatest();
    double total = 0.0;
    for (std::size_t i = 0; i + 1 < density.logarithm.size(); ++i)
        for (std::size_t k = 0; k < places::between; ++k) {
            const double t = (static_cast<double>(k) + 0.5) / places::between;
            const double weight = std::exp(density.between(i, t) - greatest);
            velocities.push_back({density.at(static_cast<double>(i) + t), weight});
            total += weight;
        }
    for (std::size_t i = first; i < velocities.size(); ++i) velocities[i].share *= share / total;
}

/// The least damping that captures; none is needed up to the undamped v_c of the law [kg/s].
double capture_damping(const ContactModel& model, double velocity) {
    const double first = model.range().lower;
    if (velocity >= first) return model.damping_coefficient(velocity, 0.0);
    // The energy that damping has to take goes with the square of the undamped restitution.
    const double share = model.greatest_restitution(velocity) / model.greatest_restitution(first);
    return model.damping_coefficient(first, 0.0) * share * share;
}

/// The damping along a curve, begun at its v_c. @param fastest impact [m/s]
EstimatedDamping damping_along(const ContactModel& model, const OnsetCurve& curve, double fastest) {
    constexpr int points = 40;
    EstimatedDamping damping;
    const double critical = curve.log_critical_velocity();
    const double range = std::log(fastest) - critical;
    for (int i = 0; i <= points && range > 0; ++i) {
        const double share = static_cast<double>(i) / points;
        const double x = critical + share * share * range;  // e begins with a root of ln v
        const double v = std::exp(x);
        if (i > 0 && v < model.range().lower) continue;
        const double e = std::min(curve.restitution(x), 0.999 * model.greatest_restitution(v));
        damping.velocity.push_back(v);
        damping.damping.push_back(i == 0 ? capture_damping(model, v) : model.damping_coefficient(v, e));
    }
    return damping;
}

/// Ends of the v_c that the impacts allow, in ln v.
std::pair<double, double> range_of(const std::vector<RecordedImpact>& impacts) {
    std::vector<double> rebounds;
    std::vector<double> captures;
    double slowest = impacts.front().log_velocity;
    for (const RecordedImpact& impact : impacts) {
        (impact.recorded == Recorded::rebound ? rebounds : captures).push_back(impact.log_velocity);
        slowest = std::min(slowest, impact.log_velocity);
    }
    std::sort(rebounds.begin(), rebounds.end());
    std::sort(captures.begin(), captures.end());
    double upper = rebounds[rebounds.size() / 2];
    if (!captures.empty()) upper = std::max(upper, captures[(captures.size() - 1) * 9 / 10]);
    return {slowest - below_slowest, upper + 0.1};
}

/// v_in of the fastest impact [m/s].
double fastest_of(const std::vector<RecordedImpact>& impacts) {
    return std::ranges::max_element(impacts, {}, &RecordedImpact::velocity)->velocity;
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
std::optional<Finding> slow_rebound_note(const CurveEstimate& estimate, const OnsetCurve& curve,
                                         const std::vector<RecordedImpact>& impacts) {
    double doubtful = 0.0;
    double end = 0.0;
    for (const RecordedImpact& impact : impacts) {
        if (impact.recorded != Recorded::zero) continue;
        const double r = impact.velocity * curve.restitution(impact.log_velocity);
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

/// Note on particles that differ more than those of one kind.
std::optional<Finding> particles_note(const Scatter& scatter) {
    constexpr double wide = 0.15;
    if (scatter.threshold < wide) return std::nullopt;
    return Finding{"particles-differ", Severity::doubt,
                   "v_c differs between particles by about " +
                       shortest(std::round(100.0 * scatter.threshold)) +
                       " %: the interval holds for the median particle; if there are two kinds, for neither"};
}

/// Note on impacts that leave v_c wide open.
std::optional<Finding> wide_note(const Interval& velocity) {
    constexpr double wide = 3.0;
    const double factor = *velocity.upper / *velocity.lower;
    if (factor < wide) return std::nullopt;
    return Finding{"wide-interval", Severity::doubt,
                   "the impacts bound v_c only within a factor of " + readable_number(factor, 2) +
                       ": impacts closer to it would narrow the interval"};
}

/// Note on rebounds that are means, of which each counts once beside captures that count by their impacts.
std::optional<Finding> means_note(const MeasurementSet& set) {
    const auto is_mean = [](const Measurement& point) { return point.count > 1 && !point.captured(); };
    if (!std::ranges::any_of(set.points, is_mean)) return std::nullopt;
    return Finding{"means", Severity::doubt,
                   "rebounds that are means of several impacts, as bins are, count once each, captures as "
                   "often as they have impacts: v_c tends to be too high; single impacts do without this"};
}

/// Notes on impacts around v_c: none between the fastest capture and a much faster rebound, a remark, as the
/// outcomes alone make the interval span most of that gap; or no rebound between rest and a speed that the
/// camera resolves.
/// @param noise of slow rebounds where none is stated [m/s]
std::optional<Finding> onset_note(const std::vector<RecordedImpact>& impacts, std::optional<double> noise) {
    constexpr double wide = 1.5;
    constexpr double resolved = 2.5;  // in standard uncertainties
    double capture = 0.0;
    bool zero = false;
    const RecordedImpact* slowest = nullptr;
    const RecordedImpact* least = nullptr;
    for (const RecordedImpact& impact : impacts) {
        if (impact.recorded != Recorded::rebound) {
            capture = std::max(capture, impact.velocity);
            zero = zero || (impact.recorded == Recorded::zero && impact.resolution == 0.0);
            continue;
        }
        if (slowest == nullptr || impact.velocity < slowest->velocity) slowest = &impact;
        if (least == nullptr || impact.rebound < least->rebound) least = &impact;
    }
    if (capture > 0.0 && slowest->velocity > wide * capture)
        return Finding{"no-impacts-near-onset", Severity::remark,
                       "no impact between " + shortest(capture) + " m/s, captured, and " +
                           shortest(slowest->velocity) + " m/s: the interval of v_c spans most of this gap"};
    // A sharp onset leaves the same gap.
    if (zero && least->rebound > resolved * noise.value_or(std::max(least->incident_u, least->rebound_u)))
        return Finding{"no-slow-rebounds", Severity::doubt,
                       (least->count > 1 ? "no mean rebound slower than " : "no rebound slower than ") +
                           readable_number(least->rebound, 3) +
                           " m/s is recorded: if slower ones were taken for captures, v_c is lower"};
    return std::nullopt;
}

/// Note on a work of adhesion that alone captures faster impacts than those that do.
std::optional<Finding> adhesion_note(const ContactModel& model, double critical) {
    if (model.greatest_restitution(critical) > 0.0) return std::nullopt;
    return Finding{
        "adhesion-too-strong", Severity::doubt,
        "by this law and work of adhesion impacts are captured up to a higher velocity without any "
        "damping: the impacts contradict it"};
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

/// @param model for the scatter of sizes, if that is given
OnsetEstimate estimated_velocity(const MeasurementSet& set, const EstimateOptions& options,
                                 const ContactModel* model) {
    std::vector<RecordedImpact> impacts = recorded_impacts(set);
    bool noise_known = set.has_noise();
    require_enough(impacts, noise_known);
    const double neighbours = noise_known ? 0.0 : noise_of_neighbours(impacts);
    std::optional<double> slow_noise;
    if (!noise_known) slow_noise = std::min(neighbours, noise_of_neighbours(impacts, 0.2));
    const bool is_grouped = impacts.size() > few_impacts;
    if (is_grouped) {
        if (!noise_known)
            for (RecordedImpact& impact : impacts) impact.incident_u = impact.rebound_u = neighbours;
        noise_known = true;
        impacts = grouped(std::move(impacts));
    }
    const double fastest = fastest_of(impacts);
    const std::pair<double, double> range = range_of(impacts);
    CurvePrior prior{.noise_known = noise_known,
                     .noise = std::clamp(neighbours, 1e-6 * fastest, 0.2 * fastest),
                     .scatter = {}};
    if (options.size_scatter) {
        const double near = std::exp(range.second);
        const double by_damping =
            std::log(1.2) / std::log(capture_damping(*model, near) / capture_damping(*model, near / 1.2));
        prior.scatter = std::max(1e-4, 2.0 * by_damping * *options.size_scatter);
    }
    const CurvePosterior posterior(impacts, prior);
    // Laboratories choose velocities around v_c, so v_c is unlikely to lie far below the slowest impact.
    const auto far_below = [&, slowest = range.first + below_slowest](double x) {
        return 0.5 * std::pow(std::max(0.0, slowest - 1.2 - x) / 0.4, 2);
    };
    const Density density =
        density_of([&](double x) { return posterior.at(x).log_density - far_below(x); }, range);
    const Density outcomes =
        density_of([&](double x) { return posterior.log_outcomes(x) - far_below(x); }, range);
    std::vector<LogNormalPart> velocities;
    add_velocities(velocities, density, 1.0 - outcomes_share);
    add_velocities(velocities, outcomes, outcomes_share);
    const Interval found =
        interval_of(velocities, std::hypot(options.scale_uncertainty, form_error_of_velocity));
    const LikeliestCurve likeliest = posterior.at(std::log(found.value));
    return {std::move(impacts), is_grouped, neighbours, slow_noise, found, likeliest};
}

}  // namespace

std::optional<Finding> no_captures_note(const MeasurementSet& set) {
    if (set.captures() > 0) return std::nullopt;
    return Finding{
        "no-captures", Severity::doubt,
        "no impact was captured: v_c below the slowest rebound rests on the assumption that damping "
        "goes on as it does above it"};
}

std::optional<OnsetEstimate> estimate_without_law(const MeasurementSet& set, const EstimateOptions& options) {
    if (options.size_scatter) return std::nullopt;
    return estimated_velocity(set, options, nullptr);
}

CriticalVelocityEstimate estimate_critical_velocity(const ContactModel& model, const MeasurementSet& set,
                                                    const EstimateOptions& options,
                                                    const OnsetEstimate* known) {
    const OnsetEstimate own = known ? *known : estimated_velocity(set, options, &model);
    const auto& [impacts, is_grouped, neighbours, slow_noise, found_velocity, likeliest] = own;
    const OnsetCurve& curve = likeliest.curve;
    const double slope = (capture_damping(model, 1.001 * found_velocity.value) -
                          capture_damping(model, 0.999 * found_velocity.value)) /
                         (0.002 * found_velocity.value);
    const double damping = capture_damping(model, found_velocity.value);
    CriticalVelocityEstimate estimate{
        .curve = {.critical_velocity = found_velocity,
                  .critical_damping = {damping, slope * found_velocity.standard_uncertainty,
                                       capture_damping(model, *found_velocity.lower),
                                       capture_damping(model, *found_velocity.upper)},
                  .damping = damping_along(model, curve, fastest_of(impacts)),
                  .scatter = likeliest.scatter,
                  .damping_scatter =
                      damping > 0.0 ? likeliest.scatter.threshold * slope * found_velocity.value / damping
                                    : 0.0},
        .rebounds = set.rebounds(),
        .captures = set.captures(),
        .noise_known = set.has_noise()};
    const Interval& v = estimate.curve.critical_velocity;
    constexpr double widest = 40.0;
    if (*v.upper > widest * *v.lower)
        throw InputError("the impacts bound v_c no closer than " + shortest(*v.lower) + " to " +
                             shortest(*v.upper) + " m/s",
                         "impacts closer to v_c");
    const bool grouped_without_noise = is_grouped && !set.has_noise();
    for (const auto& note :
         {slow_rebound_note(estimate.curve, curve, impacts),
          misfit_note(estimate.curve.scatter, set.has_noise()), particles_note(estimate.curve.scatter),
          wide_note(v), no_captures_note(set), means_note(set), adhesion_note(model, found_velocity.value),
          rising_note(estimate.curve.damping), onset_note(impacts, slow_noise)})
        if (note) estimate.findings.push_back(*note);
    if (grouped_without_noise) estimate.curve.scatter.noise *= neighbours;  // a velocity, as without groups
    return estimate;
}

}  // namespace ashimpact

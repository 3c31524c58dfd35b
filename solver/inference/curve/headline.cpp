// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/curve/headline.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/counting.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "solver/inference/curve/impact_groups.hpp"

namespace ashimpact {

namespace {

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
        const double r = impact.velocity * curve.at(impact.log_velocity).restitution;
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

}  // namespace

CriticalVelocityEstimate estimate_critical_velocity(const ContactModel& model, const MeasurementSet& set,
                                                    const EstimateOptions& options) {
    std::vector<RecordedImpact> impacts = recorded_impacts(set);
    bool noise_known = set.has_noise();
    require_enough(impacts, noise_known);
    const auto rebounds =
        static_cast<std::size_t>(std::count_if(impacts.begin(), impacts.end(), [](const RecordedImpact& i) {
            return i.recorded == Recorded::rebound;
        }));
    const std::size_t all = impacts.size();
    const double neighbours = noise_known ? 0.0 : noise_of_neighbours(impacts);
    if (all > few_impacts) {
        if (!noise_known)
            for (RecordedImpact& impact : impacts) impact.incident_u = impact.rebound_u = neighbours;
        noise_known = true;
        impacts = grouped(std::move(impacts));
    }
    const auto [slowest, fastest] = std::minmax_element(
        impacts.begin(), impacts.end(),
        [](const RecordedImpact& a, const RecordedImpact& b) { return a.velocity < b.velocity; });
    const CurveTable table(model, {0.1 * slowest->velocity, 2.0 * fastest->velocity});
    CurvePrior prior{.noise_known = noise_known,
                     .noise = std::clamp(neighbours, 1e-6 * fastest->velocity, 0.2 * fastest->velocity),
                     .scatter = {}};
    if (options.size_scatter) prior.scatter = std::max(1e-6, 2.0 * *options.size_scatter);
    CriticalVelocityEstimate estimate{.curve = estimate_curve(table, impacts, prior, starts_of(impacts)),
                                      .rebounds = rebounds,
                                      .captures = all - rebounds,
                                      .noise_known = set.has_noise()};
    const Interval& v = estimate.curve.critical_velocity;
    constexpr double widest = 40.0;
    if (*v.upper > widest * *v.lower)
        throw InputError("the impacts bound v_c no closer than " + shortest(*v.lower) + " to " +
                             shortest(*v.upper) + " m/s",
                         "impacts closer to v_c");
    const CurvePosterior posterior(table, impacts, prior);
    const SmoothDamping curve = posterior.curve(estimate.curve.parameters);
    const bool grouped_without_noise = noise_known && !set.has_noise();
    for (const auto& note : {slow_rebound_note(estimate.curve, curve, impacts),
                             misfit_note(estimate.curve.scatter, set.has_noise())})
        if (note) estimate.findings.push_back(*note);
    if (grouped_without_noise) estimate.curve.scatter.noise *= neighbours;  // a velocity, as without groups
    return estimate;
}

}  // namespace ashimpact

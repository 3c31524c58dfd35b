// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "solver/inference/critical_velocity_uncertainty.hpp"
#include "solver/inference/curve/recorded_impacts.hpp"
#include "solver/numeric/gsl/solvers.hpp"
#include "solver/numeric/gsl/statistics.hpp"
#include "solver/statistics/interval.hpp"

namespace ashimpact {

namespace {

constexpr std::size_t few_outcomes = 2500;

/// The transition from captures to rebounds: P(capture at v) = Phi((center - v)/width), where width^2 is the
/// variance of v_in plus an extra variance.
struct CaptureTransition {
    double center;          ///< [m/s]
    double extra_variance;  ///< in addition to the noise; 0 if the noise explains the mixing [m2/s2]
};

/// Impacts of that outcome; a mean counts as often as it has impacts.
double impacts_of(const MeasurementSet& set, bool captured) {
    std::size_t impacts = 0;
    for (const Measurement& point : set.points)
        if (point.captured() == captured) impacts += point.count;
    return static_cast<double>(impacts);
}

/// Share of the pairs of a capture and a rebound in which the capture is the faster (Mann and Whitney 1947);
/// pairs of equal velocity count half.
double reversed_share(const MeasurementSet& set) {
    std::vector<double> rebounds;
    for (const Measurement& point : set.points)
        if (!point.captured()) rebounds.insert(rebounds.end(), point.count, point.velocity);
    std::sort(rebounds.begin(), rebounds.end());
    double reversed = 0.0;
    for (const Measurement& point : set.points) {
        if (!point.captured()) continue;
        const auto [first, last] = std::equal_range(rebounds.begin(), rebounds.end(), point.velocity);
        reversed += static_cast<double>(point.count) *
                    (static_cast<double>(first - rebounds.begin()) + 0.5 * static_cast<double>(last - first));
    }
    return reversed / (static_cast<double>(rebounds.size()) * impacts_of(set, true));
}

/// -2 ln L of the outcomes of a series with captures and rebounds. Of large sets, neighbours of the same
/// outcome within a tenth of their noise are merged.
class OutcomeLikelihood {
  public:
    /// @param set with captures and rebounds, validated
    /// @param least standard deviation of v_in in place of an unknown noise [m/s]
    OutcomeLikelihood(const MeasurementSet& set, double least)
        : captured_(impacts_of(set, true) / (impacts_of(set, true) + impacts_of(set, false))),
          reversed_(reversed_share(set)) {
        for (const Measurement& point : set.points)
            outcomes_.push_back({.velocity = point.velocity,
                                 .variance = point.noise ? point.noise->incident : least * least,
                                 .sign = point.captured() ? 1.0 : -1.0,
                                 .count = static_cast<double>(point.count)});
        noise_ = outcomes_.front().variance;
        const auto [first, last] = std::ranges::minmax_element(outcomes_, {}, &Outcome::velocity);
        slowest_ = first->velocity;
        fastest_ = last->velocity;
        double capture = 0.0;
        double rebound = fastest_;
        for (const Outcome& outcome : outcomes_)
            if (outcome.sign > 0.0)
                capture = std::max(capture, outcome.velocity);
            else
                rebound = std::min(rebound, outcome.velocity);
        middle_ = 0.5 * (capture + rebound);
        if (outcomes_.size() > few_outcomes) merge();
    }

    /// -2 ln L.
    [[nodiscard]] double misfit(const CaptureTransition& transition) const {
        return sum_of(transition, [](const Outcome& outcome, double z, double) {
            return -2.0 * outcome.count * gsl::normal_log_probability(z);
        });
    }

    /// The most likely centre at an extra variance. It is unique because -2 ln L is convex in the centre;
    /// between outcomes far apart, where -2 ln L is flat, it is their middle. Can be negative [m/s].
    [[nodiscard]] double best_center(double extra_variance) const {
        const auto slope_at = [&](double center) { return slope({center, extra_variance}); };
        const double deviation = std::sqrt(noise_ + extra_variance);
        if (std::abs(slope_at(middle_)) * deviation < 1e-9) return middle_;
        double lower = slowest_;
        double upper = fastest_;
        for (double step = deviation; slope_at(lower) > 0.0; step *= 2.0) lower -= step;
        for (double step = deviation; slope_at(upper) < 0.0; step *= 2.0) upper += step;
        if (lower == upper) return lower;
        return gsl::brent(slope_at, lower, upper, {.relative = 0.0, .absolute = 1e-7 * deviation}).root;
    }

    /// -2 ln L at a centre with the extra variance that is likeliest there, up to the range of v_in squared.
    [[nodiscard]] double profile(double center) const {
        return misfit({center, best_extra_variance(center)});
    }

    /// The most likely transition, with an extra variance only if that makes the outcomes more likely.
    /// @return none where no extra width up to the range of v_in explains them better than outcomes that do
    /// not depend on the velocity, or the centre is not positive
    [[nodiscard]] std::optional<CaptureTransition> best() const {
        const CaptureTransition sharp{best_center(0.0), 0.0};
        const double allowed = std::pow(confidence_quantile(), 2);
        const bool noise_explains = misfit(sharp) <= without_threshold() + allowed;
        std::optional<CaptureTransition> found;
        if (fastest_ > slowest_ && reversed_ < 0.5) {
            const CaptureTransition widened = at_best_width();
            if (std::sqrt(widened.extra_variance) < 0.99 * (fastest_ - slowest_)) found = widened;
        }
        if (!found && noise_explains) found = sharp;
        if (found && !(found->center > 0.0)) found.reset();
        return found;
    }

  private:
    struct Outcome {
        double velocity;
        double variance;     ///< of v_in
        double sign;         ///< 1 for a capture, -1 for a rebound
        double count = 1.0;  ///< impacts merged into this one
    };

    void merge() {
        constexpr double cell = 0.1;            // of the standard deviation
        constexpr double like_variances = 1.2;  // greatest ratio
        std::ranges::sort(outcomes_, {},
                          [](const Outcome& o) { return std::tuple(o.sign, o.velocity, o.variance); });
        std::vector<Outcome> merged;
        std::optional<Outcome> first;
        for (const Outcome& outcome : outcomes_) {
            const bool alike = first && outcome.sign == first->sign &&
                               outcome.velocity - first->velocity <= cell * std::sqrt(first->variance) &&
                               outcome.variance <= like_variances * first->variance &&
                               first->variance <= like_variances * outcome.variance;
            if (!alike) {
                first = outcome;
                merged.push_back(outcome);
                continue;
            }
            Outcome& mean = merged.back();
            mean.count += 1.0;
            mean.velocity += (outcome.velocity - mean.velocity) / mean.count;
            mean.variance += (outcome.variance - mean.variance) / mean.count;
        }
        outcomes_ = std::move(merged);
    }

    /// Sum over the outcomes of term(outcome, z, deviation), with z the distance of v_in from the centre,
    /// positive on the side of the outcome, in standard deviations.
    template <class Term>
    [[nodiscard]] double sum_of(const CaptureTransition& transition, const Term& term) const {
        double sum = 0.0;
        for (const Outcome& outcome : outcomes_) {
            const double deviation = std::sqrt(outcome.variance + transition.extra_variance);
            sum +=
                term(outcome, outcome.sign * (transition.center - outcome.velocity) / deviation, deviation);
        }
        return sum;
    }

    [[nodiscard]] double slope(const CaptureTransition& transition) const {
        return sum_of(transition, [](const Outcome& outcome, double z, double deviation) {
            return -2.0 * outcome.count * outcome.sign * gsl::normal_log_probability_slope(z) / deviation;
        });
    }

    [[nodiscard]] double variance_slope(const CaptureTransition& transition) const {
        return sum_of(transition, [](const Outcome& outcome, double z, double deviation) {
            return outcome.count * gsl::normal_log_probability_slope(z) * z / (deviation * deviation);
        });
    }

    [[nodiscard]] double best_extra_variance(double center) const {
        // -2 ln L is convex in 1/width where all have the same noise: one minimum, or an end.
        const auto variance = [&](double log_growth) { return noise_ * std::expm1(log_growth); };
        const auto slope_at = [&](double log_growth) {
            return variance_slope({center, variance(log_growth)});
        };
        const double most = std::log1p(std::pow(fastest_ - slowest_, 2) / noise_);
        if (slope_at(0.0) >= 0.0) return 0.0;
        if (slope_at(most) <= 0.0) return variance(most);
        return variance(gsl::brent(slope_at, 0.0, most, {.relative = 0.0, .absolute = 1e-3}).root);
    }

    [[nodiscard]] double without_threshold() const {
        double all = 0.0;
        for (const Outcome& outcome : outcomes_) all += outcome.count;
        return -2.0 * all * (captured_ * std::log(captured_) + (1.0 - captured_) * std::log1p(-captured_));
    }

    [[nodiscard]] CaptureTransition at_best_width() const {
        constexpr int steps = 24;
        const double most = std::log(fastest_ - slowest_);
        const double step = std::log(1e4) / steps;
        const auto at_width = [&](double log_width) {
            const double variance = std::exp(2.0 * log_width);
            return misfit({best_center(variance), variance});
        };
        CaptureTransition best{best_center(0.0), 0.0};
        double least = misfit(best);
        std::optional<double> width;
        for (int i = 0; i <= steps; ++i) {
            const double log_width = most - i * step;
            const double here = at_width(log_width);
            if (here >= least) continue;
            least = here;
            width = log_width;
        }
        if (!width) return best;
        const double found =
            gsl::minimise_between(at_width, *width - step, *width, std::min(*width + step, most + step));
        const double variance = std::exp(2.0 * std::min(found, most));
        return {best_center(variance), variance};
    }

    std::vector<Outcome> outcomes_;
    double noise_;     ///< variance of v_in of the first impact
    double slowest_;   ///< v_in
    double fastest_;   ///< v_in
    double middle_;    ///< between the fastest capture and the slowest rebound
    double captured_;  ///< share of captures
    double reversed_;  ///< reversed_share()
};

/// The set, sorted; if it states no noise and has enough rebounds, with the noise estimated from their
/// scatter.
MeasurementSet with_noise(const MeasurementSet& set) {
    constexpr std::size_t enough = 6;
    MeasurementSet result = set;
    result.points = set.sorted();
    if (set.has_noise() || set.rebounds() < enough) return result;
    const double u = noise_of_neighbours(recorded_impacts(set));
    if (u > 0.0)
        for (Measurement& point : result.points) point.noise = VelocityNoise::of_velocities(u, u);
    return result;
}

double mean_noise(const MeasurementSet& set) {
    double sum = 0.0;
    for (const Measurement& point : set.points) sum += point.noise ? point.noise->incident : 0.0;
    return std::sqrt(sum / static_cast<double>(set.points.size()));
}

void note_range(const MeasurementSet& set, MeasuredCriticalVelocity& result) {
    for (const Measurement& point : set.points) {
        auto& end = point.captured() ? result.fastest_capture : result.slowest_rebound;
        const bool further = !end || (point.captured() ? point.velocity > *end : point.velocity < *end);
        if (further) end = point.velocity;
    }
}

/// If only one outcome was seen, v_c is bounded on one side. Each of n impacts gives a bound from its
/// velocity and error, and the tightest is taken. It holds if all of them hold, so each may fail with
/// probability (1 - confidence)/n: the fastest of many captures is likely to be the one with the largest
/// error.
void bound_one_side(const MeasurementSet& set, MeasuredCriticalVelocity& result) {
    const double share = (1.0 - confidence) / static_cast<double>(set.points.size());
    const double quantile = -gsl::normal_quantile(share);
    double lower = 0.0;
    double upper = std::numeric_limits<double>::infinity();
    for (const Measurement& point : set.points) {
        const double allowance = quantile * (point.noise ? std::sqrt(point.noise->incident) : 0.0);
        lower = std::max(lower, point.velocity - allowance);
        upper = std::min(upper, point.velocity + allowance);
    }
    if (result.fastest_capture) {
        if (lower > 0.0) result.lower = lower;
        result.note = "every impact was captured";
    } else {
        result.upper = upper;
        result.note = "no impact was captured";
    }
}

/// True if captures may be unseen slow rebounds: the slowest rebounds were hardly faster than what the camera
/// resolves, and the captures were not seen to stick.
bool may_be_slow_rebounds(const MeasurementSet& set) {
    std::vector<const Measurement*> rebounds;
    bool seen_to_stick = true;
    for (const Measurement& point : set.points)
        if (!point.captured())
            rebounds.push_back(&point);
        else if (point.outcome != NotedOutcome::capture)
            seen_to_stick = false;
    const std::size_t slowest = std::min(rebounds.size(), std::max<std::size_t>(3, rebounds.size() / 10));
    if (seen_to_stick || slowest < 3) return false;
    std::ranges::sort(rebounds, {}, &Measurement::velocity);
    const auto hardly_seen = [](const Measurement* point) {
        constexpr double often = 1.5;  // below so many standard uncertainties 7 % or more read zero or less
        const double noise = point->noise ? std::sqrt(point->noise->rebound) : 0.0;
        return point->rebound < std::max(often * noise, point->resolution);
    };
    return 2 * std::count_if(rebounds.begin(), rebounds.begin() + static_cast<std::ptrdiff_t>(slowest),
                             hardly_seen) >
           static_cast<std::ptrdiff_t>(slowest);
}

void take_gap(MeasuredCriticalVelocity& result) {
    result.lower = result.fastest_capture;
    result.upper = result.slowest_rebound;
    result.value = 0.5 * (*result.lower + *result.upper);
    result.standard_uncertainty = (*result.upper - *result.lower) / std::sqrt(12.0);
    result.note = "between the fastest capture and the slowest rebound";
}

void take_transition(const MeasurementSet& set, double noise, bool mixed, MeasuredCriticalVelocity& result) {
    const double gap = std::abs(*result.fastest_capture - *result.slowest_rebound);
    const OutcomeLikelihood likelihood(set, 1e-3 * std::max(noise, gap));
    const auto found = mixed ? likelihood.best() : CaptureTransition{likelihood.best_center(0.0), 0.0};
    if (!found || found->center <= 0.0) {
        result.note = reversed_share(set) >= 0.5
                          ? "outcomes contradict a threshold: captures are faster than rebounds"
                          : "outcomes hang on the velocity too little for a threshold";
        return;
    }
    const double width = std::sqrt(noise * noise + found->extra_variance);
    const double least = likelihood.misfit(*found);
    const Interval interval =
        profile_interval([&](double center) { return likelihood.profile(center) - least; },
                         {.best = found->center,
                          .deviation = std::max(width, 0.3 * gap),
                          .least = 0.0,
                          .greatest = 10.0 * found->center});
    result.value = interval.value;
    result.standard_uncertainty = interval.standard_uncertainty;
    result.lower = interval.lower;
    result.upper = interval.upper;
    result.width = width;
    result.note = mixed ? "outcomes mix between the slowest rebound and the fastest capture"
                        : "between the fastest capture and the slowest rebound, with their noise";
}

/// Adds a relative uncertainty that all velocities have in common.
void widen(MeasuredCriticalVelocity& result, double uncertainty) {
    const double own = confidence_quantile() * uncertainty;
    const auto end = [&](std::optional<double>& bound, double sign) {
        const double distance = result.value && bound ? std::log(*bound / *result.value) : 0.0;
        if (bound && *bound > 0.0 && uncertainty > 0.0)
            bound = *bound * std::exp(sign * (std::hypot(distance, own) - std::abs(distance)));
    };
    end(result.lower, -1.0);
    end(result.upper, 1.0);
    if (result.value && result.standard_uncertainty)
        result.standard_uncertainty = std::hypot(*result.standard_uncertainty, uncertainty * *result.value);
}

}  // namespace

MeasuredCriticalVelocity measured_critical_velocity(const MeasurementSet& stated, double scale_uncertainty) {
    validate(stated);
    const MeasurementSet set = with_noise(stated);
    MeasuredCriticalVelocity result;
    note_range(set, result);
    if (!result.fastest_capture || !result.slowest_rebound) {
        bound_one_side(set, result);
        widen(result, scale_uncertainty);
        return result;
    }
    const double noise = mean_noise(set);
    const bool mixed = *result.fastest_capture >= *result.slowest_rebound;
    if (noise == 0.0 && !mixed) {
        take_gap(result);
    } else if (noise == 0.0 && *result.fastest_capture == *result.slowest_rebound) {  // v_c, without interval
        result.value = result.fastest_capture;
        result.note = "captures end and rebounds begin at one velocity, whose uncertainty is not known";
    } else {
        take_transition(set, noise, mixed, result);
    }
    if (result.lower && may_be_slow_rebounds(set)) {
        result.lower.reset();
        result.note +=
            "; v_c may be lower, as the slowest rebounds can hardly be told from captures, which may be "
            "rebounds";
    }
    widen(result, scale_uncertainty);
    return result;
}

double shared_difference(double one, double other) {
    const double more = std::max(one * one, other * other);
    const double less = std::min(one * one, other * other);
    return std::sqrt(std::max(more - less, 0.25 * more));
}

CriticalVelocityCheck check(const Interval& model, const MeasuredCriticalVelocity& measured,
                            bool same_impacts) {
    if (!measured.value) {
        const bool low = measured.lower && model.upper && *model.upper < *measured.lower;
        const bool high = measured.upper && model.lower && *model.lower > *measured.upper;
        if (low) return {CriticalVelocityVerdict::model_too_low, {}};
        if (high) return {CriticalVelocityVerdict::model_too_high, {}};
        return {CriticalVelocityVerdict::not_comparable, {}};
    }
    const double own = measured.standard_uncertainty.value_or(0.0);
    const double joint = same_impacts ? shared_difference(model.standard_uncertainty, own)
                                      : std::hypot(model.standard_uncertainty, own);
    if (!(joint > 0.0)) return {CriticalVelocityVerdict::not_comparable, {}};
    const double deviation = (model.value - *measured.value) / joint;
    if (std::abs(deviation) <= confidence_quantile()) return {CriticalVelocityVerdict::agrees, deviation};
    if (deviation > 0.0) return {CriticalVelocityVerdict::model_too_high, deviation};
    const bool from_above = measured.upper && !measured.lower;
    return {from_above ? CriticalVelocityVerdict::not_comparable : CriticalVelocityVerdict::model_too_low,
            deviation};
}

}  // namespace ashimpact

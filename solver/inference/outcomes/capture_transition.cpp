// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/outcomes/capture_transition.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "solver/numeric/gsl/search.hpp"
#include "solver/numeric/gsl/statistics.hpp"
#include "solver/statistics/interval.hpp"

namespace ashimpact {

namespace {

constexpr std::size_t few_outcomes = 2500;

}  // namespace

OutcomeLikelihood::OutcomeLikelihood(const MeasurementSet& set, double least)
    : captured_(static_cast<double>(set.captures()) / static_cast<double>(set.points.size())),
      reversed_(reversed_share(set)) {
    for (const Measurement& point : set.points)
        outcomes_.push_back({.velocity = point.velocity,
                             .variance = point.noise ? point.noise->incident : least * least,
                             .sign = point.captured() ? 1.0 : -1.0});
    noise_ = outcomes_.front().variance;
    const auto [first, last] = std::ranges::minmax_element(outcomes_, {}, &Outcome::velocity);
    slowest_ = first->velocity;
    fastest_ = last->velocity;
    double capture = 0.0;
    double rebound = fastest_;
    for (const Outcome& outcome : outcomes_) {
        if (outcome.sign > 0.0)
            capture = std::max(capture, outcome.velocity);
        else
            rebound = std::min(rebound, outcome.velocity);
    }
    middle_ = 0.5 * (capture + rebound);
    if (outcomes_.size() > few_outcomes) merge();
}

void OutcomeLikelihood::merge() {
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
double OutcomeLikelihood::sum_of(const CaptureTransition& transition, const Term& term) const {
    double sum = 0.0;
    for (const Outcome& outcome : outcomes_) {
        const double deviation = std::sqrt(outcome.variance + transition.extra_variance);
        sum += term(outcome, outcome.sign * (transition.center - outcome.velocity) / deviation, deviation);
    }
    return sum;
}

double OutcomeLikelihood::misfit(const CaptureTransition& transition) const {
    return sum_of(transition, [](const Outcome& outcome, double z, double) {
        return -2.0 * outcome.count * gsl::normal_log_probability(z);
    });
}

double OutcomeLikelihood::slope(const CaptureTransition& transition) const {
    return sum_of(transition, [](const Outcome& outcome, double z, double deviation) {
        return -2.0 * outcome.count * outcome.sign * gsl::normal_log_probability_slope(z) / deviation;
    });
}

double OutcomeLikelihood::variance_slope(const CaptureTransition& transition) const {
    return sum_of(transition, [](const Outcome& outcome, double z, double deviation) {
        return outcome.count * gsl::normal_log_probability_slope(z) * z / (deviation * deviation);
    });
}

double OutcomeLikelihood::best_extra_variance(double center) const {
    // -2 ln L is convex in 1/width where all have the same noise: one minimum, or an end.
    const auto variance = [&](double log_growth) { return noise_ * std::expm1(log_growth); };
    const auto slope_at = [&](double log_growth) { return variance_slope({center, variance(log_growth)}); };
    const double most = std::log1p(std::pow(fastest_ - slowest_, 2) / noise_);
    if (slope_at(0.0) >= 0.0) return 0.0;
    if (slope_at(most) <= 0.0) return variance(most);
    return variance(gsl::brent(slope_at, 0.0, most, {.relative = 0.0, .absolute = 1e-3}).root);
}

double OutcomeLikelihood::profile(double center) const {
    return misfit({center, best_extra_variance(center)});
}

double OutcomeLikelihood::best_center(double extra_variance) const {
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

double OutcomeLikelihood::without_threshold() const {
    double all = 0.0;
    for (const Outcome& outcome : outcomes_) all += outcome.count;
    return -2.0 * all * (captured_ * std::log(captured_) + (1.0 - captured_) * std::log1p(-captured_));
}

CaptureTransition OutcomeLikelihood::at_best_width() const {
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

std::optional<CaptureTransition> OutcomeLikelihood::best() const {
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

double reversed_share(const MeasurementSet& set) {
    std::vector<double> rebounds;
    for (const Measurement& point : set.points)
        if (!point.captured()) rebounds.push_back(point.velocity);
    std::sort(rebounds.begin(), rebounds.end());
    double reversed = 0.0;
    for (const Measurement& point : set.points) {
        if (!point.captured()) continue;
        const auto [first, last] = std::equal_range(rebounds.begin(), rebounds.end(), point.velocity);
        reversed += static_cast<double>(first - rebounds.begin()) + 0.5 * static_cast<double>(last - first);
    }
    return reversed / (static_cast<double>(rebounds.size()) * static_cast<double>(set.captures()));
}

}  // namespace ashimpact

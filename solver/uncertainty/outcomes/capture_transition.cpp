#include "solver/uncertainty/outcomes/capture_transition.hpp"

#include "solver/gsl/distribution.hpp"
#include "solver/gsl/minimum.hpp"
#include "solver/gsl/root.hpp"
#include "solver/uncertainty/interval.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace ashimpact {

namespace {

std::array<double, 2> velocity_range(const MeasurementSet& set) {
    const auto [slowest, fastest] = std::ranges::minmax_element(set.points, {}, &Measurement::velocity);
    return {slowest->velocity, fastest->velocity};
}

double middle_of_outcomes(const MeasurementSet& set) {
    double capture = 0.0;
    double rebound = velocity_range(set)[1];
    for (const Measurement& point : set.points) {
        if (point.captured())
            capture = std::max(capture, point.velocity);
        else
            rebound = std::min(rebound, point.velocity);
    }
    return 0.5 * (capture + rebound);
}

}  // namespace

double OutcomeLikelihood::deviation_of(const Measurement& point, double extra_variance) const {
    return std::sqrt((point.noise ? point.noise->incident : least_ * least_) + extra_variance);
}

double OutcomeLikelihood::at(const CaptureTransition& transition) const {
    double sum = 0.0;
    for (const Measurement& point : set_->points) {
        const double z =
            (transition.center - point.velocity) / deviation_of(point, transition.extra_variance);
        sum -= 2.0 * gsl::normal_log_probability(point.captured() ? z : -z);
    }
    return sum;
}

double OutcomeLikelihood::slope(const CaptureTransition& transition) const {
    double sum = 0.0;
    for (const Measurement& point : set_->points) {
        const double deviation = deviation_of(point, transition.extra_variance);
        const double sign = point.captured() ? 1.0 : -1.0;
        const double z = sign * (transition.center - point.velocity) / deviation;
        sum -= 2.0 * sign * gsl::normal_log_probability_slope(z) / deviation;
    }
    return sum;
}

double OutcomeLikelihood::variance_slope(const CaptureTransition& transition) const {
    double sum = 0.0;
    for (const Measurement& point : set_->points) {
        const double deviation = deviation_of(point, transition.extra_variance);
        const double z = (point.captured() ? 1.0 : -1.0) * (transition.center - point.velocity) / deviation;
        sum += gsl::normal_log_probability_slope(z) * z / (deviation * deviation);
    }
    return sum;
}

double OutcomeLikelihood::best_extra_variance(double center) const {
    const auto [slowest, fastest] = velocity_range(*set_);
    const double noise = std::pow(deviation_of(set_->points.front(), 0.0), 2);
    // -2 ln L is convex in 1/width where all have the same noise: one minimum, or an end.
    const auto variance = [&](double log_growth) { return noise * std::expm1(log_growth); };
    const auto slope_at = [&](double log_growth) { return variance_slope({center, variance(log_growth)}); };
    const double most = std::log1p(std::pow(fastest - slowest, 2) / noise);
    if (slope_at(0.0) >= 0.0) return 0.0;
    if (slope_at(most) <= 0.0) return variance(most);
    return variance(gsl::brent(slope_at, 0.0, most, {.relative = 0.0, .absolute = 1e-3}).root);
}

double OutcomeLikelihood::profile(double center) const {
    return at({center, best_extra_variance(center)});
}

double OutcomeLikelihood::best_center(double extra_variance) const {
    const double middle = middle_of_outcomes(*set_);
    const auto slope_at = [&](double center) { return slope({center, extra_variance}); };
    const double deviation = deviation_of(set_->points.front(), extra_variance);
    if (std::abs(slope_at(middle)) * deviation < 1e-9) return middle;
    auto [lower, upper] = velocity_range(*set_);
    for (double step = deviation; slope_at(lower) > 0.0; step *= 2.0) lower -= step;
    for (double step = deviation; slope_at(upper) < 0.0; step *= 2.0) upper += step;
    if (lower == upper) return lower;
    return gsl::brent(slope_at, lower, upper, {.relative = 0.0, .absolute = 1e-7 * deviation}).root;
}

double OutcomeLikelihood::without_threshold() const {
    const auto all = static_cast<double>(set_->points.size());
    const auto captures = static_cast<double>(set_->captures());
    return -2.0 * (captures * std::log(captures / all) + (all - captures) * std::log1p(-captures / all));
}

CaptureTransition OutcomeLikelihood::at_best_width() const {
    constexpr int steps = 24;
    const auto [slowest, fastest] = velocity_range(*set_);
    const double most = std::log(fastest - slowest);
    const double step = std::log(1e4) / steps;
    const auto misfit = [&](double log_width) {
        const double variance = std::exp(2.0 * log_width);
        return at({best_center(variance), variance});
    };
    CaptureTransition best{best_center(0.0), 0.0};
    double least = at(best);
    std::optional<double> width;
    for (int i = 0; i <= steps; ++i) {
        const double log_width = most - i * step;
        const double here = misfit(log_width);
        if (here >= least) continue;
        least = here;
        width = log_width;
    }
    if (!width) return best;
    const double found =
        gsl::minimise_between(misfit, *width - step, *width, std::min(*width + step, most + step));
    const double variance = std::exp(2.0 * std::min(found, most));
    return {best_center(variance), variance};
}

std::optional<CaptureTransition> OutcomeLikelihood::best() const {
    const auto [slowest, fastest] = velocity_range(*set_);
    const CaptureTransition sharp{best_center(0.0), 0.0};
    const double allowed = std::pow(confidence_quantile(), 2);
    const bool noise_explains = at(sharp) <= without_threshold() + allowed;
    std::optional<CaptureTransition> found;
    if (fastest > slowest && reversed_share(*set_) < 0.5) {
        const CaptureTransition widened = at_best_width();
        if (std::sqrt(widened.extra_variance) < 0.99 * (fastest - slowest)) found = widened;
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

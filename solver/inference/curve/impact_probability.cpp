// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/curve/impact_probability.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/numeric/gsl/interpolation.hpp"

namespace ashimpact {

namespace {

constexpr double root_two_pi = 2.5066282746310002;

double normal_below(double z) {
    return 0.5 * std::erfc(-z * std::numbers::sqrt2 / 2.0);
}

double normal_density(double difference, double variance) {
    return std::exp(-0.5 * difference * difference / variance) / (root_two_pi * std::sqrt(variance));
}

/// Quadrature nodes on [0, 1].
const auto& unit_nodes() {
    static const auto nodes = gsl::gauss_legendre(16, 0.0, 1.0);
    return nodes;
}

class Probability {
  public:
    Probability(const SmoothDamping& curve, const Scatter& scatter, const RecordedImpact& impact)
        : curve_(curve),
          impact_(impact),
          x_(impact.log_velocity),
          velocity_share_(scatter.noise * impact.incident_u / impact.velocity),
          rebound_u_(scatter.noise * impact.rebound_u *
                     std::sqrt(1.0 - impact.correlation * impact.correlation)),
          along_(impact.correlation * impact.rebound_u / impact.incident_u),
          damping_(scatter.damping) {
        // More damping acts like a lower velocity, so noise and scatter of the damping both shift an impact
        // along ln v.
        const double from_critical = x_ - curve.log_critical_velocity();
        const double least = velocity_share_ + 0.02;
        const double away =
            from_critical < 0.0 ? std::min(from_critical, -least) : std::max(from_critical, least);
        const double place = curve.log_critical_velocity() + away;
        const double slope = std::max(0.02, curve.at_log_velocity(place).distance / away);
        const double by_damping = damping_ / slope;
        width_ = std::hypot(velocity_share_, by_damping);
        share_ = velocity_share_ * velocity_share_ / (width_ * width_);
        below_ = -from_critical / width_;
    }

    [[nodiscard]] double captured() const { return normal_below(below_); }

    /// Probability density of a rebound with this reading [s/m]. Far from v_c the curve is linearised, and
    /// between both regimes the results are blended.
    [[nodiscard]] double rebounds() const {
        if (below_ < -linear_to) return linearised();
        if (below_ > -linear_from) return integrated_reading();
        const double t = (-below_ - linear_from) / (linear_to - linear_from);
        const double blend = t * t * (3.0 - 2.0 * t);
        return (1.0 - blend) * integrated_reading() + blend * linearised();
    }

    /// Probability of a rebound that was recorded as a capture.
    [[nodiscard]] double unseen() const {
        if (below_ < -linear_to &&
            curve_.at_log_velocity(x_).restitution * impact_.velocity > 8.0 * rebound_u_ + impact_.resolution)
            return 0.0;
        return integrated([this](double, double r, double) { return at_rest(r); }, false);
    }

  private:
    static constexpr double reach = 6.0;
    static constexpr double linear_from = 5.0;
    static constexpr double linear_to = 7.0;

    /// Probability that a rebound is recorded as zero.
    [[nodiscard]] double at_rest(double r) const {
        if (impact_.resolution > 0.0) return std::clamp(1.0 - r / impact_.resolution, 0.0, 1.0);
        return normal_below(-r / rebound_u_);
    }

    /// Probability density of the reading at a shift [s/m].
    [[nodiscard]] double reading(double y, double r, double extra) const {
        const double seen = impact_.resolution > 0.0 ? 1.0 - at_rest(r) : 1.0;
        return seen * normal_density(impact_.rebound - expected(y, r), rebound_u_ * rebound_u_ + extra);
    }
    [[nodiscard]] double expected(double y, double r) const {
        return r + along_ * impact_.velocity * (1.0 - std::exp(share_ * y));
    }

    [[nodiscard]] double rebound_at(double y) const {
        return curve_.at_log_velocity(x_ + y).restitution * impact_.velocity * std::exp(share_ * y);
    }

    [[nodiscard]] double integrated_reading() const {
        return integrated([this](double y, double r, double extra) { return reading(y, r, extra); }, true);
    }
    /// Integral over the shifts y that rebound, e being about a root or a power of the distance from v_c.
    template <class Function>
    [[nodiscard]] double integrated(const Function& function, bool narrow) const {
        const double from = std::max(below_ * width_, -reach * width_);
        const double to = std::max(from, 0.0) + reach * width_;
        double low = 0.0;
        double high = std::sqrt(to - from);
        if (narrow) narrow_down(from, low, high);
        double sum = 0.0;
        for (const auto& node : unit_nodes()) {
            const double q = low + (high - low) * node.position;
            const double y = from + q * q;
            const double r = rebound_at(y);
            const double by_incident = (r - along_ * impact_.velocity) * width_;
            const double extra = share_ * (1.0 - share_) * by_incident * by_incident;
            sum += node.weight * 2.0 * q * normal_density(y, width_ * width_) * function(y, r, extra);
        }
        return sum * (high - low);
    }

    /// Restricts the integral to shifts whose rebound is within the noise of the reading.
    void narrow_down(double from, double& low, double& high) const {
        const double band = reach * rebound_u_;
        const auto r_at = [&](double q) { return expected(from + q * q, rebound_at(from + q * q)); };
        const double range = r_at(high) - r_at(low);
        if (range < 2.0 * band) return;
        const auto root = [&](double value) {
            double a = low;
            double b = high;
            for (int i = 0; i < 7; ++i) {
                const double middle = 0.5 * (a + b);
                (r_at(middle) < value ? a : b) = middle;
            }
            return std::pair(a, b);
        };
        const double lowest = impact_.rebound - band;
        const double highest = impact_.rebound + band;
        const double new_low = r_at(low) < lowest ? root(lowest).first : low;
        const double new_high = r_at(high) > highest ? root(highest).second : high;
        low = new_low;
        high = std::max(new_high, low + 1e-9);
    }

    /// Density from mean and variance of the reading, for impacts so far from v_c that the curve is nearly
    /// straight over the noise. Three points of the curve give both.
    [[nodiscard]] double linearised() const {
        const auto here = curve_.at_log_velocity(x_);
        const double r = impact_.velocity * here.restitution;
        const double by_damping = impact_.velocity * here.by_distance * damping_;
        double variance = rebound_u_ * rebound_u_ + by_damping * by_damping;
        double mean = r;
        if (velocity_share_ > 0.0) {
            const double step = std::min(std::sqrt(3.0), 0.9 / velocity_share_);
            const double up_x = std::log1p(step * velocity_share_);
            const double down_x = std::log1p(-step * velocity_share_);
            const double change = impact_.velocity * step * velocity_share_;
            const double up =
                (impact_.velocity + change) * curve_.at_log_velocity(x_ + up_x).restitution - along_ * change;
            const double down =
                (impact_.velocity - change) * curve_.at_log_velocity(x_ + down_x).restitution +
                along_ * change;
            const double weight = 0.5 / (step * step);
            mean += weight * (up + down - 2.0 * r);
            variance += weight * ((up - r) * (up - r) + (down - r) * (down - r)) - (mean - r) * (mean - r);
        }
        return normal_density(impact_.rebound - mean, variance);
    }

    const SmoothDamping& curve_;
    const RecordedImpact& impact_;
    double x_;
    double velocity_share_;  ///< u(v_in)/v_in
    double rebound_u_;       ///< of v_r where v_in is known
    double along_;           ///< d(error of v_r)/d(error of v_in), by their correlation
    double damping_;
    double width_ = 0.0;  ///< standard deviation of the shift along ln v
    double share_ = 0.0;  ///< of v_in in the variance of the shift
    double below_ = 0.0;  ///< (ln v_c - ln v_in)/width
};

}  // namespace

double log_probability(const SmoothDamping& curve, const Scatter& scatter, const RecordedImpact& impact) {
    const Probability probability(curve, scatter, impact);
    const double flat = 1.0 / (1.5 * impact.velocity);  // density of an outlier's reading
    constexpr double at_rest = 0.1;                     // share of outliers that read zero
    double regular = 0.0;
    double outlier = flat;
    switch (impact.recorded) {
        case Recorded::rebound:
            regular = probability.rebounds();
            break;
        case Recorded::capture:
            regular = probability.captured();
            outlier = at_rest;
            break;
        case Recorded::zero:
            regular = probability.captured() + probability.unseen();
            outlier = at_rest;
            break;
    }
    return std::log((1.0 - scatter.outliers) * regular + scatter.outliers * outlier);
}

}  // namespace ashimpact

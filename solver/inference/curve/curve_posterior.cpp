// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/curve/curve_posterior.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/batch/parallel.hpp"
#include "solver/numeric/gsl/interpolation.hpp"
#include "solver/numeric/interpolation.hpp"

namespace ashimpact {

namespace {

constexpr double root_two_pi = 2.5066282746310002;

double normal_below(double z) {
    return 0.5 * std::erfc(-z * std::numbers::sqrt2 / 2.0);
}

double normal_density(double difference, double variance) {
    return std::exp(-0.5 * difference * difference / variance) / (root_two_pi * std::sqrt(variance));
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
        static const auto unit_nodes = gsl::gauss_legendre(16, 0.0, 1.0);
        double sum = 0.0;
        for (const auto& node : unit_nodes) {
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

constexpr double outlier_share = 0.02;
constexpr double slope_mean = -0.4;
constexpr double slope_deviation = 0.4;
constexpr double bend_deviation = 0.07;   ///< deviation of c_2; higher terms fall with their order squared
constexpr double scatter_median = 0.005;  ///< where the noise is stated
constexpr double unstated_scatter_median =
    0.02;                               ///< prior when the file states no noise: assume a larger scatter
constexpr double scatter_spread = 1.3;  ///< of the logarithm

double square(double x) {
    return x * x;
}

}  // namespace

SmoothDamping::SmoothDamping(const CurveTable& table, double log_critical_velocity, double fastest,
                             const std::array<double, terms>& coefficients)
    : table_(&table),
      critical_(log_critical_velocity),
      critical_damping_(table.log_capture_damping(log_critical_velocity)),
      coefficients_(coefficients) {
    const double x = std::max(fastest, critical_ + 0.1);
    span_ = std::max(1e-6, table.at(table.log_capture_damping(x) - critical_damping_, x).restitution);
    step_ = std::sqrt(x + 0.25 - critical_) / cells;
    points_[1] = {0.0, 0.0, 0.0};
    for (std::size_t i = 1; i <= cells + 1; ++i) {
        const double root = step_ * static_cast<double>(i);
        const double x_here = critical_ + root * root;
        points_[i + 1] = computed(x_here);
        const double reference = table.log_capture_damping(x_here) - critical_damping_;
        const double lack = std::max(0.0, 0.6 - points_[i + 1].distance / reference);
        lingering_ += 20.0 / cells * lack * lack / (0.15 * 0.15);
    }
    const auto before = [&](double Point::*member) {
        return 3.0 * points_[1].*member - 3.0 * points_[2].*member + points_[3].*member;
    };
    points_[1].by_distance = 2.0 * points_[2].by_distance - points_[3].by_distance;
    points_[0] = {before(&Point::distance), before(&Point::restitution), before(&Point::by_distance)};
}

SmoothDamping::Point SmoothDamping::at_log_velocity(double x) const {
    if (x <= critical_) return {std::min(0.0, table_->log_capture_damping(x) - critical_damping_), 0.0, 0.0};
    const double place = std::min(std::sqrt(x - critical_) / step_, cells - 1e-9);
    const double cell = std::floor(place);
    const double t = place - cell;
    const Point* p = points_.data() + static_cast<std::size_t>(cell);
    const std::array w = cubic_weights(t);
    const auto sum = [&](double Point::*member) {
        return w[0] * p[0].*member + w[1] * p[1].*member + w[2] * p[2].*member + w[3] * p[3].*member;
    };
    return {sum(&Point::distance), std::max(0.0, sum(&Point::restitution)), sum(&Point::by_distance)};
}

double SmoothDamping::deviation(double t) const {
    const double y = 2.0 * t - 1.0;
    double before = 1.0;
    double now = y;
    double at_zero = -1.0;
    double sum = 0.0;
    for (const double c : coefficients_) {
        sum += c * (now - at_zero);
        const double next = 2.0 * y * now - before;
        before = now;
        now = next;
        at_zero = -at_zero;
    }
    return sum;
}

SmoothDamping::Point SmoothDamping::computed(double x) const {
    const double reference = std::max(1e-12, table_->log_capture_damping(x) - critical_damping_);
    const double t = std::min(1.0, table_->at(reference, x).restitution / span_);
    // Every impact above v_c must rebound: where g would exceed the reference, the distance tends to a small
    // positive share of it.
    constexpr double share = 0.05;
    const double difference = reference - deviation(t);
    const double distance =
        0.5 * (difference + std::sqrt(difference * difference + 4.0 * share * share * reference * reference));
    const CurveTable::Value value = table_->at(distance, x);
    return {distance, value.restitution, value.by_distance};
}

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

CurvePosterior::CurvePosterior(const CurveTable& table, const std::vector<RecordedImpact>& impacts,
                               const CurvePrior& prior)
    : table_(&table), impacts_(&impacts), prior_(prior) {
    for (const RecordedImpact& impact : impacts) {
        fastest_ = std::max(fastest_, impact.log_velocity);
        slowest_ = std::min(slowest_, impact.log_velocity);
    }
}

SmoothDamping CurvePosterior::curve(const Vector& parameters) const {
    std::array<double, SmoothDamping::terms> coefficients{};
    coefficients[0] = slope_mean + slope_deviation * parameters[first_term];
    // Coefficients fall as those of an integrated random walk.
    for (int k = 2; k <= SmoothDamping::terms; ++k)
        coefficients[static_cast<std::size_t>(k - 1)] =
            bend_deviation * square(2.0 / k) * parameters[first_term + k - 1];
    return {*table_, parameters[critical], fastest_, coefficients};
}

Scatter CurvePosterior::scatter_of(const Vector& parameters) const {
    const double median = prior_.noise_known ? scatter_median : unstated_scatter_median;
    return {
        .noise = (prior_.noise_known ? 1.0 : prior_.noise) * std::exp(parameters[noise]),
        .damping = prior_.scatter ? *prior_.scatter : median * std::exp(scatter_spread * parameters[scatter]),
        .outliers = outlier_share};
}

double CurvePosterior::prior_term(const Vector& parameters) const {
    double sum = 0.5 * (parameters.squaredNorm() - square(parameters[critical]) - square(parameters[noise]));
    sum += prior_.noise_known ? std::log1p(square(parameters[noise] / 0.1))
                              : 0.5 * square(parameters[noise] / 1.5);
    // Laboratories choose velocities around v_c, so v_c is unlikely to lie far below the slowest impact.
    constexpr double below = 1.2;
    constexpr double deviation = 0.4;
    return sum + 0.5 * square(std::max(0.0, slowest_ - below - parameters[critical]) / deviation);
}

double CurvePosterior::operator()(const Vector& parameters) const {
    constexpr double impossible = 1e10;
    const double a = parameters[critical];
    if (!(a > table_->lower() && a < table_->upper()) || !(parameters.cwiseAbs().maxCoeff() < 30.0))
        return impossible;
    const SmoothDamping fitted = curve(parameters);
    const Scatter scattered = scatter_of(parameters);
    double sum = prior_term(parameters) + fitted.lingering();
    for (const RecordedImpact& impact : *impacts_)
        sum -= impact.count * log_probability(fitted, scattered, impact);
    return std::isfinite(sum) ? sum : impossible;
}

CurvePosterior::Curvature CurvePosterior::curvature(const Vector& parameters, double value,
                                                    const Vector& steps) const {
    const auto at = [&](int i, double by_i, int j, double by_j) {
        Vector shifted = parameters;
        shifted[i] += by_i;
        shifted[j] += by_j;
        return (*this)(shifted);
    };
    Vector below;
    Matrix both;  // on the diagonal a step of one parameter, below it steps of two
    batch::for_each_item(static_cast<std::size_t>(size) * (size + 1), [&](std::size_t item) {
        const int i = static_cast<int>(item) / (size + 1);
        const int j = static_cast<int>(item) % (size + 1);
        if (j == size)
            below[i] = at(i, -steps[i], i, 0.0);
        else if (j <= i)
            both(i, j) = at(i, steps[i], j, j < i ? steps[j] : 0.0);
    });
    Curvature result{Vector::Zero(), Matrix::Zero()};
    for (int i = 0; i < size; ++i) {
        const double h = steps[i];
        result.gradient[i] = (both(i, i) - below[i]) / (2.0 * h);
        result.hessian(i, i) = (both(i, i) - 2.0 * value + below[i]) / (h * h);
        for (int j = 0; j < i; ++j)
            result.hessian(i, j) = result.hessian(j, i) =
                (both(i, j) - both(i, i) - both(j, j) + value) / (h * steps[j]);
    }
    return result;
}

}  // namespace ashimpact

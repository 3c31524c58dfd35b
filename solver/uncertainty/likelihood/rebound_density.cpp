#include "solver/uncertainty/likelihood/rebound_density.hpp"

#include "solver/gsl/distribution.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

namespace ashimpact {

namespace {

constexpr double least_share = 3e-3;  ///< of the integral over v in that over e v, below which it is replaced

/// r above a least share, and a smooth continuation to all r that stays positive.
struct PositiveShare {
    double value;
    double slope;

    explicit PositiveShare(double r) {
        const double depth = 2.0 - r / least_share;
        const bool as_it_is = r > least_share;
        value = as_it_is ? r : least_share / depth;
        slope = as_it_is ? 1.0 : 1.0 / (depth * depth);
    }
};

}  // namespace

bool is_slow(const Measurement& rebound) {
    return rebound.rebound < slow_rebound * std::sqrt(rebound.noise->rebound);
}

/// The density of one rebound, given the place it comes from.
class ReboundDensity::Noise {
  public:
    explicit Noise(const Measurement& rebound)
        : velocity_(rebound.velocity), rebound_(rebound.rebound), slow_(is_slow(rebound)) {
        const VelocityNoise& noise = *rebound.noise;
        if (slow_) {
            regression_ = noise.covariance / noise.incident;
            deviation_ = std::sqrt(noise.rebound - regression_ * noise.covariance);
            rebound_ = slow_rebound * std::sqrt(noise.rebound);
            xx_ = 1.0 / noise.incident;
            return;
        }
        const double determinant = noise.incident * noise.rebound - noise.covariance * noise.covariance;
        xx_ = noise.rebound / determinant;
        xy_ = -noise.covariance / determinant;
        yy_ = noise.incident / determinant;
    }

    /// Minus twice the logarithm of the density, of the places in a window.
    void measure(const CurveNodes::Values& nodes, Window window, Eigen::ArrayXd& to) const {
        const auto x = velocity_ - nodes.velocity.segment(window.first, window.size()).array();
        const auto y = rebound_ - nodes.rebound.segment(window.first, window.size()).array();
        auto squares = to.head(window.size());
        squares = x * (xx_ * x + 2.0 * xy_ * y) + yy_ * y * y;
        for (Eigen::Index k = 0; slow_ && k < window.size(); ++k)
            squares[k] -= 2.0 * gsl::quick_normal_log_probability((y[k] - regression_ * x[k]) / deviation_);
    }
    /// Slopes of the logarithm of the density by v and e v.
    void slopes(const CurveNodes::Values& nodes, Window window, ReboundDensity& to) const {
        const auto x = velocity_ - nodes.velocity.segment(window.first, window.size()).array();
        const auto y = rebound_ - nodes.rebound.segment(window.first, window.size()).array();
        to.by_velocity_.head(window.size()) = xx_ * x + xy_ * y;
        to.by_rebound_.head(window.size()) = xy_ * x + yy_ * y;
        for (Eigen::Index k = 0; slow_ && k < window.size(); ++k) {
            const double slope =
                gsl::quick_normal_log_probability_slope((y[k] - regression_ * x[k]) / deviation_);
            to.by_velocity_[k] += slope * regression_ / deviation_;
            to.by_rebound_[k] = -slope / deviation_;
        }
    }
    /// Minus twice the logarithm of the density at the beginning of the curve.
    [[nodiscard]] double square_at_start(double critical_velocity) const {
        const double x = velocity_ - critical_velocity;
        if (slow_)
            return xx_ * x * x -
                   2.0 * gsl::quick_normal_log_probability((rebound_ - regression_ * x) / deviation_);
        return x * (xx_ * x + 2.0 * xy_ * rebound_) + yy_ * rebound_ * rebound_;
    }
    /// ln of what a slow rebound's density lacks to be one over v_r, too, spread evenly below the limit.
    [[nodiscard]] double constant() const {
        return slow_ ? std::log(std::sqrt(2.0 * std::numbers::pi) / slow_rebound) : 0.0;
    }

  private:
    double velocity_;
    double rebound_;  ///< v_r, or the limit for slow ones [m/s]
    bool slow_;
    // Inverse of the noise matrix; for slow ones that of v_in alone.
    double xx_ = 0.0;
    double xy_ = 0.0;
    double yy_ = 0.0;
    // Mean of the error of v_r per that of v_in, and its deviation from that.
    double regression_ = 0.0;
    double deviation_ = 0.0;
};

ReboundDensity::ReboundDensity(const CurveNodes::Values& nodes)
    : nodes_(nodes),
      greatest_before_(nodes.velocity.begin(), nodes.velocity.end()),
      least_behind_(nodes.velocity.begin(), nodes.velocity.end()),
      squares_(nodes.velocity.size()),
      density_(nodes.velocity.size()),
      by_velocity_(nodes.velocity.size()),
      by_rebound_(nodes.velocity.size()),
      gradient_(nodes.by_coefficient.cols()) {
    for (std::size_t k = 1; k < greatest_before_.size(); ++k)
        greatest_before_[k] = std::max(greatest_before_[k], greatest_before_[k - 1]);
    for (std::size_t k = least_behind_.size() - 1; k > 0; --k)
        least_behind_[k - 1] = std::min(least_behind_[k - 1], least_behind_[k]);
}

ReboundDensity::Window ReboundDensity::around(double velocity, double distance) const {
    const auto first =
        std::lower_bound(greatest_before_.begin(), greatest_before_.end(), velocity - distance);
    const auto last = std::upper_bound(least_behind_.begin(), least_behind_.end(), velocity + distance);
    return {first - greatest_before_.begin(), last - least_behind_.begin()};
}

void ReboundDensity::measure(const Noise& noise, Window window) {
    least_ = std::numeric_limits<double>::infinity();
    if (window.size() <= 0) return;
    noise.measure(nodes_, window, squares_);
    least_ = squares_.head(window.size()).minCoeff();
}

/// The places within the noise's reach of the nearest one.
ReboundDensity::Window ReboundDensity::nearest(const Measurement& rebound, const Noise& noise) {
    const double u = std::sqrt(rebound.noise->incident);
    Window window = around(rebound.velocity, noise_reach * u);
    measure(noise, window);
    if (!(least_ < noise_reach * noise_reach)) {  // an outlier: the nearest place may lie beyond
        window = std::isfinite(least_)
                     ? around(rebound.velocity, std::hypot(noise_reach, std::sqrt(least_)) * u)
                     : all();
        measure(noise, window);
    }
    const double most = least_ + noise_reach * noise_reach;
    const auto within = [&](double square) { return square < most; };
    const auto begin = squares_.begin();
    const auto first = std::find_if(begin, begin + window.size(), within);
    const auto last = std::find_if(std::make_reverse_iterator(begin + window.size()),
                                   std::make_reverse_iterator(first), within)
                          .base();
    const Window near{window.first + (first - begin), window.first + (last - begin)};
    density_.head(near.size()) = (-0.5 * (squares_.segment(first - begin, near.size()) - least_)).exp();
    return near;
}

bool ReboundDensity::evaluate(const Measurement& rebound) {
    const Noise noise(rebound);
    const Window window = nearest(rebound, noise);
    const Eigen::Index size = window.size();
    const auto density = density_.head(size);
    const auto integral = [&](const Eigen::VectorXd& weight) {
        return density.matrix().dot(weight.segment(window.first, size));
    };
    const double sum = integral(nodes_.weight);
    const double along = integral(nodes_.rebound_weight);
    if (!(along > 0.0)) return false;
    noise.slopes(nodes_, window, *this);
    const auto places = nodes_.by_coefficient.middleRows(window.first, size).transpose();
    gradient_.noalias() = places * (density * by_rebound_.head(size)).matrix();
    const double start = noise.square_at_start(nodes_.critical_velocity) - least_;
    if (start < noise_reach * noise_reach) gradient_ -= std::exp(-0.5 * start) * nodes_.first_velocity;
    const double share = sum / along;
    if (share > least_share) {
        gradient_ /= sum;
        logarithm_ = std::log(sum);
    } else {
        const PositiveShare positive(share);
        const Eigen::VectorXd change = places * (density * by_velocity_.head(size)).matrix() / -along;
        gradient_ = change + positive.slope / positive.value * (gradient_ / along - share * change);
        logarithm_ = std::log(along * positive.value);
    }
    logarithm_ += noise.constant() - 0.5 * least_;
    return true;
}

}  // namespace ashimpact

#pragma once

#include "solver/measurement/measurement.hpp"
#include "solver/uncertainty/likelihood/curve_nodes.hpp"

#include <Eigen/Dense>

#include <vector>

namespace ashimpact {

/// A rebound slower than this many standard uncertainties of v_r can hardly be told from one at rest. How
/// such a one is recorded (cut at zero, without its sign, as read) is not known; only that it was no faster
/// is used.
inline constexpr double slow_rebound = 1.0;
[[nodiscard]] bool is_slow(const Measurement& rebound);

/// Density of a measured rebound, summed over the places of a curve (v, e v) that it may come from:
/// the integral over v of phi(v_in - v, v_r - e v), for slow ones over v_r, too, up to slow_rebound. [s/m]
///
/// Where the curve folds back more steeply than the noise can bridge, the integral over v may vanish or turn
/// negative. Below a thousandth or so of the integral over e v along the same places, which stays positive, a
/// small positive number takes its place, so that a likelihood exists for every curve.
class ReboundDensity {
  public:
    explicit ReboundDensity(const CurveNodes::Values& nodes);

    /// Whether the density is a positive number.
    bool evaluate(const Measurement& rebound);
    /// ln of the density, but for the same constant for all rebounds of the same noise.
    [[nodiscard]] double logarithm() const { return logarithm_; }
    /// Its change by each coefficient.
    [[nodiscard]] const Eigen::VectorXd& gradient() const { return gradient_; }

  private:
    /// Places from first up to last.
    struct Window {
        Eigen::Index first;
        Eigen::Index last;
        [[nodiscard]] Eigen::Index size() const { return last - first; }
    };
    class Noise;

    [[nodiscard]] Window around(double velocity, double distance) const;
    [[nodiscard]] Window all() const { return {0, static_cast<Eigen::Index>(least_behind_.size())}; }
    /// Fills squares_ from the window's beginning on.
    void measure(const Noise& noise, Window window);
    [[nodiscard]] Window nearest(const Measurement& rebound, const Noise& noise);

    const CurveNodes::Values& nodes_;
    // The curve may fold back a little, so that its velocities are not sorted.
    std::vector<double> greatest_before_;
    std::vector<double> least_behind_;
    // Of the places in a window: minus twice the logarithm of the density, the density over that of the
    // nearest place, and its slopes over itself by v and e v.
    Eigen::ArrayXd squares_;
    Eigen::ArrayXd density_;
    Eigen::ArrayXd by_velocity_;
    Eigen::ArrayXd by_rebound_;
    Eigen::VectorXd gradient_;
    double least_ = 0.0;  ///< of squares_
    double logarithm_ = 0.0;
};

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Dense>

#include "solver/inference/curve/recorded_impacts.hpp"
#include "solver/surrogate/cohesive_velocity_map.hpp"

namespace ashimpact {

/// A smooth curve of damping over velocity, anchored at the critical velocity:
///
///     ln eta(v) = ln eta_capture(v_c) + g(t),   g(t) = sum_k c_k (T_k(2t - 1) - T_k(-1)),
///
/// with t in [0, 1] the restitution at v over that at the fastest impact, both for constant damping of the
/// same v_c. In t a damping that depends on the velocity is smooth, and so is one that depends on the
/// restitution, which for adhesive laws rises vertically at v_c. g = 0 is constant damping. v_c is a
/// parameter of its own, and above it every impact rebounds.
class SmoothDamping {
  public:
    static constexpr int terms = 7;

    /// @param log_critical_velocity ln v_c @param fastest ln v of the fastest impact; taken as
    /// 0.1 above v_c where it is below that
    SmoothDamping(const CurveTable& table, double log_critical_velocity, double fastest,
                  const std::array<double, terms>& coefficients);

    struct Point {
        double distance;     ///< phi = ln(eta_capture(v)/eta(v)), negative below v_c
        double restitution;  ///< 0 below v_c
        double by_distance;  ///< d e/d phi
    };
    /// @param x ln v
    [[nodiscard]] Point at_log_velocity(double x) const;
    [[nodiscard]] double log_critical_velocity() const { return critical_; }
    /// Penalty, -ln of a prior density, on curves whose restitution stays near 0 above v_c: those whose
    /// distance is less than 0.6 of what constant damping gives. For such a curve v_c would have no meaning.
    [[nodiscard]] double lingering() const { return lingering_; }

  private:
    [[nodiscard]] double deviation(double t) const;
    [[nodiscard]] Point computed(double x) const;

    // The curve is tabulated over the square root of ln(v/v_c), in which e begins smoothly.
    static constexpr int cells = 56;

    const CurveTable* table_;
    double critical_;
    double critical_damping_;
    double span_;  ///< restitution of constant damping at the fastest impact
    double step_;  ///< of the square root of ln(v/v_c)
    double lingering_ = 0.0;
    std::array<double, terms> coefficients_;
    std::array<Point, cells + 3> points_;  ///< from one step before v_c on
};

/// How measurements scatter about the curve.
struct Scatter {
    double noise;     ///< factor on the uncertainties of both velocities
    double damping;   ///< standard deviation of ln eta between particles, or of what acts like it (size)
    double outliers;  ///< share of impacts whose record does not depend on the curve
};

/// ln of the probability of a recorded capture, or of the probability density of a reading [s/m], integrated
/// over the true velocity and over the scatter between particles.
[[nodiscard]] double log_probability(const SmoothDamping& curve, const Scatter& scatter,
                                     const RecordedImpact& impact);

/// What is known before the impacts are used.
struct CurvePrior {
    bool noise_known;
    double noise;                   ///< first estimate of an unknown noise [m/s]
    std::optional<double> scatter;  ///< of ln eta between particles, if known
};

/// -ln of the posterior density of a curve of damping with its scatter.
///
/// Parameters: ln v_c; the coefficients of g and ln of the scatter between particles, in standard deviations
/// from the means of their normal priors; ln of the noise over its expected scale.
class CurvePosterior {
  public:
    CurvePosterior(const CurveTable& table, const std::vector<RecordedImpact>& impacts,
                   const CurvePrior& prior);

    // Indices of the parameters.
    static constexpr int critical = 0;
    static constexpr int first_term = 1;
    static constexpr int noise = first_term + SmoothDamping::terms;
    static constexpr int scatter = noise + 1;
    static constexpr int size = scatter + 1;
    using Vector = Eigen::Matrix<double, size, 1>;
    using Matrix = Eigen::Matrix<double, size, size>;

    /// -ln of the posterior density; 1e10 if the curve is impossible.
    [[nodiscard]] double operator()(const Vector& parameters) const;
    [[nodiscard]] SmoothDamping curve(const Vector& parameters) const;
    [[nodiscard]] Scatter scatter_of(const Vector& parameters) const;
    /// Whether the impacts state their noise.
    [[nodiscard]] bool noise_known() const { return prior_.noise_known; }

    struct Curvature {
        Vector gradient;
        Matrix hessian;
    };
    /// Gradient and Hessian by differences. @param value that at @p parameters
    /// @param steps of the differences, at most about the standard deviations of the parameters
    [[nodiscard]] Curvature curvature(const Vector& parameters, double value, const Vector& steps) const;

  private:
    [[nodiscard]] double prior_term(const Vector& parameters) const;

    const CurveTable* table_;
    const std::vector<RecordedImpact>* impacts_;
    CurvePrior prior_;
    double fastest_ = -1e300;  ///< ln v
    double slowest_ = 1e300;
};

}  // namespace ashimpact

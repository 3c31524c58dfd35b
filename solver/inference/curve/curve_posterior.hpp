// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Dense>

#include "solver/inference/curve/recorded_impacts.hpp"

namespace ashimpact {

/// A curve of restitution over velocity that assumes no law of contact or damping:
///
///     ln e = a + q ln s + sum_k b_k T_k(2s - 1),   s = y/(1 + y),   y = ln(v/v_c),
///
/// zero up to v_c and of order y^q above it: q = 1/2 where the contact takes a fixed energy, about 1 where
/// damping that hardly varies just captures.
class OnsetCurve {
  public:
    static constexpr int bends = 6;
    static constexpr int size = 2 + bends;
    using Vector = Eigen::Matrix<double, size, 1>;  ///< a, q, b_1 ...

    OnsetCurve(double log_critical_velocity, const Vector& coefficients)
        : critical_(log_critical_velocity), coefficients_(coefficients) {}

    /// Factors of the coefficients in ln e. @param y ln(v/v_c), above 0
    [[nodiscard]] static Vector terms(double y);
    /// e at ln v = @p x
    [[nodiscard]] double restitution(double x) const;
    [[nodiscard]] double log_critical_velocity() const { return critical_; }
    [[nodiscard]] const Vector& coefficients() const { return coefficients_; }

  private:
    double critical_;
    Vector coefficients_;
};

/// How measurements scatter about the curve.
struct Scatter {
    double noise;      ///< factor on the uncertainties of both velocities
    double threshold;  ///< standard deviation of ln v_c between particles
    /// Whether particles differ in the energy that captures, which fast rebounds hardly notice, as where w
    /// differs; else their whole curves are shifted along ln v, as where size or damping do.
    bool fades = false;
};

/// ln of the probability of a recorded capture, or of the probability density of a reading [s/m], over the
/// true velocity, the scatter between particles and a small share of records that depend on nothing.
[[nodiscard]] double log_probability(const OnsetCurve& curve, const Scatter& scatter,
                                     const RecordedImpact& impact);

/// What is known before the impacts are used.
struct CurvePrior {
    bool noise_known;
    double noise;                   ///< first estimate of an unknown noise [m/s]
    std::optional<double> scatter;  ///< of ln v_c between particles, if known
};

/// The likeliest curve at a v_c and a scatter, and the density of v_c there.
struct LikeliestCurve {
    OnsetCurve curve;
    Scatter scatter;
    double log_density;  ///< ln of the posterior, integrated over the curves by Laplace's method
};

/// Posterior density of v_c. At each v_c and each of some values of the scatter between particles, the curve
/// and the factor on the noise are fitted by a fixed number of iterations, so that all results are smooth in
/// the impacts.
class CurvePosterior {
  public:
    CurvePosterior(const std::vector<RecordedImpact>& impacts, const CurvePrior& prior)
        : impacts_(&impacts), prior_(prior) {}

    /// The likeliest curve of the likeliest scatter; its density is the sum over all of them.
    /// @param log_critical_velocity ln v_c
    [[nodiscard]] LikeliestCurve at(double log_critical_velocity) const;
    /// ln of the probability of the outcomes alone, captures and rebounds, whatever the curve.
    [[nodiscard]] double log_outcomes(double log_critical_velocity) const;

  private:
    [[nodiscard]] LikeliestCurve fitted(double log_critical_velocity, const Scatter& start) const;

    const std::vector<RecordedImpact>* impacts_;
    CurvePrior prior_;
};

}  // namespace ashimpact

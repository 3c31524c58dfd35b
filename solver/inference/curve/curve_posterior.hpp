// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Dense>

#include "solver/inference/curve/impact_probability.hpp"

namespace ashimpact {

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

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <optional>

#include <Eigen/Dense>

#include "solver/damping/damping_polynomial.hpp"
#include "solver/inference/impacts/measurement.hpp"
#include "solver/numeric/chebyshev.hpp"
#include "solver/surrogate/contact_model.hpp"

namespace ashimpact {

/// The curve of rebounds that a damping eta(e_n) implies through the dynamic model: the velocity v(e) at
/// which an impact with damping eta(e) has restitution e. In the plane (v_in, v_r) it is (v, e v); it begins
/// at (v_c, 0), where e(v) rises vertically for adhesive laws while v(e) is smooth, hence the parameter e.
class RestitutionCurve {
  public:
    /// The curve of a damping; none if the damping is not positive, or v leaves the model's range, for some e
    /// in [0, greatest_restitution]. @param near a similar curve up to the same restitution, for first
    /// guesses; or null
    [[nodiscard]] static std::optional<RestitutionCurve> implied_by(const ContactModel& model,
                                                                    const DampingPolynomial& damping,
                                                                    double greatest_restitution,
                                                                    const RestitutionCurve* near = nullptr);

    struct Point {
        double velocity;    ///< v(e) [m/s]
        double slope;       ///< dv/de along the curve [m/s]
        double by_damping;  ///< dv/d(eta) at fixed e [m/kg]
    };
    /// Point of the curve at @p e; beyond the ends it is continued by its tangent, or less steeply in e(v).
    [[nodiscard]] Point point_at(double e) const;

    /// The point of the curve nearest to a measurement, in units of its noise.
    struct Projection {
        double restitution;  ///< e of the nearest point
        double distance;     ///< signed, in standard uncertainties
        double by_damping;   ///< change of the distance with the damping at that e [s/kg]
    };
    /// @param point with its noise @param start e of a point close by
    [[nodiscard]] Projection project(const Measurement& point, double start) const;

  private:
    explicit RestitutionCurve(double greatest_restitution) : greatest_(greatest_restitution) {}

    /// Axis of the cube root of e, in which the curve is a Chebyshev series.
    [[nodiscard]] static ChebyshevAxis axis(double greatest_restitution) {
        return {0.0, std::cbrt(greatest_restitution), degree};
    }

    double greatest_;
    static constexpr int degree = 20;
    Eigen::Matrix<double, degree + 1, 2> nodes_;         ///< ln v and ln dv/d(eta) at the Chebyshev nodes
    Eigen::Matrix<double, degree + 1, 2> coefficients_;  ///< of the same
};

}  // namespace ashimpact

#pragma once

#include "solver/uncertainty/likelihood/restitution_curve.hpp"

#include <Eigen/Dense>

#include <vector>

namespace ashimpact {

/// Standard uncertainties beyond which noise does not reach.
inline constexpr double noise_reach = 6.5;

/// Places along the curves of nearby dampings, for integrals over the velocity: the weight of a place is the
/// range of velocities that it stands for. Gauss-Legendre panels in the cube root of e, in which the curve is
/// smooth down to v_c, each shorter than the noise; above the curve's end they follow its tangent.
class CurveNodes {
  public:
    struct Extent {
        double resolution;  ///< length of a panel in the plane (v_in, v_r) [m/s]
        double beyond;      ///< length of the tangent [m/s]
        double fastest;     ///< greatest v_in; what rises to twice that is left out [m/s]
    };
    /// @param curve one of them @param order of the dampings
    CurveNodes(const RestitutionCurve& curve, int order, const Extent& extent);

    /// Panels that a resolution asks for are more than there can be.
    [[nodiscard]] static bool too_fine(const RestitutionCurve& curve, const Extent& extent);

    struct Values {
        Eigen::VectorXd velocity;        ///< v [m/s]
        Eigen::VectorXd rebound;         ///< e v [m/s]
        Eigen::VectorXd weight;          ///< of integrals over v [m/s]
        Eigen::VectorXd rebound_weight;  ///< of integrals over e v along the curve [m/s]
        /// Change of the integral of f(v, e v) over v by each coefficient, per slope of f in its second
        /// place; with the other sign that of the integral over e v, per slope of f in its first place.
        Eigen::MatrixXd by_coefficient;
        Eigen::MatrixXd velocity_by_coefficient;  ///< [m/kg]
        Eigen::VectorXd first_velocity;           ///< d v_c by each coefficient [m/kg]
        double critical_velocity;                 ///< [m/s]
    };
    /// @param curve of the same order and greatest restitution
    [[nodiscard]] Values on(const RestitutionCurve& curve) const;

  private:
    void add_panels(const RestitutionCurve& curve, const Extent& extent);
    void add_tangent(const RestitutionCurve& curve, const Extent& extent);
    void add_panel(double lower, double upper);

    int order_;
    double top_;  ///< cube root of the greatest restitution
    std::vector<double> roots_;
    std::vector<double> weights_;
    Eigen::MatrixXd values_;  ///< of the Chebyshev polynomials at roots_, those above top_ at top_
    Eigen::MatrixXd slopes_;
};

}  // namespace ashimpact

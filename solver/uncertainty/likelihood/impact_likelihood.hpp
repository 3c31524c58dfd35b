#pragma once

#include "solver/measurement/contact_model.hpp"
#include "solver/uncertainty/likelihood/curve_nodes.hpp"
#include "solver/uncertainty/likelihood/restitution_data.hpp"

#include <Eigen/Dense>

#include <memory>
#include <optional>

namespace ashimpact {

/// -ln L of impacts as a function of the coefficients of eta(e_n).
///
/// An impact of true velocity v > v_c rebounds at e(v) v, one below sticks; both velocities are measured with
/// normal errors. What was measured has the probability of that summed over all true velocities, each as
/// likely as the next: for a rebound the integral along the curve v(e) of the noise's density, for a capture
/// Phi((v_c - v)/u). (Structural errors in variables with a flat prior: Fuller 1987, Measurement Error
/// Models, ch. 1.) The nearest point of the curve would do for noise that is small against its bends, but at
/// v_c it bends sharply. Where captures are not used, a rebound counts given that it was one.
class ImpactLikelihood {
  public:
    /// @param near a damping close by
    ImpactLikelihood(const ContactModel& model, RestitutionData data, const Eigen::VectorXd& near);

    /// Takes the places of the integrals on the curve of these coefficients: they should be close to where
    /// the likelihood is asked for. @throws ConvergenceError where there is no such curve
    void move_to(const Eigen::VectorXd& coefficients);

    /// Whether the noise is so small against the curve that an integral over it cannot be told from the
    /// nearest point.
    [[nodiscard]] static bool noise_is_negligible(const RestitutionCurve& curve, const RestitutionData& data);

    struct Value {
        double value;  ///< -ln L, without constants
        Eigen::VectorXd gradient;
    };
    /// None where the coefficients give no curve.
    [[nodiscard]] std::optional<Value> at(const Eigen::VectorXd& coefficients) const;

    [[nodiscard]] const RestitutionData& data() const { return data_; }
    [[nodiscard]] const ContactModel& model() const { return *model_; }

  private:
    const ContactModel* model_;
    RestitutionData data_;
    double precision_ = 0.0;  ///< sum over the rebounds of 1/u^2 of v_in [s2/m2]
    std::unique_ptr<const CurveNodes> nodes_;
    mutable std::optional<RestitutionCurve> last_;  ///< the next is close by
};

}  // namespace ashimpact

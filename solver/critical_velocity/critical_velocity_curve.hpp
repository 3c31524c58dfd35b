#pragma once

#include <Eigen/Dense>

#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/numeric/chebyshev.hpp"

namespace ashimpact {

/// v_c(eta) of one law with constant damping and every contact, from a few solved ones: by dimensional
/// analysis v_c/V depends on eta/(m^(3/5) k^(2/5) V^(1/5)) alone, V being the velocity at which the law's
/// adhesion number is one (without adhesion v_c goes with eta^5/(m^3 k^2)). For Monte Carlo: below a
/// microsecond where critical_velocity() takes tenths of a millisecond.
class CriticalVelocityCurve {
  public:
    /// Solves the curve for damping within [damping/factor, damping factor] of @p contact.
    /// @param damping > 0 [kg/s] @param factor > 1
    /// @throws InputError for inadmissible input, and where some v_c in that range is not finite or the law
    /// has a history (yield)
    CriticalVelocityCurve(Law law, Detachment detachment, const ContactPair& contact, double damping,
                          double factor);

    /// v_c [m/s]; beyond the range solved the curve continues. @param damping > 0 [kg/s]
    [[nodiscard]] double operator()(const ContactPair& contact, double damping) const;

  private:
    [[nodiscard]] double velocity_unit(const ContactPair& contact) const;
    [[nodiscard]] double logarithmic_damping(const ContactPair& contact, double damping) const;

    Law law_;
    bool adhesive_;
    ChebyshevAxis axis_{};
    Eigen::VectorXd coefficients_;  ///< of ln(v_c/V) in Chebyshev polynomials of the scaled ln(eta)
};

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "solver/contact/law.hpp"
#include "solver/motion/impact.hpp"

namespace ashimpact::studies {

/// What decides the restitution of a truth.
enum class TrueDamping {
    quadratic_in_restitution,  ///< eta = a e^2 + b e + c, the law's row of Table 2
    power_of_velocity,         ///< eta as v^parameter
    bump_in_velocity,          ///< eta as v^-0.35, with a bump of 20 % at 2.5 v_c
    contact_radius,            ///< eta = C a
    hunt_crossley,             ///< eta = zeta F_r
    two_terms,                 ///< eta = zeta_H F_r + zeta_A |F_a|, zeta_A/zeta_H the parameter
    sharp_onset,               ///< e = parameter sqrt(1 - (v_c/v)^2), no damping at all
    thornton_ning,             ///< yield at parameter v_c, closed form of Thornton & Ning 1998
};

struct Truth {
    TrueDamping damping;
    double parameter = 0.0;
};

/// Factors on the nominal particle of 96 um and w of 0.2959 J/m2.
struct Particle {
    double diameter = 1.0;
    double adhesion = 1.0;
    double threshold = 1.0;  ///< on all velocities of the curve, whatever makes particles differ
};

/// Restitution against velocity of one particle. Truths of constant damping come from GSL's integration in
/// time of the law as its paper has it (tests/oracles), other damping from an integration of its own, the
/// rest from closed forms: nothing of the program's own solver or fits is in it.
class TrueCurve {
  public:
    TrueCurve(Law law, const Truth& truth, const Particle& particle = {});

    [[nodiscard]] double critical_velocity() const { return critical_velocity_; }  ///< [m/s]
    /// Restitution at a velocity up to about 10 critical velocities; 0 for a capture.
    [[nodiscard]] double restitution(double velocity) const;

  private:
    using Curve = std::function<double(double velocity)>;

    void from_restitution(const Impact& impact, const std::vector<double>& abc);
    void from_velocity(const Curve& restitution, double near);
    void from_state(Law law, const Truth& truth, const Impact& impact);
    void scale_velocities(double factor);

    double critical_velocity_ = 0.0;
    std::vector<double> velocity_;
    std::vector<double> restitution_;
};

}  // namespace ashimpact::studies

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/oracles/impact_case.hpp"

namespace ashimpact::studies {

/// What the damping of a truth depends on.
enum class TrueDamping { quadratic_in_restitution, power_of_velocity, bump_in_velocity };

/// Restitution against velocity of one particle, made by GSL's integration in time of the law as its paper
/// has it: nothing of the program's own solver or fits is in it.
class TrueCurve {
  public:
    /// @param diameter over that of the 96 um sample of Dong et al. 2013
    TrueCurve(oracles::Law law, TrueDamping damping, double diameter = 1.0);

    [[nodiscard]] double critical_velocity() const { return critical_velocity_; }  ///< [m/s]
    /// Restitution at a velocity up to about 10 critical velocities; 0 for a capture.
    [[nodiscard]] double restitution(double velocity) const;

  private:
    void from_restitution(const oracles::ImpactCase& impact, const std::vector<double>& abc);
    void from_velocity(const oracles::ImpactCase& impact, const std::function<double(double)>& damping,
                       double near);

    double critical_velocity_ = 0.0;
    std::vector<double> velocity_;
    std::vector<double> restitution_;
};

}  // namespace ashimpact::studies

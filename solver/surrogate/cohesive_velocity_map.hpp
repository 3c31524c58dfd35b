// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include <Eigen/Dense>

#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/numeric/chebyshev.hpp"
#include "solver/surrogate/contact_model.hpp"

namespace ashimpact {

/// The two numbers on which the scaled v_c of a Maugis-Dugdale pair depends.
struct CohesiveNumbers {
    double damping;  ///< scaled coefficient of the damping law, in units of Maugis [1]
    double lambda;   ///< transition parameter [1]
};
/// @param problem with law maugis-dugdale and adhesion
[[nodiscard]] CohesiveNumbers cohesive_numbers(const CriticalVelocityProblem& problem);

/// The critical velocities of similar Maugis-Dugdale pairs, for propagation and searches that need thousands:
/// ln v_c, in units of Maugis, interpolated over the logarithms of damping and transition parameter
/// (Chebyshev). Relative error at most accuracy(). A pair outside of the map is solved.
class CohesiveVelocityMap {
  public:
    static constexpr double accuracy() { return 1e-6; }

    /// @param nominal the pair at the centre
    /// @param spread half widths of the map, in ln(damping) and ln(lambda) [1]
    CohesiveVelocityMap(const CriticalVelocityProblem& nominal, const std::array<double, 2>& spread);

    /// v_c [m/s], none without a finite one. Law, detachment and damping law are those of the nominal pair.
    [[nodiscard]] std::optional<double> operator()(const CriticalVelocityProblem& problem) const;

    /// Whether a pair is read from the map; else it is solved.
    [[nodiscard]] bool holds(const CohesiveNumbers& numbers) const;

  private:
    std::array<double, 2> centre_{};
    std::array<double, 2> spread_{};
    std::optional<ChebyshevSurface> surface_{};  ///< none where v_c is not finite and smooth throughout
};

}  // namespace ashimpact

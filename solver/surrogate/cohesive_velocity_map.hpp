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

/// The restitution of one contact, tabulated over two numbers: x = ln v, and phi = ln(eta_capture(v)/eta),
/// the distance of the damping from the least that captures at this velocity. A look-up takes 50 ns, where
/// the model's own inversion takes microseconds.
///
/// The table's own variable is s = sqrt(1 - exp(-phi)), in which e is smooth from capture (s = 0) to no
/// damping at all (s = 1) for adhesive laws and for Hertz alike. Interpolation is cubic (Catmull and Rom
/// 1974); its error is below 1e-4 in e.
class CurveTable {
  public:
    /// @param velocities that impacts and v_c can have, within the model's range [m/s]
    CurveTable(const ContactModel& model, VelocityRange velocities);

    struct Value {
        double restitution;
        double by_distance;  ///< d e/d phi at fixed velocity
    };
    /// @param distance phi; zero or less is a capture @param x ln v
    [[nodiscard]] Value at(double distance, double x) const;
    /// ln eta_capture, eta in kg/s. @param x ln v
    [[nodiscard]] double log_capture_damping(double x) const;
    /// Ends of the table, in ln v.
    [[nodiscard]] double lower() const { return first_; }
    [[nodiscard]] double upper() const { return first_ + step_ * static_cast<double>(capture_.size() - 1); }

  private:
    struct Column {
        Eigen::Index first;
        std::array<double, 4> weight;
    };
    [[nodiscard]] Column column(double x) const;

    double first_;                 ///< least ln v
    double step_;                  ///< of ln v between columns
    Eigen::VectorXd capture_;      ///< ln eta_capture by x
    Eigen::MatrixXd restitution_;  ///< by s, then by x
};

}  // namespace ashimpact

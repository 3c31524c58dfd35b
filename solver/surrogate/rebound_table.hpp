// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/motion/impact.hpp"
#include "solver/numeric/chebyshev.hpp"
#include "solver/surrogate/contact_model.hpp"

namespace ashimpact {

/// Verdict and v_c [m/s] as tabulated_critical_velocity() gives them, a hundred times as fast where the
/// contact yields only beyond v_c: up to there it is elastic. Errors: as critical_velocity().
[[nodiscard]] CriticalVelocity quick_critical_velocity(const CriticalVelocityProblem& problem);

/// How fine a ReboundTable is.
struct ReboundTableOptions {
    int yield_halvings = 14;  ///< of the range in ln v, to find where the contact yields
    int lane_degree = 47;     ///< of its polynomials, for laws that batches solve in lanes
    int scalar_degree = 23;   ///< for laws whose impacts take a hundred times as long
};

/// Restitution over velocity of one contact with one damping, so that thousands of impacts cost as much as a
/// few dozen. Polynomials (Chebyshev) in sqrt(ln(v/v_c)) between the critical velocity, the velocity from
/// which the contact yields, and the fastest impact: with damping that is constant at touch e is a series in
/// that root. Where nothing is captured they are polynomials in ln v.
class ReboundTable {
  public:
    using Options = ReboundTableOptions;

    /// @param impact of the contact; its velocity does not matter @param velocities of the impacts [m/s]
    /// @throws InputError for inadmissible input, ConvergenceError as solve_impact()
    ReboundTable(Impact impact, const VelocityRange& velocities, const Options& options = {});

    /// e^2 of an impact [1]; of a capture the tangent at v_c, which is negative, or -1 without a finite v_c.
    /// @param log_velocity ln v, v within the velocities [ln m/s]
    [[nodiscard]] double energy_ratio(double log_velocity) const;

  private:
    struct Piece {
        ChebyshevAxis axis;  ///< of position()
        Eigen::VectorXd coefficients;
    };
    /// Position of ln v on the axis of the polynomials.
    [[nodiscard]] double position(double log_velocity) const;
    /// @param last restitution of the fastest impact, if known
    void add_piece(const Impact& impact, double slowest, double fastest, int degree,
                   std::optional<double> last);

    double log_critical_ = -std::numeric_limits<double>::infinity();  ///< ln v_c; infinite: none is finite
    double slope_at_capture_ = 0.01;  ///< d(e^2)/d(ln v); that value where it is not known, or less [1]
    std::vector<Piece> pieces_{};     ///< from slow to fast
};

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "pipeline/case/case.hpp"
#include "solver/contact/pair.hpp"
#include "solver/damping/damping_polynomial.hpp"

namespace ashimpact::report {

/// A known impact near a curve, from which it is searched.
struct CurveKnot {
    double restitution;  ///< 0 for the critical velocity [1]
    double velocity;     ///< [m/s]
};

/// A law, a contact and a damping eta(e) whose impacts are wanted.
struct CurveProblem {
    LawChoice choice;
    DampingLaw damping_law;
    ContactPair contact;
    DampingPolynomial damping_fit;  ///< eta(e) [unit of the damping law]
    Eigen::MatrixXd covariance;     ///< of its coefficients
    double greatest_restitution;    ///< where the curve ends [1]
    double greatest_velocity;       ///< or here, if that is slower [m/s]
    std::vector<CurveKnot> knots;   ///< at least one; the curve does not depend on them
};

/// An impact on the model's curve e(v_in): its damping is eta(e) of the fit.
struct CurveImpact {
    double velocity;      ///< v_in [m/s]
    double lower, upper;  ///< 95 % band of the velocity at this restitution; NaN where nothing is known [m/s]
    double restitution;   ///< [1]
    double damping;       ///< [unit of the damping law]
    double contact_time;  ///< [s]
    double dissipated = 0;  ///< share of the incident energy that damping takes [1]
    double adhesion = 0;    ///< share that breaking the contact takes, jumps of the surfaces included [1]
    double plastic = 0;     ///< share that yielding takes [1]
};

using ModelCurve = std::vector<CurveImpact>;

/// The curve e(v_in) that a fit eta(e) implies, from just above e = 0 to the greatest restitution, with the
/// band that the uncertainty of eta(e) makes. Empty for damping laws other than the constant one, whose
/// restitution need not rise with velocity, and where the curve cannot be solved.
[[nodiscard]] ModelCurve model_curve(const CurveProblem& problem);

}  // namespace ashimpact::report

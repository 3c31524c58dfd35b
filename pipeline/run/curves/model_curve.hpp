// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "pipeline/case/case.hpp"
#include "pipeline/run/results/contact.hpp"
#include "pipeline/run/results/critical_velocity.hpp"
#include "pipeline/run/results/damping.hpp"
#include "pipeline/run/results/histories.hpp"
#include "solver/batch/batch.hpp"
#include "solver/contact/pair.hpp"
#include "solver/damping/damping_polynomial.hpp"

namespace ashimpact::curves {

/// A known impact near a curve, from which it is searched.
struct CurveKnot {
    double restitution;  ///< 0 for the critical velocity [1]
    double velocity;     ///< [m/s]
};

/// A law, a contact and a damping eta(e), for the curve e(v) of its impacts.
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

/// Velocity [m/s] and damping of the impact of median velocity, of those beyond @p from and up to @p to
/// [m/s].
[[nodiscard]] std::optional<std::pair<double, double>> median_impact(const DampingSeries& series, double from,
                                                                     double to);

struct SearchedContact {
    LawChoice choice;
    DampingLaw damping_law;
    ContactPair pair;
};

/// Impacts of these dampings at these velocities.
[[nodiscard]] ImpactBatchResult impacts_at(const SearchedContact& contact, const Eigen::ArrayXd& damping,
                                           const Eigen::ArrayXd& velocity);

/// Impacts with given restitutions. NaN where none was found.
struct FoundImpacts {
    Eigen::ArrayXd velocity;      ///< [m/s]
    Eigen::ArrayXd contact_time;  ///< [s]
};

/// The impacts of given dampings that have these restitutions, all at once.
/// @param e restitutions, above 0 [1]
/// @param damping of each [unit of the damping law]
/// @param guess of each velocity [m/s]
/// @param enough change of ln v that ends a search
[[nodiscard]] FoundImpacts impacts_with(const Eigen::ArrayXd& e, const SearchedContact& contact,
                                        const Eigen::ArrayXd& damping, const Eigen::ArrayXd& guess,
                                        double enough);

/// The curve e(v_in) that a fit eta(e) implies, from just above e = 0 to the greatest restitution, with the
/// band that the uncertainty of eta(e) makes. Empty for damping laws other than the constant one, whose
/// restitution need not rise with velocity, and where the curve cannot be solved.
[[nodiscard]] ModelCurve model_curve(const CurveProblem& problem);

/// Adds what the figures draw of each law beside its histories: the model's curve e(v_in), with the damping
/// of the estimate if there is one and else of the fit, the impact at v_c and one of the falling branch. A
/// law without a fit has no curve; what does not converge is left out.
/// @param result with the histories of every sample of the case
void add_curves(const Case& data, const ContactResult& contacts, const DampingStageResult& dampings,
                const FitResult& fits, const CriticalVelocityResult& velocities, HistoriesResult& result);

}  // namespace ashimpact::curves

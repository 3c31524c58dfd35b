// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/inference/extrapolation/damping_curve_fit.hpp"
#include "solver/inference/propagation/random_contact.hpp"
#include "solver/statistics/propagation.hpp"
#include "solver/surrogate/contact_model.hpp"

namespace ashimpact {

/// Name of the factor under which the scatter of a fit is ranked.
inline constexpr const char* fit_factor = "damping fit";

/// How the damping changes if the contact differs from its nominal values.
enum class DampingUnderChange {
    /// The measured curve v_r(v_in) is known: the damping is read from it again with the other contact. Its
    /// errors and those of the contact cancel to a large part in v_c.
    reread,
    /// The damping is known by itself, e.g. published: errors do not cancel.
    held,
};

/// v_c with an interval from all uncertainties: the covariance of the fit (with the asymmetry of its
/// interval), size, density, moduli, fractions and w, ranked by their influence.
/// @param contact whose values are those of @p model 's contact
/// @throws InputError if the two contacts differ
[[nodiscard]] Propagation propagate_critical_velocity(const DampingCurveFit& fit, const ContactModel& model,
                                                      const RandomContact& contact,
                                                      DampingUnderChange change = DampingUnderChange::reread,
                                                      const PropagationOptions& options = {});

/// The same from a critical damping that is known by itself, such as one of the paper's Table 3; of every
/// law whose contact does not yield. Those of law maugis-dugdale are read from a CohesiveVelocityMap.
[[nodiscard]] Propagation propagate_critical_velocity(Law law, Detachment detachment,
                                                      const RandomInput& critical_damping,
                                                      const RandomContact& contact,
                                                      const PropagationOptions& options = {});

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "materials/composition.hpp"
#include "materials/modulus.hpp"
#include "solver/contact/pair.hpp"
#include "solver/inference/extrapolation/damping_curve_fit.hpp"
#include "solver/statistics/propagation.hpp"
#include "solver/surrogate/contact_model.hpp"

namespace ashimpact {

/// A contact whose properties follow from uncertain inputs.
struct RandomContact {
    std::vector<RandomInput> inputs;
    std::function<ContactPair(std::span<const double> values)> contact;  ///< for values of the inputs

    /// The contact at the values of the inputs.
    [[nodiscard]] ContactPair nominal() const;
};

/// The phases that a particle's Young's modulus follows from.
struct PhaseMixture {
    Composition composition;
    ModulusOptions options{};
};

/// A second sphere in place of the wall.
struct RandomPartner {
    RandomInput diameter;  ///< [m]
    RandomInput mass;      ///< [kg]
};

/// A sphere of one sieve size on a flat wall, or on a second sphere. Exactly one of mixture, young_modulus
/// and contact_modulus is given.
struct SphereInContact {
    RandomInput diameter;                                             ///< [m]
    RandomInput density;                                              ///< of the particle [kg/m3]
    RandomInput work_of_adhesion;                                     ///< [J/m2]
    RandomInput poisson_ratio{};                                      ///< of the particle [1]
    RandomInput wall_young_modulus{};                                 ///< [Pa]
    RandomInput wall_poisson_ratio{};                                 ///< [1]
    std::optional<PhaseMixture> mixture{};                            ///< XRD fractions and phase moduli, or
    std::optional<RandomInput> young_modulus{};                       ///< of the particle [Pa], or
    std::optional<RandomInput> contact_modulus{};                     ///< E* itself [Pa]
    std::optional<RandomPartner> partner{};                           ///< none: a flat wall
    double yield_pressure = std::numeric_limits<double>::infinity();  ///< [Pa]
    std::vector<std::pair<LawParameter, RandomInput>> parameters{};   ///< of laws that declare their own [SI]
    ParameterValues<double> other_parameters{};                       ///< that are no inputs [SI]
};

/// The inputs of a sphere in contact: first its diameter, density, w, and what its contact modulus comes
/// from, then its partner's; of a mixture, every fraction and every phase modulus whose uncertainty is known.
/// Fractions below zero count as zero.
/// @throws InputError unless exactly one way to a modulus is given
[[nodiscard]] RandomContact random_contact(const SphereInContact& sphere);

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

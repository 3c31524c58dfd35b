// SPDX-License-Identifier: GPL-3.0-or-later
// Softened contacts: E* divided by a factor S for longer time steps, with the same restitutions.
#pragma once

#include <optional>

#include "core/quantities/parameter.hpp"
#include "core/units/units.hpp"
#include "solver/contact/pair.hpp"
#include "solver/damping/damping.hpp"

namespace ashimpact {

/// Largest overlap of a softened contact, as a share of R*: beyond it the laws, for small contacts, fail [1].
inline constexpr double greatest_softened_overlap = 0.05;

/// Throws InputError unless S is finite, computable and above 1.
void require_softening(double factor);

/// S^(2/5), by which overlaps and contact times grow [1]. Mass, radii and velocities stay as they are, so
/// that the unit of overlap L = (m V^2/k)^(2/5) and the unit of time L/V go with E*^(-2/5).
[[nodiscard]] double stretch_of(double factor);

/// Power of L with which a quantity of that dimension goes where the scaled impact, the mass and the velocity
/// stay the same [1]. It follows from the SI unit: a second and a length along the overlap go with L, a
/// length along the surface with the contact radius, L^(1/2). None for a length, which may be either, and a
/// density.
[[nodiscard]] std::optional<double> length_power(Dimension dimension);

/// The same of a parameter: what it states, else what its dimension gives.
/// @throws std::logic_error if neither does
[[nodiscard]] double length_power(const LawParameter& parameter);

/// Factor on the values of a parameter in a contact softened by S [1].
[[nodiscard]] double softening_of(const LawParameter& parameter, double factor);
/// Factor on the coefficient of a damping law, from the units of the law [1]. @param stiff before softening
[[nodiscard]] double softening_of(DampingLaw law, const ContactPair& stiff, double factor);

/// The contact softened by S: E*/S, S^(-2/5) w, S^(-4/5) p_y, parameters by softening_of().
[[nodiscard]] ContactPair softened(const ContactPair& stiff, double factor);
/// The damping of that contact. @param stiff before softening
[[nodiscard]] Damping softened(const Damping& damping, const ContactPair& stiff, double factor);

/// Velocity at which an undamped Hertz impact overlaps by greatest_softened_overlap [m/s].
[[nodiscard]] double greatest_softened_velocity(const ContactPair& contact);

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/finding.hpp"
#include "solver/contact/law.hpp"
#include "solver/contact/mechanics.hpp"
#include "solver/damping/damping.hpp"
#include "solver/motion/impact.hpp"

namespace ashimpact {

/// Code of every finding on a regime.
inline constexpr std::string_view regime_code = "regime";

/// The numbers that say whether a contact law applies, and what they say of the law chosen.
struct Regime {
    double tabor_parameter = 0.0;         ///< mu = (R* w^2/(E*^2 z0^3))^(1/3) [1]; Tabor 1977
    double equilibrium_separation = 0.0;  ///< z0 of that, as the cohesion stated says, or else the usual [m]
    AdhesionRegime adhesion = AdhesionRegime::none;
    double transition_parameter = 0.0;       ///< lambda of Maugis, see transition_parameter_of() [1]
    double damping_number = 0.0;             ///< beta, the scaled coefficient of the damping law [1]
    double adhesion_number = 0.0;            ///< of the law, in the impact's own scale [1]
    double contact_radius = 0.0;             ///< at greatest overlap, by the law [m]
    double relative_contact_radius = 0.0;    ///< contact_radius/R* [1]
    double relative_overlap = 0.0;           ///< greatest overlap over R* [1]
    double greatest_pressure = 0.0;          ///< in the centre at greatest overlap; p_y if it yields [Pa]
    std::optional<double> yield_pressure{};  ///< p_y, none if the contact never yields [Pa]
    /// V_y of the closed form, without adhesion and damping; none without a yield pressure [m/s]
    std::optional<double> yield_velocity{};
    /// V_y of the law chosen, with its adhesion, without damping; 0 if adhesion alone makes it yield [m/s]
    std::optional<double> law_yield_velocity{};
    bool yields = false;              ///< the impact goes beyond the yield pressure, damping included
    std::vector<Finding> warnings{};  ///< of code regime_code
};

/// Equilibrium separation z0 of two surfaces, as usual in the Tabor parameter [m].
inline constexpr double usual_separation = 0.4e-9;

/// a/R* beyond which the parabolic geometry that every law here assumes is off by 2 % in overlap.
inline constexpr double widest_contact = 0.3;

/// The finding that a contact is wider than widest_contact. @param relative_radius a/R* [1]
[[nodiscard]] std::optional<Finding> wide_contact_finding(double relative_radius);

/// Maugis' transition parameter of a pair [1]: from the cohesion that it states for law maugis-dugdale, else
/// of surfaces with the usual_separation; 0 without adhesion.
[[nodiscard]] double transition_parameter_of(const ContactPair& contact);

/// Tabor parameter of a pair [1], of the same cohesion as transition_parameter_of(): lambda/1.157.
[[nodiscard]] double tabor_parameter_of(const ContactPair& contact);

/// Judges an impact, solved or to be solved. @p maximum_overlap as in ImpactResult [m]
///
/// A contact yields where the pressure in its centre, by Law::pressure(), reaches p_y; the
/// potential of the law gives the velocity. Brach-Dunn is empirical and has no range of Tabor parameters.
[[nodiscard]] Regime regime_of(const Impact& impact, double maximum_overlap);

/// The finding that an impact by a law without yield goes beyond the yield pressure, if it does.
[[nodiscard]] std::optional<Finding> yield_finding(const Impact& impact, const Regime& regime);

/// Velocity at which the part of the damping that is constant is of order one, beta = 1: eta^5/(m^3 k^2); 0
/// without such a part [m/s].
[[nodiscard]] double velocity_of_damping(const Damping& damping, const ContactPair& contact);

/// Velocity at which the law's adhesion number is one; 0 for a law or a pair without adhesion [m/s].
[[nodiscard]] double velocity_of_adhesion(Law law, const ContactPair& contact);

/// Yield velocity V_y of an undamped Hertz impact: (1/2) m V_y^2 is the elastic energy when the centre
/// reaches p_y; for a sphere (pi^2/sqrt40) (p_y^5/(E*^4 rho))^(1/2), Thornton & Ning 1998. Infinite without a
/// yield pressure [m/s].
[[nodiscard]] double yield_velocity(const ContactPair& contact);

}  // namespace ashimpact

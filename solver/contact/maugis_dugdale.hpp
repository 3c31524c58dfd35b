// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

#include "core/quantities/parameter.hpp"
#include "solver/contact/jkr.hpp"
#include "solver/contact/mechanics.hpp"
#include "solver/contact/pair.hpp"

namespace ashimpact {

/// Tabor parameter of a pair, mu = (R* w^2/(E*^2 z0^3))^(1/3); Tabor 1977.
inline constexpr LawParameter stated_tabor{
    .name = "tabor",
    .dimension = Dimension::fraction,
    .description = "Tabor parameter mu of the pair",
    .example = "2",
    .typical = 2.0,
    .choice = 1,
};
/// Stress sigma_0 of the cohesive zone.
inline constexpr LawParameter cohesive_stress{
    .name = "cohesive_stress",
    .dimension = Dimension::pressure,
    .description = "sigma_0, stress of the cohesive zone",
    .example = "770 MPa",
    .typical = 7.7e8,
    .choice = 1,
};
/// Equilibrium separation z0 of the two surfaces.
inline constexpr LawParameter cohesion_range{
    .name = "cohesion_range",
    .dimension = Dimension::length,
    .description = "z0, range of the attraction",
    .example = "0.4 nm",
    .typical = 4e-10,
    .choice = 1,
    .length_power = 1,  // a gap, along the overlap
};

/// Maugis 1992 (J. Colloid Interface Sci. 150:243): elastic spheres with a cohesive zone of constant stress
/// (Dugdale) around the contact. It lies between Dmt (cohesion of long reach, lambda to 0) and Jkr (short
/// reach, lambda to infinity).
///
/// Overlap and force are no polynomials of one coordinate, so this type only declares the law; the static law
/// is CohesiveZone, the impact CohesiveMotion. Sources, branches and limits: docs/laws/maugis-dugdale.md.
template <class Real>
struct MaugisDugdale {
    static constexpr std::string_view name = "maugis-dugdale";
    static constexpr std::string_view summary = "between dmt and jkr, for hard and soft particles alike";
    static constexpr Detachment default_detachment = Detachment::pull_off;
    static constexpr bool uses_work_of_adhesion = true;
    static constexpr bool has_cohesive_zone = true;
    static constexpr bool self_similar = false;
    static constexpr std::string_view similar = Jkr<Real>::name;
    static constexpr std::array parameters{stated_tabor, cohesive_stress, cohesion_range};

    [[nodiscard]] static Trust trust(double /*tabor*/, bool /*yields*/) { return Trust::every_tabor; }
    [[nodiscard]] static PressureProfile pressure(const ContactPair& pair, double a) {
        if (pair.work_of_adhesion == 0.0 || a == 0.0) return hertz_pressure(pair, a);
        return maugis_dugdale_pressure(pair, transition_parameter(pair), a);
    }

    /// Adhesion number of Jkr [1] where L is @p length [m]; the reach of the cohesion does not enter.
    [[nodiscard]] static Real adhesion_number(const BasicContactPair<Real>& pair, const Real& length) {
        return Jkr<Real>::adhesion_number(pair, length);
    }
};

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
// A restitution as DEM users request it: without adhesion, whatever the contact law.
#pragma once

#include <array>
#include <string_view>

#include "solver/contact/pair.hpp"
#include "solver/damping/damping.hpp"

namespace ashimpact {

/// Whether the restitution that a damping law gives Hertz impacts depends on their velocity: it does unless
/// no unit of the law's coefficients depends on it.
[[nodiscard]] bool restitution_depends_on_velocity(DampingLaw law, const ContactPair& contact);

/// The damping with which a Hertz impact that ends so has that restitution, exactly.
/// @param end zero_overlap or zero_force @param velocity [m/s] @throws InputError if no damping gives it
[[nodiscard]] Damping damping_without_adhesion(DampingLaw law, Detachment end, const ContactPair& contact,
                                               double velocity, double restitution);

/// What a DEM code makes of a requested restitution, without adhesion. All of these codes take the damping of
/// Tsuji et al. 1992, eta = C sqrt(m k) delta^(1/4), each with its own C, so that no velocity enters.
struct CodeRestitution {
    std::string_view code;     ///< and its version
    std::string_view setting;  ///< by which it takes the restitution
    double coefficient;        ///< C [1]
    Detachment end;            ///< zero_force where the code cuts attractive forces
    double restitution;        ///< delivered [1]
};

/// LAMMPS, LIGGGHTS, YADE and MFiX. @param requested above 0, up to 1 [1]
[[nodiscard]] std::array<CodeRestitution, 4> restitution_in_codes(double requested);

}  // namespace ashimpact

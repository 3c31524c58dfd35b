// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/present/export/dem/dem.hpp"

namespace ashimpact {

/// A code of LAMMPS's input language: what its folders have of it alone.
struct DemCode {
    std::string_view name;     ///< LAMMPS
    std::string_view program;  ///< lmp
    std::string_view command;  ///< that runs in.impacts
    std::string_view tried;    ///< version and package
    std::string_view setup;    ///< lines of the deck before the box: atom style, communication
    bool sets_mass;            ///< of a sphere; else its density
};

/// in.impacts, impacts.in, README.md, run.sh and compare.py. @param contact lines of the contact and of the
/// integrator
[[nodiscard]] ExportFolder deck_folder(const ExportSubject& subject, const DemCode& code,
                                       const std::string& contact, TemplateValues values);

/// What LAMMPS and LIGGGHTS have for two spheres: hertz and dmt with constant damping.
/// @param also_jkr whether the code knows jkr, which ends load-controlled
/// @throws InputError for a subject that is none of these, with the reason
void require_pair_contact(const ExportSubject& subject, const DemCode& code, bool also_jkr);

/// The damping of a pair [kg/s]; 0: none.
[[nodiscard]] double pair_damping(const ExportSubject& subject);

}  // namespace ashimpact

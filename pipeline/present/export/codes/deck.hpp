// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/present/export/codes/dem.hpp"

namespace ashimpact {

/// A code with the input language of LAMMPS.
struct DemCode {
    std::string_view name;     ///< LAMMPS
    std::string_view program;  ///< lmp
    std::string_view command;  ///< that runs in.impacts
    std::string_view tried;    ///< version and package that were tried
    std::string_view setup;    ///< lines of the deck before the box: atom style, communication
    bool sets_mass;            ///< the deck sets the mass of a sphere; else its density
};

/// What a folder for such a code has beside the common files.
struct Deck {
    std::string contact;                   ///< lines of in.impacts: the contact and the integrator
    ExportFolder files;                    ///< that these lines include, and examples
    std::vector<std::string> conversions;  ///< for assumptions.md
    DemCheck check;
};

/// in.impacts, impacts.in, README.md, run.sh, compare.py, the deck's own files, assumptions.md and
/// expected.json. @param values from dem_values(), with those that only this code has
[[nodiscard]] ExportFolder deck_folder(const ExportSubject& subject, const DemCode& code, const Deck& deck,
                                       TemplateValues values);

/// Accepts what LAMMPS and LIGGGHTS have for two spheres: hertz and dmt with constant damping.
/// @param also_jkr whether the code has jkr, whose contact ends load-controlled
/// @throws InputError for any other subject, with the reason
void require_pair_contact(const ExportSubject& subject, const DemCode& code, bool also_jkr);

/// The damping of a pair [kg/s]; 0: none.
[[nodiscard]] double pair_damping(const ExportSubject& subject);

}  // namespace ashimpact

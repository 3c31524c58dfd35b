// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <string>

namespace ashimpact {

/// What the user typed; empty where an option was not given.
struct ModulusCommandOptions {
    std::string file;                ///< an XRD result
    std::string amorphous_fraction;  ///< of the whole; "none", "remainder"
    std::string crystalline_total;   ///< of the whole
    std::string internal_standard;   ///< its phase
    std::string added_fraction;      ///< its weight over that of the mixture
    std::string sample;              ///< of a file with several; empty: all
    std::string sheet;               ///< of a spreadsheet; empty: the only one with a table
    std::string phase_set;           ///< looked in first
    std::string phases;              ///< a case file whose own phases come first
    std::string rule = "parallel";
    std::string porosity_law;
    std::string porosity;              ///< empty: from the particle density
    std::string porosity_coefficient;  ///< b of spriggs
    std::string particle_density;      ///< measured, pores included
    bool json = false;
};

/// `ashimpact modulus`: XRD result -> phase volumes -> Young's modulus with bounds.
void run_modulus_command(const ModulusCommandOptions& options, std::ostream& out);

}  // namespace ashimpact

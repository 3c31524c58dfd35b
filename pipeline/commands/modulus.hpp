#pragma once

#include <iosfwd>
#include <string>

namespace ashimpact {

struct ModulusCommandOptions {
    std::string file;                ///< an XRD result
    std::string amorphous_fraction;  ///< weight fraction of the whole; empty: what the file says
    std::string sample;              ///< of a file with several; empty: all
    std::string phase_set;           ///< looked in first
    std::string rule = "parallel";
    bool json = false;
};

/// `ashimpact modulus`: XRD result -> phase volumes -> Young's modulus with bounds.
void run_modulus_command(const ModulusCommandOptions& options, std::ostream& out);

}  // namespace ashimpact

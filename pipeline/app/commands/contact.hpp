// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <string>

#include "pipeline/app/commands/contact_options.hpp"

namespace ashimpact {

/// What two bodies are made of, as the user typed it; empty where an option was not given.
struct ContactCommandOptions {
    ContactOptions
        contact;  ///< size, mass, and modulus or work of adhesion where they are known by themselves
    std::string young_modulus;
    std::string poisson_ratio;
    std::string wall_young_modulus;
    std::string wall_poisson_ratio;
    bool rigid_wall = false;
    std::string surface_energy;
    std::string wall_surface_energy;
    std::string interfacial_energy;
    std::string rule;
    bool json = false;
};

/// `ashimpact contact`: E*, R*, m*, w, the separation energy W_s and the velocity v_s that adhesion alone
/// captures. Dong et al. 2013, Eqs. 6, 7, 28 and 30.
void run_contact_command(const ContactCommandOptions& options, std::ostream& out);

}  // namespace ashimpact

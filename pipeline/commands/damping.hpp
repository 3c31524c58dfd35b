#pragma once

#include <iosfwd>

#include "pipeline/commands/contact_options.hpp"

namespace ashimpact {

struct DampingOptions {
    ContactOptions contact;  ///< its damping is what is asked for, so not given
    std::string velocity;
    std::string restitution;
    bool json = false;
};

/// `ashimpact damping`: prints the damping that gives back a measured restitution.
void run_damping_command(const DampingOptions& options, std::ostream& out);

}  // namespace ashimpact

#pragma once

#include <iosfwd>

#include "pipeline/commands/contact_options.hpp"
#include "pipeline/json/document.hpp"
#include "solver/critical_velocity.hpp"

namespace ashimpact {

struct CriticalVelocityOptions {
    ContactOptions contact;
    bool json = false;
};

/// `ashimpact critical-velocity`: prints the dynamic critical velocity.
void run_critical_velocity_command(const CriticalVelocityOptions& options, std::ostream& out);

/// A critical velocity with the keys of the command's --json.
[[nodiscard]] Json critical_velocity_json(const CriticalVelocityProblem& problem,
                                          const CriticalVelocity& result);

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>

#include "pipeline/app/commands/contact_options.hpp"

namespace ashimpact {

struct CriticalVelocityOptions {
    ContactOptions contact;
    bool json = false;
};

/// `ashimpact critical-velocity`: prints the dynamic critical velocity.
void run_critical_velocity_command(const CriticalVelocityOptions& options, std::ostream& out);

}  // namespace ashimpact

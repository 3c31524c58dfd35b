// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <string>

namespace ashimpact {

/// `ashimpact phases`: the phase catalogue as a table; with a name, all that is known of that phase.
void run_phases_command(const std::string& name, std::ostream& out);

}  // namespace ashimpact

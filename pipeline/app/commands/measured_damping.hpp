// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>

#include "pipeline/app/commands/damping.hpp"

namespace ashimpact {

/// `ashimpact damping --impacts FILE`: what a series of measured impacts says of damping and critical
/// velocity under one law; intervals are those of the impacts, the contact is taken as exactly known.
void run_measured_damping_command(const DampingOptions& options, std::ostream& out);

}  // namespace ashimpact

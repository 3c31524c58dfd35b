// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>

#include "pipeline/app/sweep/spec/impacts.hpp"
#include "pipeline/app/sweep_options.hpp"

namespace ashimpact {

class MpiSession;

/// `ashimpact sweep`, as ashimpact-sweep runs it: reads the spec, continues from a checkpoint if there is
/// one, computes the rest with the threads of all processes, and writes the result.
void run_sweep_command(const SweepOptions& options, MpiSession& session, const ImpactSolver& solver,
                       std::ostream& out);

}  // namespace ashimpact

#pragma once

#include <iosfwd>

#include "pipeline/commands/sweep.hpp"
#include "pipeline/sweep/table/impact_columns.hpp"

namespace ashimpact {

class MpiSession;

/// `ashimpact sweep`, in the program that can do it: reads the spec, goes on from a checkpoint if there is
/// one, has the threads of all processes compute what is left, writes the result.
void run_sweep_command(const SweepOptions& options, MpiSession& session, const ImpactSolver& solver,
                       std::ostream& out);

}  // namespace ashimpact

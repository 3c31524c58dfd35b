#pragma once

#include <iosfwd>
#include <string>

namespace ashimpact {

class MpiSession;
struct SweepOptions;

/// `ashimpact sweep`, in the program that can do it: reads the spec, goes on from a checkpoint if there is
/// one, has the threads of all processes compute what is left, writes the result.
void run_sweep_command(const SweepOptions& options, MpiSession& session, std::ostream& out);

}  // namespace ashimpact

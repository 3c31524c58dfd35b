// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/app/export.hpp"
#include "pipeline/app/sweep_options.hpp"

namespace ashimpact {

/// The program: parses the command line, runs one command, turns errors into one line and an exit status.
/// @param sweep what `ashimpact sweep` does
/// @param exporter what `ashimpact export` does
/// @returns 0 done; 2 the user's input is wrong; 3 a computation did not converge; 1 a defect of ours.
[[nodiscard]] int run_program(int argc, const char* const* argv, const SweepRunner& sweep,
                              const ExportRunner& exporter);

}  // namespace ashimpact

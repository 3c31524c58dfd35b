// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/app/sweep/spec/plan.hpp"
#include "pipeline/app/sweep/sweep.hpp"

namespace ashimpact {

/// Checks before a computation that its outputs can be written and would replace only files of this sweep.
/// Refuses to replace the spec, a table that no sweep or another sweep wrote, rows or a checkpoint that no
/// sweep wrote, and a page that is no report of this program.
/// @param with_report whether the report will be written
/// @throws InputError naming the file
void check_outputs(const SweepFiles& files, const std::filesystem::path& spec, const SweepPlan& plan,
                   bool with_report);

}  // namespace ashimpact

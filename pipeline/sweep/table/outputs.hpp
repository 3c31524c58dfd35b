#pragma once

#include "pipeline/sweep/spec/plan.hpp"
#include "pipeline/sweep/sweep.hpp"

namespace ashimpact {

/// Refuses, before anything is computed, an output that would take the place of something that is not this
/// sweep's: of its spec, of a table that no sweep or another one wrote, of rows or a checkpoint that no sweep
/// wrote; of a page that is no report of ours; and one that cannot be written.
/// @param with_report whether the report will be written
/// @throws InputError naming the file
void check_outputs(const SweepFiles& files, const std::filesystem::path& spec, const SweepPlan& plan,
                   bool with_report);

}  // namespace ashimpact

#include "solver/batch/impact_batch.hpp"

#include "materials/base/error.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/batch/tables/restitution_table.hpp"
#include "solver/batch/task.hpp"

#include <array>
#include <limits>
#include <string>

namespace ashimpact {

namespace {

using batch::ImpactTask;
using batch::LaneEnd;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

Impact impact_at(const ImpactBatch& batch, const batch::Inputs& in, std::size_t i) {
    return {batch.law,
            batch.detachment,
            {batch.damping_law, in.damping.at(i)},
            batch::pair_at(in, i),
            in.velocity.at(i)};
}

void solve_alone(const Impact& impact, const ImpactTask& task, std::size_t i) {
    const ImpactResult result = solve_impact(impact);
    task.end[i] = result.outcome == Outcome::rebound ? LaneEnd::rebound : LaneEnd::capture;
    task.restitution[i] = result.restitution;
    task.contact_time[i] = result.contact_time.value_or(nothing);
    task.approach_time[i] = task.turning_point ? result.approach_time.value_or(nothing) : nothing;
    task.maximum_overlap[i] = task.turning_point ? result.maximum_overlap : nothing;
}

/// Solves a task, and alone what its kernel could not decide. @return how many those were
std::int64_t solve(const ImpactBatch& batch, const ImpactTask& task, std::size_t first, Outcome* outcome) {
    batch::kernels_of(batch.law).impacts(task);
    std::int64_t alone = 0;
    for (std::size_t i = 0; i < task.count; ++i) {
        if (task.end[i] == LaneEnd::undecided) {
            try {
                solve_alone(impact_at(batch, task.inputs, i), task, i);
            } catch (const ConvergenceError& error) {
                throw ConvergenceError("impact " + std::to_string(first + i) + ": " + error.what());
            }
            ++alone;
        }
        outcome[i] = task.end[i] == LaneEnd::rebound ? Outcome::rebound : Outcome::capture;
    }
    return alone;
}

void resize(ImpactBatchResult& result, Eigen::Index count) {
    result.outcome.resize(count);
    for (Eigen::ArrayXd* column :
         {&result.restitution, &result.contact_time, &result.approach_time, &result.maximum_overlap}) {
        column->resize(count);
    }
}

batch::Inputs inputs_of(const ImpactBatch& batch) {
    batch::Inputs inputs = batch::inputs_of(batch.law, batch.contact);
    inputs.damping = batch::input_of(batch.damping);
    inputs.velocity = batch::input_of(batch.velocity);
    return inputs;
}

}  // namespace

void solve_impacts(const ImpactBatch& batch, ImpactBatchResult& result, const BatchOptions& options) {
    if (const auto reason = refusal(batch.law, batch.detachment)) {
        throw InputError(*reason, admissible_detachments(batch.law));
    }
    const bool tabulated = options.method == BatchMethod::table;
    if (tabulated && options.turning_point) {
        throw InputError("a table has no turning points", "turning_point = false, or the method integration");
    }
    batch::RestitutionTable* const table =
        tabulated ? &batch::RestitutionTable::of(batch.law, batch.detachment, batch.damping_law) : nullptr;
    const Eigen::Index count =
        common_size(batch.contact, {{"damping", batch.damping.size()}, {"velocity", batch.velocity.size()}});
    const batch::Inputs inputs = inputs_of(batch);
    resize(result, count);
    batch::FirstFault fault;
    std::atomic<std::int64_t> scalar = 0;
    const auto chunk = [&](std::size_t first, std::size_t size) {
        const batch::Inputs own = inputs.from(first);
        if (!fault.check(own, first, size)) return;
        std::array<LaneEnd, batch::most_impacts> end;  // the kernel fills what is used
        const ImpactTask task{.damping_law = batch.damping_law,
                              .detachment = batch.detachment,
                              .turning_point = options.turning_point,
                              .table = table,
                              .count = size,
                              .inputs = own,
                              .end = end.data(),
                              .restitution = result.restitution.data() + first,
                              .contact_time = result.contact_time.data() + first,
                              .approach_time = result.approach_time.data() + first,
                              .maximum_overlap = result.maximum_overlap.data() + first};
        scalar += solve(batch, task, first, result.outcome.data() + first);
    };
    batch::for_chunks(static_cast<std::size_t>(count), batch::most_impacts, options.threads, chunk);
    result.scalar = scalar;
    fault.raise([&](std::size_t i) { validate(impact_at(batch, inputs, i)); });
}

ImpactBatchResult solve_impacts(const ImpactBatch& batch, const BatchOptions& options) {
    ImpactBatchResult result;
    solve_impacts(batch, result, options);
    return result;
}

}  // namespace ashimpact

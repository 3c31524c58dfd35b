#include "solver/batch/impact_batch.hpp"

#include "materials/base/error.hpp"
#include "solver/batch/admissibility.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/batch/tables/restitution_table.hpp"
#include "solver/batch/task.hpp"
#include "solver/motion/maugis/cohesive_impact.hpp"
#include "solver/motion/scale.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <string>

namespace ashimpact {

namespace {

using batch::ImpactTask;
using batch::is_possible_end;
using batch::LaneEnd;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

Impact impact_at(const ImpactBatch& batch, const batch::Inputs& in, std::size_t i) {
    return {batch.law,
            batch.detachment,
            {batch.damping_law, in.damping.at(i)},
            batch::pair_at(in, i),
            in.velocity.at(i)};
}

void take_end(const ImpactResult& result, const ImpactTask& task, std::size_t i) {
    task.end[i] = result.outcome == Outcome::rebound ? LaneEnd::rebound : LaneEnd::capture;
    task.restitution[i] = result.restitution;
    task.contact_time[i] = result.contact_time.value_or(nothing);
}

void take_turn(const ImpactResult& result, const ImpactTask& task, std::size_t i) {
    task.approach_time[i] = result.approach_time.value_or(nothing);
    task.maximum_overlap[i] = result.maximum_overlap;
}

/// Whether the turning point is possible and agrees with the end of the impact: a rebound turns before it
/// ends.
bool is_possible_turn(const ImpactTask& task, std::size_t i) {
    const double time = task.approach_time[i];
    const double overlap = task.maximum_overlap[i];
    if (!(overlap > 0.0) || !std::isfinite(overlap)) return false;
    const bool rebounds = task.end[i] == LaneEnd::rebound;
    if (std::isnan(time)) return !rebounds;
    return time > 0.0 && std::isfinite(time) && (!rebounds || time < task.contact_time[i]);
}

/// Collects impacts that did not converge, from several threads.
class Failures {
  public:
    explicit Failures(bool keep) : keep_(keep) {}

    /// Notes a failure. @throws ConvergenceError naming the impact, unless failures are kept
    void add(const ImpactTask& task, std::size_t i, std::size_t first, const ConvergenceError& error) {
        if (!keep_) throw ConvergenceError("impact " + std::to_string(first + i) + ": " + error.what());
        task.end[i] = LaneEnd::capture;
        task.restitution[i] = task.contact_time[i] = task.approach_time[i] = task.maximum_overlap[i] =
            nothing;
        const std::lock_guard lock(mutex_);
        failed_.push_back({static_cast<std::int64_t>(first + i), error.what()});
    }
    [[nodiscard]] std::vector<FailedImpact> in_order() && {
        std::sort(failed_.begin(), failed_.end(),
                  [](const FailedImpact& a, const FailedImpact& b) { return a.place < b.place; });
        return std::move(failed_);
    }

  private:
    bool keep_;
    std::mutex mutex_;
    std::vector<FailedImpact> failed_;
};

/// Adhesion numbers for which double precision resolves the motion through a cohesive zone as well as the
/// kernels do that of their laws; beyond them adhesion or inertia is lost beside the other.
constexpr double least_adhesion = 1e-6;
constexpr double most_adhesion = 1e6;

/// One impact by the scalar solver, with a cohesive zone in double precision where that is enough.
ImpactResult solve_alone(const Impact& impact) {
    if (!is_cohesive(impact.law, impact.contact)) return solve_impact(impact);
    validate(impact);
    const double length = Scale::of(impact.contact, impact.velocity).length;
    const double adhesion = Dmt<double>::adhesion_number(impact.contact, length);
    try {
        if (adhesion > least_adhesion && adhesion < most_adhesion)
            return solve_cohesive_impact(impact, Precision::standard);
    } catch (const ConvergenceError&) {  // it may in extended precision
    }
    return solve_cohesive_impact(impact, Precision::extended);
}

/// Solves a task. Impacts that its kernel left undecided or gave an impossible result go through the scalar
/// solver. @return how many those were
std::int64_t solve(const ImpactBatch& batch, const ImpactTask& task, std::size_t first, Outcome* outcome,
                   Failures& failures) {
    batch::kernels_of(batch.law).impacts(task);
    std::int64_t solved_alone = 0;
    for (std::size_t i = 0; i < task.count; ++i) {
        const bool end_known = is_possible_end(task, i);
        const bool turn_known = !task.turning_point || (end_known && is_possible_turn(task, i));
        if (!end_known || !turn_known) {
            try {
                const ImpactResult result = solve_alone(impact_at(batch, task.inputs, i));
                if (!end_known) take_end(result, task, i);
                if (task.turning_point) take_turn(result, task, i);
            } catch (const ConvergenceError& error) {
                failures.add(task, i, first, error);
            }
            ++solved_alone;
        }
        outcome[i] = task.end[i] == LaneEnd::rebound ? Outcome::rebound : Outcome::capture;
    }
    if (!task.with_contact_time) std::fill_n(task.contact_time, task.count, nothing);
    if (!task.turning_point) {
        std::fill_n(task.approach_time, task.count, nothing);
        std::fill_n(task.maximum_overlap, task.count, nothing);
    }
    return solved_alone;
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
    batch::require_admissible(batch.law, batch.detachment);
    const bool tabulated = options.method == BatchMethod::table;
    batch::RestitutionTable* const table =
        tabulated ? &batch::RestitutionTable::of(batch.law, batch.detachment, batch.damping_law) : nullptr;
    const Eigen::Index count =
        common_size(batch.contact, {{"damping", batch.damping.size()}, {"velocity", batch.velocity.size()}});
    const batch::Inputs inputs = inputs_of(batch);
    resize(result, count);
    batch::FirstFault fault;
    std::atomic<std::int64_t> scalar = 0;
    Failures failures(options.keep_failures);
    const auto chunk = [&](std::size_t first, std::size_t size) {
        const batch::Inputs chunk_inputs = inputs.from(first);
        if (!fault.check(chunk_inputs, first, size)) return;
        std::array<LaneEnd, batch::most_impacts> end;  // the kernel fills what is used
        const ImpactTask task{.damping_law = batch.damping_law,
                              .detachment = batch.detachment,
                              .with_contact_time = options.contact_time || options.turning_point,
                              .turning_point = options.turning_point,
                              .table = table,
                              .count = size,
                              .inputs = chunk_inputs,
                              .end = end.data(),
                              .restitution = result.restitution.data() + first,
                              .contact_time = result.contact_time.data() + first,
                              .approach_time = result.approach_time.data() + first,
                              .maximum_overlap = result.maximum_overlap.data() + first};
        scalar += solve(batch, task, first, result.outcome.data() + first, failures);
    };
    batch::for_chunks(static_cast<std::size_t>(count), batch::most_impacts, options.threads, chunk);
    result.scalar = scalar;
    result.failed = std::move(failures).in_order();
    fault.raise([&](std::size_t i) { validate(impact_at(batch, inputs, i)); });
}

ImpactBatchResult solve_impacts(const ImpactBatch& batch, const BatchOptions& options) {
    ImpactBatchResult result;
    solve_impacts(batch, result, options);
    return result;
}

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/batch/inversion_batch.hpp"

#include <array>
#include <limits>
#include <string>

#include "core/error.hpp"
#include "solver/batch/admissibility.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/batch/task.hpp"
#include "solver/surrogate/batch/restitution_table.hpp"

namespace ashimpact {

namespace {

constexpr double out_of_reach = std::numeric_limits<double>::quiet_NaN();
constexpr double no_damping_yet = 1.0;

/// What a kernel fills for one chunk.
struct SearchResults {
    std::array<double, batch::most_impacts> unit;
    std::array<double, batch::most_impacts> number;
    std::array<double, batch::most_impacts> undamped;
    std::array<std::uint8_t, batch::most_impacts> found;
};

DampingProblem problem_at(const DampingBatch& batch, const batch::Inputs& in, std::size_t i) {
    return {batch.law,         batch.detachment,    batch.damping_law, batch::pair_at(in, i),
            in.velocity.at(i), in.restitution.at(i)};
}

/// One impact through the scalar solver.
void invert_alone(const DampingProblem& problem, double& damping, double& greatest) {
    try {
        const DampingInversion inversion = damping_from_restitution(problem);
        damping = inversion.damping.coefficient;
        greatest = inversion.greatest_restitution;
    } catch (const InputError&) {  // the inputs have been checked, so no damping gives this restitution
        damping = out_of_reach;
        greatest = solve_impact({problem.law,
                                 problem.detachment,
                                 {problem.damping_law, 0.0},
                                 problem.contact,
                                 problem.velocity})
                       .restitution;
    }
}

/// Inverts one chunk. @return how many impacts were left to the scalar solver
std::int64_t invert(const DampingBatch& batch, batch::RestitutionTable* table, const batch::Inputs& inputs,
                    std::size_t count, double* damping, double* greatest) {
    SearchResults searched;
    const batch::InversionTask task{.damping_law = batch.damping_law,
                                    .detachment = batch.detachment,
                                    .table = table,
                                    .count = count,
                                    .inputs = inputs,
                                    .number_unit = searched.unit.data(),
                                    .number = searched.number.data(),
                                    .undamped = searched.undamped.data(),
                                    .found = searched.found.data()};
    batch::kernels_of(batch.law).inversions(task);
    std::int64_t solved_alone = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double wanted = inputs.restitution.at(i);
        if (searched.found[i] != 0 && wanted > 0.0 && wanted < searched.undamped[i]) {
            damping[i] = searched.number[i] * searched.unit[i];
            greatest[i] = searched.undamped[i];
            continue;
        }
        invert_alone(problem_at(batch, inputs, i), damping[i], greatest[i]);
        ++solved_alone;
    }
    return solved_alone;
}

}  // namespace

DampingBatchResult dampings_from_restitutions(const DampingBatch& batch, int threads, BatchMethod method) {
    batch::require_admissible(batch.law, batch.detachment);
    const Eigen::Index count = common_size(
        batch.contact, {{"velocity", batch.velocity.size()}, {"restitution", batch.restitution.size()}});
    batch::Inputs inputs = batch::inputs_of(batch.law, batch.contact);
    inputs.damping = {&no_damping_yet, true};
    inputs.velocity = batch::input_of(batch.velocity);
    inputs.restitution = batch::input_of(batch.restitution);
    batch::RestitutionTable* const table =
        method == BatchMethod::table
            ? &batch::RestitutionTable::of(batch.law, batch.detachment, batch.damping_law)
            : nullptr;
    DampingBatchResult result;
    result.damping.resize(count);
    result.greatest_restitution.resize(count);
    batch::FirstFault fault;
    std::atomic<std::int64_t> scalar = 0;
    const auto chunk = [&](std::size_t first, std::size_t size) {
        const batch::Inputs chunk_inputs = inputs.from(first);
        if (!fault.check(chunk_inputs, first, size)) return;
        scalar += invert(batch, table, chunk_inputs, size, result.damping.data() + first,
                         result.greatest_restitution.data() + first);
    };
    batch::for_chunks(static_cast<std::size_t>(count), batch::most_impacts, threads, chunk);
    result.scalar = scalar;
    fault.raise([&](std::size_t i) {
        const DampingProblem problem = problem_at(batch, inputs, i);
        validate(Impact{
            problem.law, problem.detachment, {problem.damping_law, 0.0}, problem.contact, problem.velocity});
        throw InputError("restitution is " + std::to_string(problem.restitution), "0 <= e < 1");
    });
    return result;
}

}  // namespace ashimpact

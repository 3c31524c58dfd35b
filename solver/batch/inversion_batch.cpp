// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/batch/inversion_batch.hpp"

#include <array>
#include <limits>

#include "core/text/error.hpp"
#include "solver/batch/problems.hpp"

namespace ashimpact {

namespace {

constexpr double out_of_reach = std::numeric_limits<double>::quiet_NaN();

/// What a kernel fills for one chunk.
struct SearchResults {
    std::array<double, batch::most_impacts> unit;
    std::array<double, batch::most_impacts> number;
    std::array<double, batch::most_impacts> undamped;
    std::array<std::uint8_t, batch::most_impacts> found;
};

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
std::int64_t invert(const batch::Problems& chunk, batch::RestitutionTable* table, double* damping,
                    double* greatest) {
    SearchResults searched;
    batch::kernels_of(chunk.law).inversions({.damping_law = chunk.damping_law,
                                             .detachment = chunk.detachment,
                                             .table = table,
                                             .count = chunk.count,
                                             .inputs = chunk.inputs,
                                             .number_unit = searched.unit.data(),
                                             .number = searched.number.data(),
                                             .undamped = searched.undamped.data(),
                                             .found = searched.found.data()});
    std::int64_t solved_alone = 0;
    for (std::size_t i = 0; i < chunk.count; ++i) {
        const double wanted = chunk.inputs.restitution.at(i);
        if (searched.found[i] != 0 && wanted > 0.0 && wanted < searched.undamped[i]) {
            damping[i] = searched.number[i] * searched.unit[i];
            greatest[i] = searched.undamped[i];
            continue;
        }
        invert_alone({chunk.law, chunk.detachment, chunk.damping_law, chunk.contact(i),
                      chunk.inputs.velocity.at(i), wanted},
                     damping[i], greatest[i]);
        ++solved_alone;
    }
    return solved_alone;
}

}  // namespace

DampingBatchResult dampings_from_restitutions(const DampingBatch& batch, int threads, BatchMethod method) {
    const batch::Problems problems =
        batch::problems_of(batch.law, batch.detachment, batch.damping_law, batch.contact,
                           {{"velocity", batch.velocity, &batch::Inputs::velocity},
                            {"restitution", batch.restitution, &batch::Inputs::restitution}});
    batch::RestitutionTable* const table = batch::table_for(method, problems);
    DampingBatchResult result;
    result.damping.resize(problems.size());
    result.greatest_restitution.resize(problems.size());
    result.scalar =
        batch::solve_in_chunks(problems, threads, [&](const batch::Problems& chunk, std::size_t first) {
            return invert(chunk, table, result.damping.data() + first,
                          result.greatest_restitution.data() + first);
        });
    return result;
}

}  // namespace ashimpact

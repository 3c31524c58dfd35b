// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/batch/critical_batch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "solver/batch/problems.hpp"
#include "solver/batch/tables/critical_table.hpp"
#include "solver/motion/scale.hpp"
#include "solver/motion/velocity_scales.hpp"

namespace ashimpact {

namespace {

using batch::PieceState;
using Answer = std::optional<CriticalVelocity>;

/// Reads problems from the table of their law; undecided where it has none.
void look_up(const batch::Problems& problems, PieceState* state, double* value) {
    const auto& [law, detachment, damping_law, count, inputs] = problems;
    const bool tabulated =
        law.is_adhesive() && detachment != Detachment::zero_force && batch::has_kernels(law);
    if (!tabulated) {
        std::fill_n(state, count, PieceState::undecided);
        return;
    }
    batch::kernels_of(law).critical_velocities(
        {.damping_law = damping_law,
         .table = &batch::CriticalTable::of(law, detachment, damping_law),
         .count = count,
         .inputs = inputs,
         .state = state,
         .value = value});
}

/// The answer of the table, if it has one that is possible.
Answer read(PieceState state, double value) {
    if (state == PieceState::captured) return CriticalVelocity{.verdict = CaptureVerdict::always_captured};
    if (state == PieceState::tabulated && value > 0.0 && std::isfinite(value))
        return CriticalVelocity{.value = value};
    return std::nullopt;
}

/// The answer that needs neither a table nor an integration, if there is one.
Answer closed_form(const CriticalVelocityProblem& problem) {
    const auto& [law, detachment, damping, contact] = problem;
    if (!is_self_similar(law, contact)) return std::nullopt;
    if (detachment == Detachment::zero_force)
        return CriticalVelocity{.verdict = CaptureVerdict::never_captured};
    if (law.is_adhesive() || damping.coefficient == 0.0) return std::nullopt;
    if (const auto verdict = verdict_without_adhesion(damping, contact))
        return CriticalVelocity{.verdict = *verdict};
    return CriticalVelocity{.value = hertz_critical_constant * velocity_of_damping(damping, contact)};
}

}  // namespace

std::optional<CriticalVelocity> critical_velocity_without_integration(
    const CriticalVelocityProblem& problem) {
    if (const Answer answer = closed_form(problem)) return answer;
    const auto& [law, detachment, damping, contact] = problem;
    batch::Inputs inputs = batch::inputs_of(law, contact);
    inputs.damping = {&damping.coefficient, true};
    PieceState state = PieceState::undecided;
    double value = 0.0;
    look_up({law, detachment, damping.law, 1, inputs}, &state, &value);
    return read(state, value);
}

CriticalVelocity tabulated_critical_velocity(const CriticalVelocityProblem& problem) {
    validate(Impact{problem.law, problem.detachment, problem.damping, problem.contact, 1.0});
    const auto known = critical_velocity_without_integration(problem);
    return known ? *known : critical_velocity(problem);
}

CriticalVelocityBatchResult critical_velocities(const CriticalVelocityBatch& batch, int threads) {
    const batch::Problems problems =
        batch::problems_of(batch.law, batch.detachment, batch.damping_law, batch.contact,
                           {{"damping", batch.damping, &batch::Inputs::damping}});
    CriticalVelocityBatchResult result;
    result.verdict.resize(problems.size());
    result.value.resize(problems.size());
    const auto solve = [&](const batch::Problems& chunk, std::size_t first) {
        std::array<PieceState, batch::most_impacts> state;  // look_up() fills what is used
        CaptureVerdict* const verdict = result.verdict.data() + first;
        double* const value = result.value.data() + first;
        look_up(chunk, state.data(), value);
        std::int64_t integrated = 0;
        for (std::size_t i = 0; i < chunk.count; ++i) {
            Answer answer = read(state[i], value[i]);
            if (!answer) {
                const CriticalVelocityProblem problem{batch.law, batch.detachment, chunk.damping(i),
                                                      chunk.contact(i)};
                answer = closed_form(problem);
                if (!answer) {
                    answer = critical_velocity(problem);
                    ++integrated;
                }
            }
            verdict[i] = answer->verdict;
            value[i] = answer->value.value_or(std::numeric_limits<double>::quiet_NaN());
        }
        return integrated;
    };
    result.scalar = batch::solve_in_chunks(problems, threads, solve);
    return result;
}

}  // namespace ashimpact

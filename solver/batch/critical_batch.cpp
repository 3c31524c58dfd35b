// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/batch/critical_batch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "core/error.hpp"
#include "solver/batch/admissibility.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/batch/task.hpp"
#include "solver/motion/scale.hpp"
#include "solver/motion/velocity_scales.hpp"
#include "solver/surrogate/batch/critical_table.hpp"

namespace ashimpact {

namespace {

using batch::TableVerdict;
using Answer = std::optional<KnownCriticalVelocity>;

/// Reads a chunk of problems from the table of their law; undecided where it has none.
void look_up(const CriticalVelocityProblem& of_all, const batch::Inputs& inputs, std::size_t count,
             TableVerdict* verdict, double* value) {
    const bool tabulated = of_all.law.is_adhesive() && of_all.detachment != Detachment::zero_force &&
                           batch::has_kernels(of_all.law);
    if (!tabulated) {
        std::fill_n(verdict, count, TableVerdict::undecided);
        return;
    }
    batch::kernels_of(of_all.law)
        .critical_velocities(
            {.damping_law = of_all.damping.law,
             .table = &batch::CriticalTable::of(of_all.law, of_all.detachment, of_all.damping.law),
             .count = count,
             .inputs = inputs,
             .verdict = verdict,
             .value = value});
}

/// The answer of the table, if it has one that is possible.
Answer read(TableVerdict verdict, double value) {
    if (verdict == TableVerdict::always_captured)
        return KnownCriticalVelocity{.verdict = CaptureVerdict::always_captured};
    if (verdict == TableVerdict::finite && value > 0.0 && std::isfinite(value))
        return KnownCriticalVelocity{.value = value};
    return std::nullopt;
}

/// The answer that needs neither a table nor an integration, if there is one.
Answer closed_form(const CriticalVelocityProblem& problem) {
    const auto& [law, detachment, damping, contact] = problem;
    if (!is_self_similar(law, contact)) return std::nullopt;
    if (detachment == Detachment::zero_force)
        return KnownCriticalVelocity{.verdict = CaptureVerdict::never_captured};
    if (law.is_adhesive() || damping.coefficient == 0.0) return std::nullopt;
    if (const auto verdict = verdict_without_adhesion(damping, contact))
        return KnownCriticalVelocity{.verdict = *verdict};
    return KnownCriticalVelocity{.value = hertz_critical_constant * velocity_of_damping(damping, contact)};
}

}  // namespace

std::optional<KnownCriticalVelocity> critical_velocity_without_integration(
    const CriticalVelocityProblem& problem) {
    if (const Answer answer = closed_form(problem)) return answer;
    batch::Inputs inputs = batch::inputs_of(problem.law, problem.contact);
    inputs.damping = {&problem.damping.coefficient, true};
    TableVerdict verdict = TableVerdict::undecided;
    double value = 0.0;
    look_up(problem, inputs, 1, &verdict, &value);
    return read(verdict, value);
}

CriticalVelocity tabulated_critical_velocity(const CriticalVelocityProblem& problem) {
    validate(Impact{problem.law, problem.detachment, problem.damping, problem.contact, 1.0});
    if (const auto known = critical_velocity_without_integration(problem))
        return {.verdict = known->verdict, .value = known->value};
    return critical_velocity(problem);
}

CriticalVelocityBatchResult critical_velocities(const CriticalVelocityBatch& batch, int threads) {
    batch::require_admissible(batch.law, batch.detachment);
    const Eigen::Index count = common_size(batch.contact, {{"damping", batch.damping.size()}});
    batch::Inputs inputs = batch::inputs_of(batch.law, batch.contact);
    inputs.damping = batch::input_of(batch.damping);
    CriticalVelocityBatchResult result;
    result.verdict.resize(count);
    result.value.resize(count);
    batch::FirstFault fault;
    std::atomic<std::int64_t> scalar = 0;
    const auto chunk = [&](std::size_t first, std::size_t size) {
        const batch::Inputs chunk_inputs = inputs.from(first);
        if (!fault.check(chunk_inputs, first, size)) return;
        std::int64_t integrated = 0;
        CriticalVelocityProblem problem{batch.law, batch.detachment, {.law = batch.damping_law}, {}};
        std::array<TableVerdict, batch::most_impacts> verdict;  // look_up() fills what is used
        double* const value = result.value.data() + first;
        look_up(problem, chunk_inputs, size, verdict.data(), value);
        for (std::size_t i = 0; i < size; ++i) {
            Answer answer = read(verdict[i], value[i]);
            if (!answer) {
                problem.damping.coefficient = chunk_inputs.damping.at(i);
                batch::set_pair(problem.contact, chunk_inputs, i);
                answer = closed_form(problem);
            }
            if (!answer) {
                const CriticalVelocity critical = critical_velocity(problem);
                answer = KnownCriticalVelocity{.verdict = critical.verdict, .value = critical.value};
                ++integrated;
            }
            result.verdict[static_cast<Eigen::Index>(first + i)] = answer->verdict;
            value[i] = answer->value.value_or(std::numeric_limits<double>::quiet_NaN());
        }
        scalar += integrated;
    };
    batch::for_chunks(static_cast<std::size_t>(count), batch::most_impacts, threads, chunk);
    result.scalar = scalar;
    fault.raise([&](std::size_t i) {
        validate(Impact{batch.law,
                        batch.detachment,
                        {batch.damping_law, inputs.damping.at(i)},
                        batch::pair_at(inputs, i),
                        1.0});
    });
    return result;
}

}  // namespace ashimpact

#include "solver/batch/critical_batch.hpp"

#include "materials/base/error.hpp"
#include "solver/batch/admissibility.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/batch/tables/critical_table.hpp"
#include "solver/batch/task.hpp"
#include "solver/motion/scale.hpp"
#include "solver/motion/scaled_impact.hpp"
#include "solver/motion/velocity_scales.hpp"

#include <cmath>
#include <limits>
#include <string>

namespace ashimpact {

namespace {

constexpr std::size_t chunk_size = 2048;

Damping damping_at(const CriticalVelocityBatch& batch, const batch::Inputs& in, std::size_t i) {
    return {batch.damping_law, in.damping.at(i)};
}

}  // namespace

std::optional<KnownCriticalVelocity> critical_velocity_without_integration(
    const CriticalVelocityProblem& problem) {
    using Answer = KnownCriticalVelocity;
    const auto& [law, detachment, damping, contact] = problem;
    if (!is_self_similar(law, contact)) return std::nullopt;
    if (detachment == Detachment::zero_force) return Answer{.verdict = CaptureVerdict::never_captured};
    if (damping.coefficient == 0.0) return std::nullopt;
    const double adhesion = velocity_of_adhesion(law, contact);
    if (adhesion > 0.0) {
        batch::CriticalTable& table = batch::CriticalTable::of(law, detachment, damping.law);
        const auto entry = table.at(Scale::of(contact, adhesion).damping_number(damping));
        if (!entry) return std::nullopt;
        if (entry->verdict != CaptureVerdict::finite) return Answer{.verdict = entry->verdict};
        return Answer{.value = entry->value * adhesion};
    }
    if (law != Law::of<Hertz>()) return std::nullopt;
    if (const auto verdict = verdict_without_adhesion(damping)) return Answer{.verdict = *verdict};
    return Answer{.value = hertz_critical_constant * velocity_of_damping(damping, contact)};
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
        if (!fault.check(inputs.from(first), first, size)) return;
        std::int64_t integrated = 0;
        CriticalVelocityProblem problem{batch.law, batch.detachment, {.law = batch.damping_law}, {}};
        for (std::size_t i = first; i < first + size; ++i) {
            problem.damping.coefficient = inputs.damping.at(i);
            batch::set_pair(problem.contact, inputs, i);
            auto answer = critical_velocity_without_integration(problem);
            if (!answer) {
                const CriticalVelocity critical = critical_velocity(problem);
                answer = {.verdict = critical.verdict, .value = critical.value};
                ++integrated;
            }
            const auto place = static_cast<Eigen::Index>(i);
            result.verdict[place] = answer->verdict;
            result.value[place] = answer->value.value_or(std::numeric_limits<double>::quiet_NaN());
        }
        scalar += integrated;
    };
    batch::for_chunks(static_cast<std::size_t>(count), chunk_size, threads, chunk);
    result.scalar = scalar;
    fault.raise([&](std::size_t i) {
        validate(Impact{batch.law, batch.detachment, damping_at(batch, inputs, i), batch::pair_at(inputs, i),
                        1.0});
    });
    return result;
}

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/batch/impact_batch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <string>

#include "core/text/error.hpp"
#include "solver/batch/problems.hpp"
#include "solver/contact/dmt.hpp"
#include "solver/contact/law.hpp"
#include "solver/motion/scale.hpp"

namespace ashimpact {

namespace {

using batch::ImpactTask;
using batch::is_possible_end;
using batch::LaneEnd;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

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
    const double length = Scale::of(impact.contact, impact.velocity).length;
    const double adhesion = Dmt<double>::adhesion_number(impact.contact, length);
    try {
        if (adhesion > least_adhesion && adhesion < most_adhesion)
            return solve_impact(impact, Precision::standard);
    } catch (const ConvergenceError&) {  // it may in extended precision
    }
    return solve_impact(impact);
}

/// Solves a task. Impacts that its kernel left undecided or gave an impossible result go through the scalar
/// solver. @return how many those were
std::int64_t solve(const batch::Problems& chunk, const ImpactTask& task, std::size_t first,
                   Failures& failures) {
    batch::kernels_of(chunk.law).impacts(task);
    std::int64_t solved_alone = 0;
    for (std::size_t i = 0; i < task.count; ++i) {
        const bool end_known = is_possible_end(task, i);
        const bool turn_known = !task.turning_point || (end_known && is_possible_turn(task, i));
        if (end_known && turn_known) continue;
        try {
            const ImpactResult result = solve_alone(chunk.impact(i));
            if (!end_known) take_end(result, task, i);
            if (task.turning_point) take_turn(result, task, i);
        } catch (const ConvergenceError& error) {
            failures.add(task, i, first, error);
        }
        ++solved_alone;
    }
    return solved_alone;
}

/// Columns for results of a task that the caller does not take: its kernel writes all of them.
struct Unwanted {
    using Numbers = std::array<double, batch::most_impacts>;  // filled by the kernel
    Numbers restitution;
    Numbers contact_time;
    Numbers approach_time;
    Numbers maximum_overlap;
};

/// The columns of @p outputs from impact @p first on.
BatchOutputs from(const BatchOutputs& outputs, std::size_t first) {
    const auto part = [&](auto* column) { return column == nullptr ? nullptr : column + first; };
    return {part(outputs.outcome), part(outputs.restitution), part(outputs.contact_time),
            part(outputs.approach_time), part(outputs.maximum_overlap)};
}

/// Writes what follows from a solved task: outcomes, and that there is nothing where nothing was computed.
void complete(const ImpactTask& task, const BatchOutputs& out) {
    if (out.outcome != nullptr)
        std::transform(task.end, task.end + task.count, out.outcome, [](LaneEnd end) {
            return end == LaneEnd::rebound ? Outcome::rebound : Outcome::capture;
        });
    const auto leave_out = [&](double* column) {
        if (column != nullptr) std::fill_n(column, task.count, nothing);
    };
    if (!task.with_contact_time) leave_out(out.contact_time);
    if (task.turning_point) return;
    leave_out(out.approach_time);
    leave_out(out.maximum_overlap);
}

batch::Problems problems_of(const ImpactBatch& batch) {
    return batch::problems_of(batch.law, batch.detachment, batch.damping_law, batch.contact,
                              {{"damping", batch.damping, &batch::Inputs::damping},
                               {"velocity", batch.velocity, &batch::Inputs::velocity}});
}

BatchReport solve_problems(const batch::Problems& problems, const BatchOutputs& outputs,
                           const BatchOptions& options) {
    batch::RestitutionTable* const table = batch::table_for(options.method, problems);
    Failures failures(options.keep_failures);
    const auto solve_chunk = [&](const batch::Problems& chunk, std::size_t first) {
        std::array<LaneEnd, batch::most_impacts> end;  // the kernel fills what is used
        Unwanted unwanted;
        const BatchOutputs out = from(outputs, first);
        const auto column = [](double* wanted, Unwanted::Numbers& other) {
            return wanted != nullptr ? wanted : other.data();
        };
        const ImpactTask task{.damping_law = chunk.damping_law,
                              .detachment = chunk.detachment,
                              .with_contact_time = options.contact_time || options.turning_point,
                              .turning_point = options.turning_point,
                              .table = table,
                              .count = chunk.count,
                              .inputs = chunk.inputs,
                              .end = end.data(),
                              .restitution = column(out.restitution, unwanted.restitution),
                              .contact_time = column(out.contact_time, unwanted.contact_time),
                              .approach_time = column(out.approach_time, unwanted.approach_time),
                              .maximum_overlap = column(out.maximum_overlap, unwanted.maximum_overlap)};
        const std::int64_t scalar = solve(chunk, task, first, failures);
        complete(task, out);
        return scalar;
    };
    const std::int64_t scalar = batch::solve_in_chunks(problems, options.threads, solve_chunk);
    return {std::move(failures).in_order(), scalar};
}

}  // namespace

BatchReport solve_impacts(const ImpactBatch& batch, const BatchOutputs& outputs,
                          const BatchOptions& options) {
    return solve_problems(problems_of(batch), outputs, options);
}

void solve_impacts(const ImpactBatch& batch, ImpactBatchResult& result, const BatchOptions& options) {
    const batch::Problems problems = problems_of(batch);
    result.outcome.resize(problems.size());
    for (Eigen::ArrayXd* column :
         {&result.restitution, &result.contact_time, &result.approach_time, &result.maximum_overlap}) {
        column->resize(problems.size());
    }
    BatchReport report = solve_problems(problems,
                                        {.outcome = result.outcome.data(),
                                         .restitution = result.restitution.data(),
                                         .contact_time = result.contact_time.data(),
                                         .approach_time = result.approach_time.data(),
                                         .maximum_overlap = result.maximum_overlap.data()},
                                        options);
    result.failed = std::move(report.failed);
    result.scalar = report.scalar;
}

ImpactBatchResult solve_impacts(const ImpactBatch& batch, const BatchOptions& options) {
    ImpactBatchResult result;
    solve_impacts(batch, result, options);
    return result;
}

ImpactList::ImpactList(const std::vector<Impact>& impacts) : first_(impacts.at(0)) {
    const auto size = static_cast<Eigen::Index>(impacts.size());
    for (Eigen::ArrayXd* column :
         {&mass_, &radius_, &modulus_, &adhesion_, &pressure_, &damping_, &velocity_})
        column->resize(size);
    for (Eigen::Index i = 0; i < size; ++i) {
        const auto& [law, detachment, damping, contact, velocity] = impacts[static_cast<std::size_t>(i)];
        mass_[i] = contact.mass;
        radius_[i] = contact.effective_radius;
        modulus_[i] = contact.contact_modulus;
        adhesion_[i] = contact.work_of_adhesion;
        pressure_[i] = contact.yield_pressure;
        damping_[i] = damping.coefficient;
        velocity_[i] = velocity;
    }
}

ImpactBatch ImpactList::batch() const {
    return {.law = first_.law,
            .detachment = first_.detachment,
            .damping_law = first_.damping.law,
            .contact = {.mass = mass_,
                        .effective_radius = radius_,
                        .contact_modulus = modulus_,
                        .work_of_adhesion = adhesion_,
                        .yield_pressure = pressure_,
                        .parameters = single_columns(first_.contact.parameters)},
            .damping = damping_,
            .velocity = velocity_};
}

}  // namespace ashimpact

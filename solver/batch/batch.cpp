// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/batch/batch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>

#include "core/text/error.hpp"
#include "solver/batch/problems.hpp"
#include "solver/batch/tables/law_tables.hpp"
#include "solver/batch/tables/yield_velocities.hpp"
#include "solver/batch/tables/zone_velocities.hpp"
#include "solver/contact/dmt.hpp"
#include "solver/motion/branches/cohesive_motion.hpp"
#include "solver/motion/regime.hpp"
#include "solver/motion/scale.hpp"
#include "solver/motion/scaled_impact.hpp"

namespace ashimpact {

namespace {

using batch::ImpactTask;
using batch::Inputs;
using batch::is_possible_end;
using batch::LaneEnd;
using batch::most_impacts;
using batch::PieceState;
using batch::Problems;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

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

/// Solves impacts in chunks, on several threads, into the caller's columns.
class ImpactSolver {
  public:
    ImpactSolver(const Problems& problems, const BatchOutputs& outputs, const BatchOptions& options)
        : problems_(problems),
          outputs_(outputs),
          options_(options),
          table_(batch::table_for(options.method, problems)) {}

    [[nodiscard]] BatchReport solve() && {
        report_.count = problems_.count;
        report_.scalar = batch::solve_in_chunks(
            problems_, options_.threads,
            [&](const Problems& chunk, std::size_t first) { return solve_chunk(chunk, first); });
        std::ranges::sort(report_.failed, {}, &FailedImpact::place);
        return std::move(report_);
    }

  private:
    /// Columns for results that the caller does not take: the kernel writes all of them.
    using Unwanted = std::array<double, most_impacts>;

    /// @return how many impacts went through the scalar solver
    std::int64_t solve_chunk(const Problems& chunk, std::size_t first) {
        std::array<LaneEnd, most_impacts> end;  // the kernel fills what is used
        std::array<Unwanted, 4> unwanted;
        const auto column = [&](double* wanted, std::size_t k) {
            return wanted != nullptr ? wanted + first : unwanted[k].data();
        };
        const ImpactTask task{.damping_law = chunk.damping_law,
                              .detachment = chunk.detachment,
                              .with_contact_time = options_.contact_time || options_.turning_point,
                              .turning_point = options_.turning_point,
                              .table = table_,
                              .count = chunk.count,
                              .inputs = chunk.inputs,
                              .end = end.data(),
                              .restitution = column(outputs_.restitution, 0),
                              .contact_time = column(outputs_.contact_time, 1),
                              .approach_time = column(outputs_.approach_time, 2),
                              .maximum_overlap = column(outputs_.maximum_overlap, 3)};
        batch::kernels_of(chunk.law, chunk.damping_law).impacts(task);
        const std::int64_t scalar = solve_the_undecided(chunk, task, first);
        if (outputs_.outcome != nullptr)
            std::transform(task.end, task.end + task.count, outputs_.outcome + first, [](LaneEnd how) {
                return how == LaneEnd::rebound ? Outcome::rebound : Outcome::capture;
            });
        const auto leave_out = [&](double* wanted) {
            if (wanted != nullptr) std::fill_n(wanted + first, task.count, nothing);
        };
        if (!task.with_contact_time) leave_out(outputs_.contact_time);
        if (task.turning_point) return scalar;
        leave_out(outputs_.approach_time);
        leave_out(outputs_.maximum_overlap);
        return scalar;
    }

    /// Impacts that the kernel left undecided, or gave an impossible result, by the scalar solver.
    std::int64_t solve_the_undecided(const Problems& chunk, const ImpactTask& task, std::size_t first) {
        std::int64_t solved_alone = 0;
        for (std::size_t i = 0; i < task.count; ++i) {
            const bool end_known = is_possible_end(task, i);
            if (end_known && (!task.turning_point || is_possible_turn(task, i))) continue;
            ++solved_alone;
            try {
                const Impact impact = chunk.impact(i);
                // Where kernels leave a creeping turn in doubt, so does double precision.
                const bool doubtful_turn = is_cohesive(impact.law, impact.contact) &&
                                           batch::has_kernels(impact.law, impact.damping.law);
                ImpactResult result{};
                if (!end_known || !doubtful_turn) result = solve_alone(impact);
                if (!end_known) {
                    task.end[i] = result.outcome == Outcome::rebound ? LaneEnd::rebound : LaneEnd::capture;
                    task.restitution[i] = result.restitution;
                    task.contact_time[i] = result.contact_time.value_or(nothing);
                }
                // A turn that is known keeps its bits, however the end came to be known.
                if (!task.turning_point || is_possible_turn(task, i)) continue;
                if (doubtful_turn) result = solve_impact(impact);
                task.approach_time[i] = result.approach_time.value_or(nothing);
                task.maximum_overlap[i] = result.maximum_overlap;
            } catch (const ConvergenceError& error) {
                if (!options_.keep_failures)
                    throw ConvergenceError("impact " + std::to_string(first + i) + ": " + error.what());
                task.end[i] = LaneEnd::capture;
                for (double* column :
                     {task.restitution, task.contact_time, task.approach_time, task.maximum_overlap})
                    column[i] = nothing;
                const std::lock_guard lock(mutex_);
                report_.failed.push_back({static_cast<std::int64_t>(first + i), error.what()});
            }
        }
        return solved_alone;
    }

    const Problems& problems_;
    const BatchOutputs& outputs_;
    const BatchOptions& options_;
    batch::RestitutionTable* table_;
    std::mutex mutex_;  ///< of the report
    BatchReport report_;
};

Problems problems_of(const ImpactBatch& batch) {
    return batch::problems_of(batch.law, batch.detachment, batch.damping_law, batch.contact,
                              {{&Inputs::damping, batch.damping}, {&Inputs::velocity, batch.velocity}});
}

/// What a kernel fills for one chunk.
struct SearchResults {
    std::array<double, most_impacts> unit;
    std::array<double, most_impacts> number;
    std::array<double, most_impacts> undamped;
    std::array<std::uint8_t, most_impacts> found;
};

/// One impact through the scalar solver.
void invert_alone(const DampingProblem& problem, double& damping, double& greatest) {
    try {
        const DampingInversion inversion = damping_from_restitution(problem);
        damping = inversion.damping.coefficient;
        greatest = inversion.greatest_restitution;
    } catch (const InputError&) {  // the inputs have been checked, so no damping gives this restitution
        const auto& [law, detachment, damping_law, contact, velocity, restitution] = problem;
        damping = nothing;
        greatest = undamped_restitution({law, detachment, {damping_law, 0.0}, contact, velocity});
    }
}

/// Inverts one chunk. @return how many impacts were left to the scalar solver
std::int64_t invert(const Problems& chunk, batch::RestitutionTable* table, double* damping,
                    double* greatest) {
    SearchResults searched;
    batch::kernels_of(chunk.law, chunk.damping_law)
        .inversions({.damping_law = chunk.damping_law,
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

using Answer = std::optional<CriticalVelocity>;

/// Reads problems with a cohesive zone from the tables of its spans; undecided beyond them.
void look_up_zones(const Problems& problems, PieceState* state, double* value) {
    auto& tables = batch::ZoneVelocities::of(problems.detachment, problems.damping_law);
    batch::find_transition_parameters(problems.inputs, problems.count, value);
    for (std::size_t i = 0; i < problems.count; ++i) {
        state[i] = PieceState::undecided;
        if (std::isnan(value[i])) continue;
        const ContactPair contact = problems.contact(i);
        const Scale scale = Scale::of(contact, maugis_velocity(contact));
        const batch::ZoneVelocity found = tables.at(value[i], scale.damping_number(problems.damping(i)));
        state[i] = found.state;
        value[i] = found.value * scale.velocity;
    }
}

/// Reads problems from the table of their law; undecided where it has none.
void look_up(const Problems& problems, PieceState* state, double* value) {
    const auto& [law, detachment, damping_law, count, inputs] = problems;
    if (law.is_plastic() && batch::has_kernels(law, damping_law)) {
        batch::find_yield_velocities(problems, state, value);
        return;
    }
    const bool scales = law.self_similar() || law.has_cohesive_zone();
    if (!scales || !law.is_adhesive() || !has_tables(law, damping_law) ||
        detachment == Detachment::zero_force) {
        std::fill_n(state, count, PieceState::undecided);
        return;
    }
    if (law.has_cohesive_zone()) {
        look_up_zones(problems, state, value);
        return;
    }
    batch::kernels_of(law, damping_law)
        .critical_velocities({.damping_law = damping_law,
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

/// The answer of the table of one problem, if there is one.
Answer from_table(const CriticalVelocityProblem& problem) {
    const auto& [law, detachment, damping, contact] = problem;
    if (!has_tables(law, damping.law) || law.is_plastic()) return std::nullopt;
    Inputs inputs = batch::inputs_of(law, damping.law, contact);
    inputs.damping = {&damping.coefficient, 1};
    PieceState state = PieceState::undecided;
    double value = 0.0;
    look_up({law, detachment, damping.law, 1, inputs}, &state, &value);
    return read(state, value);
}

/// The answer that needs neither a table nor an integration, if there is one.
Answer closed_form(const CriticalVelocityProblem& problem) {
    const auto& [law, detachment, damping, contact] = problem;
    if (!is_self_similar(law, contact) || !has_one_number(damping.law)) return std::nullopt;
    if (detachment == Detachment::zero_force)
        return CriticalVelocity{.verdict = CaptureVerdict::never_captured};
    if (law.is_adhesive() || damping.coefficient == 0.0) return std::nullopt;
    if (const auto verdict = verdict_without_adhesion(damping, contact))
        return CriticalVelocity{.verdict = *verdict};
    return CriticalVelocity{.value = hertz_critical_constant * velocity_of_damping(damping, contact)};
}

}  // namespace

bool has_tables(Law law, DampingLaw damping_law) {
    return batch::has_kernels(law, damping_law);
}

BatchMethod method_of_many(Law law, DampingLaw damping_law, std::uint64_t impacts) {
    constexpr std::uint64_t zone_table_pays = 2'000'000;
    constexpr std::uint64_t yield_table_pays = 500'000;
    const std::uint64_t least = law.has_cohesive_zone() ? zone_table_pays
                                : law.is_plastic()      ? yield_table_pays
                                                        : 0;
    const bool pays = impacts >= least;
    return pays && has_tables(law, damping_law) ? BatchMethod::table : BatchMethod::integration;
}

BatchMethod method_of_many_velocities(Law law, std::uint64_t velocities) {
    constexpr std::uint64_t zone_table_pays = 10'000;
    const bool pays = !law.has_cohesive_zone() || velocities >= zone_table_pays;
    return pays ? BatchMethod::table : BatchMethod::integration;
}

std::vector<ParameterColumn> single_columns(const ParameterValues<double>& values) {
    std::vector<ParameterColumn> columns;
    for (const auto& entry : values)
        columns.push_back({entry.first, Eigen::Map<const Eigen::ArrayXd>(&entry.second, 1)});
    return columns;
}

BatchReport solve_impacts(const ImpactBatch& batch, const BatchOutputs& outputs,
                          const BatchOptions& options) {
    return ImpactSolver(problems_of(batch), outputs, options).solve();
}

void solve_impacts(const ImpactBatch& batch, ImpactBatchResult& result, const BatchOptions& options) {
    const Problems problems = problems_of(batch);
    result.outcome.resize(problems.size());
    for (Eigen::ArrayXd* column :
         {&result.restitution, &result.contact_time, &result.approach_time, &result.maximum_overlap})
        column->resize(problems.size());
    const BatchOutputs outputs{.outcome = result.outcome.data(),
                               .restitution = result.restitution.data(),
                               .contact_time = result.contact_time.data(),
                               .approach_time = result.approach_time.data(),
                               .maximum_overlap = result.maximum_overlap.data()};
    static_cast<BatchReport&>(result) = ImpactSolver(problems, outputs, options).solve();
}

ImpactBatchResult solve_impacts(const ImpactBatch& batch, const BatchOptions& options) {
    ImpactBatchResult result;
    solve_impacts(batch, result, options);
    return result;
}

ImpactList::ImpactList(const std::vector<Impact>& impacts)
    : first_(impacts.at(0)), columns_(static_cast<Eigen::Index>(impacts.size()), 7) {
    for (Eigen::Index i = 0; i < columns_.rows(); ++i) {
        const auto& [law, detachment, damping, contact, velocity] = impacts[static_cast<std::size_t>(i)];
        columns_.row(i) << contact.mass, contact.effective_radius, contact.contact_modulus,
            contact.work_of_adhesion, contact.yield_pressure, damping.coefficient, velocity;
    }
}

ImpactBatch ImpactList::batch() const {
    return {.law = first_.law,
            .detachment = first_.detachment,
            .damping_law = first_.damping.law,
            .contact = {columns_.col(0), columns_.col(1), columns_.col(2), columns_.col(3), columns_.col(4),
                        single_columns(first_.contact.parameters)},
            .damping = columns_.col(5),
            .velocity = columns_.col(6)};
}

DampingBatchResult dampings_from_restitutions(const DampingBatch& batch, int threads, BatchMethod method) {
    const Problems problems =
        batch::problems_of(batch.law, batch.detachment, batch.damping_law, batch.contact,
                           {{&Inputs::velocity, batch.velocity}, {&Inputs::restitution, batch.restitution}});
    batch::RestitutionTable* const table = batch::table_for(method, problems);
    DampingBatchResult result;
    result.damping.resize(problems.size());
    result.greatest_restitution.resize(problems.size());
    result.scalar = batch::solve_in_chunks(problems, threads, [&](const Problems& chunk, std::size_t first) {
        return invert(chunk, table, result.damping.data() + first,
                      result.greatest_restitution.data() + first);
    });
    return result;
}

std::optional<CriticalVelocity> critical_velocity_without_integration(
    const CriticalVelocityProblem& problem) {
    if (const Answer answer = closed_form(problem)) return answer;
    return problem.law.self_similar() ? from_table(problem) : std::nullopt;
}

CriticalVelocity tabulated_critical_velocity(const CriticalVelocityProblem& problem) {
    validate(Impact{problem.law, problem.detachment, problem.damping, problem.contact, 1.0});
    const auto known = critical_velocity_without_integration(problem);
    return known ? *known : critical_velocity(problem, Precision::standard);
}

CriticalVelocity critical_velocity_of_many(const CriticalVelocityProblem& problem) {
    validate(Impact{problem.law, problem.detachment, problem.damping, problem.contact, 1.0});
    if (const Answer answer = closed_form(problem)) return *answer;
    if (const Answer answer = from_table(problem)) return *answer;
    return critical_velocity(problem);
}

CriticalVelocityBatchResult critical_velocities(const CriticalVelocityBatch& batch, int threads,
                                                BatchMethod method) {
    const Problems problems = batch::problems_of(batch.law, batch.detachment, batch.damping_law,
                                                 batch.contact, {{&Inputs::damping, batch.damping}});
    CriticalVelocityBatchResult result;
    result.verdict.resize(problems.size());
    result.value.resize(problems.size());
    const auto solve = [&](const Problems& chunk, std::size_t first) {
        std::array<PieceState, most_impacts> state;  // look_up() fills what is used
        CaptureVerdict* const verdict = result.verdict.data() + first;
        double* const value = result.value.data() + first;
        if (method == BatchMethod::table)
            look_up(chunk, state.data(), value);
        else
            std::fill_n(state.data(), chunk.count, PieceState::undecided);
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
            value[i] = answer->value.value_or(nothing);
        }
        return integrated;
    };
    result.scalar = batch::solve_in_chunks(problems, threads, solve);
    return result;
}

}  // namespace ashimpact

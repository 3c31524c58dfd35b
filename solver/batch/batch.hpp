// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "solver/batch/columns.hpp"
#include "solver/batch/method.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/motion/damping_inversion.hpp"
#include "solver/motion/impact.hpp"

namespace ashimpact {

struct BatchOptions {
    int threads = 1;            ///< 0: one for each core
    bool turning_point = true;  ///< also compute approach time and greatest overlap, by a step of its own
                                ///< from beside the turn. The other results are the same bits without them
    bool contact_time = true;   ///< also compute contact times, which takes as long again where a table has
                                ///< the impact. The other results are the same bits without them
    BatchMethod method = BatchMethod::integration;
    bool keep_failures = false;  ///< impacts that do not converge are listed; otherwise the first one throws
};

/// An impact of a batch that did not converge.
struct FailedImpact {
    std::int64_t place;  ///< in the batch
    std::string reason;
};

/// Results of a batch that are no columns.
struct BatchReport {
    std::size_t count = 0;               ///< how many impacts: the length of the columns, 1 if all are single
    std::vector<FailedImpact> failed{};  ///< by place; all their numbers are NaN, and they count as captures
    /// How many were left to solve_impact(): too near capture for double precision, or of laws without
    /// kernels.
    std::int64_t scalar = 0;
};

/// Results of the impacts. NaN: the contact time of a capture, the approach time of an impact that never
/// turns, and results that the options leave out.
struct ImpactBatchResult : BatchReport {
    Eigen::Array<Outcome, Eigen::Dynamic, 1> outcome{};
    Eigen::ArrayXd restitution{};      ///< e_n, 0 for a capture [1]
    Eigen::ArrayXd contact_time{};     ///< first touch to detachment [s]
    Eigen::ArrayXd approach_time{};    ///< first touch to greatest overlap [s]
    Eigen::ArrayXd maximum_overlap{};  ///< greatest overlap, or its supremum where it never turns [m]
};

/// Where the columns of ImpactBatchResult go: each as long as the batch; null if it is of no interest.
struct BatchOutputs {
    Outcome* outcome = nullptr;
    double* restitution = nullptr;      ///< [1]
    double* contact_time = nullptr;     ///< [s]
    double* approach_time = nullptr;    ///< [s]
    double* maximum_overlap = nullptr;  ///< [m]
};

/// Solves many impacts, several in each instruction, to |d(e^2)| <= 1e-12 (1 + |U_min|/(m v^2/2)) of
/// solve_impact(); with a cohesive zone to 1e-9 of that.
///
/// No bit of a result depends on the other impacts, on their number or order, or on the number of threads.
/// Instruction sets differ within the bound above.
/// @throws InputError for inadmissible input, naming the first impact it concerns, and for tables of a law
/// that has none; ConvergenceError unless failures are kept
[[nodiscard]] ImpactBatchResult solve_impacts(const ImpactBatch& batch, const BatchOptions& options = {});

/// As above, into an existing result. Columns of the right length are reused without allocation.
void solve_impacts(const ImpactBatch& batch, ImpactBatchResult& result, const BatchOptions& options = {});

/// As above, to columns of the caller: nothing is copied, and a null column is not written.
BatchReport solve_impacts(const ImpactBatch& batch, const BatchOutputs& outputs, const BatchOptions& options);

/// Impacts with measured restitutions whose dampings are sought, of one law, one damping law and one
/// detachment.
struct DampingBatch {
    Law law;
    Detachment detachment;
    DampingLaw damping_law;
    ContactColumns contact;
    Column velocity;     ///< v_in > 0 [m/s]
    Column restitution;  ///< measured e_n, 0 <= e_n < 1 [1]
};

struct DampingBatchResult {
    Eigen::ArrayXd damping{};  ///< coefficient; NaN where no damping gives the restitution [unit of the law]
    Eigen::ArrayXd greatest_restitution{};  ///< reachable without damping [1]
    std::int64_t scalar = 0;                ///< how many were left to damping_from_restitution()
};

/// Dampings from restitutions by the batch solver. A result reproduces its restitution within the batch
/// solver's bound.
/// @param threads 0: one for each core; no bit of a result depends on it
/// @throws InputError for inadmissible input, naming the first impact it concerns
[[nodiscard]] DampingBatchResult dampings_from_restitutions(const DampingBatch& batch, int threads = 1,
                                                            BatchMethod method = BatchMethod::integration);

/// Contacts whose critical velocities are sought, of one law, one damping law and one detachment.
struct CriticalVelocityBatch {
    Law law;
    Detachment detachment;
    DampingLaw damping_law;
    ContactColumns contact;
    Column damping;  ///< coefficient of the damping law [unit of the law]
};

struct CriticalVelocityBatchResult {
    Eigen::Array<CaptureVerdict, Eigen::Dynamic, 1> verdict{};
    Eigen::ArrayXd value{};   ///< v_c; NaN unless the verdict is finite [m/s]
    std::int64_t scalar = 0;  ///< how many were left to critical_velocity(): beyond the tables
};

/// Critical velocities, from tables as tabulated_critical_velocity() gives them; with a cohesive zone or
/// beyond yield to 1e-9.
/// @param threads 0: one for each core; no bit of a result depends on it
/// @param method table: where the law has none, as critical_velocity() gives them
/// @throws InputError for inadmissible input, naming the first place it concerns
[[nodiscard]] CriticalVelocityBatchResult critical_velocities(const CriticalVelocityBatch& batch,
                                                              int threads = 1,
                                                              BatchMethod method = BatchMethod::table);

/// Verdict and v_c [m/s] without the other results of critical_velocity(), in microseconds; relative
/// difference below 1e-10. With adhesion v_c depends on one number, over which batch::CriticalTable tabulates
/// it; Hertz with constant damping has a closed form; everything else goes through critical_velocity().
/// Errors: as critical_velocity().
[[nodiscard]] CriticalVelocity tabulated_critical_velocity(const CriticalVelocityProblem& problem);

/// As above, with law maugis-dugdale from its tables too, to 1e-9. They take a second or two once: for
/// thousands of contacts one after another.
[[nodiscard]] CriticalVelocity critical_velocity_of_many(const CriticalVelocityProblem& problem);

/// As tabulated_critical_velocity(), from the law, a table or a closed form; none if v_c takes an
/// integration. Admissible input only.
[[nodiscard]] std::optional<CriticalVelocity> critical_velocity_without_integration(
    const CriticalVelocityProblem& problem);

}  // namespace ashimpact

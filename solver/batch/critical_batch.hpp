// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include <Eigen/Core>

#include "solver/batch/columns.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"

namespace ashimpact {

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
    std::int64_t scalar = 0;  ///< how many were left to critical_velocity(): beyond the tables, or plastic
};

/// Verdict and v_c [m/s] without the other results of critical_velocity(), in microseconds; relative
/// difference below 1e-10. With adhesion v_c depends on one number, over which batch::CriticalTable tabulates
/// it; Hertz with constant damping has a closed form; everything else goes through critical_velocity().
/// Errors: as critical_velocity().
[[nodiscard]] CriticalVelocity tabulated_critical_velocity(const CriticalVelocityProblem& problem);

/// As above, from the law, a table or a closed form; none if v_c takes an integration. Admissible input only.
[[nodiscard]] std::optional<CriticalVelocity> critical_velocity_without_integration(
    const CriticalVelocityProblem& problem);

/// Critical velocities as tabulated_critical_velocity() gives them.
/// @param threads 0: one for each core; no bit of a result depends on it
/// @throws InputError for inadmissible input, naming the first place it concerns
[[nodiscard]] CriticalVelocityBatchResult critical_velocities(const CriticalVelocityBatch& batch,
                                                              int threads = 1);

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "interface/c/model.hpp"

namespace ashimpact {

/// Problems of one call: a model's constants, and columns in the place of some of them.
struct Call {
    const ashimpact_model& model;
    Parameters parameters;
    std::size_t count;
};

/// Where results go, an array of call.count numbers each; null where one is not asked for.
struct ImpactOutputs {
    double* restitution = nullptr;      ///< 0 for a capture [1]
    double* contact_time = nullptr;     ///< NaN for a capture [s]
    double* approach_time = nullptr;    ///< NaN where the overlap has no greatest value [s]
    double* maximum_overlap = nullptr;  ///< [m]
};
struct DampingOutputs {
    double* damping = nullptr;               ///< NaN where there is none [unit of the damping law]
    double* greatest_restitution = nullptr;  ///< without damping [1]
};

/// Solve the problems of a call on the calling thread, by tables where the results asked for are in them.
/// @throws InputError naming the first impact it concerns, where there are several; ConvergenceError
void solve_impacts(const Call& call, const ImpactOutputs& outputs);
/// v_c; 0 where nothing is captured, infinite where everything is [m/s].
void solve_critical_velocities(const Call& call, double* critical_velocity);
void solve_dampings(const Call& call, const DampingOutputs& outputs);

}  // namespace ashimpact

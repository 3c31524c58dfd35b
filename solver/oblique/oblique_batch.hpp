// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "solver/batch/columns.hpp"
#include "solver/oblique/oblique.hpp"

namespace ashimpact {

/// Motions along the wall of the impacts of a batch, of spheres on a wall or on partners without spin.
struct TangentialColumns {
    Column sphere_radius;  ///< [m]
    Column sphere_mass;    ///< [kg]
    Column velocity;       ///< v_t, as in TangentialMotion [m/s]
    Column spin;           ///< [rad/s]
    Column friction;       ///< mu >= 0 [1]
};

/// Where the results go, each as long as the batch; null if it is of no interest. NaN: of a capture, and the
/// tangential restitution without v_t.
struct TangentialOutputs {
    double* velocity = nullptr;       ///< v_t' [m/s]
    double* spin = nullptr;           ///< [rad/s]
    double* restitution = nullptr;    ///< e_t, 0 of a capture [1]
    double* rebound_angle = nullptr;  ///< from the normal, as in ObliqueResult [rad]
    double* impulse_ratio = nullptr;  ///< [1]
    double* regime = nullptr;         ///< the number of its SlidingRegime
};

/// Impacts at an angle, as oblique_result(). Where adhesion decides how far a sphere slides, its impulse
/// takes an integration of that impact.
/// @param restitution e_n of each impact of @p normal, 0 for a capture, as solve_impacts() gives it
/// @param count of impacts, at least as many as in the longest column
/// @param threads 0: one for each core; no bit of a result depends on it
/// @throws InputError naming the first impact it concerns
void solve_tangential(const ImpactBatch& normal, const double* restitution, std::size_t count,
                      const TangentialColumns& tangential, const TangentialOutputs& outputs, int threads);

}  // namespace ashimpact

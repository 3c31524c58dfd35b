// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "solver/batch/columns.hpp"
#include "solver/motion/damping_inversion.hpp"

namespace ashimpact {

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

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/batch/impact_batch.hpp"

namespace ashimpact::test {

/// An impact as a batch of one.
[[nodiscard]] inline ImpactBatchResult solve_as_batch(const Impact& impact,
                                                      const BatchOptions& options = {}) {
    const auto one = [](double value) { return Eigen::ArrayXd::Constant(1, value).eval(); };
    const ContactPair& pair = impact.contact;
    const Eigen::ArrayXd mass = one(pair.mass);
    const Eigen::ArrayXd radius = one(pair.effective_radius);
    const Eigen::ArrayXd modulus = one(pair.contact_modulus);
    const Eigen::ArrayXd adhesion = one(pair.work_of_adhesion);
    const Eigen::ArrayXd yield = one(pair.yield_pressure);
    const Eigen::ArrayXd damping = one(impact.damping.coefficient);
    const Eigen::ArrayXd velocity = one(impact.velocity);
    return solve_impacts({impact.law,
                          impact.detachment,
                          impact.damping.law,
                          {mass, radius, modulus, adhesion, yield, single_columns(pair.parameters)},
                          damping,
                          velocity},
                         options);
}

}  // namespace ashimpact::test

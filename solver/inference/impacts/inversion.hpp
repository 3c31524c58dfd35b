// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "solver/inference/impacts/measurement.hpp"
#include "solver/surrogate/contact_model.hpp"

namespace ashimpact {

/// One measured impact with the damping that the dynamic model gives for it; Dong et al. 2013, Figures 6
/// to 8.
struct InvertedImpact {
    std::size_t index;                  ///< in the set
    double velocity;                    ///< v_in [m/s]
    double restitution;                 ///< e_n, 0 for a capture [1]
    double greatest_restitution = 0.0;  ///< without damping, the greatest that can be reached [1]
    /// The damping that gives the restitution; for a capture a lower bound, the least damping that captures;
    /// none if no damping gives the restitution [kg/s].
    std::optional<double> damping{};
    std::optional<double> standard_uncertainty{};  ///< of the damping, where that of the velocities is known
    double by_restitution = 0.0;                   ///< d eta/d e at fixed v_in [kg/s]
    double by_velocity = 0.0;                      ///< d eta/d v_in at fixed e [kg/m]
    std::optional<double> contact_time{};          ///< of a rebound [s]
};

/// Inverts every impact of a set, in its order. The uncertainty of a damping is that of both velocities, with
/// their correlation, propagated linearly.
[[nodiscard]] std::vector<InvertedImpact> invert(const ContactModel& model, const MeasurementSet& set);

/// Like invert(), but for any law, also one with a history (yield), by solving impacts. Takes milliseconds an
/// impact; derivatives are central differences.
[[nodiscard]] std::vector<InvertedImpact> invert_by_solving(Law law, Detachment detachment,
                                                            const ContactPair& contact,
                                                            const MeasurementSet& set);

}  // namespace ashimpact

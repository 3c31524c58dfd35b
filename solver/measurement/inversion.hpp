#pragma once

#include "solver/measurement/contact_model.hpp"
#include "solver/measurement/measurement.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace ashimpact {

/// What the dynamic model says of one measured impact; Dong et al. 2013, Figures 6 to 8.
struct InvertedImpact {
    std::size_t index;  ///< in the set
    double velocity;    ///< v_in [m/s]
    double restitution;
    double greatest_restitution;  ///< without damping: the reachable range is 0 to this [1]
    /// The damping that gives the restitution [kg/s]; for a capture the least that captures, which is a lower
    /// bound; none for a restitution above greatest_restitution.
    std::optional<double> damping;
    std::optional<double>
        standard_uncertainty;            ///< of the damping, if those of the velocities are known [kg/s]
    double by_restitution;               ///< d eta/d e at fixed v_in [kg/s]
    double by_velocity;                  ///< d eta/d v_in at fixed e [kg/m]
    std::optional<double> contact_time;  ///< of a rebound [s]
};

/// Inverts every impact of a set, in its order. Uncertainty: that of both velocities through d eta/d e and
/// d eta/d v, with their correlation.
[[nodiscard]] std::vector<InvertedImpact> invert(const ContactModel& model, const MeasurementSet& set);

/// The same for any law, those with a history (yield) included, by solving impacts: milliseconds a point.
[[nodiscard]] std::vector<InvertedImpact> invert_by_solving(Law law, Detachment detachment,
                                                            const ContactPair& contact,
                                                            const MeasurementSet& set);

}  // namespace ashimpact

#pragma once

#include "solver/measurement/measurement.hpp"
#include "solver/uncertainty/curve/curve_estimate.hpp"

#include <optional>
#include <string>
#include <vector>

namespace ashimpact {

struct EstimateOptions {
    /// Relative standard deviation of single diameters about their mean, where it is known, such as from the
    /// sieve; the damping number goes with the square of the diameter. None: what the impacts show.
    std::optional<double> size_scatter{};
};

/// v_c as the impacts of one sample support it, through the dynamic model and a smooth curve of damping.
struct CriticalVelocityEstimate {
    CurveEstimate curve;
    std::size_t rebounds;            ///< used
    std::size_t captures;            ///< used, zero readings included
    bool noise_known;                ///< from the measurements
    std::vector<std::string> notes;  ///< what to know before it is believed
};

/// Name of the method, for artifacts.
inline constexpr const char* estimate_method =
    "posterior of v_c with a smooth curve of damping over velocity, captures by their probability";

/// Estimates v_c from rebounds and captures alike: see SmoothDamping and CurvePosterior. More than some
/// thousand impacts are put together into groups closer than their noise; all of them count.
/// @throws InputError where the impacts allow no estimate, with the reason; ConvergenceError
[[nodiscard]] CriticalVelocityEstimate estimate_critical_velocity(const ContactModel& model,
                                                                  const MeasurementSet& set,
                                                                  const EstimateOptions& options = {});

}  // namespace ashimpact

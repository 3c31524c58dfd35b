#pragma once

#include "solver/measurement/measurement.hpp"
#include "solver/uncertainty/curve/curve_estimate.hpp"

#include <optional>
#include <string>
#include <vector>

namespace ashimpact {

struct EstimateOptions {
    /// Relative standard deviation of single diameters about their mean, if known, such as from the sieve;
    /// the damping number goes with its inverse square. None: estimated from the impacts.
    std::optional<double> size_scatter{};
};

/// v_c estimated from the impacts of one sample, by the dynamic model and a smooth curve of damping.
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

/// Estimates v_c from rebounds and captures: see SmoothDamping and CurvePosterior. More than some thousand
/// impacts are first grouped (see grouped()); all of them count.
/// @throws InputError if the impacts allow no estimate, with the reason; ConvergenceError
[[nodiscard]] CriticalVelocityEstimate estimate_critical_velocity(const ContactModel& model,
                                                                  const MeasurementSet& set,
                                                                  const EstimateOptions& options = {});

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/finding.hpp"
#include "solver/inference/curve/curve_posterior.hpp"
#include "solver/inference/impacts/measurement.hpp"
#include "solver/statistics/interval.hpp"
#include "solver/surrogate/contact_model.hpp"

namespace ashimpact {

/// A curve of damping over velocity, from v_c, where the damping just captures, to the fastest impact.
struct EstimatedDamping {
    std::vector<double> velocity;  ///< [m/s]
    std::vector<double> damping;   ///< [kg/s]
};

/// v_c and the curve of damping, estimated from all impacts without assuming a law.
struct CurveEstimate {
    Interval critical_velocity;  ///< mean and 95 % interval [m/s]
    Interval critical_damping;   ///< eta_capture at those [kg/s]
    EstimatedDamping damping;    ///< of the mean curve; empty if no impact is faster than v_c
    Scatter scatter;
    double damping_scatter;  ///< standard deviation of ln eta between particles that scatters v_c so [1]
};

/// v_c of one sample, estimated from its impacts and a smooth curve of restitution.
struct CriticalVelocityEstimate {
    CurveEstimate curve;
    std::size_t rebounds;             ///< used
    std::size_t captures;             ///< used, zero readings included
    bool noise_known;                 ///< whether the measurements state it
    std::vector<Finding> findings{};  ///< doubts about the estimate
};

/// What is known beside the impacts.
struct EstimateOptions {
    /// Relative standard deviation of single diameters about their mean, such as from the sieve; ln eta then
    /// scatters by twice as much. None: it is estimated from the impacts [1].
    std::optional<double> size_scatter{};
    /// Relative standard uncertainty of a factor that all velocities have in common, as from the calibration
    /// of a camera or from an angle that all impacts share [1].
    double scale_uncertainty = 0.0;
};

/// v_c as the impacts tell it whatever the law of contact.
struct OnsetEstimate {
    std::vector<RecordedImpact> impacts;  ///< as used: in groups where there are many
    bool grouped;
    double noise;                      ///< of velocities, where it is estimated [m/s]
    std::optional<double> slow_noise;  ///< that of slow rebounds
    Interval velocity;                 ///< v_c: mean and 95 % interval [m/s]
    LikeliestCurve likeliest;          ///< at the mean
};

/// The part of estimate_critical_velocity() that laws have in common; none if size_scatter is given, which
/// acts by the damping of a law. Errors: as there.
[[nodiscard]] std::optional<OnsetEstimate> estimate_without_law(const MeasurementSet& set,
                                                                const EstimateOptions& options = {});

/// That impacts without a capture bound v_c from above alone; none if any was captured.
[[nodiscard]] std::optional<Finding> no_captures_note(const MeasurementSet& set);

/// Name of the method, for artifacts.
inline constexpr const char* estimate_method =
    "posterior of v_c with a smooth curve of restitution over velocity, captures by their probability";

/// Estimates v_c from rebounds and captures, see OnsetCurve and CurvePosterior. No law of contact takes part:
/// v_c does not depend on the contact, only the damping that belongs to it does. The posterior of v_c is
/// computed on even places in ln v_c, without random draws, and averaged with that of the outcomes alone,
/// captures and rebounds whatever the curve. More than few_impacts impacts are merged into groups narrower
/// than their noise, weighted by their numbers. A common error of scale multiplies v_c.
/// @param known estimate_without_law() of the set, if it is known
/// @throws InputError with the reason if the impacts allow no estimate; ConvergenceError
[[nodiscard]] CriticalVelocityEstimate estimate_critical_velocity(const ContactModel& model,
                                                                  const MeasurementSet& set,
                                                                  const EstimateOptions& options = {},
                                                                  const OnsetEstimate* known = nullptr);

}  // namespace ashimpact

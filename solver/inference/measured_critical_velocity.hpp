// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/quantities/names.hpp"
#include "solver/inference/impacts/measurement.hpp"
#include "solver/statistics/interval.hpp"

namespace ashimpact {

/// The critical velocity from captures and rebounds alone, without any model of the contact.
struct MeasuredCriticalVelocity {
    std::optional<double> value;  ///< > 0; none if only one outcome was seen or they give no threshold [m/s]
    std::optional<double> standard_uncertainty;  ///< [m/s]
    std::optional<double> lower;                 ///< of the 95 % interval; none: not bounded [m/s]
    std::optional<double> upper;                 ///< [m/s]
    std::optional<double> fastest_capture;       ///< [m/s]
    std::optional<double> slowest_rebound;       ///< [m/s]
    std::optional<double>
        width;         ///< standard deviation of the transition: noise, or more where outcomes mix [m/s]
    std::string note;  ///< in words
};

/// Maximum likelihood of P(capture at v) = Phi((v_c - v)/width). The width is the noise of v_in, or more if
/// outcomes mix over a wider range, as when particles differ. The interval is that of the profile likelihood,
/// with the width that is likeliest at each v_c. Without known noise and without mixing it is the gap between
/// the fastest capture and the slowest rebound. Outcomes that contradict a threshold (captures faster than
/// rebounds beyond their noise) give no value; the note gives the reason. Where captures may be rebounds too
/// slow to be seen, the interval has no lower end.
///
/// Captures alone bound v_c from below, by the greatest v_in - z u(v_in) of an impact, z the normal quantile
/// of 1 - 0.05/n for n impacts; rebounds alone bound it from above, by the least v_in + z u(v_in). If all
/// particles share one v_c such a bound holds in 95 % of cases or more, whatever velocities were aimed at.
/// @throws InputError for a set that is not valid
[[nodiscard]] MeasuredCriticalVelocity measured_critical_velocity(const MeasurementSet& stated);

/// Standard uncertainty of the difference of two estimates from the same impacts, which share most of their
/// errors. If one of them is efficient, the variance of the difference is the difference of the variances
/// (Hausman 1978). As neither quite is, at least a quarter of the larger variance is taken.
[[nodiscard]] double shared_difference(double one, double other);

enum class CriticalVelocityVerdict { agrees, model_too_low, model_too_high, not_comparable };

template <>
struct Names<CriticalVelocityVerdict> {
    static constexpr std::string_view kind = "verdict";
    static constexpr std::array<std::string_view, 4> all{"agrees", "model-too-low", "model-too-high",
                                                         "not-comparable"};
};

/// Whether a modelled v_c agrees with the measured one within their joint 95 % uncertainty. One below a
/// measured v_c whose interval has no lower end is not comparable with it.
struct CriticalVelocityCheck {
    CriticalVelocityVerdict verdict;
    std::optional<double> deviation;  ///< model less measurement, in joint standard uncertainties
};
[[nodiscard]] CriticalVelocityCheck check(const Interval& model, const MeasuredCriticalVelocity& measured,
                                          bool same_impacts = false);

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/quantities/names.hpp"
#include "pipeline/case/values.hpp"
#include "pipeline/run/results/note.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/inference/calibration/calibration.hpp"
#include "solver/inference/critical_velocity_uncertainty.hpp"
#include "solver/inference/curve/headline.hpp"
#include "solver/motion/regime.hpp"
#include "solver/statistics/interval.hpp"
#include "solver/statistics/propagation.hpp"

namespace ashimpact {

/// A 95 % interval; an end that the data do not bound is none.
struct Bounds {
    std::optional<double> lower{}, upper{};

    friend bool operator==(const Bounds&, const Bounds&) = default;
};

/// How a critical velocity was found.
enum class VelocityMethod {
    estimate,         ///< from all impacts, captures included
    extrapolation,    ///< the paper's polynomial eta(e) at e = 0
    critical_damping  ///< from the critical damping as 6-fit.json states it
};

template <>
struct Names<VelocityMethod> {
    static constexpr std::string_view kind = "method";
    static constexpr std::array<std::string_view, 3> all{
        estimate_method, "eta(e) extrapolated to e = 0, a polynomial (Dong et al. 2013)",
        "critical damping of 6-fit.json"};
};

/// A critical velocity with its interval: the form in which every part of a run states one.
struct VelocityEstimate {
    double value = 0;                              ///< [m/s]
    std::optional<double> standard_uncertainty{};  ///< [m/s]
    std::optional<Bounds> interval{};              ///< [m/s]; none: not known
    std::optional<VelocityMethod> method{};        ///< none: not stated, as of a measured velocity
};

/// A result of the solver with its uncertainty and interval, without ends that are not finite.
[[nodiscard]] inline VelocityEstimate estimate_of(const Interval& interval) {
    const auto finite = [](const std::optional<double>& value) {
        return value && std::isfinite(*value) ? value : std::nullopt;
    };
    return {.value = interval.value,
            .standard_uncertainty = finite(interval.standard_uncertainty),
            .interval = Bounds{finite(interval.lower), finite(interval.upper)}};
}

template <>
struct Names<DampingUnderChange> {
    static constexpr std::string_view kind = "damping under change";
    static constexpr std::array<std::string_view, 2> all{"reread", "held"};
};

/// The check of a modelled v_c. A measured velocity without any uncertainty is not comparable: how far it may
/// be from the modelled one is not known.
[[nodiscard]] inline CriticalVelocityCheck checked(const Interval& model,
                                                   const MeasuredCriticalVelocity& measured,
                                                   bool same_impacts) {
    const bool comparable =
        !measured.value || measured.standard_uncertainty.value_or(0) > 0 || measured.lower || measured.upper;
    return comparable ? check(model, measured, same_impacts)
                      : CriticalVelocityCheck{CriticalVelocityVerdict::not_comparable, std::nullopt};
}

/// How an interval of v_c came about, and what dominates it.
struct VelocityUncertainty {
    std::size_t evaluations = 0;
    std::size_t undefined = 0;               ///< samples without a result
    std::optional<double> mean{}, median{};  ///< [m/s]
    std::optional<double> lower_error{},
        upper_error{};  ///< of the ends of the interval, by Monte Carlo [m/s]
    std::vector<std::pair<std::string, std::optional<double>>> relative{};  ///< standard uncertainties [1]
    std::vector<std::string> taken_as_exact{};                              ///< inputs without uncertainty
    std::vector<Influence> influences{};            ///< largest total first; NaN: not known
    std::optional<CalibrationResponse> response{};  ///< powers of E* that inferred constants follow
    std::optional<DampingUnderChange> damping{};
};

/// A velocity by the paper's extrapolation of measured impacts, beside the estimate.
struct ExtrapolatedVelocity {
    VelocityEstimate velocity{};
    VelocityUncertainty uncertainty{};
    std::optional<CriticalVelocityCheck> check{};
};

/// Dynamic critical velocity by one law.
struct LawCriticalVelocity {
    Detachment detachment = Detachment::zero_overlap;
    double damping = 0;  ///< the critical damping it belongs to [unit of the damping law]
    CaptureVerdict verdict = CaptureVerdict::finite;
    std::optional<VelocityEstimate> velocity{};  ///< where finite
    std::optional<double> contact_time{};        ///< where finite [s]
    std::optional<double> maximum_overlap{};     ///< [m]
    std::vector<double> crossings{};             ///< where capture and rebound change places [m/s]
    double dissipated = 0;                       ///< work of damping at v_c [J]
    double plastic = 0;                          ///< work spent in yielding at v_c [J]
    double detachment_energy = 0;                ///< what the break itself costs [J]
    std::optional<Regime> regime{};              ///< of the impact at v_c
    std::string interval_note{};                 ///< why there is no interval
    std::optional<VelocityUncertainty> uncertainty{};
    std::optional<CriticalVelocityCheck> check{};  ///< against the measured one
    bool from_impacts = false;                     ///< v_c follows from measured impacts
    std::optional<ExtrapolatedVelocity> extrapolated{};
};

/// The critical velocities of a sample.
struct SampleCriticalVelocity {
    std::string name{};
    std::optional<MeasuredCriticalVelocity>
        measured{};  ///< reported, or as the outcomes of the impacts show it
    LawMap<LawCriticalVelocity> laws{};
};

/// The measured velocity as an estimate. @param measured with a value
[[nodiscard]] inline VelocityEstimate estimate_of(const MeasuredCriticalVelocity& measured) {
    VelocityEstimate estimate{.value = measured.value.value()};
    if (measured.lower || measured.upper) estimate.interval = Bounds{measured.lower, measured.upper};
    if (measured.standard_uncertainty.value_or(0) > 0)
        estimate.standard_uncertainty = measured.standard_uncertainty;
    return estimate;
}

/// Result of the critical velocity stage, 7-critical-velocity.json.
using CriticalVelocityResult = SampleResults<SampleCriticalVelocity>;

}  // namespace ashimpact

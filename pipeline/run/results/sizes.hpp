// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pipeline/case/values.hpp"
#include "pipeline/run/results/critical_velocity.hpp"
#include "solver/inference/damping_laws.hpp"

namespace ashimpact {

/// A point of a curve e(v).
struct DampedImpact {
    double velocity = 0, restitution = 0;  ///< [m/s], [1]
};

/// What a damping law with its constants gives for a sample.
struct DampedSample {
    std::string name{};
    std::optional<CaptureVerdict> verdict{};  ///< none: not known
    std::optional<double> velocity{};         ///< critical, where finite [m/s]
    std::vector<DampedImpact> curve{};        ///< over the velocities of its impacts
};

/// A damping law with those constants, the same for all samples, that are closest to the impacts.
struct ComparedDamping {
    DampingLaw law = DampingLaw::constant;
    std::vector<std::pair<std::string, Quantity>> constants{};  ///< empty: undetermined
    std::optional<double> correlation{};                        ///< of two constants [1]
    double misfit = 0;  ///< root mean square of the differences of e [1]
    DampingEvidence evidence = DampingEvidence::untold;
    std::vector<DampedSample> samples{};
};

/// Damping laws side by side, by one contact law.
struct DampingComparison {
    Law law;
    std::vector<ComparedDamping> laws{};  ///< in the order of DampingLaw
};

/// What a critical velocity at some size rests on.
enum class SizeBasis {
    measured,  ///< the impacts of samples; between two of them interpolated
    constant,  ///< a damping law with one constant for all sizes, in the order of DampingLaw
    contact_radius,
    tsuji,
    hunt_crossley,
    brach_dunn,
    power_of_size,  ///< the critical damping of the samples as a power of the diameter
    adhesion,       ///< no damping: a lower bound
};

template <>
struct Names<SizeBasis> {
    static constexpr std::string_view kind = "assumption";
    static constexpr std::array<std::string_view, 8> all{
        "measured",      "constant",           "contact-radius", "tsuji",
        "hunt-crossley", "brach-dunn-damping", "power-of-size",  "adhesion-alone"};
};

/// Whether a size has a critical velocity.
enum class SizeVerdict {
    finite,
    always_captured,
    never_captured,
    outside_model,  ///< v_c is above fastest_in_model
    unknown,        ///< the computation did not converge
};

template <>
struct Names<SizeVerdict> {
    static constexpr std::string_view kind = "verdict";
    static constexpr std::array<std::string_view, 5> all{"finite", "always-captured", "never-captured",
                                                         "outside-model", "unknown"};
};

/// The critical velocity of a size under an assumption.
struct SizeVelocity {
    double diameter = 0;  ///< [m]
    SizeBasis basis = SizeBasis::measured;
    SizeVerdict verdict = SizeVerdict::finite;
    std::optional<double> velocity{};  ///< where the verdict is finite [m/s]
    std::optional<Bounds> interval{};  ///< 95 %, if the assumption is right [m/s]; none: not known
};

/// Sizes from one to another [m].
struct SizeRange {
    double from = 0, to = 0;
};

/// What the constants of the damping laws follow from.
enum class ConstantsFrom {
    impacts,  ///< all of them, which the laws explain
    capture,  ///< v_c of the samples: no law explains all impacts with one constant
};

template <>
struct Names<ConstantsFrom> {
    static constexpr std::string_view kind = "source of constants";
    static constexpr std::array<std::string_view, 2> all{"impacts", "capture"};
};

/// The critical damping of the samples as a power of the diameter, damping (d/diameter)^exponent.
struct PowerOfDiameter {
    Quantity exponent{};  ///< [1]
    Quantity damping{};   ///< [unit of the damping law of the case]
    double diameter = 0;  ///< the geometric mean of the samples [m]
};

/// What the velocities by size say together.
struct SizeSummary {
    Law law;                               ///< by which all are computed
    SizeRange measured{};                  ///< the sizes of the samples
    std::optional<SizeRange> agreement{};  ///< where the assumptions differ by less than agreement_factor
    ConstantsFrom constants = ConstantsFrom::impacts;
    /// Coefficients with which the assumptions were computed, by damping law.
    std::vector<std::pair<std::string, Quantity>> coefficients{};
    std::optional<PowerOfDiameter> power{};  ///< of several sizes
};

/// A critical velocity of a size.
struct VelocityOfSize {
    double diameter = 0, velocity = 0;  ///< [m], [m/s]
    double exponent = 0;                ///< d ln v_c/d ln d, from the neighbouring sizes [1]
};

/// Critical velocities of a contact law over all sizes, without damping.
struct LawBySize {
    Law law;
    std::vector<VelocityOfSize> curve{};  ///< from small to large; sizes with a finite v_c
};

/// Assumptions agree where the greatest velocity is at most so many times the least.
inline constexpr double agreement_factor = 2;

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pipeline/case/case.hpp"
#include "pipeline/case/values.hpp"
#include "pipeline/run/results/note.hpp"
#include "solver/damping/damping_polynomial.hpp"
#include "solver/inference/curve/headline.hpp"
#include "solver/inference/extrapolation/damping_curve_fit.hpp"
#include "solver/inference/impacts/angle_classes.hpp"
#include "solver/inference/impacts/inverted_impacts.hpp"
#include "solver/inference/measured_damping.hpp"

namespace ashimpact {

/// An impact whose restitution no damping gives.
struct UnreachableImpact {
    std::size_t number = 0;  ///< in the series, from 1 on
    double velocity = 0;     ///< [m/s]
    double restitution = 0;  ///< [1]
    std::string reason{};    ///< in words
};

/// A part of eta(v_in) with the velocities between which it lies.
struct PartRange {
    DampingPart part = DampingPart::flat;
    Quantity from{}, to{};  ///< with a standard uncertainty where it is a boundary between parts [m/s]
};

/// Where restitution rises with velocity.
struct RisingRange {
    double to = 0;              ///< its greatest velocity [m/s]
    bool falls_beyond = false;  ///< restitution falls at faster impacts; else the data end there
};

/// Damping against restitution and velocity, by one law.
struct DampingSeries {
    Origin origin = Origin::measured;            ///< of the restitution data
    std::vector<double> number{};                ///< of each rebound in the series, from 1 on
    std::vector<double> velocity{};              ///< [m/s]
    std::vector<double> restitution{};           ///< above 0 [1]
    std::vector<double> greatest_restitution{};  ///< without damping, at this velocity [1]
    std::vector<double> damping{};               ///< [unit of the damping law]
    std::vector<double> damping_uncertainty{};   ///< standard; empty: not known [unit of the damping law]
    std::vector<double> contact_time{};          ///< [s]
    std::vector<double> captured_at{};           ///< v_in of captures [m/s]
    std::vector<double> capturing_damping{};     ///< least that captures; empty: not known [unit of the law]
    std::vector<UnreachableImpact> unreachable{};
    std::vector<PartRange> parts{};           ///< from slow to fast
    std::string parts_note{};                 ///< why there are none
    std::vector<std::size_t> outliers{};      ///< their numbers
    std::optional<AngleComparison> angles{};  ///< of impacts at different angles
    std::optional<RisingRange> rising{};
    std::string rising_note{};  ///< why there is none
    double map_accuracy = 0;    ///< of restitutions read from a map; 0: solved [1]
};

/// The dampings of a sample.
struct SampleDamping {
    std::string name{};
    LawMap<DampingSeries> laws{};
};

/// The columns of inverted impacts: rebounds within reach, captures, and impacts that no damping gives.
[[nodiscard]] DampingSeries inverted_series(const std::vector<InvertedImpact>& impacts);

/// Sets parts and outliers of a series. @param impacts whose range the parts cover
void set_parts(const DampingParts& parts, const std::vector<InvertedImpact>& impacts, DampingSeries& series);

/// Result of the damping stage, 5-damping.json.
using DampingStageResult = SampleResults<SampleDamping>;

/// How a, b and c of a fit were found.
enum class FitMethod {
    least_squares,  ///< of the damping on the restitution
    closest_curve,  ///< in the plane of both velocities
    estimate,       ///< nothing can be extrapolated: c is the critical damping of the estimate
};

template <>
struct Names<FitMethod> {
    static constexpr std::string_view kind = "method";
    static constexpr std::array<std::string_view, 3> all{"least-squares", "closest-curve", "estimate"};
};

/// What all measured impacts support, captures included, whatever the form of eta(e).
struct DampingEstimate {
    Interval critical_damping{};              ///< [kg/s]
    Interval critical_velocity{};             ///< for the contact as given [m/s]
    std::size_t rebounds = 0;                 ///< used
    std::size_t captures = 0;                 ///< used
    bool noise_known = false;                 ///< whether the measurements state it
    double scatter = 0;                       ///< factor on the stated noise [1], or the noise itself [m/s]
    double particle_scatter = 0;              ///< standard deviation of ln eta between particles [1]
    std::optional<EstimatedDamping> curve{};  ///< none: an older artifact, or no impact faster than v_c
};

[[nodiscard]] DampingEstimate summary_of(const CriticalVelocityEstimate& estimate);

/// A fit whose indices are those of the whole series. @param indices of the impacts it was given
[[nodiscard]] DampingCurveFit with_indices(DampingCurveFit fit, const std::vector<std::size_t>& indices);

/// The damping that the fit of one law gives.
struct LawFit {
    DampingPolynomial damping{};                           ///< eta(e), up to the second power
    double critical_damping = 0;                           ///< eta(0) [unit of the damping law]
    std::optional<double> critical_damping_uncertainty{};  ///< standard [unit of the damping law]
    std::optional<Eigen::Matrix3d> covariance{};           ///< of c, b, a
    std::optional<FitMethod> method{};
    Origin origin = Origin::measured;            ///< of the restitution data
    std::optional<double> residual_deviation{};  ///< of least squares [unit of the damping law]
    int degrees_of_freedom = 0;
    std::size_t points = 0;         ///< that were fitted
    std::size_t points_beyond = 0;  ///< faster than the rising branch
    std::optional<std::array<double, 2>> restitution_range{};
    std::optional<DampingCurveFit> extrapolated{};  ///< of measured impacts; indices are those of the series
    std::optional<DampingEstimate> estimate{};      ///< of measured impacts: what v_c follows from
    std::optional<FitComparison> comparison{};      ///< of the two

    /// The fit eta(e) over the rising branch: of measured impacts the extrapolated one.
    [[nodiscard]] const DampingPolynomial& along_rising_branch() const {
        return extrapolated ? extrapolated->damping : damping;
    }
};

/// The fits of a sample.
struct SampleFit {
    std::string name{};
    LawMap<LawFit> laws{};
};

/// Result of the fit stage, 6-fit.json.
using FitResult = SampleResults<SampleFit>;

}  // namespace ashimpact

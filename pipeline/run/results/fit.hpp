// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pipeline/case/case.hpp"
#include "pipeline/case/law_map.hpp"
#include "solver/damping/damping_polynomial.hpp"
#include "solver/inference/curve/headline.hpp"
#include "solver/inference/extrapolation/damping_curve_fit.hpp"
#include "solver/inference/measured_damping.hpp"

namespace ashimpact {

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
    Interval critical_damping{};   ///< [kg/s]
    Interval critical_velocity{};  ///< for the contact as given [m/s]
    std::size_t rebounds = 0;      ///< used
    std::size_t captures = 0;      ///< used
    bool noise_known = false;      ///< whether the measurements state it
    double scatter = 0;            ///< factor on the stated noise [1], or the noise itself [m/s]
    double particle_scatter = 0;   ///< standard deviation of ln eta between particles [1]
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
struct FitResult {
    std::vector<SampleFit> samples{};
};

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Dense>

#include "core/quantities/names.hpp"
#include "materials/contact_properties.hpp"
#include "solver/inference/calibration/published_damping.hpp"
#include "solver/statistics/interval.hpp"

namespace ashimpact {

/// The constants of one sieve size, as far as they are known; a calibration replaces the free ones.
struct CalibrationSample {
    double diameter;          ///< [m]
    double density;           ///< of the particle [kg/m3]
    double work_of_adhesion;  ///< [J/m2]
    ElasticBody particle;     ///< E from the mixture rule
    ElasticBody wall;
    std::optional<double> contact_modulus;  ///< E* taken directly instead of Eq. 7 [Pa]
    /// Of the scheme by which the published numbers were computed.
    FiniteStep step{};
    double yield_pressure = std::numeric_limits<double>::infinity();  ///< of laws that yield [Pa]
    ParameterValues<double> parameters{};                             ///< of laws that declare their own
    /// The damping of every critical velocity of the sample; none: that of the observation.
    std::optional<Damping> damping{};

    [[nodiscard]] ContactPair contact() const;
};

enum class CalibrationQuantity {
    density,
    work_of_adhesion,
    contact_modulus,
    wall_young_modulus,
    time_step,
    yield_pressure,  ///< from velocities over sizes alone
    damping          ///< likewise; one coefficient for all sizes
};

/// Where the search for a time step begins that the samples do not state: about a hundredth of the paper's
/// contacts [s].
inline constexpr double first_time_step = 2e-9;

template <>
struct Names<CalibrationQuantity> {
    static constexpr std::string_view kind = "constant of a calibration";
    static constexpr std::array<std::string_view, 7> all{
        "density",   "work_of_adhesion", "contact_modulus", "wall_young_modulus",
        "time_step", "yield_pressure",   "damping"};
};

/// Whether a constant follows from the critical velocities of several sizes alone.
[[nodiscard]] constexpr bool is_of_sizes(CalibrationQuantity quantity) {
    return quantity == CalibrationQuantity::yield_pressure || quantity == CalibrationQuantity::damping;
}

/// What a calibrated constant measures. @param damping whose coefficient is one of the constants
[[nodiscard]] Dimension dimension_of(CalibrationQuantity quantity, DampingLaw damping = DampingLaw::constant);

/// One free constant: one value for all samples, or one each. The search starts from the samples' values.
struct FreeConstant {
    CalibrationQuantity quantity;
    bool per_sample = false;
};

struct CalibrationProblem {
    std::vector<CalibrationSample> samples;
    std::vector<FreeConstant> free;
    std::vector<CriticalVelocityObservation> critical_velocities;
    std::vector<ContactTimeObservation> contact_times;
    std::function<void()> on_trial{};  ///< called for each trial of the constants; may be empty
};

/// A calibrated constant with the 95 % interval that its standard uncertainty implies (in the logarithm).
struct CalibratedConstant {
    CalibrationQuantity quantity;
    std::optional<std::size_t> sample;  ///< none: shared by all
    double value;
    double standard_uncertainty;
    double lower;
    double upper;
};

/// One observation beside its prediction [SI].
struct CalibrationResidual {
    double observed;
    double predicted;
    double relative_uncertainty;  ///< standard; rounding of the value and of the numbers behind it [1]
    /// Set for a contact time if the model captures the impact: the velocity up to which it does, that of
    /// least_rebound() [m/s]. `predicted` is then the contact time just above the critical velocity of
    /// eta(0), prolonged by the distance to it.
    std::optional<double> captured_up_to{};

    [[nodiscard]] double relative_difference() const { return predicted / observed - 1.0; }
};

/// Predictions from given samples beside the observations, and how well each is known.
struct CalibrationResiduals {
    std::vector<CalibrationResidual> critical_velocities;
    std::vector<CalibrationResidual> contact_times;
    /// Covariance of ln(predicted/observed), velocities first. The damping at v_c and the constant term of
    /// the fit that a contact time rests on are one printed number, so their rounding is one error.
    Eigen::MatrixXd covariance;
};

[[nodiscard]] CalibrationResiduals calibration_residuals(const CalibrationProblem& problem,
                                                         const std::vector<CalibrationSample>& samples);

/// The problem from the best start on a grid of ratios to the starting values of its constants, which are one
/// value for all samples each; for constants of which only the order of magnitude is known, if that.
/// @param ratios of each free constant @pre no contact times
[[nodiscard]] CalibrationProblem with_best_start(CalibrationProblem problem,
                                                 const std::vector<std::vector<double>>& ratios);

struct CalibrationSummary {
    std::vector<CalibratedConstant> constants;
    Eigen::MatrixXd correlation;             ///< of the logarithms of the constants
    std::vector<CalibrationSample> samples;  ///< with the calibrated constants in place
    std::vector<CalibrationResidual> critical_velocities;
    std::vector<CalibrationResidual> contact_times;
    double chi_squared;
    int degrees_of_freedom;
    double probability;  ///< of a chi^2 at least this large
    double akaike;       ///< chi^2 + 2 (number of constants), to compare hypotheses
    int iterations;
};

/// Least squares in the logarithms of constants and observations (GSL). The uncertainty of each observation
/// includes the rounding of the numbers it rests on: the damping, or the velocity and the fit.
/// @throws InputError for a problem with fewer observations than constants or unknown samples,
/// ConvergenceError
[[nodiscard]] CalibrationSummary calibrate(const CalibrationProblem& problem);

/// Like calibrate(), but accepts captured impacts, with the substitute contact time of CalibrationResidual.
/// @throws InputError, ConvergenceError
[[nodiscard]] CalibrationSummary calibrate_despite_captures(const CalibrationProblem& problem);

/// Like calibrate(), but fits the critical velocities alone; contact times are only predicted. chi^2, degrees
/// of freedom and AIC count the velocities, so that they are lower bounds of those of the whole problem.
[[nodiscard]] CalibrationSummary calibrate_by_velocities(const CalibrationProblem& problem);

/// How calibrated constants follow the contact modulus that they were calibrated at, to first order: the
/// exponents of powers of E*, where the E* of all samples change in the same ratio [1].
struct CalibrationResponse {
    double density = 0.0;           ///< of the sample
    double work_of_adhesion = 0.0;  ///< of the sample
};

/// The response of each sample's constants, by linearising the least squares at the constants of the problem,
/// which have to be calibrated ones. A constant that is not free does not follow.
/// @throws InputError like calibrate(); ConvergenceError
[[nodiscard]] std::vector<CalibrationResponse> response_to_contact_modulus(const CalibrationProblem& problem);

/// Profile of one calibrated constant: its interval when all others are free to follow it.
struct ConstantProfile {
    Interval interval;  ///< 95 %, from the rise of chi^2; an end beyond a factor of 10 is missing
    bool identifiable;  ///< whether both ends were found
    std::vector<std::size_t> traded_with;  ///< constants with which it is correlated by more than 0.95
    std::string statement;                 ///< in words, if it is not identifiable; else empty
};

/// Profile-likelihood intervals of the constants of a calibration, in their order.
/// @param summary of that problem
/// @throws ConvergenceError
[[nodiscard]] std::vector<ConstantProfile> profile_constants(const CalibrationProblem& problem,
                                                             const CalibrationSummary& summary);

}  // namespace ashimpact

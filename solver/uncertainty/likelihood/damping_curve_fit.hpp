#pragma once

#include "materials/base/names.hpp"
#include "solver/measurement/contact_model.hpp"
#include "solver/measurement/measurement.hpp"
#include "solver/uncertainty/interval.hpp"
#include "solver/uncertainty/likelihood/damping_polynomial.hpp"
#include "solver/uncertainty/likelihood/rebound_selection.hpp"

#include <Eigen/Dense>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ashimpact {

/// How eta(e_n) is fitted to the rebounds of a rising branch.
struct DampingCurveOptions {
    int order = 2;          ///< of the polynomial; the paper's is 2
    bool captures = false;  ///< use which impacts stuck, where the data have captures
    bool robust = false;    ///< bisquare weights take back what lies far from the curve
    /// Where the likelihood has no maximum of that order, the next lower one down to the quadratic is taken;
    /// the fit's own options say which.
    bool lower_if_needed = false;
};

/// The paper's way: quadratic in e_n, rebounds only, v_c by extrapolation to e_n = 0.
inline constexpr DampingCurveOptions extrapolated_fit{.order = 2, .captures = false};
/// Directly: captures included, and two orders more, so that v_c does not hang on eta being quadratic.
inline constexpr DampingCurveOptions direct_fit{.order = 4, .captures = true, .lower_if_needed = true};

/// One rebound in a fit.
struct FittedRebound {
    std::size_t index;        ///< in the set
    double restitution;       ///< e of the nearest point of the curve
    double distance;          ///< signed, from the curve, in standard uncertainties
    double leverage;          ///< share of the fit that this point determines by itself [0, 1]
    double deleted_distance;  ///< from the curve fitted without it, to first order
    double influence;         ///< change of eta_c by leaving it out, to first order [kg/s]
    double weight;            ///< 1, or that of a robust fit
};

enum class IntervalMethod { profile_likelihood, curvature };
template <>
struct Names<IntervalMethod> {
    static constexpr std::string_view kind = "method";
    static constexpr std::array<std::string_view, 2> all{"profile likelihood", "curvature of the likelihood"};
};

struct DampingCurveFit {
    DampingCurveOptions options;
    DampingPolynomial damping;
    Eigen::MatrixXd covariance;  ///< of the coefficients [kg2/s2]
    Interval critical_damping;   ///< eta_c = eta(0) [kg/s]
    Interval critical_velocity;  ///< at eta_c, for the contact as given [m/s]
    IntervalMethod interval_method;

    std::vector<FittedRebound> rebounds;
    std::vector<ExcludedRebound> excluded;
    std::size_t captures;  ///< used
    double chi_squared;    ///< of the rebounds
    int degrees_of_freedom;
    double probability;  ///< of a chi^2 at least this large; 1 where the noise is not known
    double scatter;    ///< factor by which the noise was enlarged (or, unknown, estimated) to fit [1 or m/s]
    bool noise_known;  ///< from the measurements
    double akaike;     ///< -2 ln L + 2 p, corrected for few points; to compare orders
    double prediction_error;             ///< root mean square of the deleted distances
    std::array<double, 2> restitutions;  ///< least and greatest measured
    double extrapolation;                ///< distance of e = 0 from the data over their width [1]
};

/// Fits eta(e_n) in the plane (v_in, v_r) by maximum likelihood; see ImpactLikelihood.
///
/// Noise that is not known is taken as equal in both velocities and estimated from the scatter; noise that
/// explains the scatter with less than 1 % probability is enlarged to fit. Where it is negligible, the
/// closest curve is the fit, and captures say no more. Intervals: profile likelihood, for more than 400
/// impacts curvature.
/// @param set the impacts to use, all of the rising branch
/// @throws InputError for too few rebounds or distinct restitutions, saying what is there; ConvergenceError
[[nodiscard]] DampingCurveFit fit_damping_curve(const ContactModel& model, const MeasurementSet& set,
                                                const DampingCurveOptions& wanted = extrapolated_fit);

/// That measured uncertainties were enlarged to fit, and how much, in words; none where they were not.
[[nodiscard]] std::optional<std::string> enlargement_note(const DampingCurveFit& fit);

/// The same data fitted by polynomials of several orders, to choose from.
struct OrderComparison {
    std::vector<DampingCurveFit> fits;  ///< by order
    std::optional<int> best;            ///< order of the least akaike
    std::vector<std::string> notes;     ///< why an order is missing
};
[[nodiscard]] OrderComparison compare_orders(const ContactModel& model, const MeasurementSet& set,
                                             const std::vector<int>& orders,
                                             DampingCurveOptions options = extrapolated_fit);

/// What an extrapolated fit and a direct one of the same impacts say of one another.
struct FitComparison {
    double critical_damping_ratio;   ///< of the direct to the extrapolated [1]
    double critical_velocity_ratio;  ///< [1]
    bool consistent;                 ///< the interval of the direct fit contains the extrapolated eta_c
    bool exclude_one_another;        ///< the intervals of eta_c do not overlap
    std::string statement;           ///< in words
};
[[nodiscard]] FitComparison compare(const DampingCurveFit& extrapolated, const DampingCurveFit& direct);

}  // namespace ashimpact

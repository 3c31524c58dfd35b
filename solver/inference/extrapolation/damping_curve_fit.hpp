// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Dense>

#include "solver/damping/damping_polynomial.hpp"
#include "solver/inference/impacts/measurement.hpp"
#include "solver/numeric/chebyshev.hpp"
#include "solver/statistics/interval.hpp"
#include "solver/surrogate/contact_model.hpp"

namespace ashimpact {

/// How eta(e_n) is fitted to the rebounds of a rising branch.
struct DampingCurveOptions {
    int order = 2;        ///< of the polynomial; the paper's is 2
    bool robust = false;  ///< whether bisquare weights reduce the influence of points far from the curve
};

enum class Exclusion {
    above_reach,  ///< v_r exceeds v_in by more than three standard uncertainties, or at all if unknown
};

struct ExcludedRebound {
    std::size_t index;
    Exclusion reason;
};

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

struct DampingCurveFit {
    DampingCurveOptions options;
    DampingPolynomial damping;
    Eigen::MatrixXd covariance;  ///< of the coefficients [kg2/s2]
    Interval critical_damping;   ///< eta_c = eta(0) [kg/s]
    Interval critical_velocity;  ///< at eta_c, for the contact as given [m/s]

    std::vector<FittedRebound> rebounds;
    std::vector<ExcludedRebound> excluded;
    double chi_squared;  ///< of the rebounds
    int degrees_of_freedom;
    double probability;  ///< of a chi^2 at least this large; 1 if the noise is not known
    double scatter;    ///< factor by which the noise was enlarged (or, unknown, estimated) to fit [1 or m/s]
    bool noise_known;  ///< whether the measurements state it
    double prediction_error;             ///< root mean square of the deleted distances
    std::array<double, 2> restitutions;  ///< least and greatest measured
    double extrapolation;                ///< distance of e = 0 from the data over their width [1]
};

/// The paper's way to v_c: eta(e_n) as a polynomial through the rebounds, extrapolated to e_n = 0. Its curve
/// in the plane (v_in, v_r) passes closest to the rebounds, in units of their noise (orthogonal distances;
/// Fuller 1987, Measurement Error Models, ch. 1). Intervals follow from the curvature and hold if eta is such
/// a polynomial.
///
/// Noise that is not known is taken as equal in both velocities and estimated from the scatter; noise that
/// explains the scatter with less than 1 % probability is enlarged to fit.
/// @param set the impacts to use, all of the rising branch; captures are ignored
/// @throws InputError for too few rebounds or distinct restitutions, saying what is there; ConvergenceError
[[nodiscard]] DampingCurveFit fit_damping_curve(const ContactModel& model, const MeasurementSet& set,
                                                const DampingCurveOptions& options = {});

/// Widens the intervals and the covariance of a fit by a relative standard uncertainty that all velocities of
/// the set have in common: the fit to greater velocities, less the fit. @throws as fit_damping_curve()
void add_common_error(DampingCurveFit& fit, const ContactModel& model, const MeasurementSet& set,
                      double relative);

/// Checks that a fitted v_c does not lie above clear rebounds among the impacts it was fitted to.
///
/// A rebound is clear if v_r exceeds three standard uncertainties of the fit, which may have enlarged or
/// estimated them. The slowest of many rebounds is likely to have a large error of v_in, which is allowed
/// for. Outliers of a robust fit (weight below 0.5) and rebounds that no damping gives do not count.
/// @throws InputError if the lower end of the interval of v_c lies above that
void require_rebounds_above(const DampingCurveFit& fit, const MeasurementSet& set);

/// Note on uncertainties that were enlarged to fit, with their factor; none if they were not.
[[nodiscard]] std::optional<std::string> enlargement_note(const DampingCurveFit& fit);

/// The curve of rebounds that a damping eta(e_n) implies through the dynamic model: the velocity v(e) at
/// which an impact with damping eta(e) has restitution e. In the plane (v_in, v_r) it is (v, e v); it begins
/// at (v_c, 0), where e(v) rises vertically for adhesive laws while v(e) is smooth, hence the parameter e.
class RestitutionCurve {
  public:
    /// The curve of a damping; none if the damping is not positive, or v leaves the model's range, for some e
    /// in [0, greatest_restitution]. @param near a similar curve up to the same restitution, for first
    /// guesses; or null
    [[nodiscard]] static std::optional<RestitutionCurve> implied_by(const ContactModel& model,
                                                                    const DampingPolynomial& damping,
                                                                    double greatest_restitution,
                                                                    const RestitutionCurve* near = nullptr);

    struct Point {
        double velocity;    ///< v(e) [m/s]
        double slope;       ///< dv/de along the curve [m/s]
        double by_damping;  ///< dv/d(eta) at fixed e [m/kg]
    };
    /// Point of the curve at @p e; beyond the ends it is continued by its tangent, or less steeply in e(v).
    [[nodiscard]] Point point_at(double e) const;

    /// The point of the curve nearest to a measurement, in units of its noise.
    struct Projection {
        double restitution;  ///< e of the nearest point
        double distance;     ///< signed, in standard uncertainties
        double by_damping;   ///< change of the distance with the damping at that e [s/kg]
    };
    /// @param point with its noise @param start e of a point close by
    [[nodiscard]] Projection project(const Measurement& point, double start) const;

  private:
    explicit RestitutionCurve(double greatest_restitution) : greatest_(greatest_restitution) {}

    /// Axis of the cube root of e, in which the curve is a Chebyshev series.
    [[nodiscard]] static ChebyshevAxis axis(double greatest_restitution) {
        return {0.0, std::cbrt(greatest_restitution), degree};
    }

    double greatest_;
    static constexpr int degree = 20;
    Eigen::Matrix<double, degree + 1, 2> nodes_;         ///< ln v and ln dv/d(eta) at the Chebyshev nodes
    Eigen::Matrix<double, degree + 1, 2> coefficients_;  ///< of the same
};

}  // namespace ashimpact

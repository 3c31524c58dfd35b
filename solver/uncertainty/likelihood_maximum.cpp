#include "solver/uncertainty/likelihood_maximum.hpp"

#include "materials/error.hpp"
#include "solver/gsl/nonlinear_fit.hpp"
#include "solver/gsl/robust.hpp"
#include "solver/uncertainty/profile.hpp"
#include "solver/uncertainty/rebound_selection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ashimpact {

namespace {

/// Turns values of eta at restitutions spread over the curve, the first at e = 0, into coefficients. The
/// values are all of one size, the coefficients of high powers are not.
Eigen::MatrixXd coefficients_from_values(const RestitutionLikelihood& likelihood, Eigen::Index count) {
    Eigen::MatrixXd powers(count, count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const double share = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0.0;
        powers.row(i) = DampingPolynomial::powers(share * likelihood.data().greatest_restitution,
                                                  static_cast<int>(count) - 1)
                            .transpose();
    }
    return powers.inverse();
}

Eigen::VectorXd prepended(double first, const Eigen::VectorXd& rest) {
    Eigen::VectorXd all(rest.size() + 1);
    all << first, rest;
    return all;
}

/// -2 ln L with the first value, eta(0), held.
double least_with(const RestitutionLikelihood& likelihood, const Eigen::MatrixXd& to_coefficients,
                  const Eigen::VectorXd& start) {
    if (start.size() == 1) return likelihood.rows(to_coefficients * start).residuals.squaredNorm();
    const auto coefficients = [&](const Eigen::VectorXd& others) -> Eigen::VectorXd {
        return to_coefficients * prepended(start[0], others);
    };
    const Eigen::MatrixXd by_others = to_coefficients.rightCols(start.size() - 1);
    return gsl::fit_nonlinear(
               {.residuals =
                    [&](const Eigen::VectorXd& x) { return likelihood.rows(coefficients(x)).residuals; },
                .jacobian = [&](const Eigen::VectorXd& x) -> Eigen::MatrixXd {
                    return likelihood.rows(coefficients(x)).jacobian * by_others;
                }},
               start.tail(start.size() - 1), {.parameter_tolerance = 1e-4, .gradient_tolerance = 1e-9})
        .chi_squared;
}

}  // namespace

Eigen::VectorXd maximise(const RestitutionLikelihood& likelihood, const Eigen::VectorXd& start) {
    const Eigen::MatrixXd to_coefficients = coefficients_from_values(likelihood, start.size());
    const Eigen::VectorXd values = to_coefficients.partialPivLu().solve(start);
    const gsl::NonlinearFit fit = gsl::fit_nonlinear(
        {.residuals =
             [&](const Eigen::VectorXd& x) { return likelihood.rows(to_coefficients * x).residuals; },
         .jacobian = [&](const Eigen::VectorXd& x) -> Eigen::MatrixXd {
             return likelihood.rows(to_coefficients * x).jacobian * to_coefficients;
         }},
        values, {.parameter_tolerance = 1e-5, .gradient_tolerance = 1e-9});
    return to_coefficients * fit.parameters;
}

Eigen::VectorXd maximise_from(const RestitutionLikelihood& likelihood,
                              const std::vector<Eigen::VectorXd>& starts) {
    Eigen::VectorXd best;
    double least = std::numeric_limits<double>::infinity();
    for (const Eigen::VectorXd& start : starts) {
        Eigen::VectorXd found;
        try {
            found = maximise(likelihood, start);
        } catch (const ConvergenceError&) {
            continue;  // another start may do
        }
        const double reached = likelihood.rows(found).residuals.squaredNorm();
        if (reached < least) {
            least = reached;
            best = found;
        }
    }
    if (best.size() == 0) throw ConvergenceError("the fit of the damping curve did not converge");
    return best;
}

Eigen::VectorXd raised(const Eigen::VectorXd& coefficients, int order) {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(order + 1);
    result.head(coefficients.size()) = coefficients;
    return result;
}

Eigen::VectorXd maximise_upwards(const RestitutionLikelihood& likelihood, int order) {
    constexpr int direct = 2;
    const Eigen::VectorXd start = order <= direct
                                      ? starting_coefficients(likelihood.model(), likelihood.data(), order)
                                      : raised(maximise_upwards(likelihood, order - 1), order);
    return maximise(likelihood, start);
}

Eigen::VectorXd maximise_robustly(const ContactModel& model, RestitutionData& data, Eigen::VectorXd start) {
    const std::vector<double> ones(data.rebounds.size(), 1.0);
    for (int i = 0; i < 50; ++i) {
        const RestitutionLikelihood plain(model, {data.rebounds, ones, {}, data.greatest_restitution});
        const Eigen::VectorXd weights =
            gsl::bisquare_weights(plain.rows(start).residuals, static_cast<int>(start.size()));
        double change = 0.0;
        for (std::size_t j = 0; j < ones.size(); ++j) {
            const double weight = weights[static_cast<Eigen::Index>(j)];
            change = std::max(change, std::abs(weight - data.weights[j]));
            data.weights[j] = weight;
        }
        if (change < 1e-4) break;
        start = maximise(RestitutionLikelihood(model, data), start);
    }
    return start;
}

Interval profile_critical_damping(const RestitutionLikelihood& likelihood, const Eigen::VectorXd& best,
                                  double quantile) {
    const auto information = likelihood.information(best);
    const Eigen::MatrixXd covariance = information.covariance();
    const RestitutionLikelihood::Information same{information.curvature, information.curvature};
    const Eigen::MatrixXd of_curvature = same.covariance();
    // Evidence that is counted twice makes the likelihood too narrow; its rise is taken by as much higher.
    const double correction = std::max(1.0, covariance(0, 0) / of_curvature(0, 0));
    const Eigen::VectorXd along = of_curvature.col(0) / of_curvature(0, 0);
    const double least = likelihood.rows(best).residuals.squaredNorm();
    const Eigen::MatrixXd to_coefficients = coefficients_from_values(likelihood, best.size());
    const Eigen::MatrixXd to_values = to_coefficients.inverse();
    const auto profile = [&](double value) {
        const Eigen::VectorXd start = best + (value - best[0]) * along;
        return least_with(likelihood, to_coefficients, to_values * start) - least;
    };
    return profile_interval(profile, {.best = best[0],
                                      .deviation = std::sqrt(covariance(0, 0)),
                                      .rise = quantile * quantile * correction,
                                      .quantile = quantile,
                                      .least = 1e-3 * best[0],
                                      .greatest = 1e3 * best[0]});
}

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/extrapolation/closest_curve.hpp"

#include <algorithm>
#include <cmath>

#include "solver/damping/damping_polynomial.hpp"
#include "solver/numeric/gsl/minimum.hpp"
#include "solver/numeric/gsl/nonlinear_fit.hpp"
#include "solver/numeric/gsl/robust.hpp"

namespace ashimpact {

namespace {

/// Matrix from values of eta at evenly spaced restitutions, the first at e = 0, to coefficients. A fit of the
/// values is better conditioned, because coefficients of different powers differ in size.
Eigen::MatrixXd coefficients_from_values(double greatest_restitution, Eigen::Index count) {
    Eigen::MatrixXd powers(count, count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const double share = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0.0;
        powers.row(i) =
            DampingPolynomial::powers(share * greatest_restitution, static_cast<int>(count) - 1).transpose();
    }
    return powers.inverse();
}

/// Some of many rebounds, evenly over the file.
RestitutionData thinned(const RestitutionData& data, std::size_t count) {
    RestitutionData few{{}, {}, data.greatest_restitution};
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t place = i * data.rebounds.size() / count;
        few.rebounds.push_back(data.rebounds[place]);
        few.weights.push_back(data.weights[place]);
    }
    return few;
}

constexpr std::size_t some = 2000;  ///< give a start from which few steps through all are left

/// Coefficients of least squares where they may have kinks: the nearest point of the curve can jump from one
/// of its branches to another.
Eigen::VectorXd closest_over_kinks(const ContactModel& model, const RestitutionData& data,
                                   const Eigen::VectorXd& start) {
    const RestitutionDistances distances(model, data);
    const Eigen::MatrixXd to_coefficients = coefficients_from_values(data.greatest_restitution, start.size());
    const auto sum = [&](const Eigen::VectorXd& x) {
        return distances.rows(to_coefficients * x).residuals.squaredNorm();
    };
    const Eigen::VectorXd values = to_coefficients.partialPivLu().solve(start);
    const double step = 0.02 * values.cwiseAbs().maxCoeff();
    return to_coefficients * gsl::minimise(sum, values, Eigen::VectorXd::Constant(values.size(), step));
}

}  // namespace

Eigen::VectorXd closest(const ContactModel& model, const RestitutionData& data,
                        const Eigen::VectorXd& start) {
    const RestitutionDistances distances(model, data);
    const Eigen::MatrixXd to_coefficients = coefficients_from_values(data.greatest_restitution, start.size());
    constexpr std::size_t many = 20000;
    const Eigen::VectorXd near =
        data.rebounds.size() > many ? closest(model, thinned(data, some), start) : start;
    const gsl::NonlinearProblem problem{
        .residuals = [&](const Eigen::VectorXd& x) { return distances.rows(to_coefficients * x).residuals; },
        .jacobian = [&](const Eigen::VectorXd& x) -> Eigen::MatrixXd {
            return distances.rows(to_coefficients * x).jacobian * to_coefficients;
        }};
    const gsl::NonlinearFit fit =
        gsl::fit_nonlinear(problem, to_coefficients.partialPivLu().solve(near),
                           {.parameter_tolerance = 1e-8, .gradient_tolerance = 1e-12, .smooth = false});
    const Eigen::VectorXd coefficients = to_coefficients * fit.parameters;
    return fit.stationary ? coefficients : closest_over_kinks(model, data, coefficients);
}

Eigen::VectorXd closest_robustly(const ContactModel& model, RestitutionData& data, Eigen::VectorXd start) {
    RestitutionData plain = data;
    for (int i = 0; i < 50; ++i) {
        const Eigen::VectorXd weights = gsl::bisquare_weights(
            RestitutionDistances(model, plain).rows(start).residuals, static_cast<int>(start.size()));
        double change = 0.0;
        for (std::size_t j = 0; j < data.weights.size(); ++j) {
            const double weight = weights[static_cast<Eigen::Index>(j)];
            change = std::max(change, std::abs(weight - data.weights[j]));
            data.weights[j] = weight;
        }
        if (change < 1e-4) break;
        start = closest(model, data, start);
    }
    return start;
}

}  // namespace ashimpact

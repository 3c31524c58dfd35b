// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/extrapolation/closest_curve.hpp"

#include <algorithm>
#include <cmath>

#include "solver/batch/parallel.hpp"
#include "solver/damping/damping_polynomial.hpp"
#include "solver/numeric/gsl/fit.hpp"
#include "solver/numeric/gsl/search.hpp"

namespace ashimpact {

namespace {

constexpr double no_curve = 1e4;              ///< residual of every row if the curve does not exist
constexpr std::size_t many_rebounds = 20000;  ///< rebounds, from which some of them give the start of the fit
constexpr std::size_t some_rebounds =
    2000;                               ///< rebounds give a start from which few steps through all are left
constexpr int most_reweighted = 50;     ///< passes of a robust fit
constexpr double steady_weight = 1e-4;  ///< change of weights at which a robust fit has converged
constexpr double parameter_tolerance = 1e-8;  ///< relative: far below the uncertainty of any coefficient
constexpr double gradient_tolerance = 1e-12;

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

RestitutionDistances::RestitutionDistances(const ContactModel& model, const RestitutionData& data)
    : model_(&model), data_(&data) {}

const RestitutionDistances::Rows& RestitutionDistances::rows(const Eigen::VectorXd& coefficients) const {
    if (last_.size() != coefficients.size() || last_ != coefficients) {
        rows_ = computed(coefficients);
        last_ = coefficients;
    }
    return rows_;
}

RestitutionDistances::Rows RestitutionDistances::computed(const Eigen::VectorXd& coefficients) const {
    const auto count = static_cast<Eigen::Index>(data_->rebounds.size());
    const int order = static_cast<int>(coefficients.size()) - 1;
    Rows rows{Eigen::VectorXd::Constant(count, no_curve), Eigen::MatrixXd::Zero(count, order + 1), {}};
    const auto curve = RestitutionCurve::implied_by(*model_, {coefficients}, data_->greatest_restitution,
                                                    curve_ ? &*curve_ : nullptr);
    if (!curve) return rows;
    rows.restitutions.resize(data_->rebounds.size());
    const auto add = [&](std::size_t point) {
        const auto i = static_cast<Eigen::Index>(point);
        const Measurement& rebound = data_->rebounds[point];
        const auto nearest = curve->project(rebound, *rebound.noise, start_of(point));
        const double weight = std::sqrt(data_->weights[point]);
        rows.residuals[i] = weight * nearest.distance;
        rows.jacobian.row(i) =
            weight * nearest.by_damping * DampingPolynomial::powers(nearest.restitution, order).transpose();
        rows.restitutions[point] = nearest.restitution;
    };
    constexpr std::size_t chunk = 1000;
    batch::for_chunks(data_->rebounds.size(), chunk, 0, [&](std::size_t first, std::size_t size) {
        for (std::size_t point = first; point < first + size; ++point) add(point);
    });
    curve_ = curve;
    return rows;
}

double RestitutionDistances::start_of(std::size_t rebound) const {
    if (!rows_.restitutions.empty()) return rows_.restitutions[rebound];
    return std::clamp(data_->rebounds[rebound].restitution(), 0.0, data_->greatest_restitution);
}

Eigen::MatrixXd covariance_from(const Eigen::MatrixXd& jacobian) {
    // Scaled to unit diagonal first: the powers of e differ by orders of magnitude.
    const Eigen::VectorXd scale = jacobian.colwise().norm().cwiseInverse();
    const Eigen::MatrixXd scaled = jacobian * scale.asDiagonal();
    const Eigen::MatrixXd inverse =
        (scaled.transpose() * scaled).ldlt().solve(Eigen::MatrixXd::Identity(scale.size(), scale.size()));
    return scale.asDiagonal() * inverse * scale.asDiagonal();
}

Eigen::VectorXd closest(const ContactModel& model, const RestitutionData& data,
                        const Eigen::VectorXd& start) {
    const RestitutionDistances distances(model, data);
    const Eigen::MatrixXd to_coefficients = coefficients_from_values(data.greatest_restitution, start.size());
    const Eigen::VectorXd near =
        data.rebounds.size() > many_rebounds ? closest(model, thinned(data, some_rebounds), start) : start;
    const gsl::NonlinearProblem problem{
        .residuals = [&](const Eigen::VectorXd& x) { return distances.rows(to_coefficients * x).residuals; },
        .jacobian = [&](const Eigen::VectorXd& x) -> Eigen::MatrixXd {
            return distances.rows(to_coefficients * x).jacobian * to_coefficients;
        }};
    const gsl::NonlinearFit fit = gsl::fit_nonlinear(problem, to_coefficients.partialPivLu().solve(near),
                                                     {.parameter_tolerance = parameter_tolerance,
                                                      .gradient_tolerance = gradient_tolerance,
                                                      .smooth = false});
    const Eigen::VectorXd coefficients = to_coefficients * fit.parameters;
    return fit.stationary ? coefficients : closest_over_kinks(model, data, coefficients);
}

Eigen::VectorXd closest_robustly(const ContactModel& model, RestitutionData& data, Eigen::VectorXd start) {
    RestitutionData plain = data;
    for (int i = 0; i < most_reweighted; ++i) {
        const Eigen::VectorXd weights = gsl::bisquare_weights(
            RestitutionDistances(model, plain).rows(start).residuals, static_cast<int>(start.size()));
        double change = 0.0;
        for (std::size_t j = 0; j < data.weights.size(); ++j) {
            const double weight = weights[static_cast<Eigen::Index>(j)];
            change = std::max(change, std::abs(weight - data.weights[j]));
            data.weights[j] = weight;
        }
        if (change < steady_weight) break;
        start = closest(model, data, start);
    }
    return start;
}

}  // namespace ashimpact

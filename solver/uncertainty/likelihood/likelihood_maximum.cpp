#include "solver/uncertainty/likelihood/likelihood_maximum.hpp"

#include "materials/base/error.hpp"
#include "solver/gsl/nonlinear_fit.hpp"
#include "solver/gsl/robust.hpp"
#include "solver/numeric/smooth_minimum.hpp"
#include "solver/uncertainty/profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace ashimpact {

namespace {

/// Turns values of eta at restitutions spread over the curve, the first at e = 0, into coefficients. The
/// values are all of one size, the coefficients of high powers are not.
Eigen::MatrixXd coefficients_from_values(double greatest_restitution, Eigen::Index count) {
    Eigen::MatrixXd powers(count, count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const double share = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0.0;
        powers.row(i) =
            DampingPolynomial::powers(share * greatest_restitution, static_cast<int>(count) - 1).transpose();
    }
    return powers.inverse();
}

/// Coefficients as a linear function of variables in which -ln L has a curvature near one.
struct Chart {
    Eigen::VectorXd center;
    Eigen::MatrixXd scales;

    [[nodiscard]] Eigen::VectorXd coefficients(const Eigen::VectorXd& z) const { return center + scales * z; }
};

SmoothFunction in_chart(const ImpactLikelihood& likelihood, const Chart& chart) {
    return {[&likelihood, &chart](const Eigen::VectorXd& z) -> SmoothFunction::Value {
        const auto at = likelihood.at(chart.coefficients(z));
        if (!at) return {std::numeric_limits<double>::infinity(), Eigen::VectorXd::Zero(z.size())};
        return {at->value, chart.scales.transpose() * at->gradient};
    }};
}

/// Curvature of -ln L at the centre of a chart, by differences of the gradient; none at the edge of where
/// there is a curve.
std::optional<Eigen::MatrixXd> curvature_of(const ImpactLikelihood& likelihood, const Chart& chart,
                                            double step) {
    const SmoothFunction function = in_chart(likelihood, chart);
    const Eigen::Index size = chart.scales.cols();
    Eigen::MatrixXd curvature(size, size);
    for (Eigen::Index i = 0; i < size; ++i) {
        const Eigen::VectorXd shift = step * Eigen::VectorXd::Unit(size, i);
        const auto above = function.evaluate(shift);
        const auto below = function.evaluate(-shift);
        if (!std::isfinite(above.value) || !std::isfinite(below.value)) return std::nullopt;
        curvature.col(i) = (above.gradient - below.gradient) / (2.0 * step);
    }
    return 0.5 * (curvature + curvature.transpose());
}

/// Scales of variables in which that curvature is one; directions that bend the wrong way or hardly at all
/// are taken as hardly bent.
Eigen::MatrixXd scales_of(const Eigen::MatrixXd& curvature) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(curvature);
    const double least = 1e-6 * eigen.eigenvalues().cwiseAbs().maxCoeff();
    const Eigen::VectorXd size = eigen.eigenvalues().cwiseAbs().cwiseMax(least).cwiseSqrt();
    return eigen.eigenvectors() * size.cwiseInverse().asDiagonal();
}

/// Scales of all coefficients but the first, given the first.
Eigen::MatrixXd scales_without_first(const Eigen::MatrixXd& covariance) {
    const Eigen::Index others = covariance.rows() - 1;
    Eigen::MatrixXd scales = Eigen::MatrixXd::Zero(others + 1, others);
    if (others == 0) return scales;
    const Eigen::VectorXd along = covariance.col(0).tail(others) / covariance(0, 0);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(covariance.bottomRightCorner(others, others) -
                                                               covariance(0, 0) * along * along.transpose());
    scales.bottomRows(others) =
        eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
    return scales;
}

/// A chart around a start, by the curvature there.
Chart chart_around(const ImpactLikelihood& likelihood, const Eigen::VectorXd& start) {
    const double small = 2e-4 * std::abs(start[0]);
    Chart values{start,
                 small * coefficients_from_values(likelihood.data().greatest_restitution, start.size())};
    const auto curvature = curvature_of(likelihood, values, 1.0);
    if (curvature) values.scales *= scales_of(*curvature);
    return values;
}

/// Least -ln L, by variables in which its curvature is about one; the chart ends there, with the curvature
/// learnt on the way. None where the search ends elsewhere.
/// @param rounds in which the places of the integrals are renewed
std::optional<double> descend(ImpactLikelihood& likelihood, Chart& chart, int rounds = 4) {
    constexpr double far = 30.0;  // standard uncertainties within which the places of the integrals serve
    for (int i = 0; i < rounds; ++i) {
        likelihood.move_to(chart.center);
        const SmoothMinimum minimum =
            minimise(in_chart(likelihood, chart), Eigen::VectorXd::Zero(chart.scales.cols()),
                     {.first_step = 3.0, .most_evaluations = 40});
        chart.center = chart.coefficients(minimum.place);
        chart.scales *= scales_of(minimum.curvature);
        if (minimum.converged && minimum.place.norm() < far) return minimum.value;
    }
    return std::nullopt;
}

}  // namespace

Eigen::VectorXd closest(const ContactModel& model, const RestitutionData& data,
                        const Eigen::VectorXd& start) {
    const RestitutionDistances distances(model, data);
    const Eigen::MatrixXd to_coefficients = coefficients_from_values(data.greatest_restitution, start.size());
    const Eigen::VectorXd values = to_coefficients.partialPivLu().solve(start);
    const gsl::NonlinearFit fit = gsl::fit_nonlinear(
        {.residuals = [&](const Eigen::VectorXd& x) { return distances.rows(to_coefficients * x).residuals; },
         .jacobian = [&](const Eigen::VectorXd& x) -> Eigen::MatrixXd {
             return distances.rows(to_coefficients * x).jacobian * to_coefficients;
         }},
        values, {.parameter_tolerance = 1e-8, .gradient_tolerance = 1e-12});
    return to_coefficients * fit.parameters;
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

LikelihoodMaximum maximise(ImpactLikelihood& likelihood, const Eigen::VectorXd& start,
                           const std::optional<Eigen::MatrixXd>& covariance) {
    likelihood.move_to(start);
    Chart chart = covariance ? Chart{start, covariance->llt().matrixL()} : chart_around(likelihood, start);
    const auto value = descend(likelihood, chart, covariance ? 1 : 4);  // where it is known, few steps do
    if (!value) throw ConvergenceError("the likelihood of the damping curve has no maximum");
    likelihood.move_to(chart.center);
    const auto curvature = curvature_of(likelihood, chart, 0.02);
    if (!curvature)
        throw ConvergenceError("the most likely damping curve is at the edge of what is possible");
    const Eigen::MatrixXd deviations = chart.scales * scales_of(*curvature);
    return {chart.center, *value, deviations * deviations.transpose()};
}

LikelihoodMaximum maximise_from(ImpactLikelihood& likelihood, const std::vector<Eigen::VectorXd>& starts) {
    std::optional<LikelihoodMaximum> best;
    std::string reason;
    for (const Eigen::VectorXd& start : starts) {
        try {
            LikelihoodMaximum found = maximise(likelihood, start);
            if (!best || found.value < best->value) best = std::move(found);
        } catch (const ConvergenceError& error) {
            reason = error.what();  // another start may do
        }
    }
    if (!best) throw ConvergenceError(reason);
    return *best;
}

Interval profile_critical_damping(ImpactLikelihood& likelihood, const LikelihoodMaximum& best,
                                  double quantile) {
    const Eigen::VectorXd along = best.covariance.col(0) / best.covariance(0, 0);
    const Eigen::MatrixXd scales = scales_without_first(best.covariance);
    const auto profile = [&](double critical_damping) {
        Chart chart{best.coefficients + (critical_damping - best.coefficients[0]) * along, scales};
        if (!RestitutionCurve::of(likelihood.model(), {chart.center}, likelihood.data().greatest_restitution))
            return std::numeric_limits<double>::max();
        if (scales.cols() == 0) return 2.0 * (likelihood.at(chart.center)->value - best.value);
        const auto value = descend(likelihood, chart);
        if (!value) throw ConvergenceError("the profile likelihood of the damping did not converge");
        return 2.0 * (*value - best.value);
    };
    return profile_interval(profile, {.best = best.coefficients[0],
                                      .deviation = std::sqrt(best.covariance(0, 0)),
                                      .rise = quantile * quantile,
                                      .quantile = quantile,
                                      .least = 1e-3 * best.coefficients[0],
                                      .greatest = 1e3 * best.coefficients[0]});
}

}  // namespace ashimpact

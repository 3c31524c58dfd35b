#include "solver/uncertainty/restitution_likelihood.hpp"

#include "solver/gsl/distribution.hpp"

#include <algorithm>
#include <cmath>

namespace ashimpact {

namespace {

constexpr double nowhere = 1e4;  ///< residual of every row where the curve does not exist
constexpr double certain = 7.0;  ///< standard uncertainties beyond which an outcome says nothing

/// How far, in standard uncertainties, an outcome lies on the side of v_c that it belongs to.
double margin_of(const ImpactOutcome& outcome, double critical_velocity) {
    const double margin = (critical_velocity - outcome.velocity) / outcome.standard_uncertainty;
    return outcome.captured ? margin : -margin;
}

}  // namespace

RestitutionLikelihood::RestitutionLikelihood(const ContactModel& model, RestitutionData data)
    : model_(&model), data_(std::move(data)) {}

const RestitutionLikelihood::Rows& RestitutionLikelihood::rows(const Eigen::VectorXd& coefficients) const {
    if (last_.size() != coefficients.size() || last_ != coefficients) {
        rows_ = computed(coefficients);
        last_ = coefficients;
    }
    return rows_;
}

RestitutionLikelihood::Rows RestitutionLikelihood::computed(const Eigen::VectorXd& coefficients) const {
    const auto rebounds = static_cast<Eigen::Index>(data_.rebounds.size());
    const auto count = rebounds + static_cast<Eigen::Index>(data_.outcomes.size());
    const int order = static_cast<int>(coefficients.size()) - 1;
    Rows rows{Eigen::VectorXd::Constant(count, nowhere), Eigen::MatrixXd::Zero(count, order + 1), {}};
    const auto curve = RestitutionCurve::of(*model_, {coefficients}, data_.greatest_restitution,
                                            curve_ ? &*curve_ : nullptr);
    if (!curve) return rows;

    for (Eigen::Index i = 0; i < rebounds; ++i) {
        const Measurement& point = data_.rebounds[static_cast<std::size_t>(i)];
        const auto nearest = curve->project(point, *point.noise, start_of(static_cast<std::size_t>(i)));
        const double weight = std::sqrt(data_.weights[static_cast<std::size_t>(i)]);
        rows.residuals[i] = weight * nearest.distance;
        rows.jacobian.row(i) =
            weight * nearest.by_damping * DampingPolynomial::powers(nearest.restitution, order).transpose();
        rows.restitutions.push_back(nearest.restitution);
    }
    const RestitutionCurve::Place capture = curve->at(0.0);
    for (Eigen::Index i = rebounds; i < count; ++i) {
        const ImpactOutcome& outcome = data_.outcomes[static_cast<std::size_t>(i - rebounds)];
        const double z = margin_of(outcome, capture.velocity);
        rows.residuals[i] = z > certain ? 0.0 : std::sqrt(-2.0 * gsl::log_normal_probability(z));
        if (z > certain) continue;
        const double towards = (outcome.captured ? 1.0 : -1.0) / outcome.standard_uncertainty;
        rows.jacobian(i, 0) =
            -gsl::log_normal_probability_slope(z) / rows.residuals[i] * towards * capture.by_damping;
    }
    curve_ = curve;
    return rows;
}

double RestitutionLikelihood::start_of(std::size_t rebound) const {
    if (!rows_.restitutions.empty()) return rows_.restitutions[rebound];
    return std::clamp(data_.rebounds[rebound].restitution(), 0.0, data_.greatest_restitution);
}

RestitutionLikelihood::Information RestitutionLikelihood::information(
    const Eigen::VectorXd& coefficients) const {
    const auto size = coefficients.size();
    const auto rebounds = static_cast<Eigen::Index>(data_.rebounds.size());
    const auto curve = RestitutionCurve::of(*model_, {coefficients}, data_.greatest_restitution);
    const Eigen::MatrixXd jacobian = rows(coefficients).jacobian.topRows(rebounds);
    Information result{jacobian.transpose() * jacobian, Eigen::MatrixXd::Zero(size, size)};
    result.variability = result.curvature;
    if (!curve || data_.outcomes.empty()) return result;

    const RestitutionCurve::Place capture = curve->at(0.0);
    const auto slope = &gsl::log_normal_probability_slope;
    double outcome_information = 0.0;
    for (const ImpactOutcome& outcome : data_.outcomes) {
        const double z = margin_of(outcome, capture.velocity);
        if (std::abs(z) > certain) continue;
        const double scaled = capture.by_damping / outcome.standard_uncertainty;
        outcome_information += slope(z) * slope(-z) * scaled * scaled;
    }
    result.curvature(0, 0) += outcome_information;
    result.variability(0, 0) += outcome_information;
    for (Eigen::Index i = 0; i < rebounds; ++i) {
        const Measurement& point = data_.rebounds[static_cast<std::size_t>(i)];
        const auto nearest = curve->project(point, *point.noise, start_of(static_cast<std::size_t>(i)));
        const double z = (nearest.velocity - capture.velocity) / std::sqrt(point.noise->incident);
        const double bend = slope(z) * (z + slope(z));  // -(ln Phi)''
        const double shared = -nearest.by_velocity / point.noise->incident * bend * capture.by_damping;
        result.variability.row(0) += shared * jacobian.row(i);
        result.variability.col(0) += shared * jacobian.row(i).transpose();
    }
    return result;
}

Eigen::MatrixXd RestitutionLikelihood::Information::covariance() const {
    // Scaled to unit diagonal first: the powers of e differ by orders of magnitude.
    const Eigen::VectorXd scale = curvature.diagonal().cwiseSqrt().cwiseInverse();
    const Eigen::MatrixXd scaled = scale.asDiagonal() * curvature * scale.asDiagonal();
    const Eigen::MatrixXd inverse =
        scale.asDiagonal() * scaled.ldlt().solve(Eigen::MatrixXd::Identity(scale.size(), scale.size())) *
        scale.asDiagonal();
    return inverse * variability * inverse;
}

}  // namespace ashimpact

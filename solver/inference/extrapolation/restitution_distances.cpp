// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/extrapolation/restitution_distances.hpp"

#include <algorithm>
#include <cmath>

#include "solver/batch/parallel.hpp"

namespace ashimpact {

namespace {

constexpr double no_curve = 1e4;  ///< residual of every row if the curve does not exist

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
    const auto curve = RestitutionCurve::of(*model_, {coefficients}, data_->greatest_restitution,
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

}  // namespace ashimpact

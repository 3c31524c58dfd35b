// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

#include <Eigen/Dense>

#include "solver/batch/parallel.hpp"
#include "solver/statistics/design.hpp"
#include "solver/statistics/interval.hpp"

namespace ashimpact {

/// Weighted draws from normal densities, by a Sobol sequence: adaptive importance sampling (Cornuet et al.
/// 2012, Scand. J. Stat. 39:798). Thread-safe is only what is const.
template <int size>
class ImportanceSampling {
  public:
    using Vector = Eigen::Matrix<double, size, 1>;
    using Matrix = Eigen::Matrix<double, size, size>;

    /// A normal density from which points are drawn.
    struct NormalDensity {
        Vector mean;
        Matrix covariance;
    };

    /// @param negative_log_density -ln of a density that need not be normalised; called by several threads
    explicit ImportanceSampling(std::function<double(const Vector&)> negative_log_density)
        : function_(std::move(negative_log_density)) {}

    void add(const NormalDensity& normal, std::size_t count) {
        proposals_.push_back({normal, normal.covariance.llt().matrixL(), static_cast<double>(count)});
        const Proposal& proposal = proposals_.back();
        static const DigitalSequence sequence(QuasiRandomSequence::sobol, size);
        std::vector<std::uint64_t> digits(count);
        const std::size_t first = point_.size();
        point_.resize(first + count, Vector::Zero());
        for (int axis = 0; axis < size; ++axis) {
            sequence.fill(static_cast<std::size_t>(axis), first + 1, digits);
            for (std::size_t i = 0; i < count; ++i)
                point_[first + i][axis] = gsl::normal_quantile(unit_interval(digits[i]));
        }
        value_.resize(point_.size());
        density_.resize(point_.size());
        log_weight_.resize(point_.size());
        batch::for_each_item(count, [&](std::size_t i) {
            Vector& point = point_[first + i];
            point = normal.mean + scales[i % scales.size()] * (proposal.factor * point);
            value_[first + i] = function_(point);
        });
        // Weights: the density over the mixture of all densities drawn from (Owen & Zhou 2000, J. Am. Stat.
        // Assoc. 95:135), of which earlier points lack the last one only.
        batch::for_each_item(point_.size(), [&](std::size_t i) {
            for (std::size_t k = i < first ? proposals_.size() - 1 : 0; k < proposals_.size(); ++k)
                density_[i] += proposals_[k].density(point_[i]);
            log_weight_[i] = -value_[i] - std::log(std::max(density_[i], 1e-300));
        });
    }

    /// Mean and covariance of the density; while it has few effective draws, those of a power of it below 1,
    /// which is wider.
    [[nodiscard]] NormalDensity moments() const {
        constexpr double enough = 60.0;
        std::vector<double> weight = weights(1.0);
        for (double power = 1.0; effective(weight) < enough; weight = weights(power)) power *= 0.7;
        NormalDensity normal{Vector::Zero(), Matrix::Zero()};
        for (std::size_t i = 0; i < point_.size(); ++i) normal.mean += weight[i] * point_[i];
        for (std::size_t i = 0; i < point_.size(); ++i)
            normal.covariance +=
                weight[i] * (point_[i] - normal.mean) * (point_[i] - normal.mean).transpose();
        return normal;
    }

    /// Effective sample size: the number of independent draws that would be as accurate.
    [[nodiscard]] double effective() const { return effective(weights(1.0)); }

    /// The draw of greatest density.
    [[nodiscard]] const Vector& likeliest() const {
        return point_[static_cast<std::size_t>(std::min_element(value_.begin(), value_.end()) -
                                               value_.begin())];
    }

    /// The distribution of one parameter, or of a function of it.
    [[nodiscard]] MarginalSample marginal(
        int axis, const std::function<double(double)>& of = [](double x) { return x; }) const {
        const std::vector<double> weight = weights(1.0);
        std::vector<std::pair<double, double>> values;
        values.reserve(point_.size());
        for (std::size_t i = 0; i < point_.size(); ++i) values.emplace_back(of(point_[i][axis]), weight[i]);
        return MarginalSample(std::move(values));
    }

  private:
    [[nodiscard]] static double effective(const std::vector<double>& weight) {
        return 1.0 / std::inner_product(weight.begin(), weight.end(), weight.begin(), 0.0);
    }

    /// Factors on the width of consecutive draws: some are wider, in case the density has longer tails.
    static constexpr std::array scales{1.0, 1.0, 1.5, 1.0, 2.2};

    struct Proposal {
        NormalDensity normal;
        Matrix factor;
        double count;

        [[nodiscard]] double density(const Vector& point) const {
            const double distance =
                factor.template triangularView<Eigen::Lower>().solve(point - normal.mean).squaredNorm();
            double sum = 0.0;
            for (const double scale : scales)
                sum += std::exp(-0.5 * distance / (scale * scale)) / std::pow(scale, size);
            return count * sum / factor.diagonal().prod();
        }
    };

    /// The weights to a power, normalised to a sum of 1.
    [[nodiscard]] std::vector<double> weights(double power) const {
        const double best = *std::max_element(log_weight_.begin(), log_weight_.end());
        std::vector<double> result;
        double total = 0.0;
        for (const double log_weight : log_weight_)
            total += result.emplace_back(std::exp(power * (log_weight - best)));
        for (double& weight : result) weight /= total;
        return result;
    }

    std::function<double(const Vector&)> function_;
    std::vector<Proposal> proposals_;
    std::vector<Vector> point_;
    std::vector<double> value_;
    std::vector<double> density_;  ///< of the mixture
    std::vector<double> log_weight_;
};

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/surrogate/restitution_section.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solver/numeric/chebyshev.hpp"

namespace ashimpact {

namespace {

constexpr int fewest_pieces = 2;
constexpr int most_pieces = 64;
constexpr double negligible = 3e-14;  ///< share of the last coefficients in the greatest one

}  // namespace

RestitutionSection::RestitutionSection(std::shared_ptr<const RestitutionMap> map, double restitution,
                                       VelocityRange range)
    : map_(std::move(map)), restitution_(restitution), range_(range) {
    // Below it no impact reaches the restitution.
    const double least = map_->lowest() - 0.5 * std::log1p(-restitution * restitution);
    range_ = {std::max({map_->range().lower, least, range.lower}),
              std::min(map_->range().upper, range.upper)};
    if (!(range_.lower < range_.upper)) return;
    for (int pieces = fewest_pieces; pieces <= most_pieces; pieces *= 2)
        if (divide(pieces)) return;
    pieces_.clear();
}

bool RestitutionSection::divide(int pieces) {
    static const Eigen::MatrixXd analysis = ChebyshevAxis{-1.0, 1.0, degree}.analysis();
    static const Eigen::MatrixXd by_powers = chebyshev_by_powers(degree + 1);
    pieces_.clear();
    width_ = (range_.upper - range_.lower) / pieces;
    for (int i = 0; i < pieces; ++i) {
        const ChebyshevAxis axis{range_.lower + i * width_, range_.lower + (i + 1) * width_, degree};
        Eigen::VectorXd values(degree + 1);
        for (int k = 0; k <= degree; ++k) values[k] = map_->number(restitution_, axis.node(k));
        const Eigen::VectorXd coefficients = analysis * values;
        if (coefficients.tail<2>().cwiseAbs().maxCoeff() > negligible * coefficients.cwiseAbs().maxCoeff())
            return false;
        Eigen::Map<Eigen::VectorXd>(pieces_.emplace_back().data(), degree + 1) = by_powers * coefficients;
    }
    return true;
}

RestitutionSection::Place RestitutionSection::place_of(double x) const {
    if (pieces_.empty() || !range_.contains(x)) return {nullptr, 0.0};
    const double position = (x - range_.lower) / width_;
    const auto last = static_cast<double>(pieces_.size() - 1);
    const double piece = std::clamp(std::floor(position), 0.0, last);
    return {&pieces_[static_cast<std::size_t>(piece)], 2.0 * (position - piece) - 1.0};
}

NumberAlongX RestitutionSection::number_along_x(double x) const {
    const auto [powers, t] = place_of(x);
    if (powers == nullptr) return map_->number_along_x(restitution_, x);
    double value = powers->back();
    double slope = 0.0;
    for (std::size_t k = degree; k-- > 0;) {
        slope = slope * t + value;
        value = value * t + (*powers)[k];
    }
    return {value, slope * 2.0 / width_};
}

double RestitutionSection::number(double x) const {
    const auto [powers, t] = place_of(x);
    if (powers == nullptr) return map_->number(restitution_, x);
    double value = powers->back();
    for (std::size_t k = degree; k-- > 0;) value = value * t + (*powers)[k];
    return value;
}

}  // namespace ashimpact

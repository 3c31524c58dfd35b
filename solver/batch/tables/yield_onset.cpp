// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/batch/tables/yield_onset.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "solver/contact/thornton_ning.hpp"
#include "solver/motion/scale.hpp"
#include "solver/numeric/chebyshev.hpp"
#include "solver/numeric/interpolation.hpp"
#include "solver/numeric/polynomial.hpp"

namespace ashimpact::batch {

namespace {

constexpr int onset_terms = YieldOnset::terms;
constexpr int onset_layers = YieldOnset::layers;

/// Searches the velocity at which an elastic contact turns at its yield point, in units of the length at
/// which the yield number is 1.
class OnsetSearch {
  public:
    OnsetSearch(double yield_adhesion, double damping)
        : numbers_{0.0, damping, yield_adhesion},
          yield_(YieldedContact<double>{power<3>(yield_adhesion), 1.0}.yield_point()),
          square_of_turn_(yield_) {
        const auto u = Polynomial<double>::identity();
        const Jkr<double> law{power<3>(yield_adhesion)};
        potential_ = (law.overlap(u).derivative() * law.force(u)).antiderivative();
        numbers_.velocity_squared = (potential_(yield_) - potential_(law.touch())) * (1.0 + damping);
    }

    /// The impact to try next.
    [[nodiscard]] const YieldNumbers& numbers() const { return numbers_; }
    [[nodiscard]] bool converged() const { return converged_; }
    /// @param turn u at the turn of the impact tried
    void observe(double turn) {
        constexpr double accuracy = 1e-9;
        double& square = numbers_.velocity_squared;
        if (converged_) return;
        if (!std::isfinite(turn)) {  // it creeps, or is in doubt
            square *= 1.5;
            return;
        }
        square_of_turn_.insert({.value = turn, .x = square});
        double next = square_of_turn_.count() > 1
                          ? square_of_turn_.interpolated()
                          : square + 2.0 * (potential_(yield_) - potential_(turn));  // but for damping
        if (!std::isfinite(next)) next = square;
        next = std::clamp(next, 0.3 * square, 3.0 * square);
        converged_ = std::abs(next - square) < accuracy * square;
        square = next;
    }

  private:
    YieldNumbers numbers_;
    double yield_;                            ///< u
    InverseInterpolation<5> square_of_turn_;  ///< of the velocity: the turn is smooth in it
    Polynomial<double> potential_;
    bool converged_ = false;
};

/// Tries all searches once.
void try_all(NumberKernel kernel, DampingLaw damping_law, std::vector<OnsetSearch>& searches) {
    const std::size_t count = searches.size();
    std::vector<double> adhesion;
    std::vector<double> damping;
    std::vector<double> root;
    std::vector<LaneEnd> end(count);
    std::vector<double> turn(count);
    std::vector<double> time(count);
    for (const OnsetSearch& search : searches) {
        const ImpactNumbers impact = impact_numbers(search.numbers(), damping_law);
        adhesion.push_back(impact.adhesion);
        damping.push_back(impact.damping);
        root.push_back(std::sqrt(impact.yield_number));
    }
    kernel({.damping_law = damping_law,
            .detachment = ThorntonNing<double>::default_detachment,
            .part = ImpactPart::approach,
            .count = count,
            .adhesion = adhesion.data(),
            .damping = damping.data(),
            .yield_number = nullptr,
            .curve = nullptr,
            .end = end.data(),
            .speed = turn.data(),
            .time = time.data()});
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; i < count; ++i)
        searches[i].observe(end[i] == LaneEnd::rebound ? turn[i] / root[i] : nothing);
}

}  // namespace

ImpactNumbers impact_numbers(const YieldNumbers& impact, DampingLaw damping_law) {
    const double y = std::pow(impact.velocity_squared, -0.2);
    const Scale unit{
        .mass = 1.0, .stiffness = 1.0, .velocity = y * y * std::sqrt(y), .length = y * y, .radius_length = y};
    return {.adhesion = power<3>(impact.yield_adhesion) * y * std::sqrt(y),
            .damping = impact.damping * unit.damping_unit(damping_law),
            .yield_number = y};
}

YieldOnset::YieldOnset(NumberKernel kernel, DampingLaw damping_law, const NumberSpan& span) {
    constexpr int most_trials = 24;
    const ChebyshevAxis place{0.0, greatest_place, onset_terms - 1};
    const ChebyshevAxis layer{-1.0, 1.0, onset_layers - 1};
    std::vector<OnsetSearch> searches;
    for (int k = 0; k < onset_layers; ++k)
        for (int j = 0; j < onset_terms; ++j)
            searches.emplace_back(span.number_at(layer.node(k)), place.node(j) / (1.0 - place.node(j)));
    for (int trial = 0; trial < most_trials; ++trial) {
        if (std::ranges::all_of(searches, &OnsetSearch::converged)) break;
        try_all(kernel, damping_law, searches);
    }
    known_ = std::ranges::all_of(searches, &OnsetSearch::converged);
    Eigen::Matrix<double, onset_terms, onset_layers> values;
    for (int k = 0; k < onset_layers; ++k)
        for (int j = 0; j < onset_terms; ++j)
            values(j, k) = searches[static_cast<std::size_t>(k * onset_terms + j)].numbers().velocity_squared;
    const Eigen::Matrix<double, onset_terms, onset_layers> coefficients =
        chebyshev_by_powers(onset_terms) * place.analysis() * values * layer.analysis().transpose() *
        chebyshev_by_powers(onset_layers).transpose();
    for (int k = 0; k < onset_layers; ++k)
        for (int j = 0; j < onset_terms; ++j)
            velocity_squared_[static_cast<std::size_t>(k)][static_cast<std::size_t>(j)] = coefficients(j, k);
}

double YieldOnset::velocity_squared_at(double x, double y, double z) const {
    const double t = local(y);
    double sum = 0.0;
    for (std::size_t k = layers; k-- > 0;) {
        double of_layer = 0.0;
        for (std::size_t j = terms; j-- > 0;) of_layer = of_layer * t + velocity_squared_[k][j];
        sum = sum * z + of_layer;
    }
    return sum + margin + unit * std::expm1(x * powers * std::numbers::ln2);
}

}  // namespace ashimpact::batch

// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/surrogate/cohesive_velocity_map.hpp"

#include <algorithm>
#include <cmath>

#include "solver/contact/maugis_dugdale.hpp"
#include "solver/contact/mechanics.hpp"
#include "solver/critical_velocity/backward_orbit.hpp"
#include "solver/motion/scaled_impact.hpp"
#include "solver/numeric/interpolation.hpp"

namespace ashimpact {

namespace {

constexpr int first_degree = 6;
constexpr int greatest_degree = 24;
constexpr double narrowest_axis = 1e-3;  // half width of an axis along which nothing is uncertain

/// ln v_c, in units of Maugis, of the pair with these logarithms of damping and transition parameter.
std::optional<double> scaled_logarithm(const CriticalVelocityProblem& nominal, double x, double y) {
    ContactPair pair{.mass = 1, .effective_radius = 1, .contact_modulus = 1, .work_of_adhesion = 1};
    pair.parameters.set(stated_tabor.name, std::exp(y) / transition_per_tabor());
    const Scale scale = Scale::of(pair, maugis_velocity(pair));
    const Damping damping{nominal.damping.law, scale.damping_coefficient(nominal.damping.law, std::exp(x))};
    const CriticalImpacts critical = critical_impacts(
        scaled_cohesive_motion({nominal.law, nominal.detachment, damping, pair, 1.0}, Precision::standard));
    if (critical.impacts.empty()) return std::nullopt;
    return static_cast<double>(std::log(critical.impacts.front().velocity));
}

constexpr int intervals_of_s = 160;  ///< rows of the table, less one
constexpr double columns_per_x = 8;  ///< the dependence on ln v at fixed phi is weak

}  // namespace

CohesiveNumbers cohesive_numbers(const CriticalVelocityProblem& problem) {
    const Scale scale = Scale::of(problem.contact, maugis_velocity(problem.contact));
    return {.damping = scale.damping_number(problem.damping),
            .lambda = transition_parameter(problem.contact)};
}

CohesiveVelocityMap::CohesiveVelocityMap(const CriticalVelocityProblem& nominal,
                                         const std::array<double, 2>& spread) {
    const CohesiveNumbers centre = cohesive_numbers(nominal);
    if (!(centre.damping > 0)) return;
    centre_ = {std::log(centre.damping), std::log(centre.lambda)};
    spread_ = {std::max(spread[0], narrowest_axis), std::max(spread[1], narrowest_axis)};
    for (int degree = first_degree; degree <= greatest_degree; degree *= 2) {
        const ChebyshevAxis x{centre_[0] - spread_[0], centre_[0] + spread_[0], degree};
        const ChebyshevAxis y{centre_[1] - spread_[1], centre_[1] + spread_[1], degree / 2};
        Eigen::MatrixXd values(x.degree + 1, y.degree + 1);
        for (int i = 0; i <= x.degree; ++i)
            for (int j = 0; j <= y.degree; ++j) {
                const auto value = scaled_logarithm(nominal, x.node(i), y.node(j));
                if (!value) return;
                values(i, j) = *value;
            }
        const ChebyshevSurface surface(x, y, values);
        double error = 0;  // between the nodes, where that of an interpolation is greatest
        for (const double share : {-0.93, -0.13, 0.71}) {
            const double px = centre_[0] + share * spread_[0];
            const double py = centre_[1] - share * spread_[1];
            const auto value = scaled_logarithm(nominal, px, py);
            if (!value) return;
            error = std::max(error, std::abs(surface(px, py).value - *value));
        }
        if (error > 0.1 * accuracy()) continue;
        surface_ = surface;
        return;
    }
}

bool CohesiveVelocityMap::holds(const CohesiveNumbers& numbers) const {
    return surface_ && std::abs(std::log(numbers.damping) - centre_[0]) <= spread_[0] &&
           std::abs(std::log(numbers.lambda) - centre_[1]) <= spread_[1];
}

std::optional<double> CohesiveVelocityMap::operator()(const CriticalVelocityProblem& problem) const {
    const CohesiveNumbers numbers = cohesive_numbers(problem);
    if (!holds(numbers)) return critical_velocity(problem).value;
    return std::exp((*surface_)(std::log(numbers.damping), std::log(numbers.lambda)).value) *
           maugis_velocity(problem.contact);
}

CurveTable::CurveTable(const ContactModel& model, VelocityRange velocities) {
    first_ = std::log(std::max(velocities.lower, model.range().lower));
    const double last = std::log(std::min(velocities.upper, model.range().upper));
    const bool adhesive = model.map().adhesive();
    const auto columns =
        adhesive ? std::max<Eigen::Index>(8, static_cast<Eigen::Index>((last - first_) * columns_per_x)) : 6;
    step_ = (last - first_) / static_cast<double>(columns - 1);
    capture_.resize(columns);
    restitution_ = Eigen::MatrixXd::Zero(intervals_of_s + 1, columns);
    for (Eigen::Index j = 0; j < columns; ++j) {
        const double velocity =
            std::min(std::max(model.range().lower, std::exp(first_ + step_ * static_cast<double>(j))),
                     model.range().upper);
        const double most = model.damping(velocity, 0.0).value;
        capture_[j] = std::log(most);
        if (!adhesive && j > 0) {
            restitution_.col(j) = restitution_.col(0);
            continue;
        }
        double e = 0.0;
        double before = 0.0;
        for (int i = 1; i < intervals_of_s; ++i) {
            const double s = static_cast<double>(i) / intervals_of_s;
            const double found = model.rebound_restitution(velocity, most * (1.0 - s * s),
                                                           {.guess = 2.0 * e - before, .tolerance = 1e-10});
            before = e;
            e = found;
            restitution_(i, j) = e;
        }
        restitution_(intervals_of_s, j) = model.greatest_restitution(velocity);
    }
}

CurveTable::Column CurveTable::column(double x) const {
    const double place = (x - first_) / step_;
    const auto last = static_cast<double>(capture_.size() - 3);
    const double cell = std::clamp(std::floor(place), 1.0, last);
    Column column{};
    column.first = static_cast<Eigen::Index>(cell) - 1;
    column.weight = cubic_weights(place - cell);
    return column;
}

double CurveTable::log_capture_damping(double x) const {
    const Column c = column(x);
    double sum = 0.0;
    for (Eigen::Index i = 0; i < 4; ++i) sum += c.weight[i] * capture_[c.first + i];
    return sum;
}

CurveTable::Value CurveTable::at(double distance, double x) const {
    if (!(distance > 0.0)) return {0.0, 0.0};
    const double rest = std::exp(-distance);
    const double s = std::sqrt(1.0 - rest);
    const double place = s * intervals_of_s;
    const double cell = std::min(std::floor(place), static_cast<double>(intervals_of_s - 1));
    const std::array value = cubic_weights(place - cell);
    const std::array slope = cubic_weight_slopes(place - cell);
    const Column c = column(x);
    const auto low = static_cast<Eigen::Index>(cell) - 1;
    double e = 0.0;
    double by_s = 0.0;
    for (Eigen::Index j = 0; j < 4; ++j) {
        const double* values = restitution_.data() + (c.first + j) * restitution_.rows();
        // Beyond the ends the values are extrapolated by a parabola through the last three.
        const double first = low < 0 ? 3.0 * values[0] - 3.0 * values[1] + values[2] : values[low];
        const double fourth =
            low + 3 > intervals_of_s
                ? 3.0 * values[intervals_of_s] - 3.0 * values[intervals_of_s - 1] + values[intervals_of_s - 2]
                : values[low + 3];
        const double f[4] = {first, values[low + 1], values[low + 2], fourth};
        double sum = 0.0;
        double sum_slope = 0.0;
        for (int i = 0; i < 4; ++i) {
            sum += value[i] * f[i];
            sum_slope += slope[i] * f[i];
        }
        e += c.weight[j] * sum;
        by_s += c.weight[j] * sum_slope;
    }
    return {std::max(e, 0.0), by_s * intervals_of_s * rest / (2.0 * std::max(s, 1e-6))};
}

}  // namespace ashimpact

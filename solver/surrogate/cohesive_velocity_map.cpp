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

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/population.hpp"

#include <algorithm>
#include <cmath>

namespace ashimpact::bench {

Population population(Law law, Detachment detachment, DampingLaw damping_law, Eigen::Index count,
                      double most_damping) {
    Population found;
    for (const test::Impacts& set : test::random_impacts(4 * count, most_damping, 41)) {
        if (set.law != law || set.detachment != detachment || set.damping_law != damping_law) continue;
        const ImpactBatchResult solved = solve_impacts(set.batch(), {.turning_point = false});
        std::vector<Eigen::Index> places;
        for (Eigen::Index i = 0; i < set.size() && std::ssize(places) < count; ++i) {
            if (solved.restitution[i] >= 0.02) places.push_back(i);
        }
        found.impacts = set.picked(places);
    }
    for (Eigen::Index i = 0; i < found.impacts.size(); ++i) {
        found.restitution.push_back(solve_impact(found.impacts.at(i)).restitution);
    }
    return found;
}

Errors errors_of(const std::vector<double>& restitution, const std::vector<double>& reference) {
    std::vector<double> errors;
    for (std::size_t i = 0; i < reference.size(); ++i)
        errors.push_back(std::abs(restitution[i] / reference[i] - 1.0));
    std::ranges::sort(errors);
    return {errors.back(), errors[errors.size() / 2]};
}

}  // namespace ashimpact::bench

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "tests/solver/batch/batch_sample.hpp"

namespace ashimpact::bench {

/// Impacts to measure with: those of the tests' distribution (fly ash of 0.5 to 100 micrometres at 0.01 to 20
/// m/s) that rebound with e >= 0.02, evenly in damping number, and their restitutions by the scalar solver
/// (error below 1e-13).
struct Population {
    test::Impacts impacts;
    std::vector<double> restitution;
};

/// @param most_damping damping numbers go from 0 to this
[[nodiscard]] Population population(Law law, Detachment detachment, DampingLaw damping_law,
                                    Eigen::Index count, double most_damping = 1.0);

/// |e/e_ref - 1| of a result, worst and median.
struct Errors {
    double worst;
    double median;
};
[[nodiscard]] Errors errors_of(const std::vector<double>& restitution, const std::vector<double>& reference);
[[nodiscard]] inline Errors errors_of(const Eigen::ArrayXd& restitution,
                                      const std::vector<double>& reference) {
    return errors_of(std::vector<double>(restitution.begin(), restitution.end()), reference);
}

}  // namespace ashimpact::bench

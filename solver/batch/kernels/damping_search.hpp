// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "solver/damping/damping.hpp"
#include "solver/numeric/interpolation.hpp"

namespace ashimpact::batch {

/// Searches the damping number beta that gives one impact a restitution e > 0. Each step interpolates beta
/// over the loss 1 - e/e_0, which is smooth up to capture, and stays inside the bracket of the impacts solved
/// so far. The first point is e_0, the restitution without damping.
class DampingSearch {
  public:
    DampingSearch() = default;
    /// @param restitution e to reach; found() at once unless 0 < e < undamped [1]
    /// @param undamped e_0 [1]
    DampingSearch(DampingLaw law, double restitution, double undamped)
        : number_of_loss_(1.0 - restitution / undamped), undamped_(undamped) {
        const double wanted = number_of_loss_.wanted();
        const bool possible = wanted > 0.0 && wanted < 1.0;
        if (possible) number_ = hertz_damping_number(law, wanted);
        found_ = !possible;
        number_of_loss_.insert({.value = 0.0, .x = 0.0});
        number_of_loss_.bound(0.0, true);
    }

    /// Damping number to try next, or the answer.
    [[nodiscard]] double number() const { return number_; }
    [[nodiscard]] bool found() const { return found_; }

    /// Records the restitution at number(), 0 for a capture, and chooses the next number.
    void observe(double restitution) {
        const double loss = 1.0 - restitution / undamped_;
        number_of_loss_.bound(number_, loss < number_of_loss_.wanted());
        double next = -1.0;
        if (restitution > 0.0) {
            number_of_loss_.insert({.value = loss, .x = number_});
            next = number_of_loss_.interpolated();
            const bool is_steep = number_of_loss_.wanted() > steep_loss;
            found_ = std::abs(next - number_) <= (is_steep ? converged_where_steep : converged) * number_;
        }
        const double lower = number_of_loss_.lower();
        const double upper = std::isinf(number_of_loss_.upper()) ? 2.0 * number_ : number_of_loss_.upper();
        const bool inside = next > lower && next < upper;
        number_ = inside || found_ ? next : 0.5 * (lower + upper);
    }

  private:
    /// Relative change at which the search has converged; the next change would be below 1e-12.
    static constexpr double converged = 1e-7;
    /// The same near capture, where the loss grows as a root and interpolation gains less in each step.
    static constexpr double converged_where_steep = 1e-9;
    static constexpr double steep_loss = 0.98;

    InverseInterpolation<5> number_of_loss_;
    double undamped_ = 1.0;
    double number_ = 0.0;
    bool found_ = false;
};

}  // namespace ashimpact::batch

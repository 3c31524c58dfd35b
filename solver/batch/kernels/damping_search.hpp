// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
    DampingSearch(DampingLaw law, double restitution, double undamped);

    /// Damping number to try next, or the answer.
    [[nodiscard]] double number() const { return number_; }
    [[nodiscard]] bool found() const { return found_; }

    /// Records the restitution at number(), 0 for a capture, and chooses the next number.
    void observe(double restitution);

  private:
    /// Relative change at which the search has converged; the next change would be below 1e-12.
    static constexpr double converged = 1e-7;

    InverseInterpolation<5> number_of_loss_;
    double undamped_ = 1.0;
    double number_ = 0.0;
    bool found_ = false;
};

}  // namespace ashimpact::batch

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "solver/damping/damping.hpp"

namespace ashimpact::batch {

/// Searches the damping number beta that gives one impact a restitution e > 0. Each step interpolates beta in
/// e/e_0, which is smooth up to capture, through the nearest impacts solved so far (Neville's scheme), and
/// stays inside the bracket they give. The first point is e_0, the restitution without damping.
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
    static constexpr std::size_t most_points = 5;
    /// Relative change at which the search has converged; the next change would be below 1e-12.
    static constexpr double converged = 1e-7;
    struct Point {
        double loss;  ///< 1 - e/e_0
        double number;
    };

    /// Inserts a point into point_, which drops the farthest one if it is full.
    void insert(Point point);
    /// Neville's scheme through the points, at the wanted loss.
    [[nodiscard]] double interpolated() const;

    double wanted_ = 0.0;  ///< 1 - e/e_0
    double undamped_ = 1.0;
    double number_ = 0.0;
    double too_little_ = 0.0;
    double too_much_ = -1.0;                  ///< negative while unknown
    std::array<Point, most_points> point_{};  ///< the nearest to the wanted loss first; at first e_0
    std::size_t count_ = 1;
    bool found_ = false;
};

}  // namespace ashimpact::batch

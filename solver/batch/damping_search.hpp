#pragma once

#include "solver/damping/damping.hpp"

#include <array>
#include <cstddef>

namespace ashimpact::batch {

/// Searches the damping number that gives one impact a restitution e > 0, from impacts solved on the way: the
/// polynomial through the nearest of them of beta in e/e_0 (Neville), which is smooth up to capture, kept
/// inside what is known to be too little and too much. e_0, reached without damping, is the first point.
class DampingSearch {
  public:
    DampingSearch() = default;
    /// @param restitution wanted; outside 0 < e < undamped nothing is searched [1]
    /// @param undamped e_0 [1]
    DampingSearch(DampingLaw law, double restitution, double undamped);

    /// Damping number to try next, or the answer.
    [[nodiscard]] double number() const { return number_; }
    [[nodiscard]] bool found() const { return found_; }

    /// Takes note of what number() gave; 0 for a capture.
    void observe(double restitution);

  private:
    static constexpr std::size_t most_points = 5;
    static constexpr double enough = 1e-7;  ///< relative change after which the next one is below 1e-12
    struct Point {
        double loss;  ///< 1 - e/e_0
        double number;
    };

    void keep(Point point);
    /// Neville's scheme through the points, at the wanted loss.
    [[nodiscard]] double interpolated() const;

    double wanted_ = 0.0;  ///< 1 - e/e_0
    double undamped_ = 1.0;
    double number_ = 0.0;
    double too_little_ = 0.0;
    double too_much_ = -1.0;                  ///< unknown while negative
    std::array<Point, most_points> point_{};  ///< the nearest to the wanted loss first; at first e_0
    std::size_t count_ = 1;
    bool found_ = false;
};

}  // namespace ashimpact::batch

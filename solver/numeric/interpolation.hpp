// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace ashimpact {

/// Weights of four evenly spaced values in the cubic interpolation of Catmull and Rom (1974), between the
/// second and the third of them. @param t distance from the second value, in steps [0, 1]
[[nodiscard]] constexpr std::array<double, 4> cubic_weights(double t) {
    return {((-0.5 * t + 1.0) * t - 0.5) * t, (1.5 * t - 2.5) * t * t + 1.0, ((-1.5 * t + 2.0) * t + 0.5) * t,
            (0.5 * t - 0.5) * t * t};
}

/// Estimates the position x at which a rising function f has a wanted value, for searches in which f is
/// expensive. Interpolates x over f through the nearest points so far (Neville's scheme). The interval that
/// contains x, as far as it is known, is kept beside them.
template <std::size_t most_points>
class InverseInterpolation {
  public:
    struct Point {
        double value;  ///< f(x)
        double x;
    };

    InverseInterpolation() = default;
    explicit InverseInterpolation(double wanted) : wanted_(wanted) {}

    [[nodiscard]] double wanted() const { return wanted_; }
    [[nodiscard]] std::size_t count() const { return count_; }
    /// The point nearest to the wanted value; there must be one.
    [[nodiscard]] const Point& nearest() const { return points_[0]; }

    /// Inserts a point; of more than most_points the farthest from the wanted value is dropped.
    void insert(const Point& point) {
        const auto nearer = [this](const Point& a, const Point& b) {
            return std::abs(a.value - wanted_) < std::abs(b.value - wanted_);
        };
        if (count_ == most_points && nearer(points_.back(), point)) return;
        if (count_ < most_points) ++count_;
        std::size_t place = count_ - 1;
        for (; place > 0 && nearer(point, points_[place - 1]); --place) points_[place] = points_[place - 1];
        points_[place] = point;
    }

    /// x at the wanted value, by the polynomial through the points; not finite if two points have the same
    /// value.
    [[nodiscard]] double interpolated() const {
        std::array<double, most_points> x{};
        for (std::size_t i = 0; i < count_; ++i) x[i] = points_[i].x;
        for (std::size_t order = 1; order < count_; ++order) {
            for (std::size_t i = 0; i + order < count_; ++i) {
                const double a = points_[i].value;
                const double b = points_[i + order].value;
                x[i] = ((wanted_ - a) * x[i + 1] - (wanted_ - b) * x[i]) / (b - a);
            }
        }
        return x[0];
    }

    /// Records that f(@p x) is below the wanted value, or not.
    void bound(double x, bool below) { (below ? lower_ : upper_) = x; }
    /// Ends of the interval that contains the position; infinite if unknown.
    [[nodiscard]] double lower() const { return lower_; }
    [[nodiscard]] double upper() const { return upper_; }
    [[nodiscard]] bool contains(double x) const { return x > lower_ && x < upper_; }

  private:
    double wanted_ = 0.0;
    double lower_ = -std::numeric_limits<double>::infinity();
    double upper_ = std::numeric_limits<double>::infinity();
    std::array<Point, most_points> points_{};  ///< the first count_, the nearest to the wanted value first
    std::size_t count_ = 0;
};

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/curve/smooth_damping.hpp"

#include <algorithm>
#include <cmath>

#include "solver/numeric/interpolation.hpp"

namespace ashimpact {

SmoothDamping::SmoothDamping(const CurveTable& table, double log_critical_velocity, double fastest,
                             const std::array<double, terms>& coefficients)
    : table_(&table),
      critical_(log_critical_velocity),
      critical_damping_(table.log_capture_damping(log_critical_velocity)),
      coefficients_(coefficients) {
    const double x = std::max(fastest, critical_ + 0.1);
    span_ = std::max(1e-6, table.at(table.log_capture_damping(x) - critical_damping_, x).restitution);
    step_ = std::sqrt(x + 0.25 - critical_) / cells;
    points_[1] = {0.0, 0.0, 0.0};
    for (std::size_t i = 1; i <= cells + 1; ++i) {
        const double root = step_ * static_cast<double>(i);
        const double x_here = critical_ + root * root;
        points_[i + 1] = computed(x_here);
        const double reference = table.log_capture_damping(x_here) - critical_damping_;
        const double lack = std::max(0.0, 0.6 - points_[i + 1].distance / reference);
        lingering_ += 20.0 / cells * lack * lack / (0.15 * 0.15);
    }
    const auto before = [&](double Point::*member) {
        return 3.0 * points_[1].*member - 3.0 * points_[2].*member + points_[3].*member;
    };
    points_[1].by_distance = 2.0 * points_[2].by_distance - points_[3].by_distance;
    points_[0] = {before(&Point::distance), before(&Point::restitution), before(&Point::by_distance)};
}

SmoothDamping::Point SmoothDamping::at_log_velocity(double x) const {
    if (x <= critical_) return {std::min(0.0, table_->log_capture_damping(x) - critical_damping_), 0.0, 0.0};
    const double place = std::min(std::sqrt(x - critical_) / step_, cells - 1e-9);
    const double cell = std::floor(place);
    const double t = place - cell;
    const Point* p = points_.data() + static_cast<std::size_t>(cell);
    const std::array w = cubic_weights(t);
    const auto sum = [&](double Point::*member) {
        return w[0] * p[0].*member + w[1] * p[1].*member + w[2] * p[2].*member + w[3] * p[3].*member;
    };
    return {sum(&Point::distance), std::max(0.0, sum(&Point::restitution)), sum(&Point::by_distance)};
}

double SmoothDamping::deviation(double t) const {
    const double y = 2.0 * t - 1.0;
    double before = 1.0;
    double now = y;
    double at_zero = -1.0;
    double sum = 0.0;
    for (const double c : coefficients_) {
        sum += c * (now - at_zero);
        const double next = 2.0 * y * now - before;
        before = now;
        now = next;
        at_zero = -at_zero;
    }
    return sum;
}

SmoothDamping::Point SmoothDamping::computed(double x) const {
    const double reference = std::max(1e-12, table_->log_capture_damping(x) - critical_damping_);
    const double t = std::min(1.0, table_->at(reference, x).restitution / span_);
    // Every impact above v_c must rebound: where g would exceed the reference, the distance tends to a small
    // positive share of it.
    constexpr double share = 0.05;
    const double difference = reference - deviation(t);
    const double distance =
        0.5 * (difference + std::sqrt(difference * difference + 4.0 * share * share * reference * reference));
    const CurveTable::Value value = table_->at(distance, x);
    return {distance, value.restitution, value.by_distance};
}

}  // namespace ashimpact

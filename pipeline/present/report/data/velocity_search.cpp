// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/report/data/velocity_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ashimpact::report {

namespace {

constexpr double farthest_step = 0.5;  ///< of x where an end of the bracket is not known yet

}  // namespace

VelocitySearch::VelocitySearch(double restitution, double guess, bool adhesive, double enough)
    : adhesive_(adhesive), enough_(enough), wanted_(height(restitution)), place_(guess) {}

double VelocitySearch::height(double restitution) const {
    return adhesive_ ? restitution * restitution : restitution;
}

void VelocitySearch::keep(Point point) {
    const auto nearer = [this](const Point& a, const Point& b) {
        return std::abs(a.height - wanted_) < std::abs(b.height - wanted_);
    };
    std::size_t place = count_ < most_points ? count_++ : most_points - 1;
    if (place == most_points - 1 && count_ == most_points && nearer(points_[place], point)) return;
    for (; place > 0 && nearer(point, points_[place - 1]); --place) points_[place] = points_[place - 1];
    points_[place] = point;
}

double VelocitySearch::interpolated() const {
    if (count_ == 1) {
        const double rise = adhesive_ ? 1.0 : 0.2;  // dh/dx, roughly
        return points_[0].place + (wanted_ - points_[0].height) / rise;
    }
    std::array<double, most_points> value{};
    for (std::size_t i = 0; i < count_; ++i) value[i] = points_[i].place;
    for (std::size_t order = 1; order < count_; ++order)
        for (std::size_t i = 0; i + order < count_; ++i) {
            const Point& a = points_[i];
            const Point& b = points_[i + order];
            value[i] = ((wanted_ - a.height) * value[i + 1] - (wanted_ - b.height) * value[i]) /
                       (b.height - a.height);
        }
    return value[0];
}

double VelocitySearch::inside(double next) const {
    const bool known = std::isfinite(next);
    if (has_slow_ && has_fast_)
        return known && next > too_slow_ && next < too_fast_ ? next : (too_slow_ + too_fast_) / 2;
    if (has_fast_)
        return known && next < too_fast_ ? std::max(next, too_fast_ - farthest_step) : too_fast_ - 0.2;
    return known && next > too_slow_ ? std::min(next, too_slow_ + farthest_step) : too_slow_ + 0.2;
}

void VelocitySearch::observe(double restitution) {
    const bool slow = restitution < (adhesive_ ? std::sqrt(wanted_) : wanted_);
    (slow ? too_slow_ : too_fast_) = place_;
    (slow ? has_slow_ : has_fast_) = true;
    double next = std::numeric_limits<double>::quiet_NaN();
    if (restitution > 0) {
        keep({height(restitution), place_});
        next = interpolated();
        const bool met = count_ > 1 ? std::abs(next - place_) <= enough_
                                    : std::abs(points_[0].height - wanted_) <= 1e-12 * wanted_;
        if (met) {
            place_ = next;
            state_ = State::found;
            return;
        }
    }
    place_ = inside(next);
    if (++steps_ == most_steps) state_ = State::failed;
}

}  // namespace ashimpact::report

// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/batch/damping_search.hpp"

#include <cmath>

namespace ashimpact::batch {

DampingSearch::DampingSearch(DampingLaw law, double restitution, double undamped)
    : wanted_(1.0 - restitution / undamped), undamped_(undamped) {
    const bool possible = wanted_ > 0.0 && wanted_ < 1.0;
    if (possible) number_ = hertz_damping_number(law, wanted_);
    found_ = !possible;
}

void DampingSearch::insert(Point point) {
    const auto nearer = [this](const Point& a, const Point& b) {
        return std::abs(a.loss - wanted_) < std::abs(b.loss - wanted_);
    };
    std::size_t place = count_ < most_points ? count_++ : most_points - 1;
    if (place == most_points - 1 && nearer(point_[place], point)) return;
    for (; place > 0 && nearer(point, point_[place - 1]); --place) point_[place] = point_[place - 1];
    point_[place] = point;
}

double DampingSearch::interpolated() const {
    std::array<double, most_points> value{};
    for (std::size_t i = 0; i < count_; ++i) value[i] = point_[i].number;
    for (std::size_t order = 1; order < count_; ++order) {
        for (std::size_t i = 0; i + order < count_; ++i) {
            const Point& a = point_[i];
            const Point& b = point_[i + order];
            value[i] =
                ((wanted_ - a.loss) * value[i + 1] - (wanted_ - b.loss) * value[i]) / (b.loss - a.loss);
        }
    }
    return value[0];
}

void DampingSearch::observe(double restitution) {
    const double loss = 1.0 - restitution / undamped_;
    (loss < wanted_ ? too_little_ : too_much_) = number_;
    double next = -1.0;
    if (restitution > 0.0) {
        insert({loss, number_});
        next = interpolated();
        found_ = std::abs(next - number_) <= converged * number_;
    }
    const double upper = too_much_ < 0.0 ? 2.0 * number_ : too_much_;
    const bool inside = next > too_little_ && next < upper;
    number_ = inside || found_ ? next : 0.5 * (too_little_ + upper);
}

}  // namespace ashimpact::batch

// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/curves/velocity_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ashimpact::curves {

namespace {

constexpr double farthest_step = 0.5;  ///< of x where an end of the bracket is not known yet

}  // namespace

VelocitySearch::VelocitySearch(double restitution, double guess, bool adhesive, double enough)
    : adhesive_(adhesive), enough_(enough), place_of_height_(height(restitution)), place_(guess) {}

double VelocitySearch::height(double restitution) const {
    return adhesive_ ? restitution * restitution : restitution;
}

double VelocitySearch::interpolated() const {
    if (place_of_height_.count() > 1) return place_of_height_.interpolated();
    const double rise = adhesive_ ? 1.0 : 0.2;  // dh/dx, roughly
    const auto& [height, place] = place_of_height_.nearest();
    return place + (place_of_height_.wanted() - height) / rise;
}

double VelocitySearch::inside(double next) const {
    const double slow = place_of_height_.lower();
    const double fast = place_of_height_.upper();
    const bool possible = place_of_height_.contains(next);
    if (std::isinf(slow)) return possible ? std::max(next, fast - farthest_step) : fast - 0.2;
    if (std::isinf(fast)) return possible ? std::min(next, slow + farthest_step) : slow + 0.2;
    return possible ? next : (slow + fast) / 2;
}

void VelocitySearch::observe(double restitution) {
    const double wanted = place_of_height_.wanted();
    place_of_height_.bound(place_, restitution < (adhesive_ ? std::sqrt(wanted) : wanted));
    double next = std::numeric_limits<double>::quiet_NaN();
    if (restitution > 0) {
        place_of_height_.insert({.value = height(restitution), .x = place_});
        next = interpolated();
        // A point that is farther than all others may have been dropped: then next is only where it was.
        const bool met = place_of_height_.count() > 1
                             ? place_of_height_.nearest().x == place_ && std::abs(next - place_) <= enough_
                             : std::abs(place_of_height_.nearest().value - wanted) <= 1e-12 * wanted;
        if (met) {
            place_ = next;
            state_ = State::found;
            return;
        }
    }
    place_ = inside(next);
    if (++steps_ == most_steps) state_ = State::failed;
}

}  // namespace ashimpact::curves

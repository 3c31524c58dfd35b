// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/motion/branches/motion.hpp"

#include <limits>
#include <numbers>

namespace ashimpact {

namespace {

/// Step of a motion that nothing accelerates, whose series end: it doubles or ends the coordinate.
template <class Real>
Real uniform_step(const MotionState<Real>& state) {
    using std::abs;
    const Real way = state.position != Real(0) ? abs(state.position) : Real(1);
    return state.velocity != Real(0) ? way / abs(state.velocity) : Real(1);
}

}  // namespace

template <class Real>
MotionExpansion<Real> Motion<Real>::expand(const MotionState<Real>& state) const {
    MotionExpansion<Real> x{};
    x.position[0] = state.position;
    x.velocity[0] = state.velocity;
    x.time[0] = state.time;
    x.dissipation[0] = state.dissipation;

    PowerSeries<Real> series;  // the powers of the chain are filled below
    Series<Real> drag_series;
    Series<Real> drag_velocity;
    const bool damped = drag.degree > 0 || drag[0] != Real(0);
    for (std::size_t n = 0; n + 1 < x.position.size(); ++n) {
        powers.advance(series, x.position, n);
        const Real factor = Real(1) / static_cast<Real>(n + 1);
        Real acceleration = -composed(stiffness, series, n);
        if (damped) {
            drag_series[n] = composed(drag, series, n);
            drag_velocity[n] = product_coefficient(drag_series, x.velocity, n);
            acceleration -= drag_velocity[n];
            x.dissipation[n + 1] = factor * product_coefficient(drag_velocity, x.velocity, n);
        }
        x.position[n + 1] = factor * x.velocity[n];
        x.velocity[n + 1] = factor * acceleration;
        x.time[n + 1] = factor * composed(slope, series, n);
    }
    const Real within = std::min(radius(x.position), radius(x.velocity));
    const bool uniform = within == std::numeric_limits<Real>::infinity();
    x.step = uniform ? uniform_step(state) : within / (std::numbers::e_v<Real> * std::numbers::e_v<Real>);
    return x;
}

template struct Motion<double>;
template struct Motion<long double>;

}  // namespace ashimpact

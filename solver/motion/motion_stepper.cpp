// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/motion/motion_stepper.hpp"

#include <numbers>

namespace ashimpact {

namespace {

/// Coefficient n of p(q(theta)) from the series of the powers of q.
template <class Real, class Powers>
Real composed(const Polynomial<Real>& p, const Powers& powers, std::size_t n) {
    Real sum = n == 0 ? p[0] : Real(0);
    for (int j = 1; j <= p.degree; ++j) {
        if (p[j] != Real(0)) sum += p[j] * powers[static_cast<std::size_t>(j)][n];
    }
    return sum;
}

}  // namespace

template <class Real>
MotionStepper<Real>::MotionStepper(const Motion<Real>& motion) : motion_(motion) {
    have_[1] = true;
    for (const Polynomial<Real>* p : {&motion.slope, &motion.drag, &motion.stiffness}) {
        for (int j = 1; j <= p->degree; ++j) {
            if ((*p)[j] != Real(0)) require_power(j);
        }
    }
}

template <class Real>
void MotionStepper<Real>::require_power(int power) {
    if (have_[static_cast<std::size_t>(power)]) return;
    int left = 0;
    for (int i = 1; i < power && left == 0; ++i) {
        if (have_[static_cast<std::size_t>(i)] && have_[static_cast<std::size_t>(power - i)]) left = i;
    }
    if (left == 0) {
        left = power / 2;
        require_power(left);
        require_power(power - left);
    }
    chain_[chain_length_++] = {power, left, power - left};
    have_[static_cast<std::size_t>(power)] = true;
}

template <class Real>
MotionExpansion<Real> MotionStepper<Real>::expand(const MotionState<Real>& state) const {
    MotionExpansion<Real> x{};
    x.position[0] = state.position;
    x.velocity[0] = state.velocity;
    x.time[0] = state.time;
    x.dissipation[0] = state.dissipation;

    std::array<Series<Real>, Polynomial<Real>::capacity> powers;  // those of the chain are filled below
    Series<Real> drag;
    Series<Real> drag_velocity;
    const bool damped = motion_.drag.degree > 0 || motion_.drag[0] != Real(0);
    for (std::size_t n = 0; n + 1 < x.position.size(); ++n) {
        powers[1][n] = x.position[n];
        for (std::size_t k = 0; k < chain_length_; ++k) {
            const auto [power, left, right] = chain_[k];
            powers[static_cast<std::size_t>(power)][n] = product_coefficient(
                powers[static_cast<std::size_t>(left)], powers[static_cast<std::size_t>(right)], n);
        }
        const Real factor = Real(1) / static_cast<Real>(n + 1);
        Real acceleration = -composed(motion_.stiffness, powers, n);
        if (damped) {
            drag[n] = composed(motion_.drag, powers, n);
            drag_velocity[n] = product_coefficient(drag, x.velocity, n);
            acceleration -= drag_velocity[n];
            x.dissipation[n + 1] = factor * product_coefficient(drag_velocity, x.velocity, n);
        }
        x.position[n + 1] = factor * x.velocity[n];
        x.velocity[n + 1] = factor * acceleration;
        x.time[n + 1] = factor * composed(motion_.slope, powers, n);
    }
    const Real within = std::min(radius(x.position), radius(x.velocity));
    x.step = within / (std::numbers::e_v<Real> * std::numbers::e_v<Real>);
    return x;
}

template class MotionStepper<double>;
template class MotionStepper<long double>;

}  // namespace ashimpact

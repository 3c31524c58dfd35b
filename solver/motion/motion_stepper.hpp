// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "solver/motion/motion.hpp"
#include "solver/numeric/series.hpp"

namespace ashimpact {

/// State of an impact on its way, scaled.
template <class Real>
struct MotionState {
    Real position{};     ///< q
    Real velocity{};     ///< d(delta)/dt, positive on approach
    Real time{};         ///< since first touch
    Real dissipation{};  ///< work taken by the damping since first touch
};

/// The impact over one step as Taylor series in pseudo-time.
template <class Real>
struct MotionExpansion {
    Series<Real> position;
    Series<Real> velocity;
    Series<Real> time;
    Series<Real> dissipation;
    Real step{};  ///< pseudo-time over which the series hold to rounding, positive

    [[nodiscard]] MotionState<Real> at(Real h) const {
        return {value(position, h), value(velocity, h), value(time, h), value(dissipation, h)};
    }
};

/// Expands the equation of motion about a state; the only arithmetic is products of power series.
template <class Real>
class MotionStepper {
  public:
    explicit MotionStepper(const Motion<Real>& motion);

    [[nodiscard]] MotionExpansion<Real> expand(const MotionState<Real>& state) const;

  private:
    struct Factors {
        int power;
        int left;
        int right;
    };
    void require_power(int power);

    const Motion<Real>& motion_;
    std::array<Factors, Polynomial<Real>::capacity> chain_{};  ///< powers of q by products of lower ones
    std::size_t chain_length_ = 0;
    std::array<bool, Polynomial<Real>::capacity> have_{};
};

extern template class MotionStepper<double>;
extern template class MotionStepper<long double>;

}  // namespace ashimpact

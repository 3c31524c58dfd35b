// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/numeric/series.hpp"

namespace ashimpact {

/// State of an impact on one branch of its static law, scaled.
template <class Real>
struct MotionState {
    Real position{};     ///< q, coordinate of the branch
    Real velocity{};     ///< d(delta)/dt, positive on approach
    Real time{};         ///< since first touch
    Real dissipation{};  ///< work taken by the damping since first touch
};

/// The impact over one step as Taylor series in pseudo-time.
template <class Real, class Goal = Real>
struct MotionExpansion {
    Series<Real, Goal> position{};
    Series<Real, Goal> velocity{};
    Series<Real, Goal> time{};
    Series<Real, Goal> dissipation{};
    Real step{};  ///< pseudo-time over which the series hold to rounding; negative backward in time

    [[nodiscard]] MotionState<Real> at(Real h) const {
        return {value(position, h), value(velocity, h), value(time, h), value(dissipation, h)};
    }
};

/// A static equilibrium, scaled.
template <class Real>
struct RestPlace {
    Real position;
    Real overlap;
    Real potential;
};

}  // namespace ashimpact

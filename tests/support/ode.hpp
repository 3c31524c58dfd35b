// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include "core/text/error.hpp"
#include "solver/numeric/gsl/support.hpp"

namespace ashimpact::test {

/// Adaptive integration of dy/dx = f(x, y) by GSL's Prince-Dormand pair of order 8(9).
///
/// x is whatever the caller takes as clock: time, or overlap, or velocity; the state carries the rest.
/// A component may err by absolute[i] + relative * |y[i]| in a step.
///
/// @tparam n number of components of the state
/// @tparam Derivative callable (double x, const State& y) -> State; it must not throw, C code lies in between
/// @throws ConvergenceError where the tolerance cannot be met
template <std::size_t n, class Derivative>
class Ode {
  public:
    using State = std::array<double, n>;

    struct Tolerance {
        double relative;
        State absolute;  ///< [unit of the component]
    };

    Ode(Derivative derivative, const Tolerance& tolerance)
        : derivative_(std::move(derivative)), system_{&Ode::evaluate, nullptr, n, this} {
        gsl::quiet();
        const double floor = std::max(tolerance.relative, 1e-16);
        State scale{};
        for (std::size_t i = 0; i < n; ++i) scale[i] = tolerance.absolute[i] / floor;
        step_.reset(gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, n));
        control_.reset(gsl_odeiv2_control_scaled_new(floor, floor, 1.0, 0.0, scale.data(), n));
        evolve_.reset(gsl_odeiv2_evolve_alloc(n));
        if (!step_ || !control_ || !evolve_) throw ConvergenceError("GSL ODE solver: out of memory");
    }

    // GSL keeps the address of this object.
    Ode(const Ode&) = delete;
    Ode& operator=(const Ode&) = delete;

    /// Takes one accepted step from x towards limit, no further.
    /// @param stride the step to try; afterwards the step to try next
    void step(double& x, double limit, double& stride, State& state) {
        gsl::check(gsl_odeiv2_evolve_apply(evolve_.get(), control_.get(), step_.get(), &system_, &x, limit,
                                           &stride, state.data()),
                   "integrating an ODE");
    }

    /// Integrates from x to exactly limit, in either direction. A fresh start: nothing is remembered of
    /// earlier steps.
    void integrate(double x, double limit, State& state) {
        restart();
        double stride = (limit - x) / 16;
        while (x != limit) step(x, limit, stride, state);
    }

    /// Forgets the previous step; to be called where the state was changed from outside.
    void restart() {
        gsl_odeiv2_evolve_reset(evolve_.get());
        gsl_odeiv2_step_reset(step_.get());
    }

  private:
    template <class Object>
    using Owner = std::unique_ptr<Object, void (*)(Object*)>;

    static int evaluate(double x, const double y[], double dydx[], void* self) {
        State state;
        std::copy_n(y, n, state.begin());
        const State slope = static_cast<Ode*>(self)->derivative_(x, state);
        std::copy_n(slope.begin(), n, dydx);
        const bool finite =
            std::all_of(slope.begin(), slope.end(), [](double s) { return std::isfinite(s); });
        return finite ? GSL_SUCCESS : GSL_EDOM;  // anything but EBADFUNC: GSL tries a smaller step
    }

    Derivative derivative_;
    gsl_odeiv2_system system_;
    Owner<gsl_odeiv2_step> step_{nullptr, gsl_odeiv2_step_free};
    Owner<gsl_odeiv2_control> control_{nullptr, gsl_odeiv2_control_free};
    Owner<gsl_odeiv2_evolve> evolve_{nullptr, gsl_odeiv2_evolve_free};
};

}  // namespace ashimpact::test

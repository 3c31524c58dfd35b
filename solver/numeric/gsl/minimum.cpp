// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/numeric/gsl/minimum.hpp"

#include <cmath>
#include <exception>
#include <memory>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_min.h>
#include <gsl/gsl_multimin.h>

#include "solver/numeric/gsl/guarded_function.hpp"
#include "solver/numeric/gsl/status.hpp"
#include "solver/numeric/gsl/views.hpp"

namespace ashimpact::gsl {

namespace {

constexpr double no_value = 1e12;  ///< stands for infinity, which GSL's line search does not accept

/// Carries a function through GSL's C interface; an exception is kept and thrown again outside it.
struct SimplexTarget {
    const std::function<double(const Eigen::VectorXd&)>& function;
    std::exception_ptr error;
};

double evaluate(const gsl_vector* x, void* parameters) {
    auto& target = *static_cast<SimplexTarget*>(parameters);
    if (target.error) return no_value;
    try {
        const double value = target.function(view_of(x));
        return std::isfinite(value) ? value : no_value;
    } catch (...) {
        target.error = std::current_exception();
        return no_value;
    }
}

/// One simplex from @p position until it has shrunk to a millionth of @p steps. Returns the value there.
double shrink_simplex(const std::function<double(const Eigen::VectorXd&)>& function,
                      Eigen::VectorXd& position, const Eigen::VectorXd& steps) {
    const auto size = static_cast<std::size_t>(position.size());
    const std::unique_ptr<gsl_multimin_fminimizer, decltype(&gsl_multimin_fminimizer_free)> minimiser(
        gsl_multimin_fminimizer_alloc(gsl_multimin_fminimizer_nmsimplex2, size),
        &gsl_multimin_fminimizer_free);
    // In units of the steps, so that the size of the simplex means the same in every direction.
    const Eigen::VectorXd scaled = position.cwiseQuotient(steps);
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(position.size());
    const std::function<double(const Eigen::VectorXd&)> in_steps = [&](const Eigen::VectorXd& x) {
        return function(x.cwiseProduct(steps));
    };
    SimplexTarget target{in_steps, nullptr};
    gsl_multimin_function problem{&evaluate, size, &target};
    const auto start = gsl_vector_const_view_array(scaled.data(), size);
    const auto sides = gsl_vector_const_view_array(ones.data(), size);
    int status = gsl_multimin_fminimizer_set(minimiser.get(), &problem, &start.vector, &sides.vector);
    for (int i = 0; i < 2000 && status == GSL_SUCCESS && !target.error; ++i) {
        status = gsl_multimin_fminimizer_iterate(minimiser.get());
        if (gsl_multimin_fminimizer_size(minimiser.get()) < 1e-6) break;
    }
    if (target.error) std::rethrow_exception(target.error);
    position = Eigen::VectorXd(view_of(gsl_multimin_fminimizer_x(minimiser.get()))).cwiseProduct(steps);
    return gsl_multimin_fminimizer_minimum(minimiser.get());
}

}  // namespace

double minimise_between(const std::function<double(double)>& function, double lower, double guess,
                        double upper, double relative) {
    quiet();
    const std::function<double(double)> finite = [&](double x) {
        const double value = function(x);
        return std::isfinite(value) ? value : no_value;
    };
    GuardedFunction guarded(finite, no_value);
    gsl_function target = guarded.for_gsl();
    const std::unique_ptr<gsl_min_fminimizer, decltype(&gsl_min_fminimizer_free)> minimiser(
        gsl_min_fminimizer_alloc(gsl_min_fminimizer_brent), &gsl_min_fminimizer_free);
    double position = guess;
    int status = gsl_min_fminimizer_set(minimiser.get(), &target, guess, lower, upper);
    for (int i = 0; i < 100 && status == GSL_SUCCESS && !guarded.failed(); ++i) {
        status = gsl_min_fminimizer_iterate(minimiser.get());
        position = gsl_min_fminimizer_x_minimum(minimiser.get());
        const double a = gsl_min_fminimizer_x_lower(minimiser.get());
        const double b = gsl_min_fminimizer_x_upper(minimiser.get());
        if (b - a <= relative * (upper - lower)) break;
    }
    guarded.rethrow();
    return position;
}

Eigen::VectorXd minimise(const std::function<double(const Eigen::VectorXd&)>& function,
                         const Eigen::VectorXd& start, const Eigen::VectorXd& steps) {
    quiet();
    Eigen::VectorXd position = start;
    double least = function(start);
    constexpr int most_restarts = 20;
    for (int i = 0; i < most_restarts; ++i) {
        const double value = shrink_simplex(function, position, steps);
        const bool settled = least - value <= 1e-9 * std::abs(value);
        least = value;
        if (settled) break;
    }
    return position;
}

}  // namespace ashimpact::gsl

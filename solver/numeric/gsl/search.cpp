// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/numeric/gsl/search.hpp"

#include <cmath>

#include <gsl/gsl_min.h>
#include <gsl/gsl_multimin.h>
#include <gsl/gsl_roots.h>

#include "solver/numeric/gsl/support.hpp"

namespace ashimpact::gsl {

namespace {

constexpr double no_value = 1e12;  ///< in place of infinity, which GSL's line search does not accept

/// The value of a guarded function for GSL.
template <class Function, class Argument>
double finite_value(void* guarded, const Argument& x) {
    auto& target = *static_cast<Guarded<Function>*>(guarded);
    const double value = target.value_of([&] { return target.function(x); }, no_value);
    return std::isfinite(value) ? value : no_value;
}

using OfOne = std::function<double(double)>;
using OfSeveral = std::function<double(const Eigen::VectorXd&)>;

/// One simplex from @p position until it has shrunk to a millionth of @p steps. Returns the value there.
double shrink_simplex(const OfSeveral& function, Eigen::VectorXd& position, const Eigen::VectorXd& steps) {
    const auto size = static_cast<std::size_t>(position.size());
    const Owner<gsl_multimin_fminimizer> minimiser(
        gsl_multimin_fminimizer_alloc(gsl_multimin_fminimizer_nmsimplex2, size),
        &gsl_multimin_fminimizer_free);
    // In units of the steps, so that the size of the simplex means the same in every direction.
    const Eigen::VectorXd scaled = position.cwiseQuotient(steps);
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(position.size());
    const OfSeveral in_steps = [&](const Eigen::VectorXd& x) { return function(x.cwiseProduct(steps)); };
    Guarded<OfSeveral> target{in_steps};
    gsl_multimin_function problem{
        [](const gsl_vector* x, void* self) { return finite_value<OfSeveral>(self, view_of(x)); }, size,
        &target};
    const auto start = gsl_vector_const_view_array(scaled.data(), size);
    const auto sides = gsl_vector_const_view_array(ones.data(), size);
    int status = gsl_multimin_fminimizer_set(minimiser.get(), &problem, &start.vector, &sides.vector);
    for (int i = 0; i < 2000 && status == GSL_SUCCESS && !target.error; ++i) {
        status = gsl_multimin_fminimizer_iterate(minimiser.get());
        if (gsl_multimin_fminimizer_size(minimiser.get()) < 1e-6) break;
    }
    target.rethrow();
    position = Eigen::VectorXd(view_of(gsl_multimin_fminimizer_x(minimiser.get()))).cwiseProduct(steps);
    return gsl_multimin_fminimizer_minimum(minimiser.get());
}

}  // namespace

RootSummary brent(const std::function<double(double)>& function, double lower, double upper,
                  const RootOptions& options) {
    quiet();
    using Target = Guarded<std::function<double(double)>>;
    Target guarded{function};
    gsl_function target{[](double x, void* self) {
                            auto& to = *static_cast<Target*>(self);
                            return to.value_of([&] { return to.function(x); }, 0.0);
                        },
                        &guarded};
    const Owner<gsl_root_fsolver> solver(gsl_root_fsolver_alloc(gsl_root_fsolver_brent),
                                         &gsl_root_fsolver_free);
    const int status = gsl_root_fsolver_set(solver.get(), &target, lower, upper);
    guarded.rethrow();
    check(status, "root finding");
    for (int i = 1; i <= options.most_iterations; ++i) {
        const int iterated = gsl_root_fsolver_iterate(solver.get());
        guarded.rethrow();
        check(iterated, "root finding");
        const double a = gsl_root_fsolver_x_lower(solver.get());
        const double b = gsl_root_fsolver_x_upper(solver.get());
        if (gsl_root_test_interval(a, b, options.absolute, options.relative) == GSL_SUCCESS)
            return {gsl_root_fsolver_root(solver.get()), i};
    }
    throw ConvergenceError("root finding: iteration limit reached");
}

double minimise_between(const std::function<double(double)>& function, double lower, double guess,
                        double upper, double relative) {
    quiet();
    Guarded<OfOne> guarded{function};
    gsl_function target{[](double x, void* self) { return finite_value<OfOne>(self, x); }, &guarded};
    const Owner<gsl_min_fminimizer> minimiser(gsl_min_fminimizer_alloc(gsl_min_fminimizer_brent),
                                              &gsl_min_fminimizer_free);
    double position = guess;
    int status = gsl_min_fminimizer_set(minimiser.get(), &target, guess, lower, upper);
    for (int i = 0; i < 100 && status == GSL_SUCCESS && !guarded.error; ++i) {
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
        const bool converged = least - value <= 1e-9 * std::abs(value);
        least = value;
        if (converged) break;
    }
    return position;
}

}  // namespace ashimpact::gsl

#include "solver/gsl/root.hpp"

#include "materials/base/error.hpp"
#include "solver/gsl/status.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

#include <exception>
#include <memory>

namespace ashimpact::gsl {

namespace {

/// Carries the function through GSL's C interface; an exception is kept and thrown again outside it.
struct RootTarget {
    const std::function<double(double)>& function;
    std::exception_ptr error;
};

double evaluate(double x, void* parameters) {
    auto& target = *static_cast<RootTarget*>(parameters);
    if (target.error) return 0.0;
    try {
        return target.function(x);
    } catch (...) {
        target.error = std::current_exception();
        return 0.0;
    }
}

}  // namespace

RootSummary brent(const std::function<double(double)>& function, double lower, double upper,
                  const RootOptions& options) {
    quiet();
    RootTarget target{function, nullptr};
    gsl_function wrapped{&evaluate, &target};
    const std::unique_ptr<gsl_root_fsolver, decltype(&gsl_root_fsolver_free)> solver(
        gsl_root_fsolver_alloc(gsl_root_fsolver_brent), &gsl_root_fsolver_free);
    const auto rethrow = [&] {
        if (target.error) std::rethrow_exception(target.error);
    };
    const int status = gsl_root_fsolver_set(solver.get(), &wrapped, lower, upper);
    rethrow();
    check(status, "root finding");
    for (int i = 1; i <= options.most_iterations; ++i) {
        const int iterated = gsl_root_fsolver_iterate(solver.get());
        rethrow();
        check(iterated, "root finding");
        const double a = gsl_root_fsolver_x_lower(solver.get());
        const double b = gsl_root_fsolver_x_upper(solver.get());
        if (gsl_root_test_interval(a, b, options.absolute, options.relative) == GSL_SUCCESS) {
            return {gsl_root_fsolver_root(solver.get()), i};
        }
    }
    throw ConvergenceError("root finding: iteration limit reached");
}

}  // namespace ashimpact::gsl

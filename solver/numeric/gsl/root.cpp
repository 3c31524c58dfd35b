// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/numeric/gsl/root.hpp"

#include <memory>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

#include "core/text/error.hpp"
#include "solver/numeric/gsl/guard.hpp"
#include "solver/numeric/gsl/status.hpp"

namespace ashimpact::gsl {

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
    const std::unique_ptr<gsl_root_fsolver, decltype(&gsl_root_fsolver_free)> solver(
        gsl_root_fsolver_alloc(gsl_root_fsolver_brent), &gsl_root_fsolver_free);
    const int status = gsl_root_fsolver_set(solver.get(), &target, lower, upper);
    guarded.rethrow();
    check(status, "root finding");
    for (int i = 1; i <= options.most_iterations; ++i) {
        const int iterated = gsl_root_fsolver_iterate(solver.get());
        guarded.rethrow();
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

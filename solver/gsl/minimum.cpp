#include "solver/gsl/minimum.hpp"

#include "solver/gsl/guarded_function.hpp"
#include "solver/gsl/status.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_min.h>

#include <cmath>
#include <memory>

namespace ashimpact::gsl {

namespace {

constexpr double no_value = 1e12;  ///< stands for infinity, which GSL's line search does not accept

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

}  // namespace ashimpact::gsl

#include "solver/gsl/minimum.hpp"

#include "materials/base/error.hpp"
#include "solver/gsl/status.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_min.h>

#include <cmath>
#include <exception>
#include <memory>

namespace ashimpact::gsl {

namespace {

constexpr double nowhere = 1e12;  ///< stands for infinity, with which GSL's line search cannot reckon

/// Carries the function through GSL's C interface; an exception is kept and thrown again outside it.
struct LineTarget {
    const std::function<double(double)>& function;
    std::exception_ptr error;
};

double value_on_line(double x, void* parameters) {
    auto& target = *static_cast<LineTarget*>(parameters);
    if (target.error) return nowhere;
    try {
        const double value = target.function(x);
        return std::isfinite(value) ? value : nowhere;
    } catch (...) {
        target.error = std::current_exception();
        return nowhere;
    }
}

}  // namespace

double minimise_between(const std::function<double(double)>& function, double lower, double guess,
                        double upper, double relative) {
    quiet();
    LineTarget target{.function = function, .error = nullptr};
    gsl_function problem{&value_on_line, &target};
    const std::unique_ptr<gsl_min_fminimizer, decltype(&gsl_min_fminimizer_free)> minimiser(
        gsl_min_fminimizer_alloc(gsl_min_fminimizer_brent), &gsl_min_fminimizer_free);
    double place = guess;
    int status = gsl_min_fminimizer_set(minimiser.get(), &problem, guess, lower, upper);
    for (int i = 0; i < 100 && status == GSL_SUCCESS && !target.error; ++i) {
        status = gsl_min_fminimizer_iterate(minimiser.get());
        place = gsl_min_fminimizer_x_minimum(minimiser.get());
        const double a = gsl_min_fminimizer_x_lower(minimiser.get());
        const double b = gsl_min_fminimizer_x_upper(minimiser.get());
        if (b - a <= relative * (upper - lower)) break;
    }
    if (target.error) std::rethrow_exception(target.error);
    return place;
}

}  // namespace ashimpact::gsl

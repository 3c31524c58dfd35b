#include "solver/gsl/minimum.hpp"

#include "materials/error.hpp"
#include "solver/gsl/status.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_min.h>
#include <gsl/gsl_multimin.h>

#include <cmath>
#include <exception>
#include <memory>
#include <optional>
#include <utility>

namespace ashimpact::gsl {

namespace {

constexpr double nowhere = 1e12;  ///< stands for infinity, with which GSL's line search cannot reckon

/// Carries the function through GSL's C interface; an exception is kept and thrown again outside it.
struct MinimumTarget {
    const SmoothFunction& function;
    std::exception_ptr error;

    std::optional<Eigen::VectorXd> last_place{};  ///< GSL asks for value and gradient one after the other
    SmoothFunction::Value last{};

    const SmoothFunction::Value& at(const gsl_vector* x) {
        const Eigen::Map<const Eigen::VectorXd> place(x->data, static_cast<Eigen::Index>(x->size));
        if (last_place && *last_place == place) return last;
        last = {nowhere, Eigen::VectorXd::Zero(place.size())};
        last_place = place;
        try {
            SmoothFunction::Value value = function.evaluate(place);
            if (std::isfinite(value.value) && value.gradient.allFinite()) last = std::move(value);
        } catch (...) {
            error = std::current_exception();
        }
        return last;
    }
};

void both(const gsl_vector* x, void* parameters, double* value, gsl_vector* gradient) {
    const SmoothFunction::Value& at = static_cast<MinimumTarget*>(parameters)->at(x);
    if (value != nullptr) *value = at.value;
    for (std::size_t i = 0; gradient != nullptr && i < gradient->size; ++i)
        gsl_vector_set(gradient, i, at.gradient[static_cast<Eigen::Index>(i)]);
}

double value_of(const gsl_vector* x, void* parameters) {
    double value = 0.0;
    both(x, parameters, &value, nullptr);
    return value;
}

void gradient_of(const gsl_vector* x, void* parameters, gsl_vector* gradient) {
    both(x, parameters, nullptr, gradient);
}

/// A function of one variable carried through GSL's C interface in the same way.
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

Minimum minimise(const SmoothFunction& function, const Eigen::VectorXd& start,
                 const MinimumOptions& options) {
    quiet();
    const auto size = static_cast<std::size_t>(start.size());
    MinimumTarget target{.function = function, .error = nullptr};
    gsl_multimin_function_fdf problem{&value_of, &gradient_of, &both, size, &target};
    const std::unique_ptr<gsl_multimin_fdfminimizer, decltype(&gsl_multimin_fdfminimizer_free)> minimiser(
        gsl_multimin_fdfminimizer_alloc(gsl_multimin_fdfminimizer_vector_bfgs2, size),
        &gsl_multimin_fdfminimizer_free);
    const auto view = gsl_vector_const_view_array(start.data(), size);
    check(gsl_multimin_fdfminimizer_set(minimiser.get(), &problem, &view.vector, options.first_step, 0.1),
          "minimisation");

    const auto steepness = [&] {
        const gsl_vector* gradient = gsl_multimin_fdfminimizer_gradient(minimiser.get());
        return Eigen::Map<const Eigen::VectorXd>(gradient->data, start.size()).norm();
    };
    int iterations = 0;
    int status = GSL_SUCCESS;
    while (status == GSL_SUCCESS && !target.error && !(steepness() <= options.gradient_tolerance) &&
           iterations < options.most_iterations) {
        status = gsl_multimin_fdfminimizer_iterate(minimiser.get());
        ++iterations;
    }
    if (target.error) std::rethrow_exception(target.error);
    const double value = gsl_multimin_fdfminimizer_minimum(minimiser.get());
    if (value >= nowhere) throw ConvergenceError("minimisation: the function is not defined at the start");
    const gsl_vector* place = gsl_multimin_fdfminimizer_x(minimiser.get());
    return {Eigen::Map<const Eigen::VectorXd>(place->data, start.size()), value, iterations,
            steepness() <= options.acceptable_gradient};
}

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

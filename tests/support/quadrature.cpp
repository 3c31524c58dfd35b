// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/quadrature.hpp"

#include <memory>
#include <stdexcept>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

namespace ashimpact::test {

namespace {

double evaluate(double x, void* function) {
    return (*static_cast<const std::function<double(double)>*>(function))(x);
}

}  // namespace

double integral(const std::function<double(double)>& function, double lower, double upper, double size) {
    constexpr std::size_t most_intervals = 1000;
    const std::unique_ptr<gsl_integration_workspace, decltype(&gsl_integration_workspace_free)> workspace(
        gsl_integration_workspace_alloc(most_intervals), &gsl_integration_workspace_free);
    std::function<double(double)> own = function;
    gsl_function wrapped{&evaluate, &own};
    double value = 0.0;
    double error = 0.0;
    gsl_error_handler_t* const previous = gsl_set_error_handler_off();
    const int status = gsl_integration_qag(&wrapped, lower, upper, 1e-13 * size, 1e-13, most_intervals,
                                           GSL_INTEG_GAUSS61, workspace.get(), &value, &error);
    gsl_set_error_handler(previous);
    if (status != GSL_SUCCESS) throw std::runtime_error(gsl_strerror(status));
    return value;
}

}  // namespace ashimpact::test

#include "solver/gsl/status.hpp"

#include "materials/base/error.hpp"

#include <gsl/gsl_errno.h>

#include <string>

namespace ashimpact::gsl {

void quiet() {
    static const auto previous = gsl_set_error_handler_off();
    static_cast<void>(previous);
}

void check(int status, const char* what) {
    if (status != GSL_SUCCESS) throw ConvergenceError(std::string(what) + ": " + gsl_strerror(status));
}

}  // namespace ashimpact::gsl

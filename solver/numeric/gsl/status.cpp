// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/numeric/gsl/status.hpp"

#include <string>

#include <gsl/gsl_errno.h>

#include "core/text/error.hpp"

namespace ashimpact::gsl {

void quiet() {
    static const auto previous = gsl_set_error_handler_off();
    static_cast<void>(previous);
}

void check(int status, const char* what) {
    if (status == GSL_SUCCESS) return;
    // GSL's own messages for these are for programmers: "problem with user-supplied function".
    const bool undefined = status == GSL_EBADFUNC || status == GSL_EFAILED || status == GSL_ENOPROG;
    throw ConvergenceError(std::string(what) + ": " +
                           (undefined
                                ? "the function has no finite value there, or the search gets no further"
                                : gsl_strerror(status)));
}

}  // namespace ashimpact::gsl

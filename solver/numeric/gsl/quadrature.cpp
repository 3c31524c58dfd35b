// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/numeric/gsl/quadrature.hpp"

#include <memory>

#include <gsl/gsl_integration.h>

#include "solver/numeric/gsl/status.hpp"

namespace ashimpact::gsl {

void gauss_legendre(double lower, double upper, int count, QuadratureNode* nodes) {
    quiet();
    const std::unique_ptr<gsl_integration_glfixed_table, decltype(&gsl_integration_glfixed_table_free)> table(
        gsl_integration_glfixed_table_alloc(static_cast<std::size_t>(count)),
        &gsl_integration_glfixed_table_free);
    for (int i = 0; i < count; ++i) {
        check(gsl_integration_glfixed_point(lower, upper, static_cast<std::size_t>(i), &nodes[i].position,
                                            &nodes[i].weight, table.get()),
              "quadrature");
    }
}

}  // namespace ashimpact::gsl

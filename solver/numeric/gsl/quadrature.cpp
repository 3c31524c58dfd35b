// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/numeric/gsl/quadrature.hpp"

#include <memory>

#include <gsl/gsl_integration.h>

#include "solver/numeric/gsl/status.hpp"

namespace ashimpact::gsl {

std::vector<QuadratureNode> gauss_legendre(int count, double lower, double upper) {
    quiet();
    const std::unique_ptr<gsl_integration_glfixed_table, decltype(&gsl_integration_glfixed_table_free)> table(
        gsl_integration_glfixed_table_alloc(static_cast<std::size_t>(count)),
        &gsl_integration_glfixed_table_free);
    std::vector<QuadratureNode> nodes(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < nodes.size(); ++i)
        check(
            gsl_integration_glfixed_point(lower, upper, i, &nodes[i].position, &nodes[i].weight, table.get()),
            "quadrature");
    return nodes;
}

}  // namespace ashimpact::gsl

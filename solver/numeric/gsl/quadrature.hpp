// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace ashimpact::gsl {

struct QuadratureNode {
    double position;
    double weight;
};

/// Gauss-Legendre nodes of an interval (GSL integration): exact for polynomials of degree 2 count - 1.
[[nodiscard]] std::vector<QuadratureNode> gauss_legendre(int count, double lower, double upper);

}  // namespace ashimpact::gsl

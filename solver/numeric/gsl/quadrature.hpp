// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace ashimpact::gsl {

struct QuadratureNode {
    double position;
    double weight;
};

/// Gauss-Legendre nodes of an interval (GSL integration): exact for polynomials of degree 2 count - 1.
void gauss_legendre(double lower, double upper, int count, QuadratureNode* nodes);

template <int count>
[[nodiscard]] std::array<QuadratureNode, count> gauss_legendre(double lower, double upper) {
    std::array<QuadratureNode, count> nodes;
    gauss_legendre(lower, upper, count, nodes.data());
    return nodes;
}

}  // namespace ashimpact::gsl

// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/numeric/chebyshev_surface.hpp"

#include <cassert>

namespace ashimpact {

ChebyshevSurface::ChebyshevSurface(const ChebyshevAxis& x, const ChebyshevAxis& y,
                                   const Eigen::MatrixXd& values)
    : x_(x), y_(y), coefficients_(x.analysis() * values * y.analysis().transpose()) {
    assert(values.rows() == x.degree + 1 && values.cols() == y.degree + 1);
}

SurfacePoint ChebyshevSurface::operator()(double x, double y) const {
    const ChebyshevBasis along_x(x_, x);
    const ChebyshevBasis along_y(y_, y);
    ChebyshevBasis::Vector value(x_.degree + 1);
    ChebyshevBasis::Vector slope(x_.degree + 1);
    value.noalias() = coefficients_ * along_y.value;
    slope.noalias() = coefficients_ * along_y.slope;
    return {value.dot(along_x.value), value.dot(along_x.slope), slope.dot(along_x.value)};
}

}  // namespace ashimpact

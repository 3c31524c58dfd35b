// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/numeric/chebyshev.hpp"

#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

namespace ashimpact {

double ChebyshevAxis::node(int i) const {
    if (degree == 0) return lower;
    const double t = -std::cos(std::numbers::pi * i / degree);
    return i == degree ? upper : lower + (upper - lower) * 0.5 * (1.0 + t);
}

Eigen::MatrixXd ChebyshevAxis::analysis() const {
    assert(degree <= greatest_degree);
    const int n = degree;
    Eigen::MatrixXd transform = Eigen::MatrixXd::Ones(n + 1, n + 1);
    if (n == 0) return transform;
    const auto half_at_ends = [n](int i) { return i == 0 || i == n ? 0.5 : 1.0; };
    for (int k = 0; k <= n; ++k) {
        for (int i = 0; i <= n; ++i) {
            const double angle = std::numbers::pi * k * (n - i) / n;
            transform(k, i) = 2.0 / n * half_at_ends(k) * half_at_ends(i) * std::cos(angle);
        }
    }
    return transform;
}

ChebyshevBasis::ChebyshevBasis(const ChebyshevAxis& axis, double position)
    : value(axis.degree + 1), slope(axis.degree + 1) {
    value[0] = 1.0;
    slope[0] = 0.0;
    if (axis.degree == 0) return;
    const double stretch = 2.0 / (axis.upper - axis.lower);
    const double t = (position - axis.lower) * stretch - 1.0;
    value[1] = t;
    slope[1] = stretch;
    double before = 1.0;  // U_0, U_1, ...: the slope of T_k is k U_(k-1)
    double second = 2.0 * t;
    for (int k = 2; k <= axis.degree; ++k) {
        value[k] = 2.0 * t * value[k - 1] - value[k - 2];
        slope[k] = stretch * k * second;
        before = std::exchange(second, 2.0 * t * second - before);
    }
}

Eigen::MatrixXd chebyshev_by_powers(int terms) {
    assert(terms > 1);
    Eigen::MatrixXd powers = Eigen::MatrixXd::Zero(terms, terms);
    powers(0, 0) = powers(1, 1) = 1.0;
    for (int k = 2; k < terms; ++k) {
        powers.col(k) = -powers.col(k - 2);
        powers.col(k).tail(terms - 1) += 2.0 * powers.col(k - 1).head(terms - 1);
    }
    return powers;
}

ChebyshevSurface::ChebyshevSurface(const ChebyshevAxis& x, const ChebyshevAxis& y,
                                   const Eigen::MatrixXd& values)
    : x_(x), y_(y), coefficients_(x.analysis() * values * y.analysis().transpose()) {
    assert(values.rows() == x.degree + 1 && values.cols() == y.degree + 1);
}

namespace {

/// The polynomials of ChebyshevBasis without their slopes.
ChebyshevBasis::Vector values_of_basis(const ChebyshevAxis& axis, double position) {
    ChebyshevBasis::Vector value(axis.degree + 1);
    value[0] = 1.0;
    if (axis.degree == 0) return value;
    const double t = (position - axis.lower) * (2.0 / (axis.upper - axis.lower)) - 1.0;
    value[1] = t;
    for (int k = 2; k <= axis.degree; ++k) value[k] = 2.0 * t * value[k - 1] - value[k - 2];
    return value;
}

}  // namespace

double ChebyshevSurface::value(double x, double y) const {
    if (x_.degree == 0) return coefficients_.row(0).dot(values_of_basis(y_, y));
    ChebyshevBasis::Vector along(x_.degree + 1);
    along.noalias() = coefficients_ * values_of_basis(y_, y);
    return along.dot(values_of_basis(x_, x));
}

SurfacePoint ChebyshevSurface::operator()(double x, double y) const {
    if (x_.degree == 0) {
        const ChebyshevBasis along(y_, y);
        return {coefficients_.row(0).dot(along.value), 0.0, coefficients_.row(0).dot(along.slope)};
    }
    const ChebyshevBasis along_x(x_, x);
    const ChebyshevBasis along_y(y_, y);
    ChebyshevBasis::Vector value(x_.degree + 1);
    ChebyshevBasis::Vector slope(x_.degree + 1);
    value.noalias() = coefficients_ * along_y.value;
    slope.noalias() = coefficients_ * along_y.slope;
    return {value.dot(along_x.value), value.dot(along_x.slope), slope.dot(along_x.value)};
}

}  // namespace ashimpact

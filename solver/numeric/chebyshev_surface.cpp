#include "solver/numeric/chebyshev_surface.hpp"

#include <cassert>
#include <cmath>
#include <numbers>

namespace ashimpact {

namespace {

constexpr int capacity = ChebyshevSurface::greatest_degree + 1;
using Basis = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, capacity, 1>;

/// Chebyshev polynomials and their slopes at one place of an axis.
struct BasisAt {
    Basis value;
    Basis slope;

    BasisAt(const ChebyshevAxis& axis, double position)
        : value(Basis::Zero(axis.degree + 1)), slope(Basis::Zero(axis.degree + 1)) {
        value[0] = 1.0;
        if (axis.degree == 0) return;
        const double stretch = 2.0 / (axis.upper - axis.lower);
        const double t = (position - axis.lower) * stretch - 1.0;
        value[1] = t;
        slope[1] = 1.0;
        for (int k = 2; k <= axis.degree; ++k) {
            value[k] = 2.0 * t * value[k - 1] - value[k - 2];
            slope[k] = 2.0 * value[k - 1] + 2.0 * t * slope[k - 1] - slope[k - 2];
        }
        slope *= stretch;
    }
};

/// Matrix that turns values at the nodes of an axis into Chebyshev coefficients.
Eigen::MatrixXd analysis(const ChebyshevAxis& axis) {
    const int n = axis.degree;
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

}  // namespace

double ChebyshevAxis::node(int i) const {
    if (degree == 0) return lower;
    const double t = -std::cos(std::numbers::pi * i / degree);
    return i == degree ? upper : lower + (upper - lower) * 0.5 * (1.0 + t);
}

ChebyshevSurface::ChebyshevSurface(const ChebyshevAxis& x, const ChebyshevAxis& y,
                                   const Eigen::MatrixXd& values)
    : x_(x), y_(y), coefficients_(analysis(x) * values * analysis(y).transpose()) {
    assert(x.degree <= greatest_degree && y.degree <= greatest_degree);
    assert(values.rows() == x.degree + 1 && values.cols() == y.degree + 1);
}

SurfacePoint ChebyshevSurface::operator()(double x, double y) const {
    const BasisAt along_x(x_, x);
    const BasisAt along_y(y_, y);
    Basis value(x_.degree + 1);
    Basis slope(x_.degree + 1);
    value.noalias() = coefficients_ * along_y.value;
    slope.noalias() = coefficients_ * along_y.slope;
    return {value.dot(along_x.value), value.dot(along_x.slope), slope.dot(along_x.value)};
}

}  // namespace ashimpact

#include "solver/uncertainty/restitution_curve.hpp"

#include "solver/numeric/chebyshev.hpp"

#include <algorithm>
#include <cmath>

namespace ashimpact {

namespace {

constexpr double least_root = 1e-2;  ///< cube root of e below which the curve's slope is that at this place

ChebyshevAxis axis_up_to(double greatest_restitution, int degree) {
    return {0.0, std::cbrt(greatest_restitution), degree};
}

/// Inverse of a noise matrix times (x, y).
struct Weighted {
    double x;
    double y;

    Weighted(const VelocityNoise& noise, double across, double along) {
        const double determinant = noise.incident * noise.rebound - noise.covariance * noise.covariance;
        x = (noise.rebound * across - noise.covariance * along) / determinant;
        y = (noise.incident * along - noise.covariance * across) / determinant;
    }
};

}  // namespace

RestitutionCurve::RestitutionCurve(DampingPolynomial damping, double greatest_restitution)
    : damping_(std::move(damping)), greatest_(greatest_restitution) {}

std::optional<RestitutionCurve> RestitutionCurve::of(const ContactModel& model, DampingPolynomial damping,
                                                     double greatest_restitution,
                                                     const RestitutionCurve* near) {
    const ChebyshevAxis root = axis_up_to(greatest_restitution, degree);
    RestitutionCurve curve(std::move(damping), greatest_restitution);
    std::optional<double> guess;
    for (int i = 0; i <= degree; ++i) {
        const double e = std::pow(root.node(i), 3);
        const double eta = curve.damping_(e);
        if (!(eta > 0.0)) return std::nullopt;
        if (near != nullptr) guess = std::exp(near->nodes_(i, 0));
        const auto velocity = model.velocity(e, eta, guess);
        if (!velocity) return std::nullopt;
        curve.nodes_(i, 0) = std::log(velocity->value);
        curve.nodes_(i, 1) = std::log(velocity->by_damping);
        guess = velocity->value;
    }
    static const Eigen::MatrixXd analysis = axis_up_to(1.0, degree).analysis();
    curve.coefficients_ = analysis * curve.nodes_;
    return curve;
}

RestitutionCurve::Place RestitutionCurve::at(double e) const {
    const double within = std::clamp(e, 0.0, greatest_);
    const ChebyshevAxis axis = axis_up_to(greatest_, degree);
    const double root = std::cbrt(within);
    const ChebyshevBasis basis(axis, root);
    const double velocity = std::exp(basis.value.dot(coefficients_.col(0)));
    const double safe = std::max(root, least_root);
    const double by_root =
        (root < safe ? ChebyshevBasis(axis, safe).slope : basis.slope).dot(coefficients_.col(0));
    const double slope = velocity * by_root / (3.0 * safe * safe);
    return {.velocity = velocity + slope * (e - within),
            .slope = slope,
            .by_damping = std::exp(basis.value.dot(coefficients_.col(1)))};
}

RestitutionCurve::Projection RestitutionCurve::project(const Measurement& point, const VelocityNoise& noise,
                                                       double start) const {
    double e = start;
    Place place = at(e);
    double across = 0.0;  // v_in of the measurement less that of the curve
    double along = 0.0;   // the same for v_r
    for (int i = 0; i < 30; ++i) {
        across = point.velocity - place.velocity;
        along = point.rebound - e * place.velocity;
        const double tx = place.slope;
        const double ty = place.velocity + e * place.slope;
        const Weighted tangent(noise, tx, ty);
        const double step = (tangent.x * across + tangent.y * along) / (tangent.x * tx + tangent.y * ty);
        if (std::abs(step) < 1e-9) break;
        e += step;
        place = at(e);
    }
    const double nx = place.velocity + e * place.slope;
    const double ny = -place.slope;
    const double width =
        std::sqrt(nx * nx * noise.incident + 2.0 * nx * ny * noise.covariance + ny * ny * noise.rebound);
    return {.restitution = e,
            .distance = (nx * across + ny * along) / width,
            .by_damping = -(nx + ny * e) / width * place.by_damping,  // the curve moves by (1, e) dv
            .by_velocity = (nx * noise.incident + ny * noise.covariance) / width,
            .velocity = place.velocity};
}

}  // namespace ashimpact

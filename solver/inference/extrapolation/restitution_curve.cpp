// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/inference/extrapolation/damping_curve_fit.hpp"

namespace ashimpact {

namespace {

constexpr double least_root = 1e-2;  ///< cube root of e below which the curve's slope is that at this place

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

constexpr int most_walk_steps = 60;

/// Searches the point of a curve with the least distance from a measurement, as a root of the derivative of
/// the squared distance. The first step takes the curve as straight, later ones are secants within the
/// bracket. Steps along tangents alone would oscillate near v_c, where the curve bends within the noise of a
/// point.
class ClosestPlace {
  public:
    explicit ClosestPlace(double start) : place_(start) {}

    [[nodiscard]] double place() const { return place_; }
    /// @param pull half the negative derivative of the squared distance
    /// @param stiffness its derivative if the curve were straight @return false if the search has converged
    bool step(double pull, double stiffness) {
        constexpr double least = 1e-12;
        (pull > 0.0 ? lower_ : upper_) = place_;
        double move = pull / stiffness;
        const double curvature = (last_pull_ - pull) / (place_ - last_);
        if (curvature > 0.0) move = pull / curvature;
        double next = place_ + move;
        if (!(next > lower_ && next < upper_)) {
            const bool bracketed = std::isfinite(lower_) && std::isfinite(upper_);
            next = bracketed ? 0.5 * (lower_ + upper_) : place_ + pull / stiffness;
        }
        if (std::abs(next - place_) < least) return false;
        last_ = place_;
        last_pull_ = pull;
        place_ = next;
        return true;
    }

  private:
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();
    double place_;
    double last_ = none;
    double last_pull_ = none;
    double lower_ = -std::numeric_limits<double>::infinity();
    double upper_ = std::numeric_limits<double>::infinity();
};

}  // namespace

std::optional<RestitutionCurve> RestitutionCurve::implied_by(const ContactModel& model,
                                                             const DampingPolynomial& damping,
                                                             double greatest_restitution,
                                                             const RestitutionCurve* near) {
    const ChebyshevAxis root = axis(greatest_restitution);
    RestitutionCurve curve(greatest_restitution);
    std::optional<double> guess;
    for (int i = 0; i <= degree; ++i) {
        const double e = std::pow(root.node(i), 3);
        const double eta = damping(e);
        if (!(eta > 0.0)) return std::nullopt;
        if (near != nullptr) guess = std::exp(near->nodes_(i, 0));
        const auto velocity = model.velocity(e, eta, guess);
        if (!velocity) return std::nullopt;
        curve.nodes_(i, 0) = std::log(velocity->value);
        curve.nodes_(i, 1) = std::log(velocity->by_damping);
        guess = velocity->value;
    }
    static const Eigen::MatrixXd analysis = axis(1.0).analysis();
    curve.coefficients_ = analysis * curve.nodes_;
    return curve;
}

RestitutionCurve::Point RestitutionCurve::point_at(double e) const {
    const double within = std::clamp(e, 0.0, greatest_);
    const ChebyshevAxis along = axis(greatest_);
    const double root = std::cbrt(within);
    const ChebyshevBasis basis(along, root);
    const double velocity = std::exp(basis.value.dot(coefficients_.col(0)));
    const double safe = std::max(root, least_root);
    const double by_root =
        (root < safe ? ChebyshevBasis(along, safe).slope : basis.slope).dot(coefficients_.col(0));
    double slope = velocity * by_root / (3.0 * safe * safe);
    // Above its end it must not rise straight up, where it would reach outliers of any restitution.
    if (e > greatest_) slope = std::max(slope, velocity / greatest_);
    return {.velocity = velocity + slope * (e - within),
            .slope = slope,
            .by_damping = std::exp(basis.value.dot(coefficients_.col(1)))};
}

RestitutionCurve::Projection RestitutionCurve::project(const Measurement& point, double start) const {
    const VelocityNoise& noise = *point.noise;
    ClosestPlace search(start);
    Point place = point_at(start);
    double across = 0.0;  // v_in of the measurement less that of the curve
    double along = 0.0;   // the same for v_r
    for (int i = 0; i < most_walk_steps; ++i) {
        const double e = search.place();
        across = point.velocity - place.velocity;
        along = point.rebound - e * place.velocity;
        const double tx = place.slope;
        const double ty = place.velocity + e * place.slope;
        const Weighted tangent(noise, tx, ty);
        if (!search.step(tangent.x * across + tangent.y * along, tangent.x * tx + tangent.y * ty)) break;
        place = point_at(search.place());
    }
    const double e = search.place();
    const double nx = place.velocity + e * place.slope;
    const double ny = -place.slope;
    const double width =
        std::sqrt(nx * nx * noise.incident + 2.0 * nx * ny * noise.covariance + ny * ny * noise.rebound);
    // The curve moves by (1, e) dv.
    return {.restitution = e,
            .distance = (nx * across + ny * along) / width,
            .by_damping = -(nx + ny * e) / width * place.by_damping};
}

}  // namespace ashimpact

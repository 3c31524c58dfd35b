#include "solver/uncertainty/likelihood/curve_nodes.hpp"

#include "solver/gsl/quadrature.hpp"

#include <algorithm>
#include <cmath>

namespace ashimpact {

namespace {

constexpr int nodes_per_panel = 6;
constexpr int first_parts = 4;
constexpr int most_panels = 2000;
constexpr int stations = 400;  ///< at which the length of the curve is measured

/// Length of the curve up to each of many evenly spaced cube roots of e, the last where it leaves for
/// velocities far beyond the impacts.
std::vector<double> lengths_of(const RestitutionCurve& curve, double fastest) {
    const double top = std::cbrt(curve.greatest_restitution());
    std::vector<double> lengths{0.0};
    double v = curve.at(0.0).velocity;
    double r = 0.0;
    std::size_t used = 1;
    for (int i = 1; i <= stations; ++i) {
        const double e = std::pow(top * i / stations, 3);
        const double next = curve.at(e).velocity;
        lengths.push_back(lengths.back() + std::hypot(next - v, e * next - r));
        v = next;
        r = e * next;
        if (v < 2.0 * fastest) used = lengths.size();
    }
    lengths.resize(std::min(used + 1, lengths.size()));
    return lengths;
}

}  // namespace

bool CurveNodes::too_fine(const RestitutionCurve& curve, const Extent& extent) {
    return lengths_of(curve, extent.fastest).back() > most_panels * extent.resolution;
}

void CurveNodes::add_panels(const RestitutionCurve& curve, const Extent& extent) {
    const std::vector<double> lengths = lengths_of(curve, extent.fastest);
    const double wanted = std::ceil(lengths.back() / extent.resolution);
    const int panels = static_cast<int>(std::clamp(wanted, 4.0, static_cast<double>(most_panels)));
    const bool whole = lengths.size() == stations + 1;
    double lower = 0.0;
    std::size_t station = 1;
    for (int i = 1; i <= panels; ++i) {
        const double length = lengths.back() * i / panels;
        while (station + 1 < lengths.size() && lengths[station] < length) ++station;
        const double share = (length - lengths[station - 1]) / (lengths[station] - lengths[station - 1]);
        const double upper =
            i == panels && whole ? top_ : top_ * (static_cast<double>(station) - 1.0 + share) / stations;
        // From v_c on e rises as the cube of its root, which is not smooth at the length of a panel.
        const int parts = i == 1 ? first_parts : 1;
        for (int part = 0; part < parts; ++part)
            add_panel(lower + (upper - lower) * part / parts, lower + (upper - lower) * (part + 1) / parts);
        lower = upper;
    }
    if (whole) add_tangent(curve, extent);
}

/// The tangent, in e itself, continues the numbering above the top by e - e_top.
void CurveNodes::add_tangent(const RestitutionCurve& curve, const Extent& extent) {
    const RestitutionCurve::Place end = curve.at(curve.greatest_restitution());
    const double range =
        extent.beyond / std::hypot(end.slope, end.velocity + curve.greatest_restitution() * end.slope);
    const int more = static_cast<int>(std::ceil(extent.beyond / extent.resolution));
    for (int i = 0; i < more; ++i) add_panel(top_ + range * i / more, top_ + range * (i + 1) / more);
}

CurveNodes::CurveNodes(const RestitutionCurve& curve, int order, const Extent& extent)
    : order_(order), top_(std::cbrt(curve.greatest_restitution())) {
    add_panels(curve, extent);
    const ChebyshevAxis axis = RestitutionCurve::axis(curve.greatest_restitution());
    const auto count = static_cast<Eigen::Index>(roots_.size());
    values_.resize(count, axis.degree + 1);
    slopes_.resize(count, axis.degree + 1);
    for (Eigen::Index k = 0; k < count; ++k) {
        const ChebyshevBasis basis(axis, std::min(top_, roots_[static_cast<std::size_t>(k)]));
        values_.row(k) = basis.value.transpose();
        slopes_.row(k) = basis.slope.transpose();
    }
}

void CurveNodes::add_panel(double lower, double upper) {
    for (const auto& [position, weight] : gsl::gauss_legendre<nodes_per_panel>(lower, upper)) {
        roots_.push_back(position);
        weights_.push_back(weight);
    }
}

CurveNodes::Values CurveNodes::on(const RestitutionCurve& curve) const {
    const auto& series = curve.series();
    const auto count = static_cast<Eigen::Index>(roots_.size());
    const Eigen::VectorXd velocity = (values_ * series.col(0)).array().exp();
    const Eigen::VectorXd by_root = velocity.cwiseProduct(slopes_ * series.col(0));
    const Eigen::VectorXd by_damping = (values_ * series.col(1)).array().exp();
    const double top = curve.greatest_restitution();
    const double by_restitution = 1.0 / (3.0 * top_ * top_);  // of the cube root, at the top

    Values result{Eigen::VectorXd(count),
                  Eigen::VectorXd(count),
                  Eigen::VectorXd(count),
                  Eigen::VectorXd(count),
                  Eigen::MatrixXd(count, order_ + 1),
                  Eigen::MatrixXd(count, order_ + 1),
                  DampingPolynomial::powers(0.0, order_),
                  0.0};
    for (Eigen::Index k = 0; k < count; ++k) {
        const double root = roots_[static_cast<std::size_t>(k)];
        const double weight = weights_[static_cast<std::size_t>(k)];
        const bool tangent = root > top_;
        const double past = tangent ? root - top_ : 0.0;
        const double e = tangent ? top + past : root * root * root;
        const double e_slope = tangent ? 1.0 : 3.0 * root * root;
        const double v_slope = tangent ? by_root[k] * by_restitution : by_root[k];
        const double v = velocity[k] + v_slope * past;
        result.velocity[k] = v;
        result.rebound[k] = e * v;
        result.weight[k] = weight * v_slope;
        result.rebound_weight[k] = weight * (e_slope * v + e * v_slope);
        double power = 1.0;
        const double bend = past * by_restitution * slopes_.row(k).dot(series.col(1));
        double steeper = 0.0;  // j e^(j - 1)
        for (int j = 0; j <= order_; ++j) {
            const double moved = by_damping[k] * (power * (1.0 + bend) + past * steeper);
            result.velocity_by_coefficient(k, j) = moved;
            result.by_coefficient(k, j) = -weight * v * e_slope * moved;
            steeper = (j + 1) * power;
            power *= tangent ? top : e;
        }
    }
    const ChebyshevBasis start(RestitutionCurve::axis(top), 0.0);
    result.critical_velocity = std::exp(start.value.dot(series.col(0)));
    result.first_velocity *= std::exp(start.value.dot(series.col(1)));
    return result;
}

}  // namespace ashimpact

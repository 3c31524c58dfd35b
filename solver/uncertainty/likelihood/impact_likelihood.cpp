#include "solver/uncertainty/likelihood/impact_likelihood.hpp"

#include "materials/base/error.hpp"
#include "solver/gsl/distribution.hpp"
#include "solver/uncertainty/likelihood/rebound_density.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ashimpact {

namespace {

constexpr double hidden = 0.5;          ///< fall below v_c that noise hides, in standard uncertainties
constexpr double certain = 9.0;         ///< standard uncertainties above v_c at which ln Phi is zero
constexpr double panel_of_noise = 3.0;  ///< length of a panel in the least noise: errors of some 1e-6
constexpr double finest_panel = 2.0;    ///< the same where the noise becomes negligible

/// How finely and how far the impacts ask for places on a curve. @param panel length in the least noise
CurveNodes::Extent extent_for(const RestitutionData& data, double panel) {
    double least = std::numeric_limits<double>::infinity();
    double greatest = 0.0;
    double fastest = 0.0;
    for (const Measurement& point : data.rebounds) {
        least = std::min({least, point.noise->incident, point.noise->rebound});
        greatest = std::max({greatest, point.noise->incident, point.noise->rebound});
        fastest = std::max(fastest, point.velocity);
    }
    return {.resolution = panel * std::sqrt(least),
            .beyond = noise_reach * std::sqrt(greatest),
            .fastest = fastest};
}

/// One velocity has one restitution, so v(e) cannot fall. Where eta falls with e it does, a little, close to
/// e = 0 (by up to 1.2 % with the paper's fits). A greater fall costs as if every rebound missed the curve by
/// what is too much.
/// @param precision sum over the rebounds of 1/u^2 [s2/m2]
void add_fold(const CurveNodes::Values& nodes, double precision, ImpactLikelihood::Value& result) {
    constexpr double allowed = 0.03;
    Eigen::Index top = 0;
    Eigen::Index from = 0;
    Eigen::Index to = 0;
    for (Eigen::Index k = 0; k < nodes.velocity.size(); ++k) {
        if (nodes.velocity[k] > nodes.velocity[top]) top = k;
        if (nodes.velocity[k] * nodes.velocity[from] < nodes.velocity[to] * nodes.velocity[top]) {
            from = top;
            to = k;
        }
    }
    const double excess = (1.0 - allowed) * nodes.velocity[from] - nodes.velocity[to];
    if (excess <= 0.0) return;
    result.value += 0.5 * precision * excess * excess;
    result.gradient +=
        precision * excess *
        ((1.0 - allowed) * nodes.velocity_by_coefficient.row(from) - nodes.velocity_by_coefficient.row(to))
            .transpose();
}

/// The velocity from which on rebounds are possible: v_c, as long as the curve does not fall below it by more
/// than the noise hides; else the lowest place of the curve. With v_c, likelihoods given a rebound would grow
/// without bounds towards curves that fold back to the impacts from a v_c far above them.
class ReboundThreshold {
  public:
    explicit ReboundThreshold(const CurveNodes::Values& nodes) : nodes_(nodes) {
        const double lowest = nodes.velocity.minCoeff(&lowest_);
        fall_ = std::max(0.0, nodes.critical_velocity - lowest);
    }

    /// Adds ln of the probability that an impact rebounds.
    void add(const Measurement& rebound, double weight, ImpactLikelihood::Value& result) const {
        const double u = std::sqrt(rebound.noise->incident);
        const double ratio = fall_ / (hidden * u);
        const double softness = 1.0 / (1.0 + ratio * ratio);
        const double velocity = nodes_.critical_velocity - fall_ + fall_ * softness;
        const double z = (rebound.velocity - velocity) / u;
        if (z > certain) return;
        result.value += weight * gsl::normal_log_probability(z);
        const double slope = weight * gsl::normal_log_probability_slope(z) / u;
        const double by_fall = fall_ > 0.0 ? (1.0 - ratio * ratio) * softness * softness : 1.0;
        result.gradient -= slope * by_fall * nodes_.first_velocity;
        if (fall_ > 0.0)
            result.gradient -=
                slope * (1.0 - by_fall) * nodes_.velocity_by_coefficient.row(lowest_).transpose();
    }

  private:
    const CurveNodes::Values& nodes_;
    Eigen::Index lowest_ = 0;
    double fall_ = 0.0;  ///< of the curve below v_c [m/s]
};

}  // namespace

ImpactLikelihood::ImpactLikelihood(const ContactModel& model, RestitutionData data,
                                   const Eigen::VectorXd& near)
    : model_(&model), data_(std::move(data)) {
    for (std::size_t i = 0; i < data_.rebounds.size(); ++i)
        precision_ += data_.weights[i] / data_.rebounds[i].noise->incident;
    move_to(near);
}

void ImpactLikelihood::move_to(const Eigen::VectorXd& coefficients) {
    auto curve = RestitutionCurve::of(*model_, {coefficients}, data_.greatest_restitution);
    if (!curve) throw ConvergenceError("no damping curve to start from");
    nodes_ = std::make_unique<const CurveNodes>(*curve, static_cast<int>(coefficients.size()) - 1,
                                                extent_for(data_, panel_of_noise));
    last_ = std::move(curve);
}

bool ImpactLikelihood::noise_is_negligible(const RestitutionCurve& curve, const RestitutionData& data) {
    return CurveNodes::too_fine(curve, extent_for(data, finest_panel));
}

std::optional<ImpactLikelihood::Value> ImpactLikelihood::at(const Eigen::VectorXd& coefficients) const {
    auto curve = RestitutionCurve::of(*model_, {coefficients}, data_.greatest_restitution, &*last_);
    if (!curve) return std::nullopt;
    const CurveNodes::Values nodes = nodes_->on(*curve);
    last_ = std::move(curve);

    const ReboundThreshold threshold(nodes);
    ReboundDensity density(nodes);
    Value result{0.0, Eigen::VectorXd::Zero(coefficients.size())};
    add_fold(nodes, precision_, result);
    for (std::size_t i = 0; i < data_.rebounds.size(); ++i) {
        const Measurement& point = data_.rebounds[i];
        if (!density.evaluate(point)) return std::nullopt;
        const double weight = data_.weights[i];
        result.value -= weight * density.logarithm();
        result.gradient -= weight * density.gradient();
        if (data_.captures.empty()) threshold.add(point, weight, result);
    }
    for (const CapturedImpact& capture : data_.captures) {
        const double u = capture.standard_uncertainty;
        const double z = (nodes.critical_velocity - capture.velocity) / u;
        result.value -= gsl::normal_log_probability(z);
        result.gradient -= gsl::normal_log_probability_slope(z) / u * nodes.first_velocity;
    }
    return result;
}

}  // namespace ashimpact

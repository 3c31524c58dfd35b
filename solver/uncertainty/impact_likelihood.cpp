#include "solver/uncertainty/impact_likelihood.hpp"

#include "materials/error.hpp"
#include "solver/gsl/distribution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ashimpact {

namespace {

constexpr double far = 6.5;             ///< standard uncertainties beyond which noise does not reach
constexpr double panel_of_noise = 3.0;  ///< length of a panel in the least noise: errors of some 1e-6
constexpr double finest_panel = 2.0;    ///< the same where the noise becomes negligible

struct NoiseRange {
    double least = std::numeric_limits<double>::infinity();
    double greatest = 0.0;
};

NoiseRange noise_of(const RestitutionData& data) {
    NoiseRange range;
    for (const Measurement& point : data.rebounds) {
        range.least = std::min({range.least, point.noise->incident, point.noise->rebound});
        range.greatest = std::max({range.greatest, point.noise->incident, point.noise->rebound});
    }
    return {std::sqrt(range.least), std::sqrt(range.greatest)};
}

/// The places that noise can have moved to a measured velocity; the curve may fold back a little.
class Windows {
  public:
    explicit Windows(const Eigen::VectorXd& velocity)
        : greatest_before_(velocity.begin(), velocity.end()),
          least_behind_(velocity.begin(), velocity.end()) {
        for (std::size_t k = 1; k < greatest_before_.size(); ++k)
            greatest_before_[k] = std::max(greatest_before_[k], greatest_before_[k - 1]);
        for (std::size_t k = least_behind_.size() - 1; k > 0; --k)
            least_behind_[k - 1] = std::min(least_behind_[k - 1], least_behind_[k]);
    }

    struct Window {
        Eigen::Index first;
        Eigen::Index last;
    };
    [[nodiscard]] Window around(double velocity, double distance) const {
        const auto first =
            std::lower_bound(greatest_before_.begin(), greatest_before_.end(), velocity - distance);
        const auto last = std::upper_bound(least_behind_.begin(), least_behind_.end(), velocity + distance);
        return {first - greatest_before_.begin(), last - least_behind_.begin()};
    }
    [[nodiscard]] Window all() const { return {0, static_cast<Eigen::Index>(least_behind_.size())}; }

  private:
    std::vector<double> greatest_before_;
    std::vector<double> least_behind_;
};

/// Inverse of a noise matrix, for differences (x, y) of v_in and v_r.
struct Precision {
    double xx;
    double xy;
    double yy;

    explicit Precision(const VelocityNoise& noise) {
        const double determinant = noise.incident * noise.rebound - noise.covariance * noise.covariance;
        xx = noise.rebound / determinant;
        xy = -noise.covariance / determinant;
        yy = noise.incident / determinant;
    }
    [[nodiscard]] double square(double x, double y) const { return x * (xx * x + 2.0 * xy * y) + yy * y * y; }
};

/// ln of the integral along the curve for one rebound, less a constant, and its gradient.
class ReboundDensity {
  public:
    ReboundDensity(const CurveNodes::Values& nodes, const Windows& windows)
        : nodes_(nodes),
          windows_(windows),
          x_(nodes.velocity.size()),
          y_(nodes.velocity.size()),
          squares_(nodes.velocity.size()),
          density_(nodes.velocity.size()),
          gradient_(nodes.by_coefficient.cols()) {}

    /// Whether the density is a positive number.
    bool evaluate(const Measurement& point) {
        const Precision precision(*point.noise);
        Windows::Window window = windows_.around(point.velocity, far * std::sqrt(point.noise->incident));
        double least = measure(point, precision, window);
        if (!(least < far * far)) {  // an outlier
            window = windows_.all();
            least = measure(point, precision, window);
        }
        const Eigen::Index size = window.last - window.first;
        density_.head(size) = (-0.5 * (squares_.head(size) - least)).exp();
        const double sum = (density_.head(size) * nodes_.weight.segment(window.first, size).array()).sum();
        density_.head(size) *= precision.xy * x_.head(size) + precision.yy * y_.head(size);
        gradient_.noalias() =
            nodes_.by_coefficient.middleRows(window.first, size).transpose() * density_.head(size).matrix();
        add_start(point, precision, least);
        logarithm_ = std::log(sum) - 0.5 * least;
        gradient_ /= sum;
        return sum > 0.0;
    }
    [[nodiscard]] double logarithm() const { return logarithm_; }
    [[nodiscard]] const Eigen::VectorXd& gradient() const { return gradient_; }

  private:
    double measure(const Measurement& point, const Precision& precision, Windows::Window window) {
        const Eigen::Index size = window.last - window.first;
        if (size <= 0) return std::numeric_limits<double>::infinity();
        x_.head(size) = point.velocity - nodes_.velocity.segment(window.first, size).array();
        y_.head(size) = point.rebound - nodes_.rebound.segment(window.first, size).array();
        squares_.head(size) =
            x_.head(size) * (precision.xx * x_.head(size) + 2.0 * precision.xy * y_.head(size)) +
            precision.yy * y_.head(size).square();
        return squares_.head(size).minCoeff();
    }
    /// The integral begins at (v_c, 0), which moves.
    void add_start(const Measurement& point, const Precision& precision, double least) {
        const double square =
            precision.square(point.velocity - nodes_.critical_velocity, point.rebound) - least;
        if (square < far * far) gradient_ -= std::exp(-0.5 * square) * nodes_.first_velocity;
    }

    const CurveNodes::Values& nodes_;
    const Windows& windows_;
    Eigen::ArrayXd x_;
    Eigen::ArrayXd y_;
    Eigen::ArrayXd squares_;
    Eigen::ArrayXd density_;
    Eigen::VectorXd gradient_;
    double logarithm_ = 0.0;
};

/// One velocity has one restitution, so v(e) cannot fall. Where eta falls with e it does, a little, close to
/// e = 0 (by up to 1.2 % with the paper's fits); a greater fall costs, or likelihoods given a rebound would
/// grow without bounds towards curves that fold.
void add_fold(const CurveNodes::Values& nodes, ImpactLikelihood::Value& result) {
    constexpr double allowed = 0.03;
    constexpr double deviation = 0.01;
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
    const double share = nodes.velocity[to] / nodes.velocity[from];
    const double excess = (1.0 - share - allowed) / deviation;
    if (excess <= 0.0) return;
    result.value += 0.5 * excess * excess;
    result.gradient -=
        excess / deviation / nodes.velocity[from] *
        (nodes.velocity_by_coefficient.row(to) - share * nodes.velocity_by_coefficient.row(from)).transpose();
}

}  // namespace

ImpactLikelihood::ImpactLikelihood(const ContactModel& model, RestitutionData data,
                                   const Eigen::VectorXd& near)
    : model_(&model), data_(std::move(data)) {
    move_to(near);
}

void ImpactLikelihood::move_to(const Eigen::VectorXd& coefficients) {
    auto curve = RestitutionCurve::of(*model_, {coefficients}, data_.greatest_restitution);
    if (!curve) throw ConvergenceError("no damping curve to start from");
    const NoiseRange noise = noise_of(data_);
    nodes_ = std::make_unique<const CurveNodes>(*curve, static_cast<int>(coefficients.size()) - 1,
                                                panel_of_noise * noise.least, far * noise.greatest);
    last_ = std::move(curve);
}

bool ImpactLikelihood::noise_is_negligible(const RestitutionCurve& curve, const RestitutionData& data) {
    return CurveNodes::too_fine(curve, finest_panel * noise_of(data).least);
}

std::optional<ImpactLikelihood::Value> ImpactLikelihood::at(const Eigen::VectorXd& coefficients) const {
    auto curve = RestitutionCurve::of(*model_, {coefficients}, data_.greatest_restitution, &*last_);
    if (!curve) return std::nullopt;
    const CurveNodes::Values nodes = nodes_->on(*curve);
    last_ = std::move(curve);

    const Windows windows(nodes.velocity);
    ReboundDensity density(nodes, windows);
    Value result{0.0, Eigen::VectorXd::Zero(coefficients.size())};
    add_fold(nodes, result);
    for (std::size_t i = 0; i < data_.rebounds.size(); ++i) {
        const Measurement& point = data_.rebounds[i];
        if (!density.evaluate(point)) return std::nullopt;
        const double weight = data_.weights[i];
        result.value -= weight * density.logarithm();
        result.gradient -= weight * density.gradient();
        if (!data_.captures.empty()) continue;
        const double u = std::sqrt(point.noise->incident);
        const double z = (point.velocity - nodes.critical_velocity) / u;
        result.value += weight * gsl::log_normal_probability(z);
        result.gradient -= weight * gsl::log_normal_probability_slope(z) / u * nodes.first_velocity;
    }
    for (const CapturedImpact& capture : data_.captures) {
        const double u = capture.standard_uncertainty;
        const double z = (nodes.critical_velocity - capture.velocity) / u;
        result.value -= gsl::log_normal_probability(z);
        result.gradient -= gsl::log_normal_probability_slope(z) / u * nodes.first_velocity;
    }
    return result;
}

}  // namespace ashimpact

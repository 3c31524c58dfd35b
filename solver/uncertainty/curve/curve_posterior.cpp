#include "solver/uncertainty/curve/curve_posterior.hpp"

#include <algorithm>
#include <cmath>

namespace ashimpact {

namespace {

constexpr double outlier_share = 0.02;
constexpr double slope_mean = -0.35;
constexpr double slope_deviation = 0.5;
constexpr double scatter_median = 0.005;

/// Standard deviation of a coefficient: an integrated random walk's fall with the square of the order.
double deviation_of(int term, double roughness) {
    return term == 1 ? slope_deviation : roughness * 4.0 / (term * term);
}

double square(double x) {
    return x * x;
}

CurvePosterior::Vector steps() {
    CurvePosterior::Vector h = CurvePosterior::Vector::Constant(2e-3);
    h[CurvePosterior::noise] = 0.01;
    h[CurvePosterior::scatter] = 0.02;
    return h;
}

}  // namespace

CurvePosterior::CurvePosterior(const RestitutionTable& table, const std::vector<RecordedImpact>& impacts,
                               const CurvePrior& prior, double roughness)
    : table_(&table), impacts_(&impacts), prior_(prior), roughness_(roughness), fastest_(-1e300), slowest_(1e300) {
    for (const RecordedImpact& impact : impacts) {
        fastest_ = std::max(fastest_, impact.log_velocity);
        slowest_ = std::min(slowest_, impact.log_velocity);
    }
}

SmoothDamping CurvePosterior::curve(const Vector& parameters) const {
    std::array<double, SmoothDamping::terms> coefficients{};
    for (int i = 0; i < SmoothDamping::terms; ++i)
        coefficients[static_cast<std::size_t>(i)] = parameters[first_term + i];
    return {*table_, parameters[critical], fastest_, coefficients};
}

Scatter CurvePosterior::scatter_of(const Vector& parameters) const {
    return {.noise = std::exp(parameters[noise]),
            .damping = prior_.scatter ? *prior_.scatter : std::exp(parameters[scatter]),
            .outliers = outlier_share};
}

CurvePosterior::Vector CurvePosterior::start(double log_critical_velocity) const {
    Vector result = Vector::Zero();
    result[critical] = log_critical_velocity;
    result[first_term] = slope_mean;
    result[noise] = prior_.noise_known ? 0.0 : std::log(prior_.noise);
    result[scatter] = std::log(scatter_median);
    return result;
}

double CurvePosterior::prior_term(const Vector& parameters) const {
    double sum = 0.5 * square((parameters[first_term] - slope_mean) / slope_deviation);
    for (int i = 2; i <= SmoothDamping::terms; ++i) {
        const double deviation = deviation_of(i, roughness_);
        sum += 0.5 * square(parameters[first_term + i - 1] / deviation) + std::log(deviation);
    }
    if (prior_.noise_known)
        sum += std::log1p(square(parameters[noise] / 0.1));
    else
        sum += 0.5 * square((parameters[noise] - std::log(prior_.noise)) / 1.5);
    // A laboratory aims where it finds v_c: far below its slowest impacts v_c is unlikely.
    constexpr double below = 1.2;
    constexpr double deviation = 0.4;
    sum += 0.5 * square(std::max(0.0, slowest_ - below - parameters[critical]) / deviation);
    sum += 2.0 * std::log1p(square(parameters[scatter] - std::log(scatter_median)) / 3.0);
    return sum;
}

double CurvePosterior::operator()(const Vector& parameters) const {
    const double a = parameters[critical];
    if (!(a > table_->lower() && a < table_->upper()) || !parameters.allFinite()) return 1e10;
    if (std::abs(parameters[noise] - (prior_.noise_known ? 0.0 : std::log(prior_.noise))) > 12.0) return 1e10;
    const SmoothDamping fitted = curve(parameters);
    const Scatter scattered = scatter_of(parameters);
    double sum = prior_term(parameters) + fitted.lingering();
    for (const RecordedImpact& impact : *impacts_)
        sum -= impact.count * log_probability(fitted, scattered, impact);
    return std::isfinite(sum) ? sum : 1e10;
}

CurvePosterior::Vector CurvePosterior::gradient(const Vector& parameters) const {
    const Vector h = steps();
    Vector result;
    for (int i = 0; i < size; ++i) {
        Vector shifted = parameters;
        shifted[i] += h[i];
        const double above = (*this)(shifted);
        shifted[i] -= 2.0 * h[i];
        result[i] = (above - (*this)(shifted)) / (2.0 * h[i]);
    }
    return result;
}

CurvePosterior::Curvature CurvePosterior::curvature(const Vector& parameters) const {
    const Vector h = steps();
    Curvature result{(*this)(parameters), Vector::Zero(), Matrix::Zero()};
    Vector above;
    for (int i = 0; i < size; ++i) {
        Vector shifted = parameters;
        shifted[i] += h[i];
        above[i] = (*this)(shifted);
        shifted[i] -= 2.0 * h[i];
        const double below = (*this)(shifted);
        result.gradient[i] = (above[i] - below) / (2.0 * h[i]);
        result.hessian(i, i) = (above[i] - 2.0 * result.value + below) / (h[i] * h[i]);
    }
    for (int i = 0; i < size; ++i) {
        for (int j = 0; j < i; ++j) {
            Vector shifted = parameters;
            shifted[i] += h[i];
            shifted[j] += h[j];
            const double both = (*this)(shifted);
            result.hessian(i, j) = (both - above[i] - above[j] + result.value) / (h[i] * h[j]);
            result.hessian(j, i) = result.hessian(i, j);
        }
    }
    return result;
}

}  // namespace ashimpact

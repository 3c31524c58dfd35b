#include "solver/uncertainty/curve/curve_estimate.hpp"

#include "materials/base/error.hpp"
#include "materials/base/text.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/gsl/distribution.hpp"
#include "solver/statistics/philox.hpp"
#include "solver/statistics/quasi_random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace ashimpact {

namespace {

using Vector = CurvePosterior::Vector;
using Matrix = CurvePosterior::Matrix;

constexpr double least_effective = 50.0;  ///< independent draws; fewer give no reliable ends of an interval

/// A normal density from which curves are drawn.
struct NormalDensity {
    Vector mean;
    Matrix covariance;
};

struct Mode {
    NormalDensity normal;
    double value = 0.0;       ///< -ln posterior
    double log_weight = 0.0;  ///< ln of the posterior's integral around it
};

/// Adds the covariance, the inverse of a Hessian. Directions of small or negative curvature get the width of
/// a prior.
Mode with_covariance(Mode mode, const Matrix& hessian) {
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(hessian);
    const Vector values = solver.eigenvalues().cwiseAbs().cwiseMax(0.5);
    mode.normal.covariance =
        solver.eigenvectors() * values.cwiseInverse().asDiagonal() * solver.eigenvectors().transpose();
    mode.log_weight = -mode.value - 0.5 * values.array().log().sum();
    return mode;
}

/// Holds noise and scatter: the posterior has a narrow peak where both are small, which holds little of its
/// weight. They get widths of about their priors.
void hold_scales(CurvePosterior::Curvature& curvature) {
    constexpr double noise_deviation = 0.5;
    for (const int scale : {CurvePosterior::noise, CurvePosterior::scatter}) {
        curvature.gradient[scale] = 0.0;
        curvature.hessian.row(scale).setZero();
        curvature.hessian.col(scale).setZero();
        curvature.hessian(scale, scale) = 1.0;
    }
    curvature.hessian(CurvePosterior::noise, CurvePosterior::noise) /= noise_deviation * noise_deviation;
}

/// The mode at the noise and scatter of @p start, by Newton's method with a Hessian made positive definite.
/// It need not be exact: the weights of the draws correct for it.
Mode find_mode(const CurvePosterior& posterior, const Vector& start) {
    Mode mode;
    mode.normal.mean = start;
    mode.value = posterior(start);
    Vector differences = Vector::Constant(0.03);
    differences[CurvePosterior::critical] = 2e-3;
    for (int i = 0; i < 25; ++i) {
        Vector& point = mode.normal.mean;
        auto curvature = posterior.curvature(point, mode.value, differences);
        hold_scales(curvature);
        mode = with_covariance(mode, curvature.hessian);
        const Vector deviations = mode.normal.covariance.diagonal().cwiseSqrt();
        differences = (0.2 * deviations).cwiseMin(0.03).cwiseMax(1e-7);
        differences[CurvePosterior::critical] = std::min(2e-3, differences[CurvePosterior::critical]);
        Vector step = -(mode.normal.covariance * curvature.gradient);
        step *= std::min(1.0, 2.0 / step.cwiseAbs().maxCoeff());
        step *= std::min(1.0, 0.5 / std::abs(step[CurvePosterior::critical]));
        constexpr double enough = 0.02;
        const double before = mode.value;
        for (double length = 1.0; length > 1e-4; length *= 0.35) {
            const double value = posterior(point + length * step);
            if (value >= mode.value) continue;
            point += length * step;
            mode.value = value;
            break;
        }
        if (before - mode.value < enough) break;
    }
    return mode;
}

/// Weighted draws from normal densities, by a quasi-random sequence.
class Draws {
  public:
    explicit Draws(const CurvePosterior& posterior) : posterior_(posterior) {}

    void add(const NormalDensity& normal, std::size_t count) {
        proposals_.push_back({normal, normal.covariance.llt().matrixL(), static_cast<double>(count)});
        const Proposal& proposal = proposals_.back();
        static const DigitalSequence sequence(QuasiRandomSequence::sobol, CurvePosterior::size);
        std::vector<std::uint64_t> digits(count);
        const std::size_t first = point_.size();
        point_.resize(first + count, Vector::Zero());
        for (int axis = 0; axis < CurvePosterior::size; ++axis) {
            sequence.fill(static_cast<std::size_t>(axis), first + 1, digits);
            for (std::size_t i = 0; i < count; ++i)
                point_[first + i][axis] = gsl::normal_quantile(unit_interval(digits[i]));
        }
        value_.resize(point_.size());
        batch::for_each_item(count, [&](std::size_t i) {
            Vector& point = point_[first + i];
            point = normal.mean + scales[i % scales.size()] * (proposal.factor * point);
            value_[first + i] = posterior_(point);
        });
        weigh();
    }

    /// Mean and covariance of the posterior; while it has few effective draws, those of a power of it below
    /// 1, which is wider.
    [[nodiscard]] NormalDensity moments() const {
        constexpr double enough = 60.0;
        std::vector<double> weight = weights(1.0);
        for (double power = 1.0; effective(weight) < enough; weight = weights(power)) power *= 0.7;
        NormalDensity normal{Vector::Zero(), Matrix::Zero()};
        for (std::size_t i = 0; i < point_.size(); ++i) normal.mean += weight[i] * point_[i];
        for (std::size_t i = 0; i < point_.size(); ++i)
            normal.covariance +=
                weight[i] * (point_[i] - normal.mean) * (point_[i] - normal.mean).transpose();
        return normal;
    }

    /// Effective sample size: the number of independent draws that would be as accurate.
    [[nodiscard]] double effective() const { return effective(weights(1.0)); }

    [[nodiscard]] const Vector& likeliest() const {
        return point_[static_cast<std::size_t>(std::min_element(value_.begin(), value_.end()) -
                                               value_.begin())];
    }

    [[nodiscard]] Interval critical_velocity() const {
        std::vector<std::pair<double, double>> sorted;
        const std::vector<double> weight = weights(1.0);
        for (std::size_t i = 0; i < point_.size(); ++i)
            sorted.emplace_back(point_[i][CurvePosterior::critical], weight[i]);
        std::sort(sorted.begin(), sorted.end());
        // Interpolated, half of a draw's weight lying below it, so that rounding moves no result.
        const auto quantile = [&](double probability) {
            double before = 0.0;
            for (std::size_t i = 0; i < sorted.size(); ++i) {
                const double here =
                    (i > 0 ? before + 0.5 * sorted[i - 1].second : 0.0) + 0.5 * sorted[i].second;
                if (here >= probability) {
                    if (i == 0) return sorted[0].first;
                    const double share = (probability - before) / (here - before);
                    return sorted[i - 1].first + share * (sorted[i].first - sorted[i - 1].first);
                }
                before = here;
            }
            return sorted.back().first;
        };
        double mean = 0.0;
        double square = 0.0;
        for (const auto& [x, share] : sorted) {
            mean += share * x;
            square += share * x * x;
        }
        const double tail = 0.5 * (1.0 - confidence);
        const double median = std::exp(quantile(0.5));
        return {median, median * std::sqrt(std::max(0.0, square - mean * mean)), std::exp(quantile(tail)),
                std::exp(quantile(1.0 - tail))};
    }

  private:
    [[nodiscard]] static double effective(const std::vector<double>& weight) {
        return 1.0 / std::inner_product(weight.begin(), weight.end(), weight.begin(), 0.0);
    }

    /// Factors on the width of consecutive draws: some are wider, in case the posterior has longer tails.
    static constexpr std::array scales{1.0, 1.0, 1.5, 1.0, 2.2};

    struct Proposal {
        NormalDensity normal;
        Matrix factor;
        double count;

        [[nodiscard]] double density(const Vector& point) const {
            const double distance =
                factor.template triangularView<Eigen::Lower>().solve(point - normal.mean).squaredNorm();
            double sum = 0.0;
            for (const double scale : scales)
                sum += std::exp(-0.5 * distance / (scale * scale)) / std::pow(scale, CurvePosterior::size);
            return count * sum / factor.diagonal().prod();
        }
    };

    /// Weights: posterior over the mixture of all densities drawn from (Owen & Zhou 2000).
    void weigh() {
        log_weight_.resize(point_.size());
        for (std::size_t i = 0; i < point_.size(); ++i) {
            double density = 0.0;
            for (const Proposal& proposal : proposals_) density += proposal.density(point_[i]);
            log_weight_[i] = -value_[i] - std::log(std::max(density, 1e-300));
        }
    }

    /// The weights to a power, normalised to a sum of 1.
    [[nodiscard]] std::vector<double> weights(double power) const {
        const double best = *std::max_element(log_weight_.begin(), log_weight_.end());
        std::vector<double> result;
        double total = 0.0;
        for (const double log_weight : log_weight_)
            total += result.emplace_back(std::exp(power * (log_weight - best)));
        for (double& weight : result) weight /= total;
        return result;
    }

    const CurvePosterior& posterior_;
    std::vector<Proposal> proposals_;
    std::vector<Vector> point_;
    std::vector<double> value_;
    std::vector<double> log_weight_;
};

/// Modes at ever less noise, each found from the one before. Where the noise is large, no impact is an
/// outlier that the curve can do without, so that there are hardly any false modes.
std::vector<Mode> modes_from(const CurvePosterior& posterior, Vector point) {
    std::vector<Mode> modes;
    for (const double noise : {1.6, 0.8, 0.0}) {
        point[CurvePosterior::noise] = noise;
        modes.push_back(find_mode(posterior, point));
        point = modes.back().normal.mean;
    }
    return modes;
}

/// The modes found from the two best starting velocities, the one of greatest weight first.
std::vector<Mode> modes_of(const CurvePosterior& posterior, const std::vector<double>& velocities) {
    std::vector<std::pair<double, Vector>> starts;
    for (const double v : velocities) {
        Vector point = Vector::Zero();
        point[CurvePosterior::critical] = std::log(v);
        starts.emplace_back(posterior(point), point);
    }
    std::sort(starts.begin(), starts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Mode> modes = modes_from(posterior, starts[0].second);
    for (Mode& mode : modes_from(posterior, starts[1].second)) modes.push_back(std::move(mode));
    std::sort(modes.begin(), modes.end(),
              [](const Mode& a, const Mode& b) { return a.log_weight > b.log_weight; });
    return modes;
}

}  // namespace

CurveEstimate estimate_curve(const CurveTable& table, const std::vector<RecordedImpact>& impacts,
                             const CurvePrior& prior, const std::vector<double>& starts) {
    const CurvePosterior posterior(table, impacts, prior);
    const std::vector<Mode> modes = modes_of(posterior, starts);
    if (!(modes.front().value < 1e9)) throw ConvergenceError("no curve of damping explains the impacts");
    Draws draws(posterior);
    for (const Mode& mode : modes)
        if (mode.log_weight > modes.front().log_weight - 5.0) draws.add(mode.normal, 250);
    draws.add(draws.moments(), 300);
    for (int i = 0; i < 12 && (i < 2 || draws.effective() < 500.0); ++i) draws.add(draws.moments(), 400);
    for (int i = 0; i < 18 && draws.effective() < least_effective; ++i) draws.add(draws.moments(), 400);
    if (draws.effective() < least_effective)
        throw ConvergenceError(
            "the stated uncertainties are so small that hardly any smooth damping explains all impacts (the "
            "curves drawn are worth " +
            shortest(std::round(draws.effective())) + " independent ones, " +
            shortest(std::round(least_effective)) +
            " are needed); remedies: larger uncertainties, or the scatter of particle sizes (--size-scatter, "
            "in a case \"size_scatter\" under \"fit\")");
    const Interval velocity = draws.critical_velocity();
    const auto damping = [&](double at) { return std::exp(table.log_capture_damping(std::log(at))); };
    const double v = velocity.value;
    const double slope = (damping(1.001 * v) - damping(0.999 * v)) / (0.002 * v);
    double fastest = -1e300;
    for (const RecordedImpact& impact : impacts) fastest = std::max(fastest, impact.log_velocity);
    return {.critical_velocity = velocity,
            .critical_damping = {damping(velocity.value), slope * velocity.standard_uncertainty,
                                 damping(*velocity.lower), damping(*velocity.upper)},
            .parameters = draws.likeliest(),
            .effective = draws.effective(),
            .scatter = posterior.scatter_of(draws.likeliest()),
            .fastest = fastest};
}

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/extrapolation/damping_curve_fit.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/numeric/gsl/solvers.hpp"
#include "solver/numeric/gsl/statistics.hpp"
#include "solver/numeric/least_median.hpp"

namespace ashimpact {

namespace {

constexpr double curve_reach = 0.995;  ///< of the greatest restitution: the upper end of any curve
constexpr double extension = 0.02;     ///< how far a curve extends above the greatest measured restitution

constexpr double no_curve = 1e4;              ///< residual of every row if the curve does not exist
constexpr std::size_t many_rebounds = 20000;  ///< rebounds, from which some of them give the start of the fit
constexpr std::size_t some_rebounds =
    2000;                               ///< rebounds give a start from which few steps through all are left
constexpr int most_reweighted = 50;     ///< passes of a robust fit
constexpr double steady_weight = 1e-4;  ///< change of weights at which a robust fit has converged
constexpr double parameter_tolerance = 1e-11;  ///< relative: far below the uncertainty of any coefficient
constexpr double gradient_tolerance = 1e-12;

constexpr std::size_t rebounds_together = 1000;  ///< on one thread

/// Data of a fit of eta(e_n). Robust fits give rebounds weights below one.
struct RestitutionData {
    std::vector<Measurement> rebounds;  ///< each with its noise
    std::vector<double> weights;
    double greatest_restitution;  ///< upper end of the curve
};

/// The rebounds of a set that a fit can use, by rising velocity, with their indices in the set.
struct ReboundSelection {
    RestitutionData data;  ///< without captures; noise that is not known is 1 m/s
    std::vector<std::size_t> indices;
    std::vector<ExcludedRebound> excluded;
    bool noise_known;
};

bool above_reach(const Measurement& point) {
    if (!point.noise) return point.rebound >= point.velocity;
    const double variance = point.noise->incident + point.noise->rebound - 2.0 * point.noise->covariance;
    return point.rebound - point.velocity > 3.0 * std::sqrt(variance);
}

/// The greatest median of five neighbours in velocity, which no outlier reaches alone.
double greatest_common_restitution(const std::vector<Measurement>& rebounds) {
    double greatest = 0.0;
    for (std::size_t i = 0; i < rebounds.size(); ++i) {
        const std::size_t first = std::min(i, rebounds.size() - std::min<std::size_t>(5, rebounds.size()));
        std::vector<double> around;
        for (std::size_t j = first; j < std::min(first + 5, rebounds.size()); ++j)
            around.push_back(rebounds[j].restitution());
        const auto middle = around.begin() + static_cast<std::ptrdiff_t>(around.size() / 2);
        std::nth_element(around.begin(), middle, around.end());
        greatest = std::max(greatest, *middle);
    }
    return greatest;
}

/// @param robust the curve ends above the restitutions that neighbours share, not above that of an outlier,
///     which only a curve that folds back could reach
ReboundSelection select_rebounds(const ContactModel& model, const MeasurementSet& set, bool robust) {
    ReboundSelection selection{
        .data = {{}, {}, 0.0}, .indices = {}, .excluded = {}, .noise_known = set.has_noise()};
    double greatest = 0.0;
    double fastest = 0.0;
    std::vector<std::size_t> order(set.points.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, {}, [&](std::size_t i) { return set.points[i].key(); });
    for (const std::size_t i : order) {
        const Measurement& point = set.points[i];
        if (point.captured()) continue;
        if (above_reach(point)) {
            selection.excluded.push_back({i, Exclusion::above_reach});
            continue;
        }
        selection.indices.push_back(i);
        selection.data.rebounds.push_back(point);
        if (!point.noise) selection.data.rebounds.back().noise = VelocityNoise{1.0, 1.0};
        greatest = std::max(greatest, point.restitution());
        fastest = std::max(fastest, point.velocity);
    }
    selection.data.weights.assign(selection.indices.size(), 1.0);
    if (robust) greatest = greatest_common_restitution(selection.data.rebounds);
    if (!selection.indices.empty())
        selection.data.greatest_restitution =
            std::min(greatest + extension, curve_reach * model.greatest_restitution(fastest));
    return selection;
}

/// @throws InputError unless there are enough distinct rebounds for a curve of this order
void require_enough(const ReboundSelection& selection, const MeasurementSet& set, int order) {
    std::set<double> distinct;
    const auto needed = static_cast<std::size_t>(order) + (selection.noise_known ? 1 : 2);
    for (const Measurement& point : selection.data.rebounds) {
        distinct.insert(point.restitution());
        if (distinct.size() >= needed) return;
    }
    std::string problem = std::to_string(distinct.size()) + " distinct restitutions of " +
                          std::to_string(selection.data.rebounds.size()) +
                          " rebounds for a damping curve of order " + std::to_string(order);
    if (!selection.noise_known) problem += " with unknown uncertainties";
    throw InputError(problem, "at least " + std::to_string(needed)).at(FileName{set.source});
}

/// First coefficients, by least squares of the inverted damping on the restitution: biased by the noise in
/// both, but close. A lower order is used if @p order gives no curve. @throws ConvergenceError if no order
/// does
/// @param robust by the least median of their residuals, so that outliers do not matter
Eigen::VectorXd starting_coefficients(const ContactModel& model, const RestitutionData& data, int order,
                                      bool robust) {
    const auto rows = static_cast<Eigen::Index>(data.rebounds.size());
    Eigen::MatrixXd design(rows, order + 1);
    Eigen::VectorXd damping(rows);
    const auto& rebounds = data.rebounds;
    batch::for_chunks(rebounds.size(), rebounds_together, 0, [&](std::size_t first, std::size_t size) {
        for (std::size_t i = first; i < first + size; ++i) {
            const Measurement& point = rebounds[i];
            const double most = curve_reach * model.greatest_restitution(point.velocity);
            const double e = std::min(point.restitution(), most);
            const auto row = static_cast<Eigen::Index>(i);
            design.row(row) = DampingPolynomial::powers(e, order).transpose();
            damping[row] = model.damping(point.velocity, e).value;
        }
    });
    const auto is_curve = [&](const Eigen::VectorXd& coefficients) {
        return RestitutionCurve::implied_by(model, {coefficients}, data.greatest_restitution).has_value();
    };
    if (robust)
        if (auto start = least_median(design, damping, is_curve)) return *start;
    for (int lower = order; lower >= 0; --lower) {
        Eigen::VectorXd start = Eigen::VectorXd::Zero(order + 1);
        start.head(lower + 1) = gsl::fit_linear(design.leftCols(lower + 1), damping, {}).parameters;
        if (is_curve(start)) return start;
    }
    throw ConvergenceError("no damping curve through the measurements could be started");
}

/// Distances of the rebounds, in units of their noise, from the curve that a damping implies in the plane
/// (v_in, v_r), as a function of the coefficients of eta(e_n): orthogonal-distance regression. It accounts
/// for the errors of both velocities, and so for the correlated ones of e and eta.
class RestitutionDistances {
  public:
    RestitutionDistances(const ContactModel& model, const RestitutionData& data)
        : model_(&model), data_(&data) {}

    struct Rows {
        Eigen::VectorXd residuals;  ///< signed distances times the roots of the weights
        Eigen::MatrixXd jacobian;
        std::vector<double> restitutions;  ///< of the nearest points of the curve
    };
    /// Rows for coefficients. If the curve does not exist, the residuals are so large that a fit rejects the
    /// step.
    [[nodiscard]] const Rows& rows(const Eigen::VectorXd& coefficients) const {
        if (last_.size() != coefficients.size() || last_ != coefficients) {
            rows_ = computed(coefficients);
            last_ = coefficients;
        }
        return rows_;
    }

  private:
    [[nodiscard]] Rows computed(const Eigen::VectorXd& coefficients) const {
        const auto count = static_cast<Eigen::Index>(data_->rebounds.size());
        const int order = static_cast<int>(coefficients.size()) - 1;
        Rows rows{Eigen::VectorXd::Constant(count, no_curve), Eigen::MatrixXd::Zero(count, order + 1), {}};
        const auto curve = RestitutionCurve::implied_by(*model_, {coefficients}, data_->greatest_restitution,
                                                        curve_ ? &*curve_ : nullptr);
        if (!curve) return rows;
        rows.restitutions.resize(data_->rebounds.size());
        const auto add = [&](std::size_t point) {
            const auto i = static_cast<Eigen::Index>(point);
            const Measurement& rebound = data_->rebounds[point];
            const auto nearest = curve->project(rebound, start_of(point));
            const double weight = std::sqrt(data_->weights[point]);
            rows.residuals[i] = weight * nearest.distance;
            rows.jacobian.row(i) = weight * nearest.by_damping *
                                   DampingPolynomial::powers(nearest.restitution, order).transpose();
            rows.restitutions[point] = nearest.restitution;
        };
        batch::for_chunks(data_->rebounds.size(), rebounds_together, 0,
                          [&](std::size_t first, std::size_t size) {
                              for (std::size_t point = first; point < first + size; ++point) add(point);
                          });
        curve_ = curve;
        return rows;
    }

    [[nodiscard]] double start_of(std::size_t rebound) const {
        if (!rows_.restitutions.empty()) return rows_.restitutions[rebound];
        return std::clamp(data_->rebounds[rebound].restitution(), 0.0, data_->greatest_restitution);
    }

    const ContactModel* model_;
    const RestitutionData* data_;
    // Cache of the last evaluation: a fit calls for residuals and jacobian one after the other, and the last
    // curve gives first guesses for the next one.
    mutable Eigen::VectorXd last_;
    mutable Rows rows_;
    mutable std::optional<RestitutionCurve> curve_;
};

/// Matrix from values of eta at evenly spaced restitutions, the first at e = 0, to coefficients. A fit of the
/// values is better conditioned, because coefficients of different powers differ in size.
Eigen::MatrixXd coefficients_from_values(double greatest_restitution, Eigen::Index count) {
    Eigen::MatrixXd powers(count, count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const double share = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0.0;
        powers.row(i) =
            DampingPolynomial::powers(share * greatest_restitution, static_cast<int>(count) - 1).transpose();
    }
    return powers.inverse();
}

/// Coefficients of least squares where they may have kinks: the nearest point of the curve can jump from one
/// of its branches to another.
Eigen::VectorXd closest_over_kinks(const ContactModel& model, const RestitutionData& data,
                                   const Eigen::VectorXd& start) {
    const RestitutionDistances distances(model, data);
    const Eigen::MatrixXd to_coefficients = coefficients_from_values(data.greatest_restitution, start.size());
    const auto sum = [&](const Eigen::VectorXd& x) {
        return distances.rows(to_coefficients * x).residuals.squaredNorm();
    };
    const Eigen::VectorXd values = to_coefficients.partialPivLu().solve(start);
    const double step = 0.02 * values.cwiseAbs().maxCoeff();
    return to_coefficients * gsl::minimise(sum, values, Eigen::VectorXd::Constant(values.size(), step));
}

/// Some of many rebounds, evenly over the velocities.
RestitutionData thinned(const RestitutionData& data, std::size_t count) {
    RestitutionData few{{}, {}, data.greatest_restitution};
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t place = i * data.rebounds.size() / count;
        few.rebounds.push_back(data.rebounds[place]);
        few.weights.push_back(data.weights[place]);
    }
    return few;
}

/// Coefficients of the curve closest to the rebounds, by least squares of their distances.
/// @param start coefficients of a similar curve @throws ConvergenceError
Eigen::VectorXd closest(const ContactModel& model, const RestitutionData& data,
                        const Eigen::VectorXd& start) {
    const RestitutionDistances distances(model, data);
    const Eigen::MatrixXd to_coefficients = coefficients_from_values(data.greatest_restitution, start.size());
    const Eigen::VectorXd near =
        data.rebounds.size() > many_rebounds ? closest(model, thinned(data, some_rebounds), start) : start;
    const gsl::NonlinearProblem problem{
        .residuals = [&](const Eigen::VectorXd& x) { return distances.rows(to_coefficients * x).residuals; },
        .jacobian = [&](const Eigen::VectorXd& x) -> Eigen::MatrixXd {
            return distances.rows(to_coefficients * x).jacobian * to_coefficients;
        }};
    const gsl::NonlinearFit fit = gsl::fit_nonlinear(problem, to_coefficients.partialPivLu().solve(near),
                                                     {.parameter_tolerance = parameter_tolerance,
                                                      .gradient_tolerance = gradient_tolerance,
                                                      .smooth = false});
    const Eigen::VectorXd coefficients = to_coefficients * fit.parameters;
    return fit.stationary ? coefficients : closest_over_kinks(model, data, coefficients);
}

/// Like closest(), with bisquare weights, which are stored in @p data.
Eigen::VectorXd closest_robustly(const ContactModel& model, RestitutionData& data, Eigen::VectorXd start) {
    RestitutionData plain = data;
    for (int i = 0; i < most_reweighted; ++i) {
        const Eigen::VectorXd weights = gsl::bisquare_weights(
            RestitutionDistances(model, plain).rows(start).residuals, static_cast<int>(start.size()));
        double change = 0.0;
        for (std::size_t j = 0; j < data.weights.size(); ++j) {
            const double weight = weights[static_cast<Eigen::Index>(j)];
            change = std::max(change, std::abs(weight - data.weights[j]));
            data.weights[j] = weight;
        }
        if (change < steady_weight) break;
        start = closest(model, data, start);
    }
    return start;
}

/// Covariance of coefficients, (J^T J)^-1 of the jacobian of normalised residuals.
Eigen::MatrixXd covariance_from(const Eigen::MatrixXd& jacobian) {
    // Scaled to unit diagonal first: the powers of e differ by orders of magnitude.
    const Eigen::VectorXd scale = jacobian.colwise().norm().cwiseInverse();
    const Eigen::MatrixXd scaled = jacobian * scale.asDiagonal();
    const Eigen::MatrixXd inverse =
        (scaled.transpose() * scaled).ldlt().solve(Eigen::MatrixXd::Identity(scale.size(), scale.size()));
    return scale.asDiagonal() * inverse * scale.asDiagonal();
}

constexpr double least_probability = 0.01;  ///< of the scatter, below which the noise is enlarged

/// @param rows with the noise as it was measured, or 1 m/s
void add_goodness(DampingCurveFit& fit, const RestitutionDistances::Rows& rows,
                  const std::vector<double>& weights) {
    constexpr double rounding = 1e-13;
    const double effective = std::accumulate(weights.begin(), weights.end(), 0.0);
    const int freedom = std::max(0, static_cast<int>(std::lround(effective)) - fit.options.order - 1);
    fit.degrees_of_freedom = freedom;
    fit.chi_squared = rows.residuals.squaredNorm();
    fit.probability = fit.noise_known ? gsl::chi_squared_exceedance(fit.chi_squared, freedom) : 1.0;
    const bool enlarge = !fit.noise_known || fit.probability < least_probability;
    const double scatter = enlarge && freedom > 0 ? std::sqrt(fit.chi_squared / freedom) : 1.0;
    fit.scatter = std::max(scatter, rounding);
}

/// The interval of eta_c from the curvature of the fit.
Interval curvature_interval(const DampingCurveFit& fit) {
    const double value = fit.damping.coefficients[0];
    const double deviation = std::sqrt(fit.covariance(0, 0));
    const bool estimated = fit.scatter != 1.0;
    const double quantile =
        gsl::student_quantile(0.5 + 0.5 * confidence, estimated ? fit.degrees_of_freedom : 0);
    Interval interval{value, deviation, value - quantile * deviation, value + quantile * deviation};
    if (*interval.lower <= 0.0) interval.lower = std::nullopt;
    return interval;
}

double critical_velocity_at(const ContactModel& model, double damping) {
    return model.critical_velocity_anywhere(damping).value_or(0.0);
}

/// The interval of v_c from that of eta_c. v_c rises with eta_c, so the ends correspond.
Interval critical_velocity_of(const ContactModel& model, const Interval& damping) {
    const double value = critical_velocity_at(model, damping.value);
    const double nudge = 1e-4 * damping.value;
    const double slope = (critical_velocity_at(model, damping.value + nudge) -
                          critical_velocity_at(model, damping.value - nudge)) /
                         (2.0 * nudge);
    Interval velocity{value, slope * damping.standard_uncertainty};
    if (damping.lower) velocity.lower = critical_velocity_at(model, *damping.lower);
    if (damping.upper) velocity.upper = critical_velocity_at(model, *damping.upper);
    return velocity;
}

/// Adds an independent error of a standard uncertainty to an interval.
void widen(Interval& interval, double uncertainty) {
    const double value = interval.value;
    const double half = confidence_quantile() * uncertainty;
    interval.standard_uncertainty = std::hypot(interval.standard_uncertainty, uncertainty);
    if (interval.lower) interval.lower = value - std::hypot(value - *interval.lower, half);
    if (interval.upper) interval.upper = value + std::hypot(*interval.upper - value, half);
}

/// @param rows in units of the noise that explains the scatter
void add_rebounds(DampingCurveFit& fit, const RestitutionDistances::Rows& rows,
                  const ReboundSelection& selection) {
    double sum = 0.0;
    double weights = 0.0;
    for (std::size_t i = 0; i < selection.indices.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        const double weight = selection.data.weights[i];
        const Eigen::VectorXd by_point = fit.covariance * rows.jacobian.row(row).transpose();
        const double leverage = rows.jacobian.row(row).dot(by_point);
        const double deleted = rows.residuals[row] / std::max(1.0 - leverage, 1e-12);
        const double root = weight > 0.0 ? std::sqrt(weight) : 1.0;
        fit.rebounds.push_back({.index = selection.indices[i],
                                .restitution = rows.restitutions[i],
                                .distance = rows.residuals[row] / root,
                                .leverage = leverage,
                                .deleted_distance = deleted / root,
                                .influence = by_point[0] * deleted,
                                .weight = weight});
        sum += deleted * deleted;
        weights += weight;
    }
    fit.prediction_error = std::sqrt(sum / weights);
    std::ranges::sort(fit.rebounds, {}, &FittedRebound::index);
}

void add_range(DampingCurveFit& fit, const RestitutionData& data) {
    fit.restitutions = {1.0, 0.0};
    for (const Measurement& point : data.rebounds) {
        fit.restitutions[0] = std::min(fit.restitutions[0], point.restitution());
        fit.restitutions[1] = std::max(fit.restitutions[1], point.restitution());
    }
    fit.extrapolation = fit.restitutions[0] / (fit.restitutions[1] - fit.restitutions[0]);
}

}  // namespace

DampingCurveFit fit_damping_curve(const ContactModel& model, const MeasurementSet& set,
                                  const DampingCurveOptions& options) {
    validate(set);
    ReboundSelection selection = select_rebounds(model, set, options.robust);
    require_enough(selection, set, options.order);
    RestitutionData& data = selection.data;
    const Eigen::VectorXd start = starting_coefficients(model, data, options.order, options.robust);
    const Eigen::VectorXd near =
        options.robust ? closest_robustly(model, data, start) : closest(model, data, start);
    RestitutionDistances::Rows rows = RestitutionDistances(model, data).rows(near);
    if (rows.restitutions.empty())
        throw ConvergenceError("the polynomial closest to the rebounds gives some of them at no velocity");
    if (!(near[0] > 0.0)) throw ConvergenceError("the polynomial gives no positive damping at e = 0");
    const auto taken = std::ranges::count_if(data.weights, [](double weight) { return weight > 0.0; });
    if (taken <= options.order)
        throw ConvergenceError("all but " + std::to_string(taken) +
                               " rebounds are outliers to the polynomial");

    DampingCurveFit fit{};
    fit.options = options;
    fit.damping = {near};
    fit.excluded = selection.excluded;
    std::ranges::sort(fit.excluded, {}, &ExcludedRebound::index);
    fit.noise_known = selection.noise_known;
    add_goodness(fit, rows, data.weights);
    rows.residuals /= fit.scatter;
    rows.jacobian /= fit.scatter;
    fit.covariance = covariance_from(rows.jacobian);
    fit.critical_damping = curvature_interval(fit);
    fit.critical_velocity = critical_velocity_of(model, fit.critical_damping);
    add_rebounds(fit, rows, selection);
    add_range(fit, data);
    if (!fit.covariance.allFinite() || !std::isfinite(fit.critical_velocity.standard_uncertainty) ||
        !std::isfinite(fit.prediction_error) || !std::isfinite(fit.extrapolation))
        throw ConvergenceError("the rebounds leave the polynomial undetermined");
    return fit;
}

void add_common_error(DampingCurveFit& fit, const ContactModel& model, const MeasurementSet& set,
                      double relative) {
    constexpr double step = 0.01;  // small enough to be linear, and to keep the rebounds that are fitted
    MeasurementSet faster = set;
    for (Measurement& point : faster.points) {
        point.velocity *= 1 + step;
        point.rebound *= 1 + step;
        if (point.noise) point.noise = point.noise->scaled((1 + step) * (1 + step));
    }
    const DampingCurveFit other = fit_damping_curve(model, faster, fit.options);
    const double steps = relative / step;
    const Eigen::VectorXd change = steps * (other.damping.coefficients - fit.damping.coefficients);
    const double of_velocity = steps * (other.critical_velocity.value - fit.critical_velocity.value);
    fit.covariance += change * change.transpose();
    widen(fit.critical_damping, change[0]);
    widen(fit.critical_velocity, of_velocity);
    if (fit.critical_damping.lower && *fit.critical_damping.lower <= 0)
        fit.critical_damping.lower = fit.critical_velocity.lower = std::nullopt;
}

void require_rebounds_above(const DampingCurveFit& fit, const MeasurementSet& set) {
    const auto count = static_cast<double>(set.points.size());
    const double extreme = gsl::normal_quantile(1.0 - 0.5 * (1.0 - confidence) / count);
    std::optional<double> slowest;
    std::optional<double> bound;
    std::vector<bool> outlying(set.points.size(), false);
    for (const FittedRebound& rebound : fit.rebounds) outlying[rebound.index] = rebound.weight < 0.5;
    for (const ExcludedRebound& rebound : fit.excluded) outlying[rebound.index] = true;
    for (std::size_t i = 0; i < set.points.size(); ++i) {
        if (outlying[i]) continue;
        const Measurement& point = set.points[i];
        const VelocityNoise noise =
            fit.noise_known ? point.noise.value_or(VelocityNoise{1.0, 1.0}) : VelocityNoise{1.0, 1.0};
        if (point.captured() || point.rebound <= 3.0 * (fit.scatter * std::sqrt(noise.rebound))) continue;
        if (!slowest || point.velocity < *slowest) slowest = point.velocity;
        const double most = point.velocity + extreme * (fit.scatter * std::sqrt(noise.incident));
        if (!bound || most < *bound) bound = most;
    }
    const Interval& fitted = fit.critical_velocity;
    const double least =
        fitted.lower.value_or(fitted.value - confidence_quantile() * fitted.standard_uncertainty);
    if (!bound || least <= *bound) return;
    throw InputError("the fitted v_c of " + shortest(fitted.value) +
                         " m/s lies above clear rebounds, the slowest at " + shortest(*slowest) + " m/s",
                     "impacts from the rising branch")
        .at(FileName{set.source});
}

std::optional<std::string> enlargement_note(const DampingCurveFit& fit) {
    if (!fit.noise_known || fit.scatter == 1.0) return std::nullopt;
    return "the rebounds scatter " + shortest(std::round(100.0 * fit.scatter) / 100.0) +
           " times their stated uncertainty about a damping of order " + std::to_string(fit.options.order) +
           " in the restitution: uncertainties are enlarged by that";
}

}  // namespace ashimpact

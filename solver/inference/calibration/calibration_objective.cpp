// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/calibration/calibration_objective.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>

#include "core/text/error.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"

namespace ashimpact {

namespace {

double& constant_of(CalibrationSample& sample, CalibrationQuantity quantity) {
    switch (quantity) {
        case CalibrationQuantity::density:
            return sample.density;
        case CalibrationQuantity::work_of_adhesion:
            return sample.work_of_adhesion;
        case CalibrationQuantity::wall_young_modulus:
            return sample.wall.young_modulus;
        case CalibrationQuantity::contact_modulus:
            break;
    }
    if (!sample.contact_modulus) sample.contact_modulus = contact_modulus(sample.particle, sample.wall);
    return *sample.contact_modulus;
}

double predicted_velocity(const CalibrationSample& sample, Law law, double damping) {
    const CriticalVelocity critical =
        critical_velocity({law, law.default_detachment(), {DampingLaw::constant, damping}, sample.contact()});
    if (!critical.value)
        throw InputError("law '" + std::string(law.name()) + "' has no finite critical velocity here",
                         "damping > 0 kg/s");
    return *critical.value;
}

PublishedDamping published_damping(const CalibrationSample& sample, const ContactTimeObservation& at) {
    return {.law = at.law,
            .detachment = at.law.default_detachment(),
            .contact = sample.contact(),
            .damping = at.damping_fit};
}

double contact_time(const PublishedDamping& published, const CurvePoint& at) {
    const Impact impact{published.law,
                        published.detachment,
                        {DampingLaw::constant, published.damping(at.restitution)},
                        published.contact,
                        at.velocity};
    return solve_impact(impact).contact_time.value();
}

/// Power of v_c/v with which the substitute for a contact time grows on the captured side: about the slope of
/// the real time just above v_c, so that the weights do not jump there.
constexpr double captured_growth = 3.0;

/// Contact time at @p velocity on the curve that the published fit implies. A captured impact has none; its
/// substitute is the time of a rebound just above the v_c of eta(0), growing with the distance to v_c, so
/// that a fit can find its way back. The time at the fold would not do: its slope there is unbounded, and
/// fits get stuck.
double predicted_time(const CalibrationSample& sample, const ContactTimeObservation& at, double velocity) {
    const PublishedDamping published = published_damping(sample, at);
    const double e = reconstructed_restitution(published, velocity);
    if (e > 0.0) return contact_time(published, {velocity, e});
    const double above = (1.0 + 1e-6) * predicted_velocity(sample, at.law, published.damping(0.0));
    return contact_time(published, {above, 0.0}) * std::pow(above / velocity, captured_growth);
}

/// The velocity up to which the impact of a contact time is captured, that of the fold; none if it rebounds.
std::optional<double> captured_up_to(const CalibrationSample& sample, const ContactTimeObservation& at) {
    const PublishedDamping published = published_damping(sample, at);
    if (reconstructed_restitution(published, at.velocity) > 0.0) return std::nullopt;
    return least_rebound(published).velocity;
}

/// The same contact time with one coefficient of the published fit changed.
double with_coefficient(const CalibrationSample& sample, ContactTimeObservation at, Eigen::Index coefficient,
                        double change) {
    at.damping_fit.coefficients[coefficient] += change;
    return predicted_time(sample, at, at.velocity);
}

double logarithmic_slope(const std::function<double(double)>& function, double at) {
    constexpr double nudge = 1e-4;
    return std::log(function(at * (1 + nudge)) / function(at * (1 - nudge))) / (2 * nudge);
}

/// Errors of ln(prediction): those of this observation alone, and that of the printed damping, which is
/// shared [1].
struct VelocityError {
    double predicted;
    double own;
    double damping;
};

VelocityError error_of(const CalibrationSample& sample, const CriticalVelocityObservation& observed) {
    const double eta = observed.critical_damping;
    const double slope =
        logarithmic_slope([&](double x) { return predicted_velocity(sample, observed.law, x); }, eta);
    return {.predicted = predicted_velocity(sample, observed.law, eta),
            .own = observed.standard_uncertainty / observed.value,
            .damping = slope * observed.critical_damping_uncertainty / eta};
}

/// The same for a contact time; of each coefficient of the fit, in ascending powers.
struct TimeError {
    double predicted;
    double own;
    Eigen::Vector3d coefficients;
};

TimeError error_of(const CalibrationSample& sample, const ContactTimeObservation& observed) {
    const double v = observed.velocity;
    const double slope = logarithmic_slope([&](double x) { return predicted_time(sample, observed, x); }, v);
    TimeError error{.predicted = predicted_time(sample, observed, v),
                    .own = std::hypot(observed.standard_uncertainty / observed.value,
                                      slope * observed.velocity_uncertainty / v),
                    .coefficients = Eigen::Vector3d::Zero()};
    const double u = observed.damping_fit_uncertainty;
    if (u == 0.0) return error;
    for (Eigen::Index i = 0; i < error.coefficients.size(); ++i) {
        constexpr double share = 0.1;  // of the uncertainty: a difference, not the bend of the curve
        error.coefficients[i] = std::log(with_coefficient(sample, observed, i, share * u) /
                                         with_coefficient(sample, observed, i, -share * u)) /
                                (2.0 * share);
    }
    return error;
}

/// ln(predicted/observed), velocities first. @throws InputError where a law has no critical velocity
Eigen::VectorXd logarithmic_residuals(const CalibrationProblem& problem,
                                      const std::vector<CalibrationSample>& samples) {
    Eigen::VectorXd result(
        static_cast<Eigen::Index>(problem.critical_velocities.size() + problem.contact_times.size()));
    Eigen::Index row = 0;
    for (const CriticalVelocityObservation& o : problem.critical_velocities)
        result[row++] = std::log(predicted_velocity(samples[o.sample], o.law, o.critical_damping) / o.value);
    for (const ContactTimeObservation& o : problem.contact_times)
        result[row++] = std::log(predicted_time(samples[o.sample], o, o.velocity) / o.value);
    return result;
}

constexpr int coefficient_count = 3;

void require_usable(std::span<const DampingPoint> points) {
    std::set<double> distinct;
    std::size_t weighted = 0;
    for (const DampingPoint& point : points) {
        if (!std::isfinite(point.restitution) || !std::isfinite(point.damping) ||
            !(point.standard_uncertainty >= 0.0) || !std::isfinite(point.standard_uncertainty)) {
            throw InputError("a point of the damping fit is not finite or has a negative uncertainty",
                             "finite numbers");
        }
        distinct.insert(point.restitution);
        weighted += point.standard_uncertainty > 0.0 ? 1 : 0;
    }
    if (distinct.size() < coefficient_count)
        throw InputError("the damping fit has " + std::to_string(distinct.size()) + " distinct restitutions",
                         "at least 3 for a quadratic");
    if (weighted != 0 && weighted != points.size())
        throw InputError("only some points of the damping fit have an uncertainty", "all of them or none");
}

Impact impact_with(const PublishedDamping& published, double e, double velocity) {
    return {.law = published.law,
            .detachment = published.detachment,
            .damping = {DampingLaw::constant, published.damping(e)},
            .contact = published.contact,
            .velocity = velocity};
}

/// Step in restitution; the curve of a parabola eta(e) has no two turns as close as this.
constexpr double branch_step = 0.02;

/// Position of the only minimum of a function between @p a and @p b, by golden sections down to the width
/// that its rounding allows.
double least_argument(const std::function<double(double)>& function, double a, double b) {
    constexpr double golden = 0.61803398874989485;
    constexpr double narrowest = 1e-8;
    double left = b - golden * (b - a);
    double right = a + golden * (b - a);
    double at_left = function(left);
    double at_right = function(right);
    while (b - a > narrowest) {
        if (at_left < at_right) {
            b = right;
            right = left;
            at_right = at_left;
            left = b - golden * (b - a);
            at_left = function(left);
        } else {
            a = left;
            left = right;
            at_left = at_right;
            right = a + golden * (b - a);
            at_right = function(right);
        }
    }
    return (a + b) / 2.0;
}

[[noreturn]] void not_reached(double restitution, const std::string& allowed) {
    throw InputError("restitution " + std::to_string(restitution) + " is not reached at any velocity",
                     allowed);
}

/// v_c at the impact's damping [m/s]. @throws InputError for @p restitution if there is none
double finite_critical_velocity(const Impact& impact, double restitution) {
    const CriticalVelocity critical =
        critical_velocity({impact.law, impact.detachment, impact.damping, impact.contact});
    if (critical.verdict != CaptureVerdict::finite)
        not_reached(restitution, "a damping with a finite critical velocity; here: " +
                                     std::string(name_of(critical.verdict)));
    return *critical.value;
}

}  // namespace

std::vector<CalibrationSlot> slots_of(const CalibrationProblem& problem) {
    std::vector<CalibrationSlot> slots;
    for (const FreeConstant& free : problem.free) {
        if (!free.per_sample) slots.push_back({free.quantity, std::nullopt});
        for (std::size_t i = 0; free.per_sample && i < problem.samples.size(); ++i)
            slots.push_back({free.quantity, i});
    }
    return slots;
}

void require_solvable(const CalibrationProblem& problem) {
    const std::size_t constants = slots_of(problem).size();
    const std::size_t observations = problem.critical_velocities.size() + problem.contact_times.size();
    const auto known = [&](const auto& observation) { return observation.sample < problem.samples.size(); };
    for (const auto& o : problem.critical_velocities)
        if (!known(o)) throw InputError("an observation names a sample that does not exist");
    for (const auto& o : problem.contact_times)
        if (!known(o)) throw InputError("an observation names a sample that does not exist");
    if (constants == 0 || observations < constants)
        throw InputError("the calibration has " + std::to_string(observations) + " observations for " +
                             std::to_string(constants) + " free constants",
                         "at least one free constant and as many observations");
}

std::vector<CalibrationSample> samples_with(const CalibrationProblem& problem,
                                            const std::vector<CalibrationSlot>& slots,
                                            const Eigen::VectorXd& logarithms) {
    std::vector<CalibrationSample> samples = problem.samples;
    for (std::size_t i = 0; i < slots.size(); ++i) {
        const double value = std::exp(logarithms[static_cast<Eigen::Index>(i)]);
        for (std::size_t s = 0; s < samples.size(); ++s)
            if (!slots[i].sample || *slots[i].sample == s) constant_of(samples[s], slots[i].quantity) = value;
    }
    return samples;
}

Eigen::VectorXd starting_logarithms(const CalibrationProblem& problem) {
    const std::vector<CalibrationSlot> slots = slots_of(problem);
    Eigen::VectorXd logarithms(static_cast<Eigen::Index>(slots.size()));
    for (std::size_t i = 0; i < slots.size(); ++i) {
        CalibrationSample start = problem.samples[slots[i].sample.value_or(0)];
        logarithms[static_cast<Eigen::Index>(i)] = std::log(constant_of(start, slots[i].quantity));
    }
    return logarithms;
}

CalibrationResiduals calibration_residuals(const CalibrationProblem& problem,
                                           const std::vector<CalibrationSample>& samples) {
    const auto velocities = static_cast<Eigen::Index>(problem.critical_velocities.size());
    const auto times = static_cast<Eigen::Index>(problem.contact_times.size());
    CalibrationResiduals result{{}, {}, Eigen::MatrixXd::Zero(velocities + times, velocities + times)};
    std::vector<double> shared;
    for (Eigen::Index i = 0; i < velocities; ++i) {
        const auto& observed = problem.critical_velocities[static_cast<std::size_t>(i)];
        const VelocityError error = error_of(samples[observed.sample], observed);
        const double total = std::hypot(error.own, error.damping);
        result.critical_velocities.push_back({observed.value, error.predicted, total, {}});
        result.covariance(i, i) = total * total;
        shared.push_back(error.damping);
    }
    for (Eigen::Index j = 0; j < times; ++j) {
        const auto& observed = problem.contact_times[static_cast<std::size_t>(j)];
        const TimeError error = error_of(samples[observed.sample], observed);
        const double total = std::hypot(error.own, error.coefficients.norm());
        result.contact_times.push_back(
            {observed.value, error.predicted, total, captured_up_to(samples[observed.sample], observed)});
        const Eigen::Index row = velocities + j;
        result.covariance(row, row) = total * total;
        for (Eigen::Index i = 0; i < velocities; ++i) {
            const auto& velocity = problem.critical_velocities[static_cast<std::size_t>(i)];
            if (velocity.sample != observed.sample || velocity.law != observed.law) continue;
            const double covariance = shared[static_cast<std::size_t>(i)] * error.coefficients[0];
            result.covariance(row, i) = covariance;
            result.covariance(i, row) = covariance;
        }
    }
    return result;
}

CalibrationObjective::CalibrationObjective(const CalibrationProblem& problem,
                                           const Eigen::VectorXd& logarithms)
    : problem_(&problem), slots_(slots_of(problem)) {
    covariance_.compute(calibration_residuals(problem, samples_with(problem, slots_, logarithms)).covariance);
}

Eigen::VectorXd CalibrationObjective::residuals(const CalibrationProblem& problem,
                                                const Eigen::VectorXd& logarithms) const {
    return covariance_.matrixL().solve(
        logarithmic_residuals(problem, samples_with(problem, slots_, logarithms)));
}

gsl::NonlinearFit CalibrationObjective::fit(const Eigen::VectorXd& start,
                                            std::optional<Eigen::Index> held) const {
    const gsl::NonlinearFitOptions options{
        .parameter_tolerance = 1e-9, .gradient_tolerance = 1e-10, .difference_step = 1e-5};
    std::vector<Eigen::Index> moved;
    for (Eigen::Index i = 0; i < start.size(); ++i)
        if (i != held) moved.push_back(i);
    const auto with_moved = [&](const Eigen::VectorXd& x) {
        Eigen::VectorXd all = start;
        all(moved) = x;
        return residuals(all);
    };
    return gsl::fit_nonlinear({with_moved}, start(moved), options);
}

DampingFit fit_damping(std::span<const DampingPoint> points) {
    require_usable(points);
    const auto count = static_cast<Eigen::Index>(points.size());
    const bool weighted = points.front().standard_uncertainty > 0.0;
    Eigen::MatrixXd design(count, coefficient_count);
    Eigen::VectorXd observations(count);
    Eigen::VectorXd weights(weighted ? count : 0);
    for (Eigen::Index i = 0; i < count; ++i) {
        const DampingPoint& point = points[static_cast<std::size_t>(i)];
        design.row(i) << point.restitution * point.restitution, point.restitution, 1.0;
        observations[i] = point.damping;
        if (weighted) weights[i] = 1.0 / (point.standard_uncertainty * point.standard_uncertainty);
    }
    const gsl::LinearFit linear = gsl::fit_linear(design, observations, weights);

    DampingFit fit{};
    fit.damping.coefficients = linear.parameters.reverse();
    fit.chi_squared = linear.chi_squared;
    fit.degrees_of_freedom = static_cast<int>(count) - coefficient_count;
    const double freedom = std::max(1, fit.degrees_of_freedom);
    fit.residual_deviation = (observations - design * linear.parameters).norm() / std::sqrt(freedom);
    const double scatter = weighted ? 1.0 : linear.chi_squared / freedom;
    fit.covariance = scatter * linear.covariance.reverse();
    return fit;
}

double velocity_of_restitution(const Impact& impact, double restitution) {
    if (impact.damping.law != DampingLaw::constant)
        throw InputError("restitution need not rise with velocity for damping law '" +
                             std::string(name_of(impact.damping.law)) + "'",
                         std::string(name_of(DampingLaw::constant)));
    if (can_yield(impact.law, impact.contact))
        throw InputError("restitution need not rise with velocity where the contact yields",
                         "a contact without yield pressure");
    if (!(restitution > 0.0 && restitution < 1.0)) not_reached(restitution, "0 < e < 1");
    const double critical = finite_critical_velocity(impact, restitution);
    const auto miss = [&](double log_velocity) {
        Impact at = impact;
        at.velocity = std::exp(log_velocity);
        return restitution_of(at) - restitution;
    };
    const double lower = std::log(critical);
    if (miss(lower) >= 0.0) return critical;  // v_c itself, to rounding
    double width = 1.0;
    while (miss(lower + width) < 0.0) {
        width *= 2.0;
        if (width > 256.0) not_reached(restitution, "a smaller restitution for this damping law");
    }
    return std::exp(gsl::brent(miss, lower, lower + width, {.relative = 0.0, .absolute = 1e-13}).root);
}

double reconstructed_velocity(const PublishedDamping& published, double e) {
    return velocity_of_restitution(impact_with(published, e, 1.0), e);
}

CurvePoint least_rebound(const PublishedDamping& published) {
    const CurvePoint onset{finite_critical_velocity(impact_with(published, 0.0, 1.0), 0.0), 0.0};
    CurvePoint least = onset;
    double lower = 0.0;
    double upper = branch_step;
    while (upper < 1.0) {  // as far as the curve runs back
        const double velocity = reconstructed_velocity(published, upper);
        if (velocity >= least.velocity) break;
        lower = std::max(0.0, upper - branch_step);
        least = {velocity, upper};
        upper += branch_step;
    }
    const double e = least_argument([&](double at) { return reconstructed_velocity(published, at); }, lower,
                                    std::min(upper, 0.999));
    least = {reconstructed_velocity(published, e), e};
    return least.velocity < onset.velocity ? least : onset;
}

double reconstructed_restitution(const PublishedDamping& published, double velocity) {
    const auto excess = [&](double e) { return restitution_of(impact_with(published, e, velocity)) - e; };
    double from = 0.0;
    if (excess(0.0) <= 0.0) {
        const CurvePoint least = least_rebound(published);
        if (velocity < least.velocity || least.restitution == 0.0) return 0.0;
        from = least.restitution;
        if (excess(from) <= 0.0) return from;  // the fold itself, to rounding
    }
    double to = from + branch_step;
    while (to < 1.0 && excess(to) > 0.0) {
        from = to;
        to += branch_step;
    }
    return gsl::brent(excess, from, std::min(to, 1.0), {.relative = 0.0, .absolute = 1e-13}).root;
}

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/calibration/calibration.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/inference/calibration/velocities_over_sizes.hpp"
#include "solver/motion/impact.hpp"
#include "solver/numeric/gsl/solvers.hpp"

namespace ashimpact {

namespace {

/// One fitted number: a quantity of one sample, or of all.
struct CalibrationSlot {
    CalibrationQuantity quantity;
    std::optional<std::size_t> sample;
};

double& constant_of(CalibrationSample& sample, CalibrationQuantity quantity) {
    switch (quantity) {
        case CalibrationQuantity::density:
            return sample.density;
        case CalibrationQuantity::work_of_adhesion:
            return sample.work_of_adhesion;
        case CalibrationQuantity::wall_young_modulus:
            return sample.wall.young_modulus;
        case CalibrationQuantity::time_step:
            if (sample.step.time_step == 0.0) sample.step.time_step = first_time_step;
            return sample.step.time_step;
        case CalibrationQuantity::yield_pressure:
            return sample.yield_pressure;
        case CalibrationQuantity::damping:
            if (!sample.damping) sample.damping = Damping{};
            return sample.damping->coefficient;
        case CalibrationQuantity::contact_modulus:
            break;
    }
    if (!sample.contact_modulus) sample.contact_modulus = contact_modulus(sample.particle, sample.wall);
    return *sample.contact_modulus;
}

/// Substitute for v_c where everything is captured, or where adhesion yields more than the law can describe,
/// so that a fit steps back from there [m/s].
constexpr double captured_at_all = 1e6;

CriticalVelocity critical_velocity_or_capture(const CriticalVelocityProblem& problem) {
    try {
        return critical_velocity(problem);
    } catch (const InputError&) {
        if (!can_yield(problem.law, problem.contact)) throw;
        return {CaptureVerdict::always_captured};
    }
}

double predicted_velocity(const CalibrationSample& sample, Law law, double damping) {
    const ContactPair contact = sample.contact();
    const CriticalVelocity critical = critical_velocity_or_capture(
        {law, law.default_detachment(), sample.damping.value_or(Damping{DampingLaw::constant, damping}),
         sample.step.contact(damping, contact)});
    if (critical.verdict == CaptureVerdict::always_captured) return captured_at_all;
    if (!critical.value)
        throw InputError("law '" + std::string(law.name()) + "' has no finite critical velocity here",
                         "damping > 0 kg/s");
    return *critical.value / (1.0 + sample.step.lag(damping, contact));
}

PublishedDamping published_damping(const CalibrationSample& sample, const ContactTimeObservation& at) {
    return {.law = at.law,
            .detachment = at.law.default_detachment(),
            .contact = sample.contact(),
            .damping = at.damping_fit,
            .step = sample.step};
}

double contact_time(const PublishedDamping& published, double e, double velocity) {
    return solve_impact(published.impact(e, velocity)).contact_time.value();
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
    if (e > 0.0) return contact_time(published, e, velocity);
    const double above = (1.0 + 1e-6) * predicted_velocity(sample, at.law, published.damping(0.0));
    return contact_time(published, 0.0, above) * std::pow(above / velocity, captured_growth);
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
    VelocityError error{.predicted = predicted_velocity(sample, observed.law, eta),
                        .own = observed.standard_uncertainty / observed.value,
                        .damping = 0};
    if (observed.critical_damping_uncertainty == 0) return error;
    const double slope =
        logarithmic_slope([&](double x) { return predicted_velocity(sample, observed.law, x); }, eta);
    error.damping = slope * observed.critical_damping_uncertainty / eta;
    return error;
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
    for (const double each :
         in_parallel(problem.critical_velocities, [&](const CriticalVelocityObservation& o) {
             return std::log(predicted_velocity(samples[o.sample], o.law, o.critical_damping) / o.value);
         }))
        result[row++] = each;
    for (const ContactTimeObservation& o : problem.contact_times)
        result[row++] = std::log(predicted_time(samples[o.sample], o, o.velocity) / o.value);
    return result;
}

std::vector<CalibrationSlot> slots_of(const CalibrationProblem& problem) {
    std::vector<CalibrationSlot> slots;
    for (const FreeConstant& free : problem.free) {
        if (!free.per_sample) slots.push_back({free.quantity, std::nullopt});
        for (std::size_t i = 0; free.per_sample && i < problem.samples.size(); ++i)
            slots.push_back({free.quantity, i});
    }
    return slots;
}

/// @throws InputError without free constants, with fewer observations than those, or with unknown samples
void require_solvable(const CalibrationProblem& problem) {
    const std::size_t constants = slots_of(problem).size();
    const std::size_t observations = problem.critical_velocities.size() + problem.contact_times.size();
    const auto unknown = [&](const auto& o) { return o.sample >= problem.samples.size(); };
    if (std::ranges::any_of(problem.critical_velocities, unknown) ||
        std::ranges::any_of(problem.contact_times, unknown))
        throw InputError("an observation names a sample that does not exist");
    if (constants == 0 || observations < constants)
        throw InputError("the calibration has " + std::to_string(observations) + " observations for " +
                             std::to_string(constants) + " free constants",
                         "at least one free constant and as many observations");
}

/// Refuses constants that a fit takes to where they change no observation.
[[noreturn]] void refuse_unidentified(const std::vector<std::string>& names) {
    throw InputError(joined(names) + (names.size() == 1 ? " is" : " are") +
                         " not identifiable: the fit goes to where an observation no longer depends on " +
                         (names.size() == 1 ? "it" : "them") + ", which is bounded from one side at most",
                     "fewer free constants, such as with a damping that is stated, 0 for none");
}

/// A problem's samples with these logarithms of the fitted numbers in place.
std::vector<CalibrationSample> samples_with(const CalibrationProblem& problem,
                                            const std::vector<CalibrationSlot>& slots,
                                            const Eigen::VectorXd& logarithms) {
    constexpr double most = 92;  // ln of 1e40, beyond which no quantity is taken
    std::vector<std::string> unidentified;
    for (std::size_t i = 0; i < slots.size(); ++i)
        if (!(std::abs(logarithms[static_cast<Eigen::Index>(i)]) < most))
            unidentified.emplace_back(name_of(slots[i].quantity));
    if (!unidentified.empty()) refuse_unidentified(unidentified);
    std::vector<CalibrationSample> samples = problem.samples;
    for (std::size_t i = 0; i < slots.size(); ++i) {
        const double value = std::exp(logarithms[static_cast<Eigen::Index>(i)]);
        for (std::size_t s = 0; s < samples.size(); ++s)
            if (!slots[i].sample || *slots[i].sample == s) constant_of(samples[s], slots[i].quantity) = value;
    }
    return samples;
}

/// The logarithms of a problem's starting values.
Eigen::VectorXd starting_logarithms(const CalibrationProblem& problem) {
    const std::vector<CalibrationSlot> slots = slots_of(problem);
    Eigen::VectorXd logarithms(static_cast<Eigen::Index>(slots.size()));
    for (std::size_t i = 0; i < slots.size(); ++i) {
        CalibrationSample start = problem.samples[slots[i].sample.value_or(0)];
        logarithms[static_cast<Eigen::Index>(i)] = std::log(constant_of(start, slots[i].quantity));
    }
    return logarithms;
}

/// Normalised, uncorrelated residuals of a problem. The weights are computed once, at the point given to the
/// constructor, so that chi^2 keeps its meaning during a fit.
class CalibrationObjective {
  public:
    CalibrationObjective(const CalibrationProblem& problem, const Eigen::VectorXd& logarithms)
        : problem_(&problem), slots_(slots_of(problem)) {
        covariance_.compute(
            calibration_residuals(problem, samples_with(problem, slots_, logarithms)).covariance);
    }

    [[nodiscard]] Eigen::VectorXd residuals(const Eigen::VectorXd& logarithms) const {
        return residuals(*problem_, logarithms);
    }
    /// Those of another problem with the same observations, with the weights of this one.
    [[nodiscard]] Eigen::VectorXd residuals(const CalibrationProblem& problem,
                                            const Eigen::VectorXd& logarithms) const {
        if (problem.on_trial) problem.on_trial();
        return covariance_.matrixL().solve(
            logarithmic_residuals(problem, samples_with(problem, slots_, logarithms)));
    }
    /// Fit from @p start; the number at index @p held, if given, keeps its value. @throws ConvergenceError
    [[nodiscard]] gsl::NonlinearFit fit(const Eigen::VectorXd& start,
                                        std::optional<Eigen::Index> held = std::nullopt) const {
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

  private:
    const CalibrationProblem* problem_;
    std::vector<CalibrationSlot> slots_;
    Eigen::LLT<Eigen::MatrixXd> covariance_;
};

std::vector<CalibratedConstant> constants_of(const std::vector<CalibrationSlot>& slots,
                                             const gsl::NonlinearFit& fit) {
    const double factor = confidence_quantile();
    std::vector<CalibratedConstant> constants;
    for (std::size_t i = 0; i < slots.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        const double value = std::exp(fit.parameters[row]);
        const double deviation = std::sqrt(fit.covariance(row, row));
        constants.push_back({.quantity = slots[i].quantity,
                             .sample = slots[i].sample,
                             .value = value,
                             .standard_uncertainty = value * deviation,
                             .lower = value * std::exp(-factor * deviation),
                             .upper = value * std::exp(factor * deviation)});
    }
    return constants;
}

CalibrationProblem velocities_of(CalibrationProblem problem) {
    problem.contact_times.clear();
    return problem;
}

bool is_step(const FreeConstant& free) {
    return free.quantity == CalibrationQuantity::time_step;
}

bool has_free_step(const CalibrationProblem& problem) {
    return std::ranges::any_of(problem.free, is_step);
}

/// The problem with its constants fitted to the critical velocities, the step held: those alone cannot tell a
/// step from a density.
CalibrationProblem led_by_velocities(CalibrationProblem problem) {
    for (CalibrationSample& sample : problem.samples) constant_of(sample, CalibrationQuantity::time_step);
    CalibrationProblem leading = velocities_of(problem);
    std::erase_if(leading.free, is_step);
    if (leading.critical_velocities.size() < slots_of(leading).size() || leading.free.empty()) return problem;
    const Eigen::VectorXd start = starting_logarithms(leading);
    problem.samples =
        samples_with(leading, slots_of(leading), CalibrationObjective(leading, start).fit(start).parameters);
    return problem;
}

gsl::NonlinearFit fit_from(const CalibrationProblem& problem, Eigen::VectorXd logarithms) {
    gsl::NonlinearFit fit;
    for (int pass = 0; pass < 3; ++pass) {  // the weights depend, weakly, on the constants
        fit = CalibrationObjective(problem, logarithms).fit(logarithms);
        logarithms = fit.parameters;
    }
    return fit;
}

CalibrationSummary summary_of(const CalibrationProblem& problem, const std::vector<CalibrationSlot>& slots,
                              const gsl::NonlinearFit& fit) {
    const Eigen::VectorXd deviation = fit.covariance.diagonal().cwiseSqrt();
    std::vector<std::string> unidentified;
    for (std::size_t i = 0; i < slots.size(); ++i)
        if (const double own = deviation[static_cast<Eigen::Index>(i)]; !(own > 0) || !std::isfinite(own))
            unidentified.emplace_back(name_of(slots[i].quantity));
    if (!unidentified.empty()) refuse_unidentified(unidentified);
    CalibrationSummary summary;
    summary.constants = constants_of(slots, fit);
    summary.correlation = fit.covariance.cwiseQuotient(deviation * deviation.transpose());
    summary.samples = samples_with(problem, slots, fit.parameters);
    CalibrationResiduals residuals = calibration_residuals(problem, summary.samples);
    summary.critical_velocities = std::move(residuals.critical_velocities);
    summary.contact_times = std::move(residuals.contact_times);
    summary.chi_squared = fit.chi_squared;
    summary.degrees_of_freedom = static_cast<int>(fit.residuals.size()) - static_cast<int>(slots.size());
    summary.probability = gsl::chi_squared_exceedance(fit.chi_squared, summary.degrees_of_freedom);
    summary.akaike = fit.chi_squared + 2.0 * static_cast<double>(slots.size());
    summary.iterations = fit.iterations;
    return summary;
}

/// The problem at contact moduli multiplied by @p factor.
CalibrationProblem with_moduli(CalibrationProblem problem, double factor) {
    for (CalibrationSample& sample : problem.samples)
        sample.contact_modulus = factor * sample.contact().contact_modulus;
    return problem;
}

constexpr double furthest = 10.0;  ///< factor from the best value to which a profile is followed
constexpr double strong = 0.95;    ///< correlation from which two constants are called traded

std::string name_of(const CalibratedConstant& constant) {
    std::string name(name_of(constant.quantity));
    if (constant.sample) name += " of sample " + std::to_string(*constant.sample + 1);
    return name;
}

std::string statement_of(const CalibrationSummary& summary, std::size_t constant,
                         const ConstantProfile& profile) {
    std::string text =
        name_of(summary.constants[constant]) + " is not identifiable: the observations bound it ";
    text += profile.interval.lower   ? "only from below"
            : profile.interval.upper ? "only from above"
                                     : "not at all";
    for (std::size_t i = 0; i < profile.traded_with.size(); ++i)
        text += (i == 0 ? "; it is traded with " : ", ") + name_of(summary.constants[profile.traded_with[i]]);
    return text;
}

/// Interval of one logarithm. The search for the others starts from their last values.
Interval logarithmic_interval(const CalibrationObjective& objective, const Eigen::VectorXd& best,
                              Eigen::Index constant, double deviation) {
    const double least = objective.residuals(best).squaredNorm();
    const auto profile = [&](double value) {
        Eigen::VectorXd start = best;
        start[constant] = value;
        if (best.size() == 1) return objective.residuals(start).squaredNorm() - least;
        return objective.fit(start, constant).chi_squared - least;
    };
    const double range = std::log(furthest);
    return profile_interval(profile, {.best = best[constant],
                                      .deviation = std::min(deviation, 0.2 * range),
                                      .least = best[constant] - range,
                                      .greatest = best[constant] + range});
}

}  // namespace

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

std::vector<CalibratedVelocity> velocities_over_sizes(const CalibrationProblem& problem,
                                                      const CalibrationSummary& summary,
                                                      const std::vector<double>& diameters) {
    constexpr double step = 0.1;  // of a standard deviation
    const Law law = problem.critical_velocities.front().law;
    const auto velocity_of = [&](const CalibrationSample& sample) -> std::optional<double> {
        const double velocity = predicted_velocity(sample, law, 0);
        return velocity < captured_at_all ? std::optional(velocity) : std::nullopt;
    };
    return in_parallel(diameters, [&](double diameter) {
        CalibrationSample sample = summary.samples.front();
        sample.diameter = diameter;
        CalibratedVelocity result{.diameter = diameter, .velocity = velocity_of(sample)};
        Eigen::VectorXd changes(summary.correlation.rows());  // of ln v_c, by a standard deviation of each
        for (Eigen::Index i = 0; i < changes.size(); ++i) {
            const CalibratedConstant& constant = summary.constants[static_cast<std::size_t>(i)];
            const double ratio = std::exp(step * constant.standard_uncertainty / constant.value);
            CalibrationSample less = sample;
            CalibrationSample more = sample;
            constant_of(less, constant.quantity) /= ratio;
            constant_of(more, constant.quantity) *= ratio;
            const auto lower = velocity_of(less);
            const auto upper = velocity_of(more);
            if (!lower || !upper) return result;
            changes[i] = std::log(*upper / *lower) / (2 * step);
        }
        const double variance = changes.dot(summary.correlation * changes);
        const double deviation = std::sqrt(std::max(0.0, variance));
        if (!result.velocity || !std::isfinite(deviation)) return result;
        const double factor = std::exp(confidence_quantile() * deviation);
        result.interval = {*result.velocity, deviation * *result.velocity, *result.velocity / factor,
                           *result.velocity * factor};
        return result;
    });
}

Dimension dimension_of(CalibrationQuantity quantity, DampingLaw damping) {
    switch (quantity) {
        case CalibrationQuantity::density:
            return Dimension::density;
        case CalibrationQuantity::work_of_adhesion:
            return Dimension::energy_per_area;
        case CalibrationQuantity::contact_modulus:
        case CalibrationQuantity::wall_young_modulus:
        case CalibrationQuantity::yield_pressure:
            return Dimension::pressure;
        case CalibrationQuantity::damping:
            return dimension_of(damping);
        case CalibrationQuantity::time_step:
            return Dimension::time;
    }
    throw std::logic_error("calibration quantity without a dimension");
}

ContactPair CalibrationSample::contact() const {
    return {
        .mass = sphere_mass(diameter / 2, density),
        .effective_radius = diameter / 2,
        .contact_modulus = contact_modulus ? *contact_modulus : ashimpact::contact_modulus(particle, wall),
        .work_of_adhesion = work_of_adhesion,
        .yield_pressure = yield_pressure,
        .parameters = parameters};
}

CalibrationProblem with_best_start(CalibrationProblem problem,
                                   const std::vector<std::vector<double>>& ratios) {
    const std::vector<CalibrationSlot> slots = slots_of(problem);
    const Eigen::VectorXd centre = starting_logarithms(problem);
    std::vector<Eigen::VectorXd> starts{centre};
    for (std::size_t i = 0; i < slots.size(); ++i) {
        std::vector<Eigen::VectorXd> finer;
        for (const Eigen::VectorXd& start : starts)
            for (const double ratio : ratios[i]) {
                finer.push_back(start);
                finer.back()[static_cast<Eigen::Index>(i)] += std::log(ratio);
            }
        starts = std::move(finer);
    }
    const std::vector<double> misfits = in_parallel(starts, [&](const Eigen::VectorXd& start) {
        return logarithmic_residuals(problem, samples_with(problem, slots, start)).squaredNorm();
    });
    const auto best = std::ranges::min_element(misfits) - misfits.begin();
    problem.samples = samples_with(problem, slots, starts[static_cast<std::size_t>(best)]);
    return problem;
}

CalibrationSummary calibrate(const CalibrationProblem& problem) {
    CalibrationSummary summary = calibrate_despite_captures(problem);
    for (std::size_t i = 0; i < summary.contact_times.size(); ++i)
        if (summary.contact_times[i].captured_up_to)
            throw ConvergenceError("calibration: the constants found capture sample " +
                                   std::to_string(problem.contact_times[i].sample + 1) +
                                   " at the velocity of its contact time; start nearer to the answer");
    return summary;
}

CalibrationSummary calibrate_despite_captures(const CalibrationProblem& problem) {
    const std::vector<CalibrationSlot> slots = slots_of(problem);
    require_solvable(problem);
    Eigen::VectorXd logarithms = starting_logarithms(problem);

    // A contact time jumps where its impact is captured, so the critical velocities lead the fit near the
    // answer.
    if (has_free_step(problem)) {
        logarithms = starting_logarithms(led_by_velocities(problem));
    } else if (problem.critical_velocities.size() >= slots.size()) {
        const CalibrationProblem velocities = velocities_of(problem);
        logarithms = CalibrationObjective(velocities, logarithms).fit(logarithms).parameters;
    }
    return summary_of(problem, slots, fit_from(problem, logarithms));
}

CalibrationSummary calibrate_by_velocities(const CalibrationProblem& problem) {
    const CalibrationProblem velocities = velocities_of(problem);
    const std::vector<CalibrationSlot> slots = slots_of(velocities);
    require_solvable(velocities);
    return summary_of(problem, slots, fit_from(velocities, starting_logarithms(velocities)));
}

std::vector<CalibrationResponse> response_to_contact_modulus(const CalibrationProblem& problem) {
    constexpr double log_step = 1e-3;  // of the logarithms, for differences
    require_solvable(problem);
    const std::vector<CalibrationSlot> slots = slots_of(problem);
    const Eigen::VectorXd at = starting_logarithms(problem);
    const CalibrationObjective objective(problem, at);
    const auto central = [&](const auto& residuals) -> Eigen::VectorXd {
        return (residuals(log_step) - residuals(-log_step)) / (2.0 * log_step);
    };
    const Eigen::VectorXd by_modulus = central(
        [&](double change) { return objective.residuals(with_moduli(problem, std::exp(change)), at); });
    Eigen::MatrixXd by_constant(by_modulus.size(), at.size());
    for (Eigen::Index i = 0; i < at.size(); ++i)
        by_constant.col(i) = central([&](double change) {
            Eigen::VectorXd moved = at;
            moved[i] += change;
            return objective.residuals(moved);
        });
    const Eigen::VectorXd exponents = -by_constant.colPivHouseholderQr().solve(by_modulus);
    std::vector<CalibrationResponse> responses(problem.samples.size());
    for (std::size_t i = 0; i < slots.size(); ++i)
        for (std::size_t s = 0; s < responses.size(); ++s) {
            if (slots[i].sample && *slots[i].sample != s) continue;
            const double exponent = exponents[static_cast<Eigen::Index>(i)];
            if (slots[i].quantity == CalibrationQuantity::density) responses[s].density = exponent;
            if (slots[i].quantity == CalibrationQuantity::work_of_adhesion)
                responses[s].work_of_adhesion = exponent;
        }
    return responses;
}

std::vector<ConstantProfile> profile_constants(const CalibrationProblem& problem,
                                               const CalibrationSummary& summary) {
    const auto count = static_cast<Eigen::Index>(summary.constants.size());
    Eigen::VectorXd best(count);
    for (Eigen::Index i = 0; i < count; ++i)
        best[i] = std::log(summary.constants[static_cast<std::size_t>(i)].value);
    const CalibrationObjective objective(problem, best);
    std::vector<ConstantProfile> profiles;
    for (Eigen::Index i = 0; i < count; ++i) {
        const CalibratedConstant& constant = summary.constants[static_cast<std::size_t>(i)];
        const double deviation = constant.standard_uncertainty / constant.value;
        const Interval logarithm = logarithmic_interval(objective, best, i, deviation);
        ConstantProfile profile{.interval = {constant.value, constant.value * logarithm.standard_uncertainty},
                                .identifiable = logarithm.lower && logarithm.upper,
                                .traded_with = {},
                                .statement = {}};
        if (logarithm.lower) profile.interval.lower = std::exp(*logarithm.lower);
        if (logarithm.upper) profile.interval.upper = std::exp(*logarithm.upper);
        for (Eigen::Index j = 0; j < count; ++j)
            if (j != i && std::abs(summary.correlation(i, j)) > strong)
                profile.traded_with.push_back(static_cast<std::size_t>(j));
        if (!profile.identifiable)
            profile.statement = statement_of(summary, static_cast<std::size_t>(i), profile);
        profiles.push_back(std::move(profile));
    }
    return profiles;
}

}  // namespace ashimpact

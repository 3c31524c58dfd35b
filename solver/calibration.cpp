#include "solver/calibration.hpp"

#include "materials/error.hpp"
#include "solver/critical_velocity.hpp"
#include "solver/gsl/distribution.hpp"
#include "solver/gsl/nonlinear_fit.hpp"
#include "solver/reconstruction.hpp"

#include <cmath>
#include <functional>
#include <string>

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

/// One fitted number: a quantity of one sample, or of all.
struct Slot {
    CalibrationQuantity quantity;
    std::optional<std::size_t> sample;
};

std::vector<Slot> slots_of(const CalibrationProblem& problem) {
    std::vector<Slot> slots;
    for (const FreeConstant& free : problem.free) {
        if (!free.per_sample) slots.push_back({free.quantity, std::nullopt});
        for (std::size_t i = 0; free.per_sample && i < problem.samples.size(); ++i)
            slots.push_back({free.quantity, i});
    }
    return slots;
}

std::vector<CalibrationSample> samples_with(const CalibrationProblem& problem, const std::vector<Slot>& slots,
                                            const Eigen::VectorXd& logarithms) {
    std::vector<CalibrationSample> samples = problem.samples;
    for (std::size_t i = 0; i < slots.size(); ++i) {
        const double value = std::exp(logarithms[static_cast<Eigen::Index>(i)]);
        for (std::size_t s = 0; s < samples.size(); ++s) {
            if (!slots[i].sample || *slots[i].sample == s) constant_of(samples[s], slots[i].quantity) = value;
        }
    }
    return samples;
}

double predicted_velocity(const CalibrationSample& sample, Law law, double damping) {
    const CriticalVelocity critical =
        critical_velocity({law, law.default_detachment(), {DampingLaw::constant, damping}, sample.contact()});
    if (!critical.value) {
        throw InputError("law '" + std::string(law.name()) + "' has no finite critical velocity here",
                         "damping > 0 kg/s");
    }
    return *critical.value;
}

/// Power of v_c/v with which the stand-in for a contact time grows on the captured side: about the slope of
/// the real one just above v_c, so that the weights do not jump there.
constexpr double captured_growth = 3.0;

/// Contact time at @p velocity on the curve that the published fit implies. On the captured side of the curve
/// there is none; the nearest rebound's, growing with the distance to it, stands for it so that a fit can
/// find its way back.
double predicted_time(const CalibrationSample& sample, const ContactTimeObservation& at, double velocity) {
    const PublishedDamping published{
        at.law,           at.law.default_detachment(), sample.contact(), at.damping_fit[0], at.damping_fit[1],
        at.damping_fit[2]};
    const double e = reconstructed_restitution(published, velocity);
    Impact impact{at.law,
                  published.detachment,
                  {DampingLaw::constant, published.damping(e)},
                  published.contact,
                  velocity};
    if (e > 0.0) return solve_impact(impact).contact_time.value();
    impact.velocity = (1.0 + 1e-6) * predicted_velocity(sample, at.law, impact.damping.coefficient);
    return solve_impact(impact).contact_time.value() * std::pow(impact.velocity / velocity, captured_growth);
}

double logarithmic_slope(const std::function<double(double)>& function, double at) {
    constexpr double nudge = 1e-4;
    return std::log(function(at * (1 + nudge)) / function(at * (1 - nudge))) / (2 * nudge);
}

CalibrationResidual residual_of(const std::vector<CalibrationSample>& samples,
                                const CriticalVelocityObservation& observed) {
    const CalibrationSample& sample = samples[observed.sample];
    const double eta = observed.critical_damping;
    const double slope =
        logarithmic_slope([&](double x) { return predicted_velocity(sample, observed.law, x); }, eta);
    return {.observed = observed.value,
            .predicted = predicted_velocity(sample, observed.law, eta),
            .relative_uncertainty = std::hypot(observed.standard_uncertainty / observed.value,
                                               slope * observed.critical_damping_uncertainty / eta)};
}

CalibrationResidual residual_of(const std::vector<CalibrationSample>& samples,
                                const ContactTimeObservation& observed) {
    const CalibrationSample& sample = samples[observed.sample];
    const double v = observed.velocity;
    const double slope = logarithmic_slope([&](double x) { return predicted_time(sample, observed, x); }, v);
    return {.observed = observed.value,
            .predicted = predicted_time(sample, observed, v),
            .relative_uncertainty = std::hypot(observed.standard_uncertainty / observed.value,
                                               slope * observed.velocity_uncertainty / v)};
}

template <class Observations>
std::vector<CalibrationResidual> residuals_of(const std::vector<CalibrationSample>& samples,
                                              const Observations& observations) {
    std::vector<CalibrationResidual> residuals;
    residuals.reserve(observations.size());
    for (const auto& observation : observations) residuals.push_back(residual_of(samples, observation));
    return residuals;
}

/// The weights stay those of the point they were computed at, so that chi^2 has one meaning during a fit.
struct Weights {
    std::vector<CalibrationResidual> critical_velocities;
    std::vector<CalibrationResidual> contact_times;
};

Eigen::VectorXd normalised(const CalibrationProblem& problem, const std::vector<CalibrationSample>& samples,
                           const Weights& weights) {
    Eigen::VectorXd result(
        static_cast<Eigen::Index>(problem.critical_velocities.size() + problem.contact_times.size()));
    Eigen::Index row = 0;
    for (std::size_t i = 0; i < problem.critical_velocities.size(); ++i) {
        const CriticalVelocityObservation& o = problem.critical_velocities[i];
        const double predicted = predicted_velocity(samples[o.sample], o.law, o.critical_damping);
        result[row++] = std::log(predicted / o.value) / weights.critical_velocities[i].relative_uncertainty;
    }
    for (std::size_t i = 0; i < problem.contact_times.size(); ++i) {
        const ContactTimeObservation& o = problem.contact_times[i];
        const double predicted = predicted_time(samples[o.sample], o, o.velocity);
        result[row++] = std::log(predicted / o.value) / weights.contact_times[i].relative_uncertainty;
    }
    return result;
}

/// Fit from @p start with the weights of that point.
gsl::NonlinearFit fit_once(const CalibrationProblem& problem, const std::vector<Slot>& slots,
                           const Eigen::VectorXd& start) {
    const auto at = samples_with(problem, slots, start);
    const Weights weights{residuals_of(at, problem.critical_velocities),
                          residuals_of(at, problem.contact_times)};
    return gsl::fit_nonlinear(
        [&](const Eigen::VectorXd& x) {
            return normalised(problem, samples_with(problem, slots, x), weights);
        },
        start, {.parameter_tolerance = 1e-9, .gradient_tolerance = 1e-10, .difference_step = 1e-5});
}

void require_solvable(const CalibrationProblem& problem, std::size_t constants) {
    const std::size_t observations = problem.critical_velocities.size() + problem.contact_times.size();
    const auto known = [&](const auto& observation) { return observation.sample < problem.samples.size(); };
    for (const auto& o : problem.critical_velocities) {
        if (!known(o)) throw InputError("an observation names a sample that does not exist");
    }
    for (const auto& o : problem.contact_times) {
        if (!known(o)) throw InputError("an observation names a sample that does not exist");
    }
    if (constants == 0 || observations < constants) {
        throw InputError("the calibration has " + std::to_string(observations) + " observations for " +
                             std::to_string(constants) + " free constants",
                         "at least one free constant and as many observations");
    }
}

/// A contact time that the calibrated model has not is no minimum worth reporting.
void require_rebounds(const CalibrationProblem& problem, const std::vector<CalibrationSample>& samples) {
    for (const ContactTimeObservation& o : problem.contact_times) {
        const PublishedDamping published{o.law,
                                         o.law.default_detachment(),
                                         samples[o.sample].contact(),
                                         o.damping_fit[0],
                                         o.damping_fit[1],
                                         o.damping_fit[2]};
        if (reconstructed_restitution(published, o.velocity) > 0.0) continue;
        throw ConvergenceError("calibration: the constants found capture sample " +
                               std::to_string(o.sample + 1) +
                               " at the velocity of its contact time; start nearer to the answer");
    }
}

std::vector<CalibratedConstant> constants_of(const std::vector<Slot>& slots, const gsl::NonlinearFit& fit) {
    const double factor = gsl::normal_quantile(0.975);
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

}  // namespace

ContactPair CalibrationSample::contact() const {
    return {
        .mass = sphere_mass(diameter / 2, density),
        .effective_radius = diameter / 2,
        .contact_modulus = contact_modulus ? *contact_modulus : ashimpact::contact_modulus(particle, wall),
        .work_of_adhesion = work_of_adhesion};
}

CalibrationSummary calibrate(const CalibrationProblem& problem) {
    const std::vector<Slot> slots = slots_of(problem);
    require_solvable(problem, slots.size());
    Eigen::VectorXd logarithms(static_cast<Eigen::Index>(slots.size()));
    for (std::size_t i = 0; i < slots.size(); ++i) {
        CalibrationSample start = problem.samples[slots[i].sample.value_or(0)];
        logarithms[static_cast<Eigen::Index>(i)] = std::log(constant_of(start, slots[i].quantity));
    }

    // A contact time jumps where its impact is captured, so the critical velocities lead the fit near the
    // answer.
    CalibrationProblem velocities_only = problem;
    velocities_only.contact_times.clear();
    if (problem.critical_velocities.size() >= slots.size()) {
        logarithms = fit_once(velocities_only, slots, logarithms).parameters;
    }
    gsl::NonlinearFit fit;
    for (int pass = 0; pass < 3; ++pass) {  // the weights depend, weakly, on the constants
        fit = fit_once(problem, slots, logarithms);
        logarithms = fit.parameters;
    }

    require_rebounds(problem, samples_with(problem, slots, fit.parameters));

    const Eigen::VectorXd deviation = fit.covariance.diagonal().cwiseSqrt();
    CalibrationSummary summary;
    summary.constants = constants_of(slots, fit);
    summary.correlation = fit.covariance.cwiseQuotient(deviation * deviation.transpose());
    summary.samples = samples_with(problem, slots, fit.parameters);
    summary.critical_velocities = residuals_of(summary.samples, problem.critical_velocities);
    summary.contact_times = residuals_of(summary.samples, problem.contact_times);
    summary.chi_squared = fit.chi_squared;
    summary.degrees_of_freedom = static_cast<int>(fit.residuals.size()) - static_cast<int>(slots.size());
    summary.probability = gsl::chi_squared_exceedance(fit.chi_squared, summary.degrees_of_freedom);
    summary.akaike = fit.chi_squared + 2.0 * static_cast<double>(slots.size());
    summary.iterations = fit.iterations;
    return summary;
}

}  // namespace ashimpact

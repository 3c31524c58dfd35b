// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/calibration/calibration.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/text/error.hpp"
#include "solver/inference/calibration/calibration_objective.hpp"
#include "solver/numeric/gsl/statistics.hpp"

namespace ashimpact {

namespace {

/// Refuses a minimum at which the model captures an impact whose contact time was measured.
void require_rebounds(const CalibrationProblem& problem, const CalibrationSummary& summary) {
    for (std::size_t i = 0; i < summary.contact_times.size(); ++i) {
        if (!summary.contact_times[i].captured_up_to) continue;
        throw ConvergenceError("calibration: the constants found capture sample " +
                               std::to_string(problem.contact_times[i].sample + 1) +
                               " at the velocity of its contact time; start nearer to the answer");
    }
}

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

Dimension dimension_of(CalibrationQuantity quantity) {
    switch (quantity) {
        case CalibrationQuantity::density:
            return Dimension::density;
        case CalibrationQuantity::work_of_adhesion:
            return Dimension::energy_per_area;
        case CalibrationQuantity::contact_modulus:
        case CalibrationQuantity::wall_young_modulus:
            return Dimension::pressure;
    }
    throw std::logic_error("calibration quantity without a dimension");
}

ContactPair CalibrationSample::contact() const {
    return {
        .mass = sphere_mass(diameter / 2, density),
        .effective_radius = diameter / 2,
        .contact_modulus = contact_modulus ? *contact_modulus : ashimpact::contact_modulus(particle, wall),
        .work_of_adhesion = work_of_adhesion};
}

CalibrationSummary calibrate(const CalibrationProblem& problem) {
    CalibrationSummary summary = calibrate_despite_captures(problem);
    require_rebounds(problem, summary);
    return summary;
}

CalibrationSummary calibrate_despite_captures(const CalibrationProblem& problem) {
    const std::vector<CalibrationSlot> slots = slots_of(problem);
    require_solvable(problem);
    Eigen::VectorXd logarithms = starting_logarithms(problem);

    // A contact time jumps where its impact is captured, so the critical velocities lead the fit near the
    // answer.
    if (problem.critical_velocities.size() >= slots.size()) {
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
                                               const CalibrationSummary& summary,
                                               const std::function<void(std::size_t done)>& on_profile) {
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
        if (on_profile) on_profile(profiles.size());
    }
    return profiles;
}

}  // namespace ashimpact

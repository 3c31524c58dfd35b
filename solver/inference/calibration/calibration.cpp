// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/calibration/calibration.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/text/error.hpp"
#include "solver/inference/calibration/calibration_objective.hpp"
#include "solver/inference/calibration/calibration_response.hpp"
#include "solver/numeric/gsl/statistics.hpp"
#include "solver/statistics/interval.hpp"

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

}  // namespace ashimpact

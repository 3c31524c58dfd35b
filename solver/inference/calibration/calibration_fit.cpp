// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/calibration/calibration_fit.hpp"

#include <cmath>
#include <string>

#include "core/error.hpp"
#include "solver/inference/calibration/calibration_residuals.hpp"

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

Eigen::VectorXd without(const Eigen::VectorXd& all, Eigen::Index left_out) {
    Eigen::VectorXd rest(all.size() - 1);
    rest << all.head(left_out), all.tail(all.size() - left_out - 1);
    return rest;
}

Eigen::VectorXd with(const Eigen::VectorXd& rest, Eigen::Index place, double value) {
    Eigen::VectorXd all(rest.size() + 1);
    all << rest.head(place), value, rest.tail(rest.size() - place);
    return all;
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

std::vector<CalibrationSample> samples_with(const CalibrationProblem& problem,
                                            const std::vector<CalibrationSlot>& slots,
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

Eigen::VectorXd starting_logarithms(const CalibrationProblem& problem) {
    const std::vector<CalibrationSlot> slots = slots_of(problem);
    Eigen::VectorXd logarithms(static_cast<Eigen::Index>(slots.size()));
    for (std::size_t i = 0; i < slots.size(); ++i) {
        CalibrationSample start = problem.samples[slots[i].sample.value_or(0)];
        logarithms[static_cast<Eigen::Index>(i)] = std::log(constant_of(start, slots[i].quantity));
    }
    return logarithms;
}

CalibrationObjective::CalibrationObjective(const CalibrationProblem& problem,
                                           const Eigen::VectorXd& logarithms)
    : problem_(&problem), slots_(slots_of(problem)) {
    covariance_.compute(calibration_residuals(problem, samples_with(problem, slots_, logarithms)).covariance);
}

Eigen::VectorXd CalibrationObjective::residuals(const Eigen::VectorXd& logarithms) const {
    return residuals(*problem_, logarithms);
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
    if (!held)
        return gsl::fit_nonlinear([&](const Eigen::VectorXd& x) { return residuals(x); }, start, options);
    const double value = start[*held];
    return gsl::fit_nonlinear([&](const Eigen::VectorXd& x) { return residuals(with(x, *held, value)); },
                              without(start, *held), options);
}

}  // namespace ashimpact

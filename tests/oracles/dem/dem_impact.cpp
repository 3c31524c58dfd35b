// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/oracles/dem/dem_impact.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

#include "tests/oracles/contact_force.hpp"
#include "tests/oracles/dem/extrapolation.hpp"

namespace ashimpact::oracles {

namespace {

constexpr double hertz_contact_time = 3.21806546;  // undamped, in time scales

constexpr std::array coarse_steps{200, 280, 400};                // a Hertz contact
constexpr int coarse_horizon = 6;                                // in Hertz contacts
constexpr std::array fine_steps{2000, 3000, 4500, 6750, 10000};  // a contact

// What double precision leaves of an extrapolated result, relative: the overlap is known to the digits of the
// distance between the centres, some 1e-13 of it, and the extrapolation multiplies that by some ten.
constexpr double rounding = 1e-11;

constexpr std::size_t verdict_steps = 20000;  // a Hertz contact
constexpr std::size_t verdict_horizon = 12;   // in Hertz contacts

double hertz_time(const ImpactCase& impact) {
    return hertz_contact_time * ContactForce(impact).time_scale();
}

std::vector<double> error_powers(const ImpactCase& impact) {
    const bool smooth = impact.law == Law::jkr;
    const bool damped = impact.damping > 0;
    if (smooth) return damped ? std::vector{1., 2., 3., 4.} : std::vector{2., 4., 6., 8.};
    return damped ? std::vector{1., 2., 2.5, 3.} : std::vector{2., 2.5, 3.5, 4.};
}

std::vector<Contact> contacts(const DemCode& code, const std::vector<DemRun>& runs,
                              const std::string& directory) {
    const auto tracks = run(code, runs, directory);
    std::vector<Contact> result;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        result.push_back(read_contact(tracks[i], ContactForce(runs[i].impact).end_overlap()));
        if (!result.back().separated)
            throw std::runtime_error(code.name + ": the spheres did not separate, see run " +
                                     std::to_string(i) + " in " + directory);
    }
    return result;
}

// The time step with which the contact ends in the middle of step `steps`.
double mid_step_end(std::span<const double> contact_time_fit, int steps) {
    double step = 0;
    for (int i = 0; i < 30; ++i)
        step = (contact_time_fit[0] + contact_time_fit[1] * step + contact_time_fit[2] * step * step) /
               (steps - 0.5);
    return step;
}

std::vector<DemRun> coarse_runs(std::span<const ImpactCase> impacts) {
    std::vector<DemRun> runs;
    for (const ImpactCase& impact : impacts)
        for (const int steps : coarse_steps)
            runs.push_back(
                {impact, hertz_time(impact) / steps, static_cast<std::size_t>(coarse_horizon * steps)});
    return runs;
}

std::vector<DemRun> fine_runs(std::span<const ImpactCase> impacts, std::span<const Contact> coarse) {
    std::vector<DemRun> runs;
    for (std::size_t i = 0; i < impacts.size(); ++i) {
        std::array<double, coarse_steps.size()> steps{};
        std::array<double, coarse_steps.size()> times{};
        for (std::size_t j = 0; j < coarse_steps.size(); ++j) {
            steps[j] = hertz_time(impacts[i]) / coarse_steps[j];
            times[j] = coarse[i * coarse_steps.size() + j].contact_time;
        }
        const auto fit = fit_powers(steps, times, std::array{1., 2.});
        for (const int fine : fine_steps)
            runs.push_back({impacts[i], mid_step_end(fit, fine), static_cast<std::size_t>(fine) + 3});
    }
    return runs;
}

ImpactResult extrapolated(std::span<const DemRun> runs, std::span<const Contact> found) {
    std::array<double, fine_steps.size()> step{};
    std::array<double, fine_steps.size()> restitution{};
    std::array<double, fine_steps.size()> contact_time{};
    std::array<double, fine_steps.size()> maximum_overlap{};
    for (std::size_t i = 0; i < fine_steps.size(); ++i) {
        if (std::abs(found[i].end_in_steps - (fine_steps[i] - 0.5)) > 0.1)
            throw std::runtime_error("the contact does not end in the middle of a step: at " +
                                     std::to_string(found[i].end_in_steps));
        step[i] = runs[i].time_step;
        restitution[i] = found[i].restitution;
        contact_time[i] = found[i].contact_time;
        maximum_overlap[i] = found[i].maximum_overlap;
    }
    const auto powers = error_powers(runs.front().impact);
    const auto at_zero_step = [&](const auto& values) {
        Estimate estimate = extrapolate(step, values, powers);
        estimate.error += rounding * estimate.value;
        return estimate;
    };
    return {.rebound = true,
            .restitution = at_zero_step(restitution),
            .contact_time = at_zero_step(contact_time),
            .maximum_overlap = at_zero_step(maximum_overlap)};
}

}  // namespace

std::vector<ImpactResult> dem_impacts(const DemCode& code, std::span<const ImpactCase> impacts) {
    const auto coarse = contacts(code, coarse_runs(impacts), code.program + "-coarse");
    const auto runs = fine_runs(impacts, coarse);
    const auto found = contacts(code, runs, code.program + "-fine");
    std::vector<ImpactResult> results;
    for (std::size_t i = 0; i < runs.size(); i += fine_steps.size())
        results.push_back(extrapolated(std::span(runs).subspan(i, fine_steps.size()),
                                       std::span(found).subspan(i, fine_steps.size())));
    return results;
}

std::vector<bool> dem_rebounds(const DemCode& code, std::span<const ImpactCase> impacts) {
    std::vector<DemRun> runs;
    for (const ImpactCase& impact : impacts) {
        constexpr std::size_t steps = verdict_steps * verdict_horizon;
        runs.push_back({impact, hertz_time(impact) / verdict_steps, steps, steps});
    }
    const auto tracks = run(code, runs, code.program + "-verdicts");
    std::vector<bool> rebounds;
    for (std::size_t i = 0; i < runs.size(); ++i)
        rebounds.push_back(tracks[i].samples.back().overlap < ContactForce(impacts[i]).end_overlap());
    return rebounds;
}

}  // namespace ashimpact::oracles

// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/dampings.hpp"

#include <algorithm>
#include <cmath>

#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/surrogate/rebound_table.hpp"

namespace ashimpact {

namespace {

constexpr int damped_points = 15;        ///< of a curve
constexpr double beyond_impacts = 1.25;  ///< a curve reaches so far beyond the slowest and fastest impact

/// e over the velocities of the impacts.
std::vector<DampedImpact> damped_curve(const LawChoice& choice, const FittedDamping& fitted,
                                       const ImpactsOfSample& sample) {
    const auto [slowest, fastest] = std::ranges::minmax_element(sample.impacts, {}, &Measurement::velocity);
    const double first = slowest->velocity / beyond_impacts;
    const double last = fastest->velocity * beyond_impacts;
    const ReboundTable table(
        {choice.law, choice.detachment, fitted.damping(), contact_with(fitted, sample.contact), last},
        {first, last}, {.lane_degree = 23, .scalar_degree = 11});
    std::vector<DampedImpact> curve;
    for (int i = 0; i < damped_points; ++i) {
        const double share = static_cast<double>(i) / (damped_points - 1);
        const double log_velocity = (1 - share) * std::log(first) + share * std::log(last);
        curve.push_back({std::exp(log_velocity), std::sqrt(std::max(0.0, table.energy_ratio(log_velocity)))});
    }
    return curve;
}

DampedSample damped_sample(const LawChoice& choice, const FittedDamping& fitted,
                           const ImpactsOfSample& sample, const std::string& name) {
    DampedSample damped{.name = name};
    if (fitted.constants.empty() || sample.impacts.empty()) return damped;
    try {
        const CriticalVelocity critical = quick_critical_velocity(
            {choice.law, choice.detachment, fitted.damping(), contact_with(fitted, sample.contact)});
        damped.verdict = critical.verdict;
        damped.velocity = critical.value;
        damped.curve = damped_curve(choice, fitted, sample);
    } catch (const ConvergenceError&) {
        damped.curve.clear();
    }
    return damped;
}

}  // namespace

std::optional<DampingStudy> study_dampings(const LawChoice& choice,
                                           const std::vector<ImpactsOfSample>& samples,
                                           const std::vector<std::string>& names) {
    std::vector<FittedDamping> fits = fit_damping_laws(choice.law, choice.detachment, samples);
    if (fits.empty()) return std::nullopt;
    DampingStudy study{{.law = choice.law}, std::move(fits)};
    study.comparison.laws = in_parallel(study.fits, [&](const FittedDamping& fitted) {
        ComparedDamping damping{.law = fitted.law,
                                .correlation = fitted.correlation,
                                .misfit = fitted.misfit,
                                .evidence = fitted.evidence};
        for (const DampingConstant& constant : fitted.constants)
            damping.constants.emplace_back(
                std::string(constant.name),
                make_quantity(constant.value, constant.dimension, constant.uncertainty));
        for (std::size_t i = 0; i < samples.size(); ++i)
            damping.samples.push_back(damped_sample(choice, fitted, samples[i], names[i]));
        return damping;
    });
    return study;
}

std::optional<DampingStudy> study_dampings(const LawChoice& choice, const ContactResult& contacts,
                                           const RestitutionResult& restitutions) {
    std::vector<ImpactsOfSample> samples;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < restitutions.samples.size(); ++i) {
        const RestitutionSeries* series = restitutions.samples[i].of(choice.law);
        if (series == nullptr || series->impacts.points.empty()) continue;
        samples.push_back({contacts.samples[i].pair, series->impacts.points});
        names.push_back(restitutions.samples[i].name);
    }
    return study_dampings(choice, samples, names);
}

}  // namespace ashimpact

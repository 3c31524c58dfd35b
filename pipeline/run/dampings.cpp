// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/dampings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "solver/batch/batch.hpp"
#include "solver/batch/kernels/kernel.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/motion/regime.hpp"
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

/// The damping that captures, searched from that of a contact without adhesion; NaN where that is far off.
double near_capturing_damping(const DampingProblem& problem) {
    const double unit = velocity_of_damping({DampingLaw::constant, 1.0}, problem.contact);
    const double guess = std::pow(problem.velocity / (hertz_critical_constant * unit), 0.2);
    return capturing_damping(
               {problem.law, problem.detachment, {DampingLaw::constant, guess}, problem.contact},
               problem.velocity)
        .value_or(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

Eigen::ArrayXd near_dampings(const std::vector<DampingProblem>& problems) {
    Eigen::ArrayXd all =
        Eigen::ArrayXd::Constant(std::ssize(problems), std::numeric_limits<double>::quiet_NaN());
    std::vector<Eigen::Index> places;
    std::vector<Impact> impacts;
    for (std::size_t i = 0; i < problems.size(); ++i) {
        const DampingProblem& problem = problems[i];
        const bool in_lanes =
            batch::has_kernels(problem.law, problem.damping_law) && !can_yield(problem.law, problem.contact);
        if (!in_lanes || !(problem.restitution < 1)) continue;
        if (problem.restitution == 0 && problem.damping_law == DampingLaw::constant)
            all[static_cast<Eigen::Index>(i)] = near_capturing_damping(problem);
        if (!(problem.restitution > 0)) continue;
        places.push_back(static_cast<Eigen::Index>(i));
        impacts.push_back(
            {problem.law, problem.detachment, {problem.damping_law, 0}, problem.contact, problem.velocity});
    }
    if (impacts.empty()) return all;
    Eigen::ArrayXd restitution(std::ssize(places));
    for (std::size_t k = 0; k < places.size(); ++k)
        restitution[static_cast<Eigen::Index>(k)] = problems[static_cast<std::size_t>(places[k])].restitution;
    try {
        const ImpactList list(impacts);
        const ImpactBatch batch = list.batch();
        all(places) = dampings_from_restitutions({.law = batch.law,
                                                  .detachment = batch.detachment,
                                                  .damping_law = batch.damping_law,
                                                  .contact = batch.contact,
                                                  .velocity = batch.velocity,
                                                  .restitution = restitution})
                          .damping;
    } catch (const InputError&) {  // each impact says why
        return all;
    }
    return all;
}

namespace {

/// Adds to the uncertainties of constants what an error of scale of all velocities moves them by.
void add_common_error(std::vector<FittedDamping>& fits, const LawChoice& choice,
                      std::vector<ImpactsOfSample> samples, double scale_uncertainty) {
    const double factor = 1 + scale_uncertainty;
    for (ImpactsOfSample& sample : samples)
        for (Measurement& impact : sample.impacts) {
            impact.velocity *= factor;
            impact.rebound *= factor;
            if (!impact.noise) continue;
            for (double VelocityNoise::*variance :
                 {&VelocityNoise::incident, &VelocityNoise::rebound, &VelocityNoise::covariance})
                (*impact.noise).*variance *= factor * factor;
        }
    const auto moved = fit_damping_laws(choice.law, choice.detachment, samples);
    for (FittedDamping& fit : fits) {
        const auto other = std::ranges::find(moved, fit.law, &FittedDamping::law);
        if (other == moved.end() || other->constants.size() != fit.constants.size()) continue;
        for (std::size_t k = 0; k < fit.constants.size(); ++k)
            fit.constants[k].uncertainty =
                std::hypot(fit.constants[k].uncertainty, other->constants[k].value - fit.constants[k].value);
    }
}

}  // namespace

std::optional<DampingStudy> study_dampings(const LawChoice& choice,
                                           const std::vector<ImpactsOfSample>& samples,
                                           const std::vector<std::string>& names, double scale_uncertainty) {
    std::vector<FittedDamping> fits = fit_damping_laws(choice.law, choice.detachment, samples);
    if (fits.empty()) return std::nullopt;
    if (scale_uncertainty > 0) add_common_error(fits, choice, samples, scale_uncertainty);
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
                                           const RestitutionResult& restitutions, double scale_uncertainty) {
    std::vector<ImpactsOfSample> samples;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < restitutions.samples.size(); ++i) {
        const RestitutionSeries* series = restitutions.samples[i].of(choice.law);
        if (series == nullptr || series->impacts.points.empty()) continue;
        samples.push_back({contacts.samples[i].pair, series->impacts.points});
        names.push_back(restitutions.samples[i].name);
    }
    return study_dampings(choice, samples, names, scale_uncertainty);
}

}  // namespace ashimpact

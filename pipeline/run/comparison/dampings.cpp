// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/comparison/dampings.hpp"

#include <algorithm>
#include <cmath>

#include "core/quantities/quantity.hpp"
#include "solver/batch/batch.hpp"

namespace ashimpact {

namespace {

constexpr int explained_points = 25;       ///< of a curve
constexpr double beyond_explained = 1.25;  ///< a curve reaches so far beyond the slowest and fastest impact

/// The law that most samples report, of several the one that the case has first.
std::optional<LawChoice> most_reported(const Case& data, const std::vector<SampleComparison>& samples) {
    const auto reports = [&](const LawChoice& choice) {
        return std::ranges::count_if(samples, [&](const SampleComparison& sample) {
            return sample.reported && sample.reported->law == choice.law;
        });
    };
    const auto most = std::ranges::max_element(data.laws, {}, reports);
    if (most == data.laws.end() || reports(*most) == 0) return std::nullopt;
    return *most;
}

/// e over the velocities of the impacts.
std::vector<ExplainedImpact> explained_curve(const LawChoice& choice, const DampingExplanation& explanation,
                                             const ImpactsOfSphere& sphere) {
    if (explanation.constants.empty()) return {};
    const auto [slowest, fastest] = std::ranges::minmax_element(sphere.impacts, {}, &Measurement::velocity);
    const double first = slowest->velocity / beyond_explained;
    const double ratio = fastest->velocity * beyond_explained / first;
    std::vector<Impact> impacts;
    for (int i = 0; i < explained_points; ++i)
        impacts.push_back({choice.law,
                           choice.detachment,
                           {explanation.law, explanation.constants.front().value},
                           contact_with(explanation, sphere.contact),
                           first * std::pow(ratio, static_cast<double>(i) / (explained_points - 1))});
    const Eigen::ArrayXd e =
        solve_impacts(ImpactList(impacts).batch(), {.turning_point = false, .contact_time = false})
            .restitution;
    std::vector<ExplainedImpact> curve;
    for (int i = 0; i < explained_points; ++i)
        curve.push_back({impacts[static_cast<std::size_t>(i)].velocity, e[i]});
    return curve;
}

LawVerdict verdict_of(const std::optional<CriticalVelocity>& velocity) {
    return velocity ? static_cast<LawVerdict>(velocity->verdict) : LawVerdict::no_fit;
}

}  // namespace

std::optional<DampingComparison> explained_dampings(const LawChoice& choice,
                                                    const std::vector<ImpactsOfSphere>& spheres,
                                                    const std::vector<std::string>& names) {
    const bool rebounds = std::ranges::any_of(spheres, [](const ImpactsOfSphere& sphere) {
        return !std::ranges::all_of(sphere.impacts, &Measurement::captured);
    });
    if (!rebounds) return std::nullopt;
    DampingComparison comparison{.law = choice.law};
    for (const DampingExplanation& explanation : explain_by_damping(choice.law, choice.detachment, spheres)) {
        ExplainedDamping damping{
            .law = explanation.law, .correlation = explanation.correlation, .misfit = explanation.misfit};
        for (const DampingConstant& constant : explanation.constants)
            damping.constants.emplace_back(
                std::string(constant.name),
                make_quantity(constant.value, constant.dimension, constant.uncertainty));
        for (std::size_t i = 0; i < spheres.size(); ++i) {
            const std::optional<CriticalVelocity>& velocity = explanation.velocities[i];
            damping.samples.push_back({.name = names[i],
                                       .verdict = verdict_of(velocity),
                                       .velocity = velocity ? velocity->value : std::nullopt,
                                       .curve = explained_curve(choice, explanation, spheres[i])});
        }
        comparison.dampings.push_back(std::move(damping));
    }
    return comparison;
}

std::optional<DampingComparison> compare_dampings(const Case& data, const ContactResult& contacts,
                                                  const RestitutionResult& restitutions,
                                                  const std::vector<SampleComparison>& samples) {
    const std::optional<LawChoice> choice = most_reported(data, samples);
    if (!choice) return std::nullopt;
    std::vector<ImpactsOfSphere> spheres;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < restitutions.samples.size(); ++i) {
        const RestitutionSeries* series = restitutions.samples[i].of(choice->law);
        if (series == nullptr || series->impacts.points.empty()) continue;
        spheres.push_back({contacts.samples[i].pair, series->impacts.points});
        names.push_back(restitutions.samples[i].name);
    }
    return explained_dampings(*choice, spheres, names);
}

}  // namespace ashimpact

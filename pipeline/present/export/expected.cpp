// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/export/expected.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/json/quantity_json.hpp"
#include "core/json/writer.hpp"
#include "core/version.hpp"

namespace ashimpact {

namespace {

constexpr std::array critical_multiples{0.99, 1.01, 1.5, 3.0, 10.0};
constexpr double largest_overlap = 0.1;                          // of the radius; beyond it no law here holds
constexpr std::array velocities_without_capture{0.1, 0.5, 2.0};  // [m/s]

std::vector<double> sizes_of(const ExportSubject& subject) {
    const double middle = std::sqrt(subject.from_diameter * subject.to_diameter);
    std::vector<double> sizes{subject.from_diameter, subject.to_diameter};
    for (const double size : {subject.reference_diameter(), 0.97 * middle})
        if (size > subject.from_diameter && size < subject.to_diameter) sizes.push_back(size);
    std::ranges::sort(sizes);
    sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
    return sizes;
}

std::vector<double> velocities_of(const ExportSubject& subject, double diameter) {
    std::vector<double> velocities;
    if (const auto critical = threshold_at(subject, diameter).value)
        for (const double multiple : critical_multiples) velocities.push_back(multiple * *critical);
    else
        velocities.assign(velocities_without_capture.begin(), velocities_without_capture.end());
    if (subject.velocity) velocities.push_back(*subject.velocity);
    if (subject.to_velocity) std::erase_if(velocities, [&](double v) { return v > *subject.to_velocity; });
    std::ranges::sort(velocities);
    velocities.erase(std::unique(velocities.begin(), velocities.end()), velocities.end());
    return velocities;
}

}  // namespace

std::vector<ExpectedImpact> expected_impacts(const ExportSubject& subject) {
    std::vector<ExpectedImpact> impacts;
    for (const double diameter : sizes_of(subject))
        for (const double velocity : velocities_of(subject, diameter)) {
            const ImpactResult result = solve_impact(impact_at(subject, diameter, velocity));
            if (result.maximum_overlap > largest_overlap * contact_at(subject, diameter).effective_radius)
                continue;
            impacts.push_back({.diameter = diameter,
                               .velocity = velocity,
                               .outcome = result.outcome,
                               .restitution = result.restitution,
                               .contact_time = result.contact_time,
                               .maximum_overlap = result.maximum_overlap});
        }
    return impacts;
}

ExportFile expected_json(const ExportSubject& subject, std::string_view code, const Json& more) {
    Json document{{"program", "ashimpact"},
                  {"version", program_version()},
                  {"code", code},
                  {"law", subject.law.name()},
                  {"detachment", name_of(subject.detachment)},
                  {"damping_law", name_of(subject.damping.law)},
                  {"density", quantity_json(subject.density, Dimension::density)}};
    if (subject.partner)
        document["partner"] = {{"radius", quantity_json(subject.partner->radius, Dimension::length)},
                               {"mass", quantity_json(subject.partner->mass, Dimension::mass)}};
    document.update(more);
    document["impacts"] = Json::array();
    for (const ExpectedImpact& impact : expected_impacts(subject))
        document["impacts"].push_back(
            {{"diameter", quantity_json(impact.diameter, Dimension::length)},
             {"velocity", quantity_json(impact.velocity, Dimension::velocity)},
             {"outcome", name_of(impact.outcome)},
             {"restitution", quantity_json(impact.restitution, Dimension::fraction)},
             {"contact_time", quantity_json(impact.contact_time, Dimension::time)}});
    return {"expected.json", write_json(document, Digits::seventeen)};
}

}  // namespace ashimpact

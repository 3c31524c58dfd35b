// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/export/laboratory.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/json/view.hpp"
#include "core/quantities/quantity.hpp"
#include "core/text/text.hpp"
#include "solver/batch/batch.hpp"
#include "solver/batch/problems.hpp"

namespace ashimpact {

namespace {

constexpr std::size_t most_groups = 16;  // of neighbouring rebounds, each with its mean
constexpr std::size_t most_compared =
    1000;  // impacts of a sample; laws without a vector kernel take 1 ms each

/// The impacts that are compared, evenly chosen by their rank in velocity; the fastest is among them.
std::vector<LaboratoryImpact> compared_impacts(const Laboratory& laboratory) {
    const auto& all = laboratory.impacts;
    const std::size_t count = std::min(most_compared, all.size());
    std::vector<LaboratoryImpact> some;
    for (std::size_t k = 1; k <= count; ++k) some.push_back(all[k * all.size() / count - 1]);
    return some;
}

/// Exported restitutions of these impacts.
Eigen::ArrayXd exported_restitutions(const ExportSubject& subject, double diameter,
                                     const std::vector<LaboratoryImpact>& measured) {
    const double critical = threshold_at(subject, diameter).value.value_or(0);
    std::vector<Impact> impacts;
    impacts.reserve(measured.size());
    for (const LaboratoryImpact& each : measured)
        impacts.push_back(
            impact_above(subject, diameter, each.velocity, critical > 0 ? critical : each.velocity));
    return solve_impacts(ImpactList(impacts).batch(), {.threads = 0, .turning_point = false}).restitution;
}

LaboratoryDifference difference_of(const ExportSubject& subject, const Laboratory& laboratory) {
    const auto impacts = compared_impacts(laboratory);
    LaboratoryDifference difference{
        .laboratory = &laboratory, .compared = impacts.size(), .fastest = impacts.back().velocity};
    const Eigen::ArrayXd exported = exported_restitutions(subject, laboratory.diameter, impacts);
    double squares = 0;
    for (std::size_t i = 0; i < impacts.size(); ++i) {
        const auto& [velocity, measured] = impacts[i];
        const double e = exported[static_cast<Eigen::Index>(i)];
        if ((e > 0) != (measured > 0)) ++difference.other_outcomes;
        squares += (e - measured) * (e - measured);
        if (std::abs(e - measured) <= difference.largest) continue;
        difference.largest = std::abs(e - measured);
        difference.at_velocity = velocity;
    }
    difference.root_mean_square = std::sqrt(squares / static_cast<double>(impacts.size()));
    return difference;
}

/// Means of velocity and restitution of neighbouring rebounds.
std::vector<LaboratoryImpact> mean_rebounds(const std::vector<LaboratoryImpact>& rebounds) {
    const std::size_t count = std::min(most_groups, rebounds.size());
    std::vector<LaboratoryImpact> means;
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t from = k * rebounds.size() / count;
        const std::size_t to = (k + 1) * rebounds.size() / count;
        const auto share = 1.0 / static_cast<double>(to - from);
        LaboratoryImpact mean{0, 0};
        for (std::size_t i = from; i < to; ++i) {
            mean.velocity += share * rebounds[i].velocity;
            mean.restitution += share * rebounds[i].restitution;
        }
        means.push_back(mean);
    }
    return means;
}

}  // namespace

std::vector<LaboratoryDifference> laboratory_differences(const ExportSubject& subject) {
    const ExportSubject stiff = stiffened(subject);
    std::vector<LaboratoryDifference> differences;
    for (const Laboratory& laboratory : subject.laboratory)
        if (!laboratory.impacts.empty()) {
            differences.push_back(difference_of(stiff, laboratory));
            differences.back().laboratory = &laboratory;
        }
    return differences;
}

std::optional<double> measured_restitution(const ExportSubject& subject, double diameter, double velocity) {
    const auto laboratory = std::ranges::find(subject.laboratory, diameter, &Laboratory::diameter);
    if (laboratory == subject.laboratory.end() || laboratory->impacts.empty()) return std::nullopt;
    std::vector<LaboratoryImpact> rebounds;
    double fastest_capture = 0;
    for (const LaboratoryImpact& each : laboratory->impacts)
        if (each.restitution > 0)
            rebounds.push_back(each);
        else
            fastest_capture = std::max(fastest_capture, each.velocity);
    const bool only_captures = rebounds.empty() || velocity < rebounds.front().velocity;
    if (only_captures && velocity <= fastest_capture && velocity >= laboratory->impacts.front().velocity)
        return 0;
    const auto means = mean_rebounds(rebounds);
    if (only_captures || velocity <= fastest_capture || velocity < means.front().velocity ||
        velocity > means.back().velocity)
        return std::nullopt;
    const auto above = std::ranges::lower_bound(means, velocity, {}, &LaboratoryImpact::velocity);
    if (above->velocity == velocity) return above->restitution;
    const LaboratoryImpact& below = *std::prev(above);
    const double share = (velocity - below.velocity) / (above->velocity - below.velocity);
    return below.restitution + share * (above->restitution - below.restitution);
}

std::string laboratory_lines(const ExportSubject& subject) {
    std::string lines;
    for (const LaboratoryDifference& each : laboratory_differences(subject)) {
        const Laboratory& laboratory = *each.laboratory;
        lines += fmt::format(
            "e against the {} impacts of {} ({}, up to {}): off by {} (root mean square), at most {} "
            "at "
            "{}{}.\n",
            laboratory.reconstructed ? "reconstructed" : "measured", readable(laboratory.diameter, "m"),
            each.compared == laboratory.impacts.size()
                ? fmt::format("{} of them", each.compared)
                : fmt::format("{} of {}", each.compared, laboratory.impacts.size()),
            readable(each.fastest, "m/s"), readable_number(each.root_mean_square, 2),
            readable_number(each.largest, 2), readable(each.at_velocity, "m/s"),
            each.other_outcomes == 0 ? "" : fmt::format("; {} with another outcome", each.other_outcomes));
    }
    if (!lines.empty() && subject.depends_on_velocity())
        lines +=
            "Faster than these impacts the damping is held at its last value: e is an assumption there.\n";
    return lines;
}

Json laboratory_json(const ExportSubject& subject) {
    Json samples = Json::array();
    const LaboratoryDifference* worst = nullptr;
    const auto differences = laboratory_differences(subject);
    for (const LaboratoryDifference& each : differences) {
        if (worst == nullptr || each.largest > worst->largest) worst = &each;
        samples.push_back(
            {{"diameter", quantity_json(each.laboratory->diameter, Dimension::length)},
             {"origin", each.laboratory->reconstructed ? "reconstructed" : "measured"},
             {"impacts", each.laboratory->impacts.size()},
             {"compared", each.compared},
             {"fastest", quantity_json(each.fastest, Dimension::velocity)},
             {"largest_difference", quantity_json(each.largest, Dimension::fraction)},
             {"at_velocity", quantity_json(each.at_velocity, Dimension::velocity)},
             {"root_mean_square_difference", quantity_json(each.root_mean_square, Dimension::fraction)},
             {"other_outcomes", each.other_outcomes}});
    }
    return {{"largest_difference",
             worst == nullptr ? Json() : quantity_json(worst->largest, Dimension::fraction)},
            {"samples", samples}};
}

}  // namespace ashimpact

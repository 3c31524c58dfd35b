// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/export/folder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

#include "core/embedded.hpp"
#include "core/json/document.hpp"
#include "core/json/view.hpp"
#include "core/plausibility.hpp"
#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "core/version.hpp"
#include "solver/motion/regime.hpp"

namespace ashimpact {

namespace {

constexpr std::array critical_multiples{0.99, 1.01, 1.5, 3.0, 10.0};
constexpr double largest_overlap = 0.1;                          // of the radius; beyond it no law here holds
constexpr std::array velocities_without_capture{0.1, 0.5, 2.0};  // [m/s]

std::vector<double> sorted_once(std::vector<double> values) {
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

std::vector<double> sizes_of(const ExportSubject& subject) {
    const double middle = std::sqrt(subject.from_diameter * subject.to_diameter);
    std::vector<double> sizes{subject.from_diameter, subject.to_diameter};
    for (const double size : {subject.reference_diameter(), 0.97 * middle})
        if (size > subject.from_diameter && size < subject.to_diameter) sizes.push_back(size);
    return sorted_once(std::move(sizes));
}

std::vector<double> velocities_of(const ExportSubject& subject, double diameter) {
    std::vector<double> velocities;
    if (const auto critical = threshold_at(subject, diameter).value)
        for (const double multiple : critical_multiples) velocities.push_back(multiple * *critical);
    else
        velocities.assign(velocities_without_capture.begin(), velocities_without_capture.end());
    if (subject.velocity) velocities.push_back(*subject.velocity);
    if (subject.to_velocity) std::erase_if(velocities, [&](double v) { return v > *subject.to_velocity; });
    return sorted_once(std::move(velocities));
}

std::string_view template_text(std::string_view path) {
    const auto text = embedded_file("export/" + std::string(path));
    if (!text) throw std::logic_error("no template export/" + std::string(path));
    return *text;
}

std::string damping_words(const ExportSubject& subject) {
    const SizedDamping& damping = subject.damping;
    if (damping.is_zero()) return "none";
    std::string words =
        damping.depends_on_velocity()
            ? fmt::format("{} at {} nodes of v_in", name_of(damping.law), damping.nodes.size())
            : fmt::format("{} {}", name_of(damping.law),
                          readable(damping.nodes.front().coefficient, unit_of(damping.law)));
    if (damping.exponent != 0)
        words += fmt::format(" at {}, times (d/d_0)^{}", readable(damping.reference_diameter, "m"),
                             shortest(damping.exponent));
    return words;
}

std::string range_words(const ExportSubject& subject) {
    return subject.one_size() ? "a diameter of " + readable(subject.from_diameter, "m")
                              : fmt::format("diameters from {} to {}", readable(subject.from_diameter, "m"),
                                            readable(subject.to_diameter, "m"));
}

/// Who meets whom, and the R* and m* of it.
std::string geometry_words(const ExportSubject& subject) {
    if (!subject.partner) return "R* = d/2, m = density pi d^3/6";
    return fmt::format(
        "on a sphere of radius r2 = {} and mass m2 = {}: 1/R* = 2/d + 1/r2, 1/m* = 1/m + 1/m2, "
        "m = density pi d^3/6; the velocity is that of one to the other",
        readable(subject.partner->radius, "m"), readable(subject.partner->mass, "kg"));
}

/// What regime_of() remarks on the impacts of the folder, each once.
std::set<std::string> remarks(const ExportSubject& subject) {
    std::set<std::string> lines;
    for (const Finding& doubt : sizes_outside_model(subject)) lines.insert(doubt.text);
    for (const ExpectedImpact& each : expected_impacts(subject)) {
        if (!each.maximum_overlap) continue;
        const Regime regime =
            regime_of(impact_at(subject, each.diameter, each.velocity), *each.maximum_overlap);
        for (const Finding& warning : regime.warnings)
            lines.insert(readable(each.diameter, "m") + ": " + warning.text);
    }
    return lines;
}

}  // namespace

std::string exact(double value) {
    return fmt::format("{:.17g}", value);
}

std::string filled(std::string_view path, const TemplateValues& values) {
    const std::string_view text = template_text(path);
    std::string result;
    std::size_t position = 0;
    for (std::size_t open = 0; (open = text.find('@', position)) != std::string_view::npos;) {
        const std::size_t close = text.find('@', open + 1);
        const auto value = close == std::string_view::npos
                               ? values.end()
                               : values.find(text.substr(open + 1, close - open - 1));
        if (value == values.end())
            throw std::logic_error(
                fmt::format("template {}: no value for {}", path,
                            text.substr(open, std::min(close - open + 1, std::size_t{40}))));
        result.append(text, position, open - position).append(value->second);
        position = close + 1;
    }
    return result.append(text, position);
}

ExportFile unchanged(std::string_view path) {
    return {std::string(path.substr(path.rfind('/') + 1)), std::string(template_text(path))};
}

TemplateValues common_values(const ExportSubject& subject) {
    return {{"law", std::string(subject.law.name())},
            {"detachment", std::string(name_of(subject.detachment))},
            {"damping", damping_words(subject)},
            {"version", std::string(program_version())},
            {"diameter", exact(subject.reference_diameter())},
            {"density", exact(subject.density)},
            {"other_body", subject.partner ? "on another sphere" : "on a wall"},
            {"density_words", readable(subject.density, "kg/m3")},
            {"contact_modulus", exact(subject.contact.contact_modulus)},
            {"work_of_adhesion", exact(subject.contact.work_of_adhesion)},
            {"range", range_words(subject)},
            {"smallest", exact(subject.from_diameter)},
            {"largest", exact(subject.to_diameter)}};
}

ExportFile assumptions(const ExportSubject& subject, const std::vector<std::string>& conversions) {
    std::string text = "# Assumptions and conversions\n\n## The numbers and where they come from\n\n";
    for (const std::string& origin : subject.origins) text += "- " + origin + "\n";
    text += fmt::format(
        "- {}{}: {}\n- damping: {}\n- law {}, contact ends at {}; one normal impact on {}, no rotation, no "
        "friction\n",
        range_words(subject), subject.one_size() ? "" : ", E*, w and density the same for all of them",
        geometry_words(subject), damping_words(subject), subject.law.name(), name_of(subject.detachment),
        subject.partner ? "the other sphere" : "a flat wall");
    text += "\n## What they became\n\n";
    for (const std::string& conversion : conversions) text += "- " + conversion + "\n";
    text += "\n## What the model holds for\n\n";
    const auto lines = remarks(subject);
    for (const std::string& line : lines) text += "- " + line + "\n";
    if (lines.empty()) text += "- nothing speaks against this law in these impacts\n";
    text +=
        fmt::format("- for {} only; for another {}, humidity or temperature the numbers above are others\n",
                    range_words(subject), subject.partner ? "partner" : "wall");
    return {"assumptions.md", without_controls(text)};
}

std::vector<Finding> sizes_outside_model(const ExportSubject& subject) {
    std::vector<Finding> findings;
    for (const double diameter : sizes_of(subject))
        if (auto doubt = outside_model(threshold_at(subject, diameter).value.value_or(0))) {
            doubt->text.insert(0, readable(diameter, "m") + ": ");
            findings.push_back(*std::move(doubt));
        }
    return findings;
}

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

std::span<const ExportCode> export_codes() {
    static constexpr std::array codes{
        ExportCode{"openfoam", openfoam_folder}, ExportCode{"lammps", lammps_folder},
        ExportCode{"liggghts", liggghts_folder}, ExportCode{"yade", yade_folder},
        ExportCode{"fluent", fluent_folder},     ExportCode{"table", table_folder, "compare.py"}};
    return codes;
}

const ExportCode& export_code(std::string_view name) {
    std::vector<std::string> names;
    for (const ExportCode& code : export_codes()) {
        if (code.name == name) return code;
        names.emplace_back(code.name);
    }
    throw InputError("no code is called " + in_quotes(name) + did_you_mean(name, names), joined(names))
        .at("export");
}

}  // namespace ashimpact

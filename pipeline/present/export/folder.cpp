// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/export/folder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
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
#include "pipeline/present/export/laboratory.hpp"
#include "solver/damping/brach_dunn.hpp"
#include "solver/dem/softening.hpp"
#include "solver/motion/regime.hpp"

namespace ashimpact {

namespace {

constexpr std::array critical_multiples{0.99, 1.01, 1.2, 2.0, 5.0, 10.0};
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
    const auto add = [&](double size) {
        if (size > subject.from_diameter && size < subject.to_diameter) sizes.push_back(size);
    };
    for (const AshSize& size : subject.sizes) add(size.diameter);
    add(0.97 * middle);
    return sorted_once(std::move(sizes));
}

std::vector<double> velocities_of(const ExportSubject& subject, double diameter) {
    std::vector<double> velocities;
    if (const auto critical = threshold_at(subject, diameter).value)
        for (const double multiple : critical_multiples) velocities.push_back(multiple * *critical);
    else
        velocities.assign(velocities_without_capture.begin(), velocities_without_capture.end());
    if (subject.velocity) velocities.push_back(*subject.velocity);
    if (subject.to_velocity) {
        std::erase_if(velocities, [&](double v) { return v > *subject.to_velocity; });
        if (!velocities.empty()) velocities.push_back(*subject.to_velocity);
    }
    return sorted_once(std::move(velocities));
}

/// A positive number with two digits, not above it: "8.3", "140".
std::string rounded_down(double value) {
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
    return fmt::format("{:.10g}", std::floor(value / unit * (1 + 1e-12)) * unit);
}

std::string_view template_text(std::string_view path) {
    const auto text = embedded_file("export/" + std::string(path));
    if (!text) throw std::logic_error("no template export/" + std::string(path));
    return *text;
}

std::string damping_words(const ExportSubject& subject) {
    if (subject.is_undamped()) return "none";
    const AshSize& reference = subject.reference();
    std::string words =
        subject.depends_on_velocity()
            ? fmt::format("{} along the {} impacts", name_of(subject.damping_law),
                          std::ranges::any_of(subject.laboratory, &Laboratory::reconstructed)
                              ? "reconstructed"
                              : "measured")
            : fmt::format("{} {}", name_of(subject.damping_law),
                          readable(reference.damping.critical(), unit_of(subject.damping_law)));
    if (subject.sizes.size() > 1)
        words = fmt::format("{} of {} sizes",
                            subject.depends_on_velocity() ? words : std::string(name_of(subject.damping_law)),
                            subject.sizes.size());
    if (subject.exponent != 0 && subject.goes_beyond_sizes())
        words += subject.sizes.size() > 1
                     ? fmt::format(", beyond them times (d/d_0)^{}", shortest(subject.exponent))
                     : fmt::format(" at {}, times (d/d_0)^{}", readable(reference.diameter, "m"),
                                   shortest(subject.exponent));
    const auto& parameters = reference.contact.parameters;
    if (!has_one_number(subject.damping_law) && parameters.has(adhesion_damping))
        words += fmt::format(", zeta_A {}", readable(parameters[adhesion_damping], "s/m")) +
                 (subject.goes_beyond_sizes() ? " at every size" : "");
    return words;
}

/// One softened constant: "w 300 mJ/m2 -> 18.93 mJ/m2".
std::string change(std::string_view name, double before, double after, std::string_view unit) {
    return fmt::format("{} {} -> {}", name, readable(before, unit), readable(after, unit));
}

/// The constants of a softened contact, before and after.
std::string softened_constants(const ExportSubject& subject) {
    const ContactPair& soft = subject.reference().contact;
    const AshSize& before = subject.stiff->sizes.front();
    const ContactPair& stiff = before.contact;
    std::vector<std::string> changes{change("E*", stiff.contact_modulus, soft.contact_modulus, "Pa")};
    if (subject.law.uses_work_of_adhesion())
        changes.push_back(change("w", stiff.work_of_adhesion, soft.work_of_adhesion, "J/m2"));
    if (std::isfinite(stiff.yield_pressure))
        changes.push_back(change("p_y", stiff.yield_pressure, soft.yield_pressure, "Pa"));
    for (const LawParameter& parameter : subject.law.parameters())
        if (stiff.parameters.has(parameter))
            changes.push_back(change(parameter.name, stiff.parameters[parameter], soft.parameters[parameter],
                                     si_unit(parameter.dimension)));
    if (!subject.is_undamped())
        changes.push_back(change(fmt::format("damping {}", name_of(subject.damping_law)),
                                 before.damping.critical(), subject.reference().damping.critical(),
                                 unit_of(subject.damping_law)));
    return joined(changes);
}

/// What softening changed and what it loses, for assumptions.md.
std::vector<std::string> softening_lines(const ExportSubject& subject) {
    const std::string stretch = readable_number(stretch_of(subject));
    double overlap = 0;
    double shortest_contact = std::numeric_limits<double>::infinity();
    for (const ExpectedImpact& each : expected_impacts(subject)) {
        overlap = std::max(
            overlap, each.maximum_overlap.value_or(0) / contact_at(subject, each.diameter).effective_radius);
        shortest_contact = std::min(shortest_contact, each.contact_time.value_or(shortest_contact));
    }
    std::vector<std::string> lines{
        fmt::format("softened by S = {}: {}; e at every velocity and v_c are those of the stiff contact",
                    shortest(subject.stiff->factor), softened_constants(subject)),
        fmt::format("contacts last {0} times longer{1}; the time step may be {0} times longer, too", stretch,
                    std::isfinite(shortest_contact)
                        ? fmt::format(", the shortest now {}", readable(shortest_contact, "s"))
                        : ""),
        fmt::format("overlaps are {} times greater: up to {} % of R* in the impacts of expected.json; the "
                    "limit is {} %",
                    stretch, readable_number(100 * overlap, 2),
                    readable_number(100 * greatest_softened_overlap)),
        fmt::format("lost: forces of contact, adhesion and pull-off among them, are {} times weaker against "
                    "weight, drag and all that is not softened: what stays on a wall in gravity or shear is "
                    "not that of the stiff contact",
                    stretch),
        fmt::format("lost: rolling resistance and heat transfer, which go with the contact radius, now {} "
                    "times greater; friction that depends on the time of contact",
                    readable_number(std::sqrt(stretch_of(subject))))};
    return lines;
}

std::string range_words(const ExportSubject& subject) {
    return subject.one_size() ? "a diameter of " + readable(subject.from_diameter, "m")
                              : fmt::format("diameters from {} to {}", readable(subject.from_diameter, "m"),
                                            readable(subject.to_diameter, "m"));
}

std::string density_words(const ExportSubject& subject) {
    const auto [least, greatest] = std::ranges::minmax(subject.sizes, {}, &AshSize::density);
    return least.density == greatest.density
               ? readable(least.density, "kg/m3")
               : fmt::format("{} to {}, by size", readable(least.density, "kg/m3"),
                             readable(greatest.density, "kg/m3"));
}

/// Who meets whom, and the R* and m* of it.
std::string geometry_words(const ExportSubject& subject) {
    if (!subject.partner) return "R* = d/2, m = density pi d^3/6";
    return fmt::format(
        "on a sphere of radius r2 = {} and mass m2 = {}: 1/R* = 2/d + 1/r2, 1/m* = 1/m + 1/m2, "
        "m = density pi d^3/6; the velocity is that of one to the other",
        readable(subject.partner->radius, "m"), readable(subject.partner->mass, "kg"));
}

}  // namespace

std::set<std::string> regime_remarks(const ExportSubject& subject, Severity least) {
    std::set<std::string> lines;
    const ExportSubject stiff = stiffened(subject);
    for (const ExpectedImpact& each : expected_impacts(stiff)) {
        if (!each.maximum_overlap) continue;
        const Regime regime =
            regime_of(impact_at(stiff, each.diameter, each.velocity), *each.maximum_overlap);
        for (const Finding& warning : regime.warnings)
            if (warning.severity >= least) lines.insert(readable(each.diameter, "m") + ": " + warning.text);
    }
    return lines;
}

std::string softening_comment(const ExportSubject& subject) {
    if (!subject.stiff) return "";
    return fmt::format(
        "# Softened: E* is divided by {}; e and v_c are those of the stiff contact. See "
        "assumptions.md.\n",
        shortest(subject.stiff->factor));
}

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
    return {
        {"law", std::string(subject.law.name())},
        {"detachment", std::string(name_of(subject.detachment))},
        {"damping", damping_words(stiffened(subject))},
        {"softening",
         subject.stiff ? fmt::format("Softened by {0}: contacts last {1} times longer, with the e and v_c of "
                                     "the stiff contact. The numbers of this folder are not those of the "
                                     "material;\nadhesion is {1} times weaker against weight and drag. "
                                     "`assumptions.md` lists what else is lost.\n",
                                     shortest(subject.stiff->factor), readable_number(stretch_of(subject)))
                       : ""},
        {"softening_comment", softening_comment(subject)},
        {"friction", exact(subject.friction)},
        {"tangential",
         subject.friction > 0
             ? fmt::format(
                   "Along the wall: Coulomb friction {}, by a spring {} times as stiff as the contact. "
                   "Nothing resists rolling: what stays rolls on.",
                   shortest(subject.friction), shortest(tangential_stiffness_ratio))
             : "Tangential forces are off (`--friction MU` sets them); the normal direction does not depend "
               "on "
               "them."},
        {"version", std::string(program_version())},
        {"diameter", exact(subject.reference().diameter)},
        {"density", exact(subject.reference().density)},
        {"laboratory", laboratory_lines(subject)},
        {"other_body", subject.partner ? "on another sphere" : "on a wall"},
        {"density_words", density_words(subject)},
        {"contact_modulus", exact(subject.reference().contact.contact_modulus)},
        {"work_of_adhesion", exact(subject.reference().contact.work_of_adhesion)},
        {"range", range_words(subject)},
        {"smallest", exact(subject.from_diameter)},
        {"largest", exact(subject.to_diameter)}};
}

ExportFile assumptions(const ExportSubject& subject, const std::vector<std::string>& conversions) {
    std::string text = "# Assumptions and conversions\n\n## The numbers and where they come from\n\n";
    for (const auto* lines : {&subject.edits, &subject.origins, &subject.dampings})
        for (const std::string& line : *lines) text += "- " + line + "\n";
    text += fmt::format(
        "- {}{}: {}\n- damping: {}\n{}- law {}, contact ends at {}; one impact on {}, {}\n",
        range_words(subject),
        subject.one_size() || subject.sizes.size() > 1 ? "" : ", E*, w and density the same for all of them",
        geometry_words(subject), damping_words(stiffened(subject)),
        subject.depends_on_velocity() && subject.goes_beyond_sizes()
            ? "- sizes beyond the measured ones have the damping of the nearest one at the same v/v_c, times "
              "(d/d_0)^n\n"
            : "",
        subject.law.name(), name_of(subject.detachment), subject.partner ? "the other sphere" : "a flat wall",
        subject.friction > 0 ? "along it a rigid sphere with Coulomb friction " + shortest(subject.friction) +
                                   " and without spin before"
                             : "normal, no rotation, no friction");
    text += "\n## What they became\n\n";
    if (subject.stiff)
        for (const std::string& line : softening_lines(subject)) text += "- " + line + "\n";
    for (const std::string& conversion : conversions) text += "- " + conversion + "\n";
    text += "\n## What the model holds for\n\n";
    std::set<std::string> lines = regime_remarks(subject, Severity::background);
    lines.insert(subject.doubts.begin(), subject.doubts.end());
    for (const std::string& line : lines) text += "- " + line + "\n";
    if (lines.empty()) text += "- nothing speaks against this law in these impacts\n";
    text +=
        fmt::format("- for {} only; for another {}, humidity or temperature the numbers above are others\n",
                    range_words(subject), subject.partner ? "partner" : "wall");
    return {"assumptions.md", without_controls(text)};
}

void require_inside_model(const ExportSubject& subject) {
    for (const double diameter : sizes_of(subject))
        if (const auto doubt = outside_model(threshold_at(subject, diameter).value.value_or(0)))
            throw InputError(readable(diameter, "m") + ": " + doubt->text,
                             "damping and sizes with critical velocities inside the model");
}

namespace {

/// Adds a normal rebound of middle velocity at several angles, and a capture at one, with friction on a wall.
void add_oblique(const ExportSubject& subject, std::vector<ExpectedImpact>& impacts) {
    if (!(subject.friction > 0) || subject.partner) return;
    std::vector<ExpectedImpact> rebounds;
    std::optional<ExpectedImpact> capture;
    for (const ExpectedImpact& each : impacts) {
        if (each.diameter != impacts.front().diameter) continue;
        if (each.outcome == Outcome::rebound)
            rebounds.push_back(each);
        else
            capture = each;
    }
    const auto add = [&](ExpectedImpact each, double degrees) {
        each.tangential_velocity = each.velocity * std::tan(degrees * std::numbers::pi / 180);
        each.oblique = solve_oblique_impact(
            {.normal = impact_at(subject, each.diameter, each.velocity),
             .bodies = {.sphere = {each.diameter / 2, particle_mass(subject, each.diameter)}, .partner = {}},
             .tangential = {.velocity = each.tangential_velocity},
             .friction = subject.friction});
        impacts.push_back(std::move(each));
    };
    if (!rebounds.empty())
        for (const double degrees : {10, 25, 40, 55, 70}) add(rebounds[rebounds.size() / 2], degrees);
    if (capture) add(*capture, 40);
}

/// Adds what a code has to return of an oblique impact; of a capture its regime alone.
void add_oblique_json(const ExpectedImpact& impact, Json& json) {
    const ObliqueResult& oblique = *impact.oblique;
    json["tangential_velocity"] = quantity_json(impact.tangential_velocity, Dimension::velocity);
    json["regime"] = name_of(oblique.tangential.regime);
    if (!oblique.rebound_angle) return;
    const TangentialMotion& after = oblique.tangential.after;
    json["rebound_tangential_velocity"] = quantity_json(after.velocity, Dimension::velocity);
    json["tangential_restitution"] = quantity_json(oblique.tangential_restitution, Dimension::fraction);
    json["rebound_angle"] = quantity_json(oblique.rebound_angle, Dimension::angle);
    json["spin"] = quantity_json(after.spin, Dimension::angular_velocity);
}

}  // namespace

std::vector<ExpectedImpact> expected_impacts(const ExportSubject& subject) {
    const ExportSubject stiff = stiffened(subject);
    const double stretch = stretch_of(subject);
    std::vector<ExpectedImpact> impacts;
    for (const double diameter : sizes_of(stiff))
        for (const double velocity : velocities_of(stiff, diameter)) {
            const ImpactResult result = solve_impact(impact_at(stiff, diameter, velocity));
            if (result.maximum_overlap > largest_overlap * contact_at(stiff, diameter).effective_radius)
                continue;
            impacts.push_back({.diameter = diameter,
                               .velocity = velocity,
                               .outcome = result.outcome,
                               .restitution = result.restitution,
                               .measured = measured_restitution(stiff, diameter, velocity),
                               .contact_time = result.contact_time,
                               .maximum_overlap = stretch * result.maximum_overlap});
            if (result.contact_time) *impacts.back().contact_time *= stretch;
        }
    if (impacts.empty() && subject.to_velocity)
        throw InputError(
            fmt::format("no impact up to {} is left to compare with", readable(*subject.to_velocity, "m/s")),
            "a velocity above the critical one; without one 0.1 m/s or more")
            .at("--to-velocity");
    add_oblique(stiff, impacts);
    return impacts;
}

void require_small_overlaps(const ExportSubject& subject) {
    if (!subject.stiff) return;
    const auto share = [&](double diameter, double velocity) {
        const Impact impact = impact_at(subject, diameter, velocity);
        return solve_impact(impact).maximum_overlap / impact.contact.effective_radius;
    };
    const ExpectedImpact* worst = nullptr;
    double greatest = greatest_softened_overlap;
    const auto impacts = expected_impacts(subject);
    for (const ExpectedImpact& each : impacts)
        if (const double here = share(each.diameter, each.velocity); here > greatest) {
            greatest = here;
            worst = &each;
        }
    if (worst == nullptr) return;
    // The overlap goes with S^(2/5), and by Hertz with v^(4/5); adhesion pulls slow spheres in, too.
    const double excess = greatest / greatest_softened_overlap;
    const double factor = subject.stiff->factor * std::pow(excess, -2.5);
    double velocity = worst->velocity * std::pow(excess, -1.25);
    const double least = 0.01 * velocity;
    while (velocity > least && share(worst->diameter, velocity) > greatest_softened_overlap) velocity *= 0.98;
    std::string allowed = fmt::format("up to {} %", readable_number(100 * greatest_softened_overlap));
    if (factor > 1.05) allowed += ", --soften " + rounded_down(factor);
    if (velocity > least) allowed += fmt::format(", --to-velocity \"{} m/s\"", rounded_down(velocity));
    throw InputError(fmt::format("at {} the contact of {} softened {} times overlaps by {} % of R*",
                                 readable(worst->velocity, "m/s"), readable(worst->diameter, "m"),
                                 shortest(subject.stiff->factor), readable_number(100 * greatest, 2)),
                     allowed)
        .at("--soften");
}

ExportFile expected_json(const ExportSubject& subject, std::string_view code, const Json& more) {
    std::vector<double> densities;
    for (const AshSize& size : subject.sizes) densities.push_back(size.density);
    Json document{{"program", "ashimpact"},
                  {"version", program_version()},
                  {"code", code},
                  {"law", subject.law.name()},
                  {"detachment", name_of(subject.detachment)},
                  {"damping_law", name_of(subject.damping_law)},
                  {"density", quantity_json(subject.reference().density, Dimension::density)},
                  {"densities", {{"values", densities}, {"unit", "kg/m3"}}}};
    if (subject.partner)
        document["partner"] = {{"radius", quantity_json(subject.partner->radius, Dimension::length)},
                               {"mass", quantity_json(subject.partner->mass, Dimension::mass)}};
    if (subject.friction > 0) document["friction"] = subject.friction;
    if (subject.stiff)
        document["softening"] = {{"factor", subject.stiff->factor}, {"stretch", stretch_of(subject)}};
    if (!subject.edits.empty()) document["edited"] = subject.edits;
    if (!subject.laboratory.empty()) document["laboratory"] = laboratory_json(subject);
    document.update(more);
    document["impacts"] = Json::array();
    for (const ExpectedImpact& impact : expected_impacts(subject)) {
        document["impacts"].push_back(
            {{"diameter", quantity_json(impact.diameter, Dimension::length)},
             {"velocity", quantity_json(impact.velocity, Dimension::velocity)},
             {"outcome", name_of(impact.outcome)},
             {"restitution", quantity_json(impact.restitution, Dimension::fraction)},
             {"contact_time", quantity_json(impact.contact_time, Dimension::time)}});
        if (impact.oblique) add_oblique_json(impact, document["impacts"].back());
        if (!subject.laboratory.empty())
            document["impacts"].back()["measured_restitution"] =
                quantity_json(impact.measured, Dimension::fraction);
    }
    return {"expected.json", write_json(document, Digits::seventeen)};
}

std::span<const ExportCode> export_codes() {
    static constexpr std::array codes{
        ExportCode{"openfoam", openfoam_folder, "run.sh", "its parcels take e and v_c without a contact",
                   true},
        ExportCode{"lammps", lammps_folder},
        ExportCode{"liggghts", liggghts_folder},
        ExportCode{.name = "yade", .folder = yade_folder, .pairs_follow = true},
        ExportCode{"fluent", fluent_folder, "run.sh", "its particles take e and v_c without a contact", true},
        ExportCode{"table", table_folder, "compare.py", {}, true, true}};
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

// SPDX-License-Identifier: GPL-3.0-or-later
// Published critical velocities, alone or beside those of a contact law.
#include "pipeline/case/literature.hpp"

#include <cmath>
#include <optional>
#include <ostream>
#include <set>
#include <vector>

#include <fmt/format.h>

#include "core/json/view.hpp"
#include "core/plausibility.hpp"
#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "pipeline/app/command.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/present/report/figures/figures.hpp"
#include "pipeline/present/text/layout.hpp"
#include "pipeline/run/laws_by_size.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/motion/regime.hpp"

namespace ashimpact {

namespace {

/// A contact law with constants, for every size.
class LawOfSizes {
  public:
    explicit LawOfSizes(const CommandOptions& options)
        : material_(read_material(options)), damping_(read_damping(options, material_.reference.contact)) {}

    [[nodiscard]] Law law() const { return material_.reference.law; }
    [[nodiscard]] CriticalVelocityProblem problem(double diameter) const {
        return {law(), material_.reference.detachment, damping_, material_.contact(diameter)};
    }
    [[nodiscard]] CriticalVelocity velocity(double diameter) const {
        return critical_velocity(problem(diameter));
    }
    /// d ln v_c/d ln d; none where v_c is not finite on both sides.
    [[nodiscard]] std::optional<double> exponent(double diameter) const {
        constexpr double step = 1e-3;
        const auto below = velocity(diameter * (1 - step)).value;
        const auto above = velocity(diameter * (1 + step)).value;
        if (!below || !above) return std::nullopt;
        return std::log(*above / *below) / std::log((1 + step) / (1 - step));
    }

    /// The doubts if the law is outside of its range at a size.
    [[nodiscard]] std::vector<Finding> doubts_at(double diameter) const {
        const CriticalVelocityProblem at = problem(diameter);
        const CriticalVelocity critical = critical_velocity(at);
        if (!critical.value || !critical.maximum_overlap) return {};
        if (const auto doubt = outside_model(*critical.value)) return {*doubt};
        return regime_of({at.law, at.detachment, at.damping, at.contact, *critical.value},
                         *critical.maximum_overlap)
            .warnings;
    }

  private:
    MaterialChoice material_;
    Damping damping_;
};

/// A published velocity beside that of the law.
struct LawBeside {
    CriticalVelocity critical;
    std::optional<double> exponent;
};

std::optional<LawBeside> beside_law(const std::optional<LawOfSizes>& law,
                                    const LiteratureVelocity& velocity) {
    if (!law || !velocity.diameter) return std::nullopt;
    return LawBeside{law->velocity(*velocity.diameter), law->exponent(*velocity.diameter)};
}

/// "14 m/s", "0.829 to 0.847 m/s", "below 0.01 m/s", "1.6 m/s (second-hand)".
std::string literature_velocity_text(const LiteratureVelocity& velocity) {
    std::string text = readable(velocity.upper, "m/s");
    if (!velocity.lower)
        text = "below " + text;
    else if (!velocity.value())
        text = fmt::format("{:.4g} to {}", *velocity.lower, text);
    if (velocity.basis != VelocityBasis::measured) text += fmt::format(" ({})", name_of(velocity.basis));
    return text;
}

Json literature_velocity_json(const LiteratureVelocity& velocity, const std::optional<LawBeside>& law) {
    Json json{{"name", velocity.name},
              {"particle", velocity.particle},
              {"wall", velocity.wall},
              {"conditions", velocity.conditions},
              {"diameter", quantity_json(velocity.diameter, Dimension::length)},
              {"critical_velocity",
               {{"lower", quantity_json(velocity.lower, Dimension::velocity)},
                {"upper", quantity_json(velocity.upper, Dimension::velocity)}}},
              {"basis", name_of(velocity.basis)}};
    if (law)
        json["by_law"] = {{"critical_velocity", quantity_json(law->critical.value, Dimension::velocity)},
                          {"verdict", name_of(law->critical.verdict)},
                          {"exponent", law->exponent ? Json(*law->exponent) : Json(nullptr)}};
    return json;
}

Json source_json(const LiteratureSource& source, const std::optional<LawOfSizes>& law) {
    Json velocities = Json::array();
    for (const LiteratureVelocity& each : source.velocities)
        velocities.push_back(literature_velocity_json(each, beside_law(law, each)));
    return {{"source", source.key},
            {"reference", source.reference},
            {"doi", source.doi.empty() ? Json(nullptr) : Json(source.doi)},
            {"read", source.read},
            {"missing", source.missing},
            {"exponent", source.exponent ? Json(*source.exponent) : Json(nullptr)},
            {"velocities", velocities}};
}

/// The velocities of all sources in one table.
std::string velocities_text(const std::vector<LiteratureSource>& sources) {
    TextTable table({"source", "diameter", "v_c", "particle on wall"});
    for (const LiteratureSource& source : sources)
        for (const LiteratureVelocity& each : source.velocities)
            table.add({source.key, each.diameter ? readable(*each.diameter, "m") : "-",
                       literature_velocity_text(each), each.particle + " on " + each.wall});
    return table.text();
}

/// The velocities with a diameter beside those of the law.
std::string beside_law_text(const std::vector<LiteratureSource>& sources, const LawOfSizes& law) {
    TextTable table({"source", "diameter", "v_c", "by the law", "ratio", "exponent"});
    for (const LiteratureSource& source : sources)
        for (const LiteratureVelocity& each : source.velocities) {
            const auto beside = beside_law(law, each);
            if (!beside) continue;
            const auto& velocity = beside->critical.value;
            const bool outside = velocity && outside_model(*velocity);
            table.add({source.key, readable(*each.diameter, "m"), literature_velocity_text(each),
                       outside    ? "above " + readable(fastest_in_model, "m/s")
                       : velocity ? readable(*velocity, "m/s")
                                  : std::string(name_of(beside->critical.verdict)),
                       velocity && !outside ? readable_number(*velocity / each.upper, 3) : "-",
                       beside->exponent && !outside ? fmt::format("{:.3f}", *beside->exponent) : "-"});
        }
    return table.text() +
           "ratio: v_c by the law over the published one, of a range or bound its upper end; exponent: d ln "
           "v_c/d ln d of the law at that size.\n";
}

/// "particle on wall: conditions" of the velocities that state conditions.
std::string literature_conditions(const LiteratureSource& source) {
    std::string text;
    for (const LiteratureVelocity& each : source.velocities)
        if (!each.conditions.empty())
            text += (text.empty() ? "" : "; ") +
                    fmt::format("{}: {}", literature_velocity_text(each), each.conditions);
    return text;
}

std::string source_text(const LiteratureSource& source) {
    TextList list;
    list.add(source.key, source.reference + (source.doi.empty() ? "" : ", doi " + source.doi));
    if (const std::string conditions = literature_conditions(source); !conditions.empty())
        list.add("conditions", conditions);
    if (source.exponent)
        list.add("exponent", readable_number(*source.exponent) + ", as its authors state it");
    list.add("read", source.read);
    std::string missing;
    for (const std::string& each : source.missing) missing += (missing.empty() ? "" : "; ") + each;
    list.add("missing", missing);
    return list.text(0);
}

void run_literature_command(const CommandOptions& options, std::ostream& out) {
    std::vector<LiteratureSource> sources = literature();
    if (options.has("source"))
        sources = {at_place("SOURCE", [&] { return literature_source(options["source"]); })};
    std::optional<LawOfSizes> law;
    if (options.has("--law"))
        law.emplace(options);
    else
        refuse_material(options, "--law");
    std::set<double> sizes;
    std::vector<Finding> notes = options.doubts();
    for (const LiteratureSource& source : sources)
        for (const LiteratureVelocity& each : source.velocities) {
            if (!law || !each.diameter || !sizes.insert(*each.diameter).second) continue;
            for (Finding doubt : law->doubts_at(*each.diameter)) {
                doubt.text.insert(0, readable(*each.diameter, "m") + ": ");
                warn_of({doubt});
                if (doubt.code == outside_model_code) notes.push_back(std::move(doubt));
            }
        }
    if (options.has("--output")) {
        const auto format = report::format_of(options["--output"]);
        std::vector<LawBySize> lines;
        if (law) {
            lines.push_back(law_by_size(law->law(), [&](double diameter) { return law->problem(diameter); }));
            if (lines.front().curve.empty()) lines.clear();
        }
        write_file(options["--output"],
                   report::figure_bytes(report::literature_figure(lines), report::Width::wide, format));
    }
    if (options.has("--json")) {
        Json list = Json::array();
        for (const LiteratureSource& source : sources) list.push_back(source_json(source, law));
        Json json{{"sources", list}};
        add_notes(json, notes);
        out << write_json(json, Digits::seventeen);
        return;
    }
    out << (law ? beside_law_text(sources, *law) : velocities_text(sources));
    for (const LiteratureSource& source : sources) out << '\n' << source_text(source);
    if (options.has("--output")) out << '\n' << options["--output"] << '\n';
}

}  // namespace

void add_literature(const CommandLine& line) {
    Command command = line.add(
        "literature", "Critical velocities that others measured, with their sources; beside a law, or drawn",
        "ashimpact literature\n"
        "  ashimpact literature arffman2015 --law jkr --density \"10490 kg/m3\" --contact-modulus \"43 GPa\" "
        "--work-of-adhesion \"0.1 J/m2\"",
        run_literature_command);
    command.add("source", "SOURCE", "one of them, such as arffman2015; default: all");
    command.add_material_options(false);
    command.add(
        "-o,--output", "FILE",
        "draws all velocities over the diameter, with a line of the law if there is one: .svg, .pdf or .png");
    command.add_json_flag();
}

}  // namespace ashimpact

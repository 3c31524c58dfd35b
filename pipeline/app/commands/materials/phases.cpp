// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/commands/materials/phases.hpp"

#include <ostream>

#include <fmt/format.h>

#include "core/text.hpp"
#include "pipeline/app/program_word.hpp"
#include "pipeline/case/case_reader.hpp"
#include "pipeline/present/text/readable.hpp"
#include "pipeline/present/text/table.hpp"

namespace ashimpact {

namespace {

std::string property_text(const PhaseProperty& property, std::string_view unit) {
    const auto number = [&](double value) {
        return unit == "1" ? readable_number(value) : readable(value, unit);
    };
    std::string text = readable(Quantity{
        .value = property.value, .unit = std::string(unit), .standard_uncertainty = property.uncertainty()});
    if (property.range)
        text += fmt::format(", {} to {}", number(property.range->first), number(property.range->second));
    if (property.assumed) text += ", assumed";
    if (!property.citations.empty()) text += " [" + joined(property.citations) + "]";
    return text;
}

std::string phase_text(const ResolvedPhase& resolved) {
    const Phase& phase = resolved.phase;
    TextList list;
    list.add("phase", phase.name + (phase.amorphous ? " (amorphous)" : ""));
    if (!phase.formula.empty()) list.add("formula", phase.formula);
    list.add("density", property_text(phase.density, "kg/m3"));
    list.add("Young's modulus", property_text(phase.young_modulus, "Pa"));
    if (phase.poisson_ratio) list.add("Poisson's ratio", property_text(*phase.poisson_ratio, "1"));
    std::vector<std::string> names = phase.synonyms;
    names.insert(names.end(), phase.bgmn.begin(), phase.bgmn.end());
    if (!names.empty()) list.add("other names", joined(names));
    std::string text = list.text(0);
    text += uncertainty_legend(text);
    for (const std::string& note : {phase.remark, resolved.note})
        if (!note.empty()) text += note + "\n";
    return text;
}

std::string set_text(const PhaseSet& set) {
    TextTable table({set.name, "formula", "density", "E", "nu"});
    for (const Phase& phase : set.phases)
        table.add({phase.name, phase.formula.empty() ? "-" : phase.formula,
                   readable(phase.density.value, "kg/m3"), readable(phase.young_modulus.value, "Pa"),
                   phase.poisson_ratio ? readable_number(phase.poisson_ratio->value) : "unknown"});
    return table.text();
}

}  // namespace

void run_phases_command(const std::string& name, std::ostream& out) {
    const PhaseCatalogue catalogue = built_in_phases();
    if (!name.empty()) {
        out << phase_text(catalogue.resolve_all({PlacedName{.name = name}}).front());
        return;
    }
    for (const PhaseSet& set : catalogue.sets()) out << set_text(set) << '\n';
    out << "One of them with its sources and other names, such as\n  " << program_word()
        << " phases mullite\n"
        << "Phases of your own: `modulus --phases FILE`, or \"phases\" in a case.\n";
}

}  // namespace ashimpact

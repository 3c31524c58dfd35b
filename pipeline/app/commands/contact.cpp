// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/commands/contact.hpp"

#include <cmath>
#include <ostream>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/json/writer.hpp"
#include "core/text.hpp"
#include "materials/contact_properties.hpp"
#include "materials/separation_energy.hpp"
#include "materials/work_of_adhesion.hpp"
#include "pipeline/document/quantity_json.hpp"
#include "pipeline/present/text/readable.hpp"
#include "pipeline/present/text/table.hpp"
#include "solver/motion/regime.hpp"

namespace ashimpact {

namespace {

/// One body of the pair. @p young and @p poisson name the options
ElasticBody read_body(const char* young, const std::string& young_modulus, const char* poisson,
                      const std::string& poisson_ratio) {
    if (poisson_ratio.empty()) throw InputError("is missing", "Poisson's ratio, such as 0.2").at(poisson);
    return {.young_modulus = read_positive_option(young, young_modulus, Dimension::pressure),
            .poisson_ratio = read_option(poisson, poisson_ratio, Dimension::fraction)};
}

/// E*, given or of both bodies by Eq. 7 [Pa].
double read_contact_modulus(const ContactCommandOptions& options) {
    if (!options.contact.contact_modulus.empty()) {
        if (!options.young_modulus.empty())
            throw InputError("both are given", "one of the two").at("--contact-modulus, --young-modulus");
        return read_positive_option("--contact-modulus", options.contact.contact_modulus,
                                    Dimension::pressure);
    }
    if (options.young_modulus.empty())
        throw InputError("neither is given",
                         "E* of the pair, or Young's modulus with --poisson-ratio and those of the wall")
            .at("--contact-modulus, --young-modulus");
    const ElasticBody particle =
        read_body("--young-modulus", options.young_modulus, "--poisson-ratio", options.poisson_ratio);
    if (options.rigid_wall)
        return at_place("--poisson-ratio", [&] { return contact_modulus(particle, RigidWall{}); });
    if (options.wall_young_modulus.empty())
        throw InputError("neither is given", "Young's modulus of the wall, or --rigid-wall")
            .at("--wall-young-modulus, --rigid-wall");
    const ElasticBody wall = read_body("--wall-young-modulus", options.wall_young_modulus,
                                       "--wall-poisson-ratio", options.wall_poisson_ratio);
    return at_place("--poisson-ratio, --wall-poisson-ratio", [&] { return contact_modulus(particle, wall); });
}

/// w, given or from both surface energies [J/m2].
double read_work_of_adhesion(const ContactCommandOptions& options) {
    const auto energy = [](const char* option, const std::string& text) {
        return read_option(option, text, Dimension::energy_per_area);
    };
    if (!options.contact.work_of_adhesion.empty()) {
        if (!options.surface_energy.empty())
            throw InputError("both are given", "one of the two").at("--work-of-adhesion, --surface-energy");
        return energy("--work-of-adhesion", options.contact.work_of_adhesion);
    }
    if (options.surface_energy.empty())
        throw InputError("neither is given", "w of the pair, or both surface energies with --adhesion-rule")
            .at("--work-of-adhesion, --surface-energy");
    if (options.rule.empty())
        throw InputError("is missing", joined(Names<AdhesionRule>::all)).at("--adhesion-rule");
    const auto rule = at_place("--adhesion-rule", [&] { return named<AdhesionRule>(options.rule); });
    SurfaceEnergies energies{.particle = energy("--surface-energy", options.surface_energy),
                             .wall = energy("--wall-surface-energy", options.wall_surface_energy)};
    if (!options.interfacial_energy.empty())
        energies.interfacial = energy("--interfacial-energy", options.interfacial_energy);
    return at_place("--surface-energy, --wall-surface-energy, --interfacial-energy",
                    [&] { return work_of_adhesion(rule, energies); });
}

}  // namespace

void run_contact_command(const ContactCommandOptions& options, std::ostream& out) {
    ContactOptions typed = options.contact;
    typed.law = "jkr";  // W_s is that of a JKR contact; all laws share the other properties
    typed.contact_modulus = shortest(read_contact_modulus(options));
    typed.work_of_adhesion = shortest(read_work_of_adhesion(options));
    const ContactPair pair = read_contact(typed).contact;
    const AdhesiveContact adhesive{.work_of_adhesion = pair.work_of_adhesion,
                                   .effective_radius = pair.effective_radius,
                                   .contact_modulus = pair.contact_modulus};
    const double energy = separation_energy(adhesive);
    const double velocity = std::sqrt(2 * energy / pair.mass);
    const double tabor = tabor_parameter(adhesive, usual_separation);
    if (options.json) {
        out << write_json(
            {{"contact_modulus", quantity_json(pair.contact_modulus, Dimension::pressure)},
             {"effective_radius", quantity_json(pair.effective_radius, Dimension::length)},
             {"mass", quantity_json(pair.mass, Dimension::mass)},
             {"work_of_adhesion", quantity_json(pair.work_of_adhesion, Dimension::energy_per_area)},
             {"separation_energy", quantity_json(energy, Dimension::energy)},
             {"critical_velocity", quantity_json(velocity, Dimension::velocity)},
             {"tabor_parameter", tabor}},
            Digits::seventeen);
        return;
    }
    TextList list;
    list.add("E*, contact modulus", readable(pair.contact_modulus, "Pa"));
    list.add("R*, effective radius", readable(pair.effective_radius, "m"));
    list.add("m, mass in motion", readable(pair.mass, "kg"));
    list.add("w, work of adhesion", readable(pair.work_of_adhesion, "J/m2"));
    list.add("W_s, separation energy", readable(energy, "J"));
    list.add("v_s, adhesion only",
             readable(velocity, "m/s") + ": below it adhesion captures without damping");
    list.add("Tabor parameter", readable_number(tabor) + " (DMT holds below 0.1, JKR above 5)");
    out << list.text(0);
}

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <ostream>
#include <string>

#include <fmt/format.h>

#include "core/json/view.hpp"
#include "core/json/writer.hpp"
#include "core/quantities/readable.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "materials/contact_properties.hpp"
#include "materials/separation_energy.hpp"
#include "materials/work_of_adhesion.hpp"
#include "pipeline/app/command.hpp"
#include "pipeline/app/options/contact_options.hpp"
#include "pipeline/present/text/table.hpp"
#include "solver/motion/regime.hpp"

namespace ashimpact {

namespace {

/// What two bodies are made of, as the user typed it; empty where an option was not given.
struct ContactCommandOptions {
    ContactOptions
        contact;  ///< size, mass, and modulus or work of adhesion where they are known by themselves
    std::string young_modulus;
    std::string poisson_ratio;
    std::string wall_young_modulus;
    std::string wall_poisson_ratio;
    bool rigid_wall = false;
    std::string surface_energy;
    std::string wall_surface_energy;
    std::string interfacial_energy;
    std::string rule;
    bool json = false;
};

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

}  // namespace

void add_contact(const CommandLine& line) {
    auto [command, options] =
        line.add<ContactCommandOptions>("contact", "E*, R*, m, w, W_s and v_s of a sphere on a wall",
                                        "ashimpact contact --diameter \"88 um\" --density \"2300 kg/m3\" "
                                        "--young-modulus \"148 GPa\" --poisson-ratio 0.2 "
                                        "--wall-young-modulus \"193 GPa\" --wall-poisson-ratio 0.29 "
                                        "--work-of-adhesion \"0.3 J/m2\"",
                                        run_contact_command);
    add_sphere_options(*command, options->contact);
    add_text(*command, "--partner-radius", options->contact.partner_radius, "Q",
             "of a second sphere instead of a flat wall");
    add_text(*command, "--partner-diameter", options->contact.partner_diameter, "Q",
             "of it, instead of its radius");
    add_text(*command, "--partner-density", options->contact.partner_density, "Q", "of the second sphere");
    add_text(*command, "--partner-mass", options->contact.partner_mass, "Q",
             "of the second sphere, instead of its density");
    add_text(*command, "--contact-modulus", options->contact.contact_modulus, "Q",
             "E* of the pair, instead of what follows");
    add_text(*command, "--young-modulus", options->young_modulus, "Q", "of the sphere, \"148 GPa\"");
    add_text(*command, "--poisson-ratio", options->poisson_ratio, "X", "of the sphere");
    add_text(*command, "--wall-young-modulus", options->wall_young_modulus, "Q",
             "of the wall, or of the second sphere");
    add_text(*command, "--wall-poisson-ratio", options->wall_poisson_ratio, "X",
             "of the wall, or of the second sphere");
    command->add_flag("--rigid-wall", options->rigid_wall, "the wall does not deform");
    add_text(*command, "--work-of-adhesion", options->contact.work_of_adhesion, "Q",
             "w, \"0.3 J/m2\" (not a surface energy)");
    add_text(*command, "--surface-energy", options->surface_energy, "Q",
             "of the sphere, from which w follows");
    add_text(*command, "--wall-surface-energy", options->wall_surface_energy, "Q", "of the wall");
    add_text(*command, "--interfacial-energy", options->interfacial_energy, "Q",
             "of both, for the rule dupre");
    add_text(*command, "--adhesion-rule", options->rule, "NAME",
             "girifalco-good, dong2013, dupre: w from surface energies");
    add_text(*command, "--roughness", options->contact.roughness, "Q",
             "rms of both surfaces, reduces w (Rabinovich et al. 2000)");
    add_json_flag(*command, options->json);
}

}  // namespace ashimpact

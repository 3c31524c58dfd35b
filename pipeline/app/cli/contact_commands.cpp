// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include <CLI/CLI.hpp>

#include "core/text.hpp"
#include "pipeline/app/cli/argument_checks.hpp"
#include "pipeline/app/cli/commands.hpp"
#include "pipeline/app/commands/contact.hpp"
#include "pipeline/app/commands/critical_velocity.hpp"
#include "pipeline/app/commands/damping.hpp"
#include "pipeline/app/commands/impact.hpp"
#include "solver/contact/law_parameters.hpp"

namespace ashimpact {

namespace {

constexpr auto json_help = "print one JSON object, numbers with 17 significant digits";

/// Names of the laws that pass a test, for help.
template <class Test>
std::string laws_where(Test&& test) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < Law::count(); ++i)
        if (test(Law::at(i))) names.emplace_back(Law::at(i).name());
    return joined(names);
}

std::string laws_without_adhesion() {
    return laws_where([](Law law) { return !law.uses_work_of_adhesion(); });
}

std::string laws_with(const LawParameter& parameter) {
    return laws_where([&](Law law) { return law.takes(parameter); });
}

void add_impact(CLI::App& program, Action& action) {
    auto* command = add_command(program, "impact", "One normal impact of a sphere on a flat wall",
                                "ashimpact impact --law dmt --radius \"44 um\" --density \"2600 kg/m3\" "
                                "--contact-modulus \"90 GPa\" --work-of-adhesion \"0.3 J/m2\" "
                                "--damping \"0.0141 kg/s\" --velocity \"2 m/s\"");
    const auto options = std::make_shared<ImpactOptions>();
    add_contact_options(*command, options->contact, ContactNeeds::required);
    add_damping_option(*command, options->contact);
    command->add_option("--velocity", options->velocity, "at first touch, \"2 m/s\"")
        ->required()
        ->type_name("Q");
    command
        ->add_option("--method", options->method,
                     "taylor (exact) or paper-explicit (the paper's scheme, first order in the time step)")
        ->capture_default_str()
        ->type_name("NAME");
    command
        ->add_option("--time-step", options->time_step, "of paper-explicit; default: 10000 steps a contact")
        ->type_name("Q");
    auto* trajectory = command
                           ->add_option("--trajectory", options->trajectory,
                                        "write overlap, velocity and forces against time (CSV)")
                           ->type_name("FILE");
    command->add_option("--points", options->points, "number of points of the trajectory")
        ->capture_default_str()
        ->check(whole_number(2, 10'000'000))
        ->needs(trajectory);
    command->add_flag("--json", options->json, json_help);
    command->callback(
        [options, &action] { action = [options](std::ostream& out) { run_impact_command(*options, out); }; });
}

void add_critical_velocity(CLI::App& program, Action& action) {
    auto* command = add_command(program, "critical-velocity", "The velocity below which a sphere is captured",
                                "ashimpact critical-velocity --law brach-dunn --radius \"44 um\" "
                                "--density \"2600 kg/m3\" --contact-modulus \"90 GPa\" "
                                "--work-of-adhesion \"0.3 J/m2\" --damping \"0.0141 kg/s\"");
    const auto options = std::make_shared<CriticalVelocityOptions>();
    add_contact_options(*command, options->contact, ContactNeeds::required);
    add_damping_option(*command, options->contact);
    command->add_flag("--json", options->json, json_help);
    command->callback([options, &action] {
        action = [options](std::ostream& out) { run_critical_velocity_command(*options, out); };
    });
}

void add_damping(CLI::App& program, Action& action) {
    auto* command = add_command(program, "damping", "The damping that gives back a measured restitution",
                                "ashimpact damping --law dmt --radius \"44 um\" --density \"2600 kg/m3\" "
                                "--contact-modulus \"90 GPa\" --work-of-adhesion \"0.3 J/m2\" "
                                "--velocity \"2 m/s\" --restitution 0.2\n"
                                "  (the same with --impacts impacts.csv instead of the last two)");
    const auto options = std::make_shared<DampingOptions>();
    add_contact_options(*command, options->contact, ContactNeeds::required);
    command->add_option("--velocity", options->velocity, "at first touch, \"2 m/s\"")->type_name("Q");
    command->add_option("--restitution", options->restitution, "e_n; 0: the smallest damping that captures")
        ->type_name("X");
    command
        ->add_option("--impacts", options->impacts,
                     "instead of one impact a table of many (CSV, .xlsx, .ods), with a heading such as "
                     "\"v_in [m/s], v_r "
                     "[m/s]\": damping of each, fits, critical velocity with its interval")
        ->type_name("FILE");
    command->add_option("--sheet", options->sheet, "of a spreadsheet with several tables")->type_name("NAME");
    command->add_option("--frame-rate", options->frame_rate, "of the camera, frames per second")
        ->type_name("X");
    command->add_option("--pixel-size", options->pixel_size, "of the camera, in the object, \"2 um\"")
        ->type_name("Q");
    command
        ->add_option("--frames", options->frames, "positions that each velocity is the slope of; default 2")
        ->type_name("N")
        ->check(whole_number(2, 10'000));
    command
        ->add_option("--size-scatter", options->size_scatter,
                     "relative standard deviation of single diameters, such as of a sieve, \"5 %\"")
        ->type_name("X");
    command->add_option("--order", options->order, "of the polynomial that is extrapolated; default 2")
        ->type_name("N")
        ->check(whole_number(1, 6));
    command->add_flag("--robust", options->robust, "bisquare weights in the extrapolated polynomial");
    command->add_option("--bin", options->bin, "rebounds to be put into one point")
        ->type_name("N")
        ->check(whole_number(1, 1'000'000));
    command->add_flag("--json", options->json, json_help);
    command->callback([options, &action] {
        action = [options](std::ostream& out) { run_damping_command(*options, out); };
    });
}

void add_contact(CLI::App& program, Action& action) {
    auto* command = add_command(program, "contact", "E*, R*, m, w, W_s and v_s of a sphere on a wall",
                                "ashimpact contact --diameter \"88 um\" --density \"2300 kg/m3\" "
                                "--young-modulus \"148 GPa\" --poisson-ratio 0.2 "
                                "--wall-young-modulus \"193 GPa\" --wall-poisson-ratio 0.29 "
                                "--work-of-adhesion \"0.3 J/m2\"");
    const auto options = std::make_shared<ContactCommandOptions>();
    const auto add = [&](const char* name, std::string& value, const char* purpose, const char* type = "Q") {
        command->add_option(name, value, purpose)->type_name(type);
    };
    add("--radius", options->contact.radius, "of the sphere, \"44 um\"; or its --diameter");
    add("--diameter", options->contact.diameter, "of the sphere, \"88 um\"; or its --radius");
    add("--density", options->contact.density, "of the sphere, \"2160 kg/m3\"");
    add("--mass", options->contact.mass, "of the sphere, instead of its density");
    add("--partner-radius", options->contact.partner_radius, "of a second sphere instead of a flat wall");
    add("--partner-diameter", options->contact.partner_diameter, "of it, instead of its radius");
    add("--partner-density", options->contact.partner_density, "of the second sphere");
    add("--partner-mass", options->contact.partner_mass, "of the second sphere, instead of its density");
    add("--contact-modulus", options->contact.contact_modulus, "E* of the pair, instead of what follows");
    add("--young-modulus", options->young_modulus, "of the sphere, \"148 GPa\"");
    add("--poisson-ratio", options->poisson_ratio, "of the sphere", "X");
    add("--wall-young-modulus", options->wall_young_modulus, "of the wall, or of the second sphere");
    add("--wall-poisson-ratio", options->wall_poisson_ratio, "of the wall, or of the second sphere", "X");
    command->add_flag("--rigid-wall", options->rigid_wall, "the wall does not deform");
    add("--work-of-adhesion", options->contact.work_of_adhesion, "w, \"0.3 J/m2\" (not a surface energy)");
    add("--surface-energy", options->surface_energy, "of the sphere, from which w follows");
    add("--wall-surface-energy", options->wall_surface_energy, "of the wall");
    add("--interfacial-energy", options->interfacial_energy, "of both, for the rule dupre");
    add("--adhesion-rule", options->rule, "girifalco-good, dong2013, dupre: w from surface energies", "NAME");
    add("--roughness", options->contact.roughness,
        "rms of both surfaces, reduces w (Rabinovich et al. 2000)");
    command->add_flag("--json", options->json, json_help);
    command->callback([options, &action] {
        action = [options](std::ostream& out) { run_contact_command(*options, out); };
    });
}

}  // namespace

void add_contact_options(CLI::App& command, ContactOptions& options, ContactNeeds needs) {
    const bool required = needs == ContactNeeds::required;
    command.add_option("--law", options.law, "contact law: " + law_names())
        ->required(required)
        ->type_name("NAME");
    command.add_option("--radius", options.radius, "of the sphere, \"44 um\"; or its --diameter")
        ->type_name("Q");
    command.add_option("--diameter", options.diameter, "of the sphere, \"88 um\"; or its --radius")
        ->type_name("Q");
    command.add_option("--density", options.density, "of the sphere, \"2160 kg/m3\"")->type_name("Q");
    command.add_option("--mass", options.mass, "of the sphere, instead of its density")->type_name("Q");
    command
        .add_option("--partner-radius", options.partner_radius,
                    "of a second sphere, \"60 um\"; without it the partner is a flat wall")
        ->type_name("Q");
    command
        .add_option("--partner-diameter", options.partner_diameter, "of that sphere, instead of its radius")
        ->type_name("Q");
    command.add_option("--partner-density", options.partner_density, "of the second sphere")->type_name("Q");
    command
        .add_option("--partner-mass", options.partner_mass, "of the second sphere, instead of its density")
        ->type_name("Q");
    command
        .add_option("--roughness", options.roughness,
                    "rms of both surfaces, \"1 nm\": reduces w (Rabinovich et al. 2000); default: smooth")
        ->type_name("Q");
    command
        .add_option("--contact-modulus", options.contact_modulus, "E*, \"90 GPa\" (not a Young's modulus)")
        ->required(required)
        ->type_name("Q");
    command
        .add_option("--work-of-adhesion", options.work_of_adhesion,
                    "w, \"0.3 J/m2\" (not a surface energy); not for " + laws_without_adhesion())
        ->type_name("Q");
    command.add_option("--yield-pressure", options.yield_pressure, "p_y, \"35.3 MPa\", for thornton-ning")
        ->type_name("Q");
    for (std::size_t i = 0; i < law_parameters().size(); ++i) {
        const LawParameter& parameter = law_parameters()[i];
        const bool quantity = parameter.dimension != Dimension::fraction;
        command
            .add_option(option_of(parameter), options.parameters[i],
                        std::string(parameter.description) + ", \"" + std::string(parameter.example) +
                            "\", for " + laws_with(parameter))
            ->type_name(quantity ? "Q" : "X");
    }
    command
        .add_option(
            "--detachment", options.detachment,
            "where the contact ends: zero-overlap, zero-force, pull-off, load-controlled; default: that "
            "of the law")
        ->type_name("NAME");
    command
        .add_option("--damping-law", options.damping_law,
                    joined(names_of<DampingLaw>()) + "; the unit of the damping goes with it")
        ->capture_default_str()
        ->type_name("NAME");
}

void add_damping_option(CLI::App& command, ContactOptions& options) {
    command.add_option("--damping", options.damping, "\"0.0141 kg/s\"; default: none")->type_name("Q");
}

void add_contact_commands(CLI::App& program, Action& action) {
    add_contact(program, action);
    add_impact(program, action);
    add_critical_velocity(program, action);
    add_damping(program, action);
}

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/command.hpp"

#include <charconv>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "core/text/text.hpp"
#include "core/version.hpp"
#include "pipeline/app/terminal/messages.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/damping/damping.hpp"

namespace ashimpact {

namespace {

constexpr auto purpose =
    "From a fly ash's XRD result to the dynamic critical velocity.\n"
    "Quantities carry their unit in quotes (\"44 um\"); a bare number is SI. Results go to standard output, "
    "messages to standard error. Exit status: 0 done, 2 input is wrong, 3 not converged, 1 a defect of the "
    "program.";

void add_common_options(CLI::App& app) {
    app.set_version_flag(
        "--version", [] { return "ashimpact " + version_text(); }, "print version and revision");
    app.add_flag_callback(
        "-q,--quiet", [] { spdlog::set_level(spdlog::level::err); }, "errors only");
    app.add_flag_callback(
        "-v,--verbose", [] { spdlog::set_level(spdlog::level::debug); }, "more messages");
    app.add_option_function<std::string>("--color", choose_color, "auto (on a terminal), always, never")
        ->check(CLI::IsMember({"auto", "always", "never"}))
        ->type_name("WHEN");
}

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

/// By the kind of value that its help shows.
bool names_a_path(const CLI::Option& option) {
    const std::string type = option.get_type_name();
    return type == "FILE" || type == "DIR" || type.ends_with(".json");
}

/// What is wrong with a value of the option before anyone reads it; empty: nothing.
std::string emptiness(const CLI::Option& option, const std::string& text) {
    if (text.empty()) return "is empty; allowed: " + option.get_description();
    if (text == "-" && names_a_path(option)) return "is \"-\"; allowed: a path, ./- for a file of that name";
    return "";
}

/// That the argument is a Number in a range, all of it.
template <class Number>
CLI::Validator within(Number least, Number most, const char* kind) {
    return {[=](std::string& text) -> std::string {
                Number number = 0;
                const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
                const bool is_number = failure == std::errc() && end == text.data() + text.size();
                if (is_number && number >= least && number <= most) return "";
                return fmt::format("is {}; allowed: a {} from {} to {}", in_quotes(text), kind, least, most);
            },
            "", kind};
}

}  // namespace

std::string version_text() {
    return fmt::format("{} ({})", program_version(), program_revision());
}

CLI::App* add_command(CLI::App& program, const std::string& name, const std::string& purpose_of_it,
                      const std::string& example) {
    CLI::App* command = program.add_subcommand(name, purpose_of_it);
    add_common_options(*command);
    command->footer("Example:\n  " + example);
    return command;
}

void set_up_commands(CLI::App& program, Action& action, const SweepRunner& sweep,
                     const ExportRunner& exporter) {
    program.name("ashimpact");
    program.description(purpose);
    add_common_options(program);
    program.require_subcommand(1);
    program.footer("Example:\n  ashimpact run\n`ashimpact help COMMAND` says more about each.");
    const CommandLine line{program, action};
    add_run(line);
    add_modulus(line);
    add_contact(line);
    add_impact(line);
    add_critical_velocity(line);
    add_damping(line);
    add_sweep(line, sweep);
    add_report(line);
    add_figure(line);
    add_export(line, exporter);
    add_calibrate(line);
    add_cross_check(line);
    add_inspect(line);
    add_init(line);
    add_phases(line);
    add_schema(line);
    refuse_empty_values(program);
}

CLI::Option* add_text(CLI::App& command, const std::string& name, std::string& value, const std::string& type,
                      const std::string& purpose_of_it) {
    return command.add_option(name, value, purpose_of_it)->type_name(type);
}

void add_json_flag(CLI::App& command, bool& json) {
    command.add_flag("--json", json, "print one JSON object, numbers with 17 significant digits");
}

void add_case_argument(CLI::App& command, std::string& file) {
    add_text(command, "case", file, "CASE.json", "case file; default: the built-in case, Dong et al. 2013");
}

void add_allow_outside_flag(CLI::App& command, bool& allow_outside) {
    command.add_flag("--allow-outside", allow_outside, "the case may name files outside of its own folder");
}

void add_sphere_options(CLI::App& command, ContactOptions& options) {
    add_text(command, "--radius", options.radius, "Q", "of the sphere, \"44 um\"; or its --diameter");
    add_text(command, "--diameter", options.diameter, "Q", "of the sphere, \"88 um\"; or its --radius");
    add_text(command, "--density", options.density, "Q", "of the sphere, \"2160 kg/m3\"");
    add_text(command, "--mass", options.mass, "Q", "of the sphere, instead of its density");
}

void add_contact_options(CLI::App& command, ContactOptions& options, ContactNeeds needs) {
    const bool required = needs == ContactNeeds::required;
    command.add_option("--law", options.law, "contact law: " + law_names())
        ->required(required)
        ->type_name("NAME");
    add_sphere_options(command, options);
    add_text(command, "--partner-radius", options.partner_radius, "Q",
             "of a second sphere, \"60 um\"; without it the partner is a flat wall");
    add_text(command, "--partner-diameter", options.partner_diameter, "Q",
             "of that sphere, instead of its radius");
    add_text(command, "--partner-density", options.partner_density, "Q", "of the second sphere");
    add_text(command, "--partner-mass", options.partner_mass, "Q",
             "of the second sphere, instead of its density");
    add_text(command, "--roughness", options.roughness, "Q",
             "rms of both surfaces, \"1 nm\": reduces w (Rabinovich et al. 2000); default: smooth");
    command
        .add_option("--contact-modulus", options.contact_modulus, "E*, \"90 GPa\" (not a Young's modulus)")
        ->required(required)
        ->type_name("Q");
    add_text(command, "--work-of-adhesion", options.work_of_adhesion, "Q",
             "w, \"0.3 J/m2\" (not a surface energy); not for " + laws_without_adhesion());
    add_text(command, "--yield-pressure", options.yield_pressure, "Q",
             "p_y, \"35.3 MPa\", for thornton-ning");
    for (std::size_t i = 0; i < law_parameters().size(); ++i) {
        const LawParameter& parameter = law_parameters()[i];
        const bool quantity = parameter.dimension != Dimension::fraction;
        command
            .add_option(option_of(parameter), options.parameters[i],
                        std::string(parameter.description) + ", \"" + std::string(parameter.example) +
                            "\", for " + laws_with(parameter))
            ->type_name(quantity ? "Q" : "X");
    }
    add_text(command, "--detachment", options.detachment, "NAME",
             "where the contact ends: zero-overlap, zero-force, pull-off, load-controlled; default: that "
             "of the law");
    command
        .add_option("--damping-law", options.damping_law,
                    joined(names_of<DampingLaw>()) + "; the unit of the damping goes with it")
        ->capture_default_str()
        ->type_name("NAME");
}

void add_damping_option(CLI::App& command, ContactOptions& options) {
    add_text(command, "--damping", options.damping, "Q", "\"0.0141 kg/s\"; default: none");
}

void refuse_empty_values(CLI::App& program) {
    for (CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
        for (CLI::Option* option : command->get_options()) {
            if (option->get_expected_max() == 0) continue;  // a flag
            option->check([option](const std::string& text) { return emptiness(*option, text); }, "",
                          "not empty");
        }
    }
}

CLI::Validator number_within(double least, double most) {
    return within(least, most, "number");
}

CLI::Validator whole_number(std::size_t least, std::size_t most) {
    return within(least, most, "whole number");
}

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>

#include <CLI/CLI.hpp>

#include "pipeline/app/man/man.hpp"
#include "pipeline/app/run_stages.hpp"
#include "pipeline/files/schema.hpp"
#include "solver/contact/law.hpp"
#include "solver/damping/damping.hpp"

namespace ashimpact {

namespace {

using Words = std::vector<std::string>;

Words law_words() {
    Words words;
    for (std::size_t i = 0; i < Law::count(); ++i) words.emplace_back(Law::at(i).name());
    return words;
}

/// Units that people write, by what the option measures.
const std::map<std::string, Words>& units() {
    static const Words lengths{"um", "nm", "mm", "m"};
    static const Words pressures{"GPa", "MPa", "Pa"};
    static const Words velocities{"m/s", "mm/s", "cm/s"};
    static const Words densities{"kg/m3", "g/cm3"};
    static const std::map<std::string, Words> all{{"--radius", lengths},
                                                  {"--diameter", lengths},
                                                  {"--pixel-size", lengths},
                                                  {"--cohesion-range", {"nm", "m"}},
                                                  {"--contact-modulus", pressures},
                                                  {"--yield-pressure", pressures},
                                                  {"--cohesive-stress", pressures},
                                                  {"--velocity", velocities},
                                                  {"--density", densities},
                                                  {"--particle-density", densities},
                                                  {"--mass", {"kg", "ug", "ng"}},
                                                  {"--work-of-adhesion", {"J/m2", "mJ/m2"}},
                                                  {"--damping", {"kg/s", "Pa s", "1"}},
                                                  {"--time-step", {"ns", "ps", "s"}}};
    return all;
}

/// The words of options that take a name from a list.
const std::map<std::string, Words>& names() {
    static const std::map<std::string, Words> all{
        {"--law", law_words()},
        {"--detachment", names_of<Detachment>()},
        {"--damping-law", names_of<DampingLaw>()},
        {"--method", {"taylor", "entry-explicit"}},
        {"--from", stage_names()},
        {"--only", stage_names()},
        {"--phase-set", {"literature", "dong2013"}},
        {"--free", {"density", "work_of_adhesion", "contact_modulus", "wall_young_modulus"}}};
    return all;
}

Values of_name(const std::string& command, const std::string& option) {
    if (command == "schema") return {.kind = Values::Kind::words, .words = schema_names()};
    const auto listed = names().find(option);
    if (listed == names().end()) return {.kind = Values::Kind::text};
    return {.kind = Values::Kind::words, .words = listed->second};
}

/// What may stand for the value of an option of a command, by the kind that its help shows.
Values values_of(const std::string& command, const std::string& option, const std::string& type) {
    if (type == "DIR") return {.kind = Values::Kind::folder};
    if (type == "FILE") return {.kind = Values::Kind::file};
    if (type.ends_with(".json")) return {.kind = Values::Kind::file, .extension = ".json"};
    const auto unit = units().find(option);
    if (unit != units().end()) return {.kind = Values::Kind::quantity, .words = unit->second};
    return of_name(command, option);
}

std::vector<std::string> names_of(const CLI::Option& option) {
    std::vector<std::string> names;
    for (const std::string& name : option.get_snames()) names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
    return names;
}

/// The kind of value without what its checks add to it.
std::string type_of(const CLI::Option& option) {
    const std::string type = option.get_type_name();
    const auto colon = type.find(':');
    return colon == std::string::npos || type.ends_with("]") ? type : type.substr(0, colon);
}

OptionEntry entry_of(const std::string& command, const CLI::Option& option) {
    const bool is_flag = option.get_expected_max() == 0;
    OptionEntry entry{.names = names_of(option),
                      .type = is_flag ? "" : type_of(option),
                      .description = option.get_description(),
                      .default_value = is_flag ? "" : option.get_default_str(),
                      .required = option.get_required(),
                      .repeats = option.get_expected_max() > 1};
    const std::string& name = entry.names.empty() ? option.get_single_name() : entry.names.back();
    if (!is_flag) entry.values = values_of(command, name, entry.type);
    return entry;
}

CommandEntry command_of(const CLI::App& app) {
    CommandEntry entry{.name = app.get_name(), .purpose = app.get_description(), .example = app.get_footer()};
    for (const CLI::Option* option : app.get_options()) {
        OptionEntry one = entry_of(entry.name, *option);
        (one.names.empty() ? entry.arguments : entry.options).push_back(std::move(one));
    }
    return entry;
}

}  // namespace

ProgramEntry entry_of(const CLI::App& program) {
    ProgramEntry entry{.program = command_of(program)};
    for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
        entry.commands.push_back(command_of(*command));
    }
    return entry;
}

}  // namespace ashimpact

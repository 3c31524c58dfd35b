// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <iosfwd>
#include <string>

#include "pipeline/app/commands/sweep.hpp"
#include "pipeline/app/commands/export.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own name
class App;
}

namespace ashimpact {

/// What the command line asked for; set by the command that was named.
using Action = std::function<void(std::ostream& out)>;

/// Gives the program its purpose, its options and all of its commands.
void set_up_commands(CLI::App& program, Action& action, const SweepRunner& sweep,
                     const ExportRunner& exporter);

/// A new command with the options that every command has.
[[nodiscard]] CLI::App* add_command(CLI::App& program, const std::string& name, const std::string& purpose,
                                    const std::string& example);

/// run, modulus
void add_case_commands(CLI::App& program, Action& action);

/// impact, critical-velocity, damping
void add_contact_commands(CLI::App& program, Action& action);

/// calibrate, inspect, init, phases, schema
void add_document_commands(CLI::App& program, Action& action);

/// report, figure
void add_report_commands(CLI::App& program, Action& action);

/// sweep, which @p runner runs
void add_sweep_command(CLI::App& program, Action& action, const SweepRunner& runner);

/// export, which @p runner runs
void add_export_command(CLI::App& program, Action& action, const ExportRunner& runner);

/// Whether a command can do without the options of a contact.
enum class ContactNeeds { required, optional };

/// The options that describe a contact, and its damping.
void add_contact_options(CLI::App& command, ContactOptions& options, ContactNeeds needs);
void add_damping_option(CLI::App& command, ContactOptions& options);

}  // namespace ashimpact

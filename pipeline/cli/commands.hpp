#pragma once

#include <functional>
#include <iosfwd>
#include <string>

#include "pipeline/commands/sweep.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own name
class App;
}

namespace ashimpact {

/// What the command line asked for; set by the command that was named.
using Action = std::function<void(std::ostream& out)>;

/// Gives the program its purpose, its options and all of its commands.
void set_up_commands(CLI::App& program, Action& action, const SweepRunner& sweep);

/// A new command with the options that every command has.
[[nodiscard]] CLI::App* add_command(CLI::App& program, const std::string& name, const std::string& purpose,
                                    const std::string& example);

/// run, modulus
void add_case_commands(CLI::App& program, Action& action);

/// impact, critical-velocity, damping
void add_contact_commands(CLI::App& program, Action& action);

/// calibrate, inspect, init, schema
void add_document_commands(CLI::App& program, Action& action);

/// sweep, which @p runner runs
void add_sweep_command(CLI::App& program, Action& action, const SweepRunner& runner);

}  // namespace ashimpact

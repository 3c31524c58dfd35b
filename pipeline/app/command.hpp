// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <string>

#include <CLI/CLI.hpp>

#include "core/tables/number_marks.hpp"
#include "pipeline/app/contact/single_contact.hpp"
#include "pipeline/present/export/folder.hpp"

namespace ashimpact {

/// What a command does with its options; its result goes to @p out.
using CommandBody = std::function<void(const CommandOptions& options, std::ostream& out)>;

/// What the command line requests; set by the command that it names.
using Action = std::function<void(std::ostream& out)>;

/// A command of the program while its options are declared.
class Command {
  public:
    Command(CLI::App& app, CommandOptions& options) : app_(app), options_(options) {}

    /// An option, or without dashes an argument. @p type is what help shows: "Q" for a quantity, "FILE",
    /// "NAME". @param standard its default, which help shows; empty: none
    CLI::Option* add(const std::string& name, const std::string& type, const std::string& purpose,
                     const std::string& standard = {});
    CLI::Option* add_flag(const std::string& name, const std::string& purpose);
    /// An option or argument that may be given several times.
    CLI::Option* add_list(const std::string& name, const std::string& type, const std::string& purpose);

    // Options of several commands.
    void add_json_flag();
    void add_case_argument();
    void add_allow_outside_flag();
    /// What a table of a file needs to be read: --sheet, --decimal. @param table the option that
    /// names the file, which they need; null: an argument does
    void add_table_options(CLI::Option* table = nullptr);
    /// The size and the mass of a sphere: --radius, --diameter, --density, --mass.
    void add_sphere_options();
    /// The options that describe a contact. @param required whether the command cannot do without
    void add_contact_options(bool required);
    /// The options of a sphere on a wall apart from its size and the end of contact.
    void add_material_options(bool required);
    void add_damping_law_option();
    /// Those of the parameters of damping laws.
    void add_damping_parameter_options();
    /// --damping, or --damping-restitution with --at.
    void add_damping_option();
    /// --method and --time-step, as read_explicit_step() reads them.
    void add_method_options();

  private:
    void add_parameter(const LawParameter& parameter);
    void add_law_option(bool required);
    void add_pair_options(bool required);

    CLI::App& app_;
    CommandOptions& options_;
};

/// The command line, to which each command adds itself.
struct CommandLine {
    CLI::App& program;
    Action& action;

    [[nodiscard]] Command add(const std::string& name, const std::string& purpose, const std::string& example,
                              const CommandBody& body) const;
};

/// Gives the program its options and commands. @p sweep and @p exporter carry out `sweep` and `export`.
void set_up_commands(CLI::App& program, Action& action, const CommandBody& sweep,
                     const CommandBody& exporter);

/// Each adds a command or several.
void add_run(const CommandLine& line);
void add_modulus(const CommandLine& line);
void add_contact_commands(const CommandLine& line);
void add_damping(const CommandLine& line);
void add_deposit(const CommandLine& line);
void add_sweep(const CommandLine& line, const CommandBody& body);
void add_report_commands(const CommandLine& line);
void add_export(const CommandLine& line, const CommandBody& body);
void add_calibrate(const CommandLine& line);
void add_cross_check(const CommandLine& line);
void add_literature(const CommandLine& line);
void add_document_commands(const CommandLine& line);

/// The options of a table.
[[nodiscard]] TableOptions table_options(const CommandOptions& options);

/// Checks that an argument is a whole number from @p least to @p most.
[[nodiscard]] CLI::Validator whole_number(std::size_t least, std::size_t most);

/// Checks that an argument is a number from @p least to @p most.
[[nodiscard]] CLI::Validator number_within(double least, double most);

/// `ashimpact export`: writes a folder that runs in another code. @param image makes the HDF5 file of tables
/// @throws InputError with the reason if the code cannot do the subject; then nothing is written
void run_export_command(const CommandOptions& options, const TableImage& image, std::ostream& out);

/// Runs a program, if `ulimit -s` leaves less stack than it needs on a thread that has it; threads get as
/// much.
[[nodiscard]] int with_enough_stack(const std::function<int()>& program);

/// Parses the command line, runs one command, turns errors into one line and an exit status.
/// @param sweep, exporter bodies of `ashimpact sweep` and `ashimpact export`
/// @returns 0 done; 2 the user's input is wrong; 3 a computation did not converge; 1 a defect of ours.
[[nodiscard]] int run_program(int argc, const char* const* argv, const CommandBody& sweep,
                              const CommandBody& exporter);

}  // namespace ashimpact

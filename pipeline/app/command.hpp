// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "pipeline/app/contact/single_contact.hpp"
#include "pipeline/present/export/folder.hpp"

namespace ashimpact {

struct SweepOptions {
    std::string spec;                 ///< the file that says what to compute
    std::string output;               ///< JSON file for the result
    int threads = 0;                  ///< of each process; 0: its share of the cores
    double checkpoint_interval = 10;  ///< [s]
    bool restart = false;             ///< leave a checkpoint aside
    bool no_report = false;           ///< leave the page beside the result out
    bool progress = false;            ///< show progress though standard error is no terminal
};

/// Who runs a sweep: the program itself, or the one it hands over to.
using SweepRunner = std::function<void(const SweepOptions&, std::ostream& out)>;

/// Options of `ashimpact export`; empty if not given.
struct ExportOptions {
    std::string code;  ///< openfoam, lammps, liggghts, yade, fluent, table
    std::string run;   ///< folder of a run; if empty, the options of an impact
    std::string sample;
    bool follow_velocity = false;
    ContactOptions contact;
    std::string velocity;
    std::string from_diameter;
    std::string to_diameter;
    std::string to_velocity;
    std::string damping_exponent;
    std::string folder;
};

/// The command's body; tables are exported by the program that is linked with HDF5.
using ExportRunner = std::function<void(const ExportOptions&, std::ostream& out)>;

/// What the command line requests; set by the command that it names.
using Action = std::function<void(std::ostream& out)>;

/// Version and revision of the program.
[[nodiscard]] std::string version_text();

/// A new command with the options that every command has.
[[nodiscard]] CLI::App* add_command(CLI::App& program, const std::string& name, const std::string& purpose,
                                    const std::string& example);

/// A command, and the values of its options.
template <class Options>
struct Command {
    CLI::App* app;
    Options* options;
};

/// The command line, to which each command adds itself.
struct CommandLine {
    CLI::App& program;
    Action& action;

    /// Adds a command that calls @p run with its options and the stream of its output.
    template <class Options, class Run>
    [[nodiscard]] Command<Options> add(const std::string& name, const std::string& purpose,
                                       const std::string& example, Run run) const {
        const auto options = std::make_shared<Options>();
        CLI::App* command = add_command(program, name, purpose, example);
        command->callback([options, run, &requested = action] {
            requested = [options, run](std::ostream& out) { run(*options, out); };
        });
        return {command, options.get()};
    }
};

/// Gives the program its purpose, its options and all of its commands. @p sweep and @p exporter carry out
/// `sweep` and `export`.
void set_up_commands(CLI::App& program, Action& action, const SweepRunner& sweep,
                     const ExportRunner& exporter);

void add_run(const CommandLine& line);
void add_modulus(const CommandLine& line);
void add_contact(const CommandLine& line);
void add_impact(const CommandLine& line);
void add_critical_velocity(const CommandLine& line);
void add_damping(const CommandLine& line);
void add_sweep(const CommandLine& line, const SweepRunner& runner);
void add_report(const CommandLine& line);
void add_figure(const CommandLine& line);
void add_export(const CommandLine& line, const ExportRunner& runner);
void add_calibrate(const CommandLine& line);
void add_cross_check(const CommandLine& line);
void add_inspect(const CommandLine& line);
void add_init(const CommandLine& line);
void add_phases(const CommandLine& line);
void add_schema(const CommandLine& line);

/// Adds an option that takes a text. @p type is what help shows: "Q" for a quantity, "FILE", "NAME".
CLI::Option* add_text(CLI::App& command, const std::string& name, std::string& value, const std::string& type,
                      const std::string& purpose);

/// Options of several commands.
void add_json_flag(CLI::App& command, bool& json);
void add_case_argument(CLI::App& command, std::string& file);
void add_allow_outside_flag(CLI::App& command, bool& allow_outside);

/// The size and the mass of a sphere: --radius, --diameter, --density, --mass.
void add_sphere_options(CLI::App& command, ContactOptions& options);

/// Whether a command can do without the options of a contact.
enum class ContactNeeds { required, optional };

/// The options that describe a contact, and its damping.
void add_contact_options(CLI::App& command, ContactOptions& options, ContactNeeds needs);
void add_damping_option(CLI::App& command, ContactOptions& options);

/// Checks that an argument is a whole number from @p least to @p most.
[[nodiscard]] CLI::Validator whole_number(std::size_t least, std::size_t most);

/// Checks that an argument is a number from @p least to @p most.
[[nodiscard]] CLI::Validator number_within(double least, double most);

/// Makes every option and argument of the program's commands refuse an empty value, and those that name a
/// file or folder the "-" that elsewhere means a stream.
void refuse_empty_values(CLI::App& program);

/// The program: parses the command line, runs one command, turns errors into one line and an exit status.
/// @param sweep what `ashimpact sweep` does
/// @param exporter what `ashimpact export` does
/// @returns 0 done; 2 the user's input is wrong; 3 a computation did not converge; 1 a defect of ours.
[[nodiscard]] int run_program(int argc, const char* const* argv, const SweepRunner& sweep,
                              const ExportRunner& exporter);

/// `ashimpact export`: writes a folder that runs in another code. @param image used for tables only
/// @throws InputError for a subject that the code cannot do, with the reason; then nothing is written
void run_export_command(const ExportOptions& options, const TableImage& image, std::ostream& out);

}  // namespace ashimpact

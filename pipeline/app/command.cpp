// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/command.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <pthread.h>
#include <spdlog/spdlog.h>
#include <sys/resource.h>
#include <unistd.h>

#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "core/version.hpp"
#include "pipeline/app/terminal.hpp"
#include "pipeline/present/text/layout.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/damping/damping.hpp"

namespace ashimpact {

namespace {

/// Version and revision of the program.
std::string version_text() {
    return fmt::format("{} ({})", program_version(), program_revision());
}

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

template <class Number>
std::optional<Number> whole(const std::string& text) {
    if constexpr (std::is_floating_point_v<Number>) {
        return whole_decimal(text);
    } else {
        Number number = 0;
        const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
        return failure == std::errc() && end == text.data() + text.size() ? std::optional(number)
                                                                          : std::nullopt;
    }
}

/// That the argument is a Number in a range, all of it.
template <class Number>
CLI::Validator within(Number least, Number most, const char* kind) {
    return {[=](std::string& text) -> std::string {
                const auto number = whole<Number>(text);
                if (number && *number >= least && *number <= most) return "";
                return fmt::format("is {}; allowed: a {} from {} to {}", in_quotes(text), kind, least, most);
            },
            "", kind};
}

enum ExitStatus : int { done = 0, defect = 1, wrong_input = 2, not_converged = 3 };

std::shared_ptr<Messages> set_up_messages() {
    auto messages = std::make_shared<Messages>();
    auto logger = std::make_shared<spdlog::logger>("ashimpact", messages);
    logger->set_pattern("%v");
    spdlog::set_default_logger(std::move(logger));
    return messages;
}

/// Prints a text and checks that it arrived.
void print(const std::string& text) {
    const std::string shown = without_controls(text);
    std::cout << (is_colored(STDOUT_FILENO) ? with_colors(shown) : shown) << std::flush;
    if (!std::cout) throw InputError("cannot be written", "a place with room").at("standard output");
}

/// Whether a line is a command to be typed, as those that say what to do next are.
bool is_command(const std::string& line) {
    static const std::vector<std::string> beginnings{"  " + program_word() + ' ', "  sh ", "  python3 "};
    return std::any_of(beginnings.begin(), beginnings.end(),
                       [&](const std::string& beginning) { return line.starts_with(beginning); });
}

/// Wraps lines to the width of the output, commands so that they can be pasted; JSON stays as it is.
std::string laid_out(const std::string& text) {
    if (text.starts_with('{') || text.starts_with('[')) return text;
    const std::size_t width = output_width();
    std::string out;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line); out += '\n')
        out += is_command(line) ? wrapped_command(line, width) : wrapped(line, width, 2);
    return out;
}

/// Prints the result. If the output files are already written, a failure to print is only a warning.
void print_result(const std::string& text, bool writes_files) {
    try {
        print(laid_out(text));
    } catch (const InputError& error) {
        if (!writes_files) throw;
        spdlog::warn("warning: {}; all files were written", error.what());
    }
}

/// Runs a command, which prints all of its result or nothing.
void perform(const Action& action, bool writes_files, Messages& messages) {
    std::ostringstream out;
    try {
        action(out);
    } catch (const InputError&) {
        messages.drop();  // an input error prints one line only
        throw;
    } catch (const std::filesystem::filesystem_error& error) {  // such as a name that is too long
        messages.drop();
        throw InputError("cannot be used: " + error.code().message(), "a path that the system takes")
            .at(FileName{shortened(error.path1().string())});
    }
    messages.release();
    print_result(out.str(), writes_files);
}

/// Neither quiet and verbose at once, wherever on the line they stand.
void check_common_options(const CLI::App& program) {
    const auto given = [&](const char* name) {
        return program.count(name) > 0 || program.get_subcommands().front()->count(name) > 0;
    };
    if (given("--quiet") && given("--verbose"))
        throw InputError("both are given", "one of the two").at("--quiet, --verbose");
}

/// Help or version. @throws CLI::ExtrasError if it was asked of a command that there is not
void answer(const CLI::App& program, const CLI::Success& request) {
    const auto unknown = program.remaining();
    if (program.get_subcommands().empty() && !unknown.empty()) throw CLI::ExtrasError("ashimpact", unknown);
    std::ostringstream out;
    static_cast<void>(program.exit(request, out, out));
    print(help_layout(out.str(), output_width()));
}

/// Parses the command line and runs its command.
void run_command_line(CLI::App& program, int argc, const char* const* argv, const Action& action,
                      Messages& messages) {
    try {
        program.parse(argc, argv);
    } catch (const CLI::Success& request) {  // --help, --version
        answer(program, request);
        return;
    }
    check_common_options(program);
    constexpr std::array<std::string_view, 7> writing{"run",    "sweep",  "init",   "export",
                                                      "report", "figure", "deposit"};
    const std::string command = program.get_subcommands().front()->get_name();
    perform(action, std::find(writing.begin(), writing.end(), command) != writing.end(), messages);
}

/// The words of the command line; `help` is `--help`, and `help COMMAND` is `COMMAND --help`.
std::vector<const char*> words_of(int argc, const char* const* argv) {
    std::vector<const char*> words(argv, argv + argc);
    if (words.size() < 2 || std::string_view(words[1]) != "help") return words;
    words.erase(words.begin() + 1);
    words.insert(words.begin() + std::min<std::ptrdiff_t>(2, std::ssize(words)), "--help");
    return words;
}

/// Makes options and arguments refuse an empty value, and paths "-", which elsewhere means a stream.
void refuse_empty_values(CLI::App& program) {
    for (CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
        for (CLI::Option* option : command->get_options()) {
            if (option->get_expected_max() == 0) continue;  // a flag
            option->check([option](const std::string& text) { return emptiness(*option, text); }, "",
                          "not empty");
        }
}

/// Key of an option in CommandOptions: "--output" for "-o,--output".
std::string key_of(const std::string& name) {
    return name.substr(name.rfind(',') + 1);
}

}  // namespace

Command CommandLine::add(const std::string& name, const std::string& purpose_of_it,
                         const std::string& example, const CommandBody& body) const {
    CLI::App* command = program.add_subcommand(name, purpose_of_it);
    add_common_options(*command);
    command->footer("Example:\n  " + example);
    const auto options = std::make_shared<CommandOptions>();
    command->callback([options, body, &requested = action] {
        requested = [options, body](std::ostream& out) {
            warn_of(options->doubts());
            body(*options, out);
        };
    });
    return {*command, *options};
}

void set_up_commands(CLI::App& program, Action& action, const CommandBody& sweep,
                     const CommandBody& exporter) {
    program.name("ashimpact");
    program.description(purpose);
    add_common_options(program);
    program.require_subcommand(1);
    program.footer("Example:\n  ashimpact run\n`ashimpact help COMMAND` says more about each.");
    const CommandLine line{program, action};
    add_run(line);
    add_modulus(line);
    add_contact_commands(line);
    add_damping(line);
    add_sweep(line, sweep);
    add_report_commands(line);
    add_export(line, exporter);
    add_deposit(line);
    add_calibrate(line);
    add_cross_check(line);
    add_literature(line);
    add_document_commands(line);
    refuse_empty_values(program);
}

CLI::Option* Command::add(const std::string& name, const std::string& type, const std::string& purpose_of_it,
                          const std::string& standard) {
    std::string& text = options_.text_of(key_of(name));
    text = standard;
    CLI::Option* option = app_.add_option(name, text, purpose_of_it)->type_name(type);
    return standard.empty() ? option : option->capture_default_str();
}

CLI::Option* Command::add_flag(const std::string& name, const std::string& purpose_of_it) {
    return app_.add_flag_callback(
        name, [&text = options_.text_of(name)] { text = "true"; }, purpose_of_it);
}

CLI::Option* Command::add_list(const std::string& name, const std::string& type,
                               const std::string& purpose_of_it) {
    return app_.add_option(name, options_.list_of(name), purpose_of_it)->type_name(type);
}

void Command::add_json_flag() {
    add_flag("--json", "print one JSON object, numbers with 17 significant digits");
}

void Command::add_case_argument() {
    add("case", "CASE.json", "case file; default: the built-in case, Dong et al. 2013");
}

void Command::add_allow_outside_flag() {
    add_flag("--allow-outside", "the case may name files outside of its own folder");
}

void Command::add_table_options(CLI::Option* table) {
    CLI::Option* sheet = add("--sheet", "NAME", "of a spreadsheet with several tables");
    CLI::Option* decimal = add("--decimal", "MARK",
                               "point or comma, before the decimals of all numbers of the table; default: by "
                               "the numbers themselves");
    if (table == nullptr) return;
    sheet->needs(table);
    decimal->needs(table);
}

void Command::add_sphere_options() {
    add("--radius", "Q", "of the sphere, \"44 um\"; or its --diameter");
    add("--diameter", "Q", "of the sphere, \"88 um\"; or its --radius");
    add("--density", "Q", "of the sphere, \"2160 kg/m3\"");
    add("--mass", "Q", "of the sphere, instead of its density");
}

void Command::add_law_option(bool required) {
    add("--law", "NAME", "contact law: " + law_names())->required(required);
}

void Command::add_pair_options(bool required) {
    add("--contact-modulus", "Q", "E*, \"90 GPa\" (not a Young's modulus)")->required(required);
    add("--work-of-adhesion", "Q",
        "w, \"0.3 J/m2\" (not a surface energy); not for " +
            laws_where([](Law law) { return !law.uses_work_of_adhesion(); }));
    add("--yield-pressure", "Q", "p_y, \"35.3 MPa\", for thornton-ning");
    for (const LawParameter& parameter : law_parameters()) add_parameter(parameter);
}

void Command::add_material_options(bool required) {
    add_law_option(required);
    add("--density", "Q", "of the spheres, \"2160 kg/m3\"")->required(required);
    add_pair_options(required);
    add_damping_law_option();
    add("--damping", "Q", "of all sizes, \"1e-6 kg/s\"; default: none");
}

void Command::add_contact_options(bool required) {
    add_law_option(required);
    add_sphere_options();
    add("--partner-radius", "Q", "of a second sphere, \"60 um\"; without it the partner is a flat wall");
    add("--partner-diameter", "Q", "of that sphere, instead of its radius");
    add("--partner-density", "Q", "of the second sphere");
    add("--partner-mass", "Q", "of the second sphere, instead of its density");
    add("--roughness", "Q",
        "rms of both surfaces, \"1 nm\": reduces w (Rabinovich et al. 2000); default: smooth");
    add_pair_options(required);
    add("--detachment", "NAME",
        "where the contact ends: zero-overlap, zero-force, pull-off, load-controlled; default: that of the "
        "law");
    add_damping_law_option();
}

void Command::add_parameter(const LawParameter& parameter) {
    add(option_of(parameter), parameter.dimension == Dimension::fraction ? "X" : "Q",
        fmt::format("{}, \"{}\", for {}", parameter.description, parameter.example,
                    joined(takers_of(parameter))));
}

void Command::add_damping_parameter_options() {
    for (const DampingLaw law : all_values<DampingLaw>)
        for (const LawParameter& parameter : parameters_of(law)) add_parameter(parameter);
}

void Command::add_damping_law_option() {
    add("--damping-law", "NAME",
        joined(names_of<DampingLaw>()) + "; the unit of the damping goes with it; default: constant");
}

void Command::add_damping_option() {
    add("--damping", "Q", "\"0.0141 kg/s\"; default: none");
    add("--damping-restitution", "X",
        "instead: the damping with which an impact without adhesion has this restitution");
    add("--at", "Q", "velocity at which it does, \"2 m/s\"; not needed for tsuji");
}

void Command::add_method_options() {
    add("--method", "NAME",
        "taylor (exact) or paper-explicit (the paper's scheme, first order in the time step)", "taylor");
    add("--time-step", "Q", "of paper-explicit; default: 10000 steps a contact");
}

TableOptions table_options(const CommandOptions& options) {
    TableOptions table{.sheet = options["--sheet"]};
    if (options.has("--decimal"))
        table.decimal = at_place("--decimal", [&] { return named<DecimalMark>(options["--decimal"]); });
    return table;
}

CLI::Validator number_within(double least, double most) {
    return within(least, most, "number");
}

CLI::Validator whole_number(std::size_t least, std::size_t most) {
    return within(least, most, "whole number");
}

int with_enough_stack(const std::function<int()>& program) {
#ifdef __GLIBC__
    constexpr std::size_t needed = std::size_t{8} << 20;
    rlimit limit{};
    if (getrlimit(RLIMIT_STACK, &limit) == 0 && limit.rlim_cur < needed) {
        pthread_attr_t attributes;
        pthread_attr_init(&attributes);
        pthread_attr_setstacksize(&attributes, needed);
        pthread_setattr_default_np(&attributes);
        pthread_attr_destroy(&attributes);
        int status = defect;
        std::thread([&] { status = program(); }).join();
        return status;
    }
#endif
    return program();
}

int run_program(int argc, const char* const* argv, const CommandBody& sweep, const CommandBody& exporter) {
    const auto messages = set_up_messages();
    set_program_word(argc > 0 ? argv[0] : nullptr);
    CLI::App program;
    Action action;
    set_up_commands(program, action, sweep, exporter);
    std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is an error of its write
    try {
        const auto words = words_of(argc, argv);
        run_command_line(program, static_cast<int>(words.size()), words.data(), action, *messages);
        return done;
    } catch (const CLI::ParseError& error) {
        spdlog::error("{}", usage_error(program, error));
        return wrong_input;
    } catch (const InputError& error) {
        spdlog::error("{}", on_one_line(error.what()));
        return wrong_input;
    } catch (const ConvergenceError& error) {
        messages->release();
        spdlog::error("not converged: {}", on_one_line(error.what()));
        return not_converged;
    } catch (const std::exception& error) {
        spdlog::error("a defect of ashimpact {}: {}", version_text(), on_one_line(error.what()));
        return defect;
    }
}

}  // namespace ashimpact

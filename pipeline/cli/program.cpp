#include "pipeline/cli/program.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "data/version.hpp"
#include "materials/error.hpp"
#include "materials/text.hpp"
#include "pipeline/cli/commands.hpp"
#include "pipeline/cli/held_warnings.hpp"
#include "pipeline/cli/usage.hpp"

namespace ashimpact {

namespace {

enum ExitStatus : int { done = 0, defect = 1, wrong_input = 2, not_converged = 3 };

constexpr auto purpose =
    "From a fly ash's XRD result to the dynamic critical velocity.\n"
    "Quantities carry their unit in quotes (\"44 um\"); a bare number is SI. Results go to standard output, "
    "messages to\nstandard error. Exit status: 0 done, 2 input is wrong, 3 not converged, 1 a defect of the "
    "program.";

std::string version_text() {
    return fmt::format("ashimpact {} ({})", program_version(), program_revision());
}

std::shared_ptr<HeldWarnings> set_up_messages() {
    auto messages = std::make_shared<HeldWarnings>();
    auto logger = std::make_shared<spdlog::logger>("ashimpact", messages);
    logger->set_pattern("%v");
    spdlog::set_default_logger(std::move(logger));
    return messages;
}

void add_common_options(CLI::App& app) {
    app.set_version_flag("--version", version_text, "print version and revision");
    app.add_flag_callback(
        "-q,--quiet", [] { spdlog::set_level(spdlog::level::err); }, "errors only");
    app.add_flag_callback(
        "-v,--verbose", [] { spdlog::set_level(spdlog::level::debug); }, "more messages");
}

/// Runs a command and checks that what it printed arrived.
void perform(const Action& action, HeldWarnings& messages) {
    try {
        action(std::cout);
    } catch (const InputError&) {
        messages.drop();  // one line says what is wrong
        throw;
    }
    messages.release();
    std::cout.flush();
    if (!std::cout) throw InputError("cannot be written", "a place with room").at("standard output");
}

}  // namespace

CLI::App* add_command(CLI::App& program, const std::string& name, const std::string& purpose_of_it,
                      const std::string& example) {
    CLI::App* command = program.add_subcommand(name, purpose_of_it);
    add_common_options(*command);
    command->footer("Example:\n  " + example);
    return command;
}

int run_program(int argc, const char* const* argv, const SweepRunner& sweep) {
    const auto messages = set_up_messages();
    CLI::App program(purpose, "ashimpact");
    add_common_options(program);
    program.require_subcommand(1);
    program.footer("Example:\n  ashimpact run\n`ashimpact COMMAND --help` says more about each.");
    Action action;
    add_case_commands(program, action);
    add_contact_commands(program, action);
    add_sweep_command(program, action, sweep);
    add_document_commands(program, action);
    try {
        program.parse(argc, argv);
        perform(action, *messages);
        return done;
    } catch (const CLI::Success& request) {  // --help, --version
        return program.exit(request);
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

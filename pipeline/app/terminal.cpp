// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/terminal.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include "core/text/text.hpp"
#include "pipeline/present/text/layout.hpp"

namespace ashimpact {

namespace {

constexpr std::string_view bold = "\x1b[1m";
constexpr std::string_view yellow = "\x1b[33m";
constexpr std::string_view red = "\x1b[31m";
constexpr std::string_view plain = "\x1b[0m";
constexpr std::string_view warning_word = "warning:";
constexpr const char* clear_line = "\r\x1b[K";

enum class Color { automatic, always, never };
Color color_choice = Color::automatic;

std::string_view line_at(std::string_view text, std::size_t begin) {
    return text.substr(begin, std::min(text.find('\n', begin), text.size()) - begin);
}

bool is_rule(std::string_view line) {
    const auto first = line.find_first_not_of(' ');
    return first != std::string_view::npos && line.size() - first > 2 &&
           line.find_first_not_of('-', first) == std::string_view::npos;
}

void write_message(std::string_view message, bool is_error) {
    std::string text = without_controls(message);
    if (is_colored(STDERR_FILENO)) text = is_error ? error_in_color(text) : with_colors(text);
    std::fwrite(text.data(), 1, text.size(), stderr);
}

std::string started_by = "ashimpact";  ///< program_word()

constexpr std::string_view command_head = "  ashimpact ";

/// Where the description of an option or a command begins: behind two blanks or more after its name.
std::size_t description_column(const std::string& line) {
    const auto name = line.find_first_not_of(' ');
    if (name == 0 || name == std::string::npos) return 0;
    if (name > 8) return name;         // a description in a line of its own
    constexpr std::size_t usual = 30;  // of CLI11
    if (name == 2 && line[name] == '-' && line.size() > usual && line[usual - 1] == ' ') return usual;
    const auto end = line.find("  ", name);
    return end == std::string::npos ? name : std::min(line.find_first_not_of(' ', end), line.size());
}

/// As it is typed: --law; a positional one by its type, CASE.json.
std::string name_of_option(const CLI::Option& option) {
    return option.get_positional() ? option.get_type_name() : option.get_name();
}

std::vector<std::string> names_of_options(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) names.push_back(name_of_option(*option));
    return names;
}

std::string missing(const CLI::App& command) {
    for (const CLI::Option* option : command.get_options())
        if (option->get_required() && option->count() == 0)
            return fmt::format("{} is missing; allowed: {}", name_of_option(*option),
                               option->get_description());
    return "an option is missing; allowed: " + joined(names_of_options(command));
}

/// The name that a word begins, else the nearest one; at most one.
std::vector<std::string> meant(const std::string& word, const std::vector<std::string>& names) {
    constexpr std::size_t shortest = 4;  // two letters after the dashes
    if (word.size() >= shortest)
        for (const std::string& name : names)
            if (name.starts_with(word)) return {name};
    // Without the dashes, which all options share: --plot is not --from.
    const std::size_t dashes = std::min(word.find_first_not_of('-'), word.size());
    std::vector<std::string> bare;
    for (const std::string& name : names)
        if (name.starts_with(std::string(dashes, '-'))) bare.push_back(name.substr(dashes));
    std::vector<std::string> guess = nearest(word.substr(dashes), bare, 1);
    for (std::string& name : guess) name.insert(0, dashes, '-');
    return guess;
}

std::string unexpected(const CLI::App& command) {
    const auto names = names_of_options(command);
    const std::string given = command.remaining().empty() ? "" : command.remaining().front();
    const auto guess = meant(given, names);
    return fmt::format("{} is not expected{}; allowed: {}", in_quotes(given),
                       guess.empty() ? "" : ", did you mean " + guess.front() + "?", joined(names));
}

/// The option that a message of the parser starts with.
const CLI::Option* option_in(const CLI::App& command, const std::string& message) {
    return command.get_option_no_throw(message.substr(0, message.find(':')));
}

std::string wrong_count(const CLI::App& command, const std::string& message) {
    const CLI::Option* option = option_in(command, message);
    if (option == nullptr) return message + "; allowed: one value for each option";
    return fmt::format("{} {}; allowed: {}", name_of_option(*option),
                       option->count() > 1 ? "is given more than once" : "has no value",
                       option->get_description());
}

std::string what_is_wrong(const CLI::App& command, const CLI::Error& error) {
    std::string message = error.what();
    const bool is_missing = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
    if (is_missing && command.remaining().empty()) return missing(command);
    if (is_missing) return unexpected(command);  // perhaps the missing one, mistyped
    if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) return unexpected(command);
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) return wrong_count(command, message);
    if (dynamic_cast<const CLI::ExcludesError*>(&error) != nullptr) return message + "; allowed: one of them";
    if (dynamic_cast<const CLI::RequiresError*>(&error) != nullptr)
        return message + "; allowed: both or neither";
    const CLI::Option* option = option_in(command, message);
    if (option != nullptr && option->get_positional())
        message = option->get_type_name() + message.substr(message.find(':'));
    if (option == nullptr || message.find("; allowed: ") != std::string::npos) return message;
    return message + "; allowed: " + option->get_description();
}

constexpr std::chrono::milliseconds period{250};

/// "3.2 million impacts/s"; what takes more than a second each, "12 s for each of 6 hypotheses".
std::string rate_text(double rate, std::uint64_t total, const char* noun) {
    if (rate >= 1e6) return fmt::format("{:.3g} million {}/s", rate / 1e6, noun);
    if (rate >= 1e3) return fmt::format("{:.3g} thousand {}/s", rate / 1e3, noun);
    if (rate >= 1.0) return fmt::format("{:.3g} {}/s", rate, noun);
    return fmt::format("{:.{}f} s for each of {} {}", 1.0 / rate, rate > 0.1 ? 1 : 0, total, noun);
}

std::string time_text(double seconds) {
    if (seconds >= 100 * 3600) return fmt::format("{:.0f} days", seconds / 86400);
    const auto whole = std::lround(seconds);
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

}  // namespace

void choose_color(std::string_view when) {
    color_choice = when == "always" ? Color::always : when == "never" ? Color::never : Color::automatic;
}

std::string error_in_color(std::string_view text) {
    const bool ends = text.ends_with('\n');
    std::string out(red);
    out.append(ends ? text.substr(0, text.size() - 1) : text).append(plain);
    return ends ? out + "\n" : out;
}

bool is_colored(int descriptor) {
    if (color_choice != Color::automatic) return color_choice == Color::always;
    const auto variable = [](const char* name) {
        const char* value = std::getenv(name);
        return std::string_view(value == nullptr ? "" : value);
    };
    return isatty(descriptor) == 1 && variable("NO_COLOR").empty() && variable("TERM") != "dumb";
}

std::string with_colors(std::string_view text) {
    std::string out;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::string_view line = line_at(text, begin);
        const std::size_t next = begin + line.size() + 1;
        const auto add = [&](std::string_view color, std::string_view marked) {
            out.append(color).append(marked).append(plain).append(line.substr(marked.size()));
        };
        if (next < text.size() && is_rule(line_at(text, next)))
            add(bold, line);
        else if (line.starts_with(warning_word))
            add(yellow, warning_word);
        else
            out += line;
        if (next <= text.size()) out += '\n';
        begin = next;
    }
    return out;
}

Messages::~Messages() {
    write_message(held_, false);
}

void Messages::release() {
    const std::lock_guard lock(mutex_);
    write_message(held_, false);
    held_.clear();
}

void Messages::drop() {
    const std::lock_guard lock(mutex_);
    held_.clear();
}

void Messages::sink_it_(const spdlog::details::log_msg& message) {
    spdlog::memory_buf_t line;
    formatter_->format(message, line);
    const std::string_view text(line.data(), line.size());
    if (message.level == spdlog::level::warn)
        held_ += wrapped(text, message_width(), 2);
    else if (message.level < spdlog::level::warn)
        write_message(wrapped(text, message_width(), 2), false);
    else  // an error is one line, however long
        write_message(text, true);
}

void Messages::flush_() {
    std::fflush(stderr);
}

const std::string& program_word() {
    return started_by;
}

void set_program_word(const char* typed) {
    if (typed != nullptr && *typed != '\0') started_by = shell_word(typed);
}

std::string help_layout(const std::string& help, std::size_t width) {
    std::istringstream lines(help);
    std::string out;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(command_head)) {
            out += wrapped_command("  " + program_word() + line.substr(command_head.size() - 1), width);
        } else {
            const std::size_t column = description_column(line);
            const std::size_t own = std::min(line.find_first_not_of(' '), line.size());
            out += wrapped(line, width, column > own && column < width / 2 ? column - own : 0);
        }
        out += '\n';
    }
    return out;
}

std::string usage_error(const CLI::App& program, const CLI::Error& error) {
    const auto chosen = program.get_subcommands();
    if (!chosen.empty()) {
        const std::string command = chosen.front()->get_name();
        return on_one_line(fmt::format("ashimpact {}: {}; see `{} {} --help`", command,
                                       what_is_wrong(*chosen.front(), error), program_word(), command));
    }
    std::vector<std::string> commands;
    for (const CLI::App* each : program.get_subcommands([](const CLI::App*) { return true; }))
        commands.push_back(each->get_name());
    const auto unknown = program.remaining();
    return on_one_line(fmt::format("ashimpact: {}; allowed: {}; see `{} --help`",
                                   unknown.empty() ? "a command is missing"
                                                   : "unknown command " + in_quotes(unknown.front()) +
                                                         did_you_mean(unknown.front(), commands),
                                   joined(commands), program_word()));
}

Progress::Progress(std::uint64_t total, std::uint64_t done, bool shown, const char* noun)
    : total_(total), before_(done), shown_(shown), noun_(noun) {}

Progress::~Progress() {
    if (dirty_) std::fputs(clear_line, stderr);
}

void Progress::update(std::uint64_t done) {
    const auto now = Clock::now();
    if (!shown_ || done == before_ || now - last_ < period) return;
    last_ = now;
    const double seconds = std::chrono::duration<double>(now - start_).count();
    const double rate = static_cast<double>(done - before_) / seconds;
    const std::string line = total_ == 0
                                 ? fmt::format("{}{} {} in {}", clear_line, done, noun_, time_text(seconds))
                                 : fmt::format("{}{:5.1f} %, {}, {} left", clear_line,
                                               100 * static_cast<double>(done) / static_cast<double>(total_),
                                               rate_text(rate, total_, noun_),
                                               time_text(static_cast<double>(total_ - done) / rate));
    std::fputs(line.c_str(), stderr);
    dirty_ = true;
}

void StepLine::clear() {
    if (dirty_) std::fputs(clear_line, stderr);
    dirty_ = false;
}

void StepLine::show(const std::string& step) {
    if (!shown_) return;
    std::fputs((clear_line + step).c_str(), stderr);
    dirty_ = true;
}

bool on_terminal() {
    return isatty(STDERR_FILENO) == 1;
}

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/cli/argument_checks.hpp"

#include <charconv>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "core/text.hpp"

namespace ashimpact {

namespace {

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

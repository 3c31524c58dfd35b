#include "pipeline/cli/argument_checks.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>

#include "materials/text.hpp"

namespace ashimpact {

CLI::Validator not_empty() {
    return {[](std::string& text) { return text.empty() ? std::string("is empty; allowed: a path") : ""; },
            "", "not empty"};
}

CLI::Validator whole_number(std::size_t least, std::size_t most) {
    return {[=](std::string& text) -> std::string {
                std::size_t number = 0;
                const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
                const bool is_number = failure == std::errc() && end == text.data() + text.size();
                if (is_number && number >= least && number <= most) return "";
                return fmt::format("is {}; allowed: a whole number from {} to {}", in_quotes(text), least,
                                   most);
            },
            "", "whole number"};
}

}  // namespace ashimpact

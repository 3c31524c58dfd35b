// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/cli/colors.hpp"

#include <algorithm>
#include <cstdlib>

#include <unistd.h>

namespace ashimpact {

namespace {

constexpr std::string_view bold = "\x1b[1m";
constexpr std::string_view yellow = "\x1b[33m";
constexpr std::string_view red = "\x1b[31m";
constexpr std::string_view plain = "\x1b[0m";
constexpr std::string_view warning = "warning:";

enum class Color { automatic, always, never };
Color chosen = Color::automatic;

bool is_set(const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr && *value != '\0';
}

std::string_view line_at(std::string_view text, std::size_t begin) {
    return text.substr(begin, std::min(text.find('\n', begin), text.size()) - begin);
}

bool is_rule(std::string_view line) {
    const auto first = line.find_first_not_of(' ');
    return first != std::string_view::npos && line.size() - first > 2 &&
           line.find_first_not_of('-', first) == std::string_view::npos;
}

}  // namespace

void choose_color(std::string_view when) {
    chosen = when == "always" ? Color::always : when == "never" ? Color::never : Color::automatic;
}

bool is_colored(int descriptor) {
    if (chosen != Color::automatic) return chosen == Color::always;
    const char* terminal = std::getenv("TERM");
    const bool dumb = terminal != nullptr && std::string_view(terminal) == "dumb";
    return isatty(descriptor) == 1 && !is_set("NO_COLOR") && !dumb;
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
        else if (line.starts_with(warning))
            add(yellow, warning);
        else
            out += line;
        if (next <= text.size()) out += '\n';
        begin = next;
    }
    return out;
}

std::string error_in_color(std::string_view text) {
    const bool ends = text.ends_with('\n');
    std::string out(red);
    out.append(ends ? text.substr(0, text.size() - 1) : text).append(plain);
    return ends ? out + "\n" : out;
}

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/cli/help_layout.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

#include "pipeline/present/text/layout.hpp"

namespace ashimpact {

namespace {

constexpr std::string_view command_head = "  ashimpact ";

/// Where the description of an option or a command begins: behind two blanks or more after its name.
std::size_t description_column(const std::string& line) {
    const auto name = line.find_first_not_of(' ');
    if (name == 0 || name == std::string::npos) return 0;
    if (name > 8) return name;  // a description in a line of its own
    const auto end = line.find("  ", name);
    return end == std::string::npos ? name : std::min(line.find_first_not_of(' ', end), line.size());
}

}  // namespace

std::string help_layout(const std::string& help, std::size_t width, const std::string& program) {
    std::istringstream lines(help);
    std::string out;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(command_head)) {
            out += wrapped_command("  " + program + line.substr(command_head.size() - 1), width);
        } else {
            const std::size_t column = description_column(line);
            const std::size_t own = std::min(line.find_first_not_of(' '), line.size());
            out += wrapped(line, width, column > own && column < width / 2 ? column - own : 0);
        }
        out += '\n';
    }
    return out;
}

}  // namespace ashimpact

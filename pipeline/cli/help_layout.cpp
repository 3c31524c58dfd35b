#include "pipeline/cli/help_layout.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

#include "pipeline/text/layout.hpp"

namespace ashimpact {

namespace {

constexpr std::string_view command_head = "  ashimpact ";

/// The words of a command, a quoted one as one word.
std::vector<std::string> shell_words(const std::string& command) {
    std::vector<std::string> words(1);
    char quote = 0;
    for (const char c : command) {
        if (c == ' ' && quote == 0) {
            if (!words.back().empty()) words.emplace_back();
            continue;
        }
        if (quote == 0 && (c == '"' || c == '\''))
            quote = c;
        else if (c == quote)
            quote = 0;
        words.back() += c;
    }
    return words;
}

/// A command of an example; a line that is too long goes on behind a backslash, an option with its value.
std::string example_line(const std::string& line, std::size_t width, const std::string& program) {
    const std::string whole = "  " + program + line.substr(command_head.size() - 1);
    if (width_of(whole) <= width) return whole;
    constexpr std::string_view margin = "    ";
    constexpr std::size_t backslash = 2;
    std::string out = "  ";
    std::size_t column = out.size();
    const auto words = shell_words(whole);
    for (std::size_t i = 0; i < words.size(); ++i) {
        std::string piece = words[i];
        if (piece.starts_with("-") && i + 1 < words.size() && !words[i + 1].starts_with("-"))
            piece += " " + words[++i];
        const bool breaks = i > 0 && column + 1 + width_of(piece) + backslash > width;
        if (breaks) {
            out += " \\\n" + std::string(margin);
            column = margin.size();
        } else if (column > 2) {
            out += ' ';
            ++column;
        }
        out += piece;
        column += width_of(piece);
    }
    return out;
}

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
            out += example_line(line, width, program);
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

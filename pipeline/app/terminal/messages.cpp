// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/terminal/messages.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

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

enum class Color { automatic, always, never };
Color color_choice = Color::automatic;

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

void write_message(std::string_view message, bool is_error) {
    std::string text = without_controls(message);
    if (is_colored(STDERR_FILENO)) text = is_error ? error_in_color(text) : with_colors(text);
    std::fwrite(text.data(), 1, text.size(), stderr);
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

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/cli/held_warnings.hpp"

#include <cstdio>

#include <unistd.h>

#include "core/text.hpp"
#include "pipeline/app/cli/colors.hpp"
#include "pipeline/present/text/layout.hpp"

namespace ashimpact {

namespace {

void write_message(std::string_view message) {
    std::string text = without_controls(message);
    if (is_colored(STDERR_FILENO)) text = with_colors(text);
    std::fwrite(text.data(), 1, text.size(), stderr);
}

void write_error(std::string_view message) {
    const std::string text = without_controls(message);
    const std::string shown = is_colored(STDERR_FILENO) ? error_in_color(text) : text;
    std::fwrite(shown.data(), 1, shown.size(), stderr);
}

}  // namespace

HeldWarnings::~HeldWarnings() {
    write_message(held_);
}

void HeldWarnings::release() {
    const std::lock_guard lock(mutex_);
    write_message(held_);
    held_.clear();
}

void HeldWarnings::drop() {
    const std::lock_guard lock(mutex_);
    held_.clear();
}

void HeldWarnings::sink_it_(const spdlog::details::log_msg& message) {
    spdlog::memory_buf_t line;
    formatter_->format(message, line);
    const std::string_view text(line.data(), line.size());
    if (message.level == spdlog::level::warn)
        held_ += wrapped(text, message_width(), 2);
    else if (message.level < spdlog::level::warn)
        write_message(wrapped(text, message_width(), 2));
    else  // an error is one line, however long
        write_error(text);
}

void HeldWarnings::flush_() {
    std::fflush(stderr);
}

}  // namespace ashimpact

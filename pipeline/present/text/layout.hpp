// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/text/utf8.hpp"

namespace ashimpact {

/// Columns of a text that goes to a file or to another program.
inline constexpr std::size_t piped_width = 80;

/// Columns that standard output takes: those of its terminal, else piped_width.
[[nodiscard]] std::size_t output_width();
/// The same for standard error.
[[nodiscard]] std::size_t message_width();

/// The text with its lines broken at blanks, so that none is longer than @p width unless a single word is.
/// @param hanging blanks before the continued part of a line, beyond those that the line begins with
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t width, std::size_t hanging = 0);

/// A command to be typed. One that is longer than @p width goes on behind a backslash, an option with its
/// value and what is quoted whole.
[[nodiscard]] std::string wrapped_command(const std::string& line, std::size_t width);

/// The text, or its beginning and "..." in exactly @p width characters.
[[nodiscard]] std::string cut_to(const std::string& text, std::size_t width);

}  // namespace ashimpact

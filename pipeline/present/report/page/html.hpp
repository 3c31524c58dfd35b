// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/present/report/drawing/figure.hpp"

namespace ashimpact::report {

/// A figure as HTML: both forms of the drawing, caption, readout, numbers as a table and as CSV.
/// @param id link target, unique in the page
[[nodiscard]] std::string html_of(const Figure& figure, const std::string& id);

/// A table that scrolls within the page; numbers with five significant digits.
[[nodiscard]] std::string html_table(const NumberTable& table, const std::string& label);

/// A part that scrolls by itself. @param label for those who do not see it, escaped
[[nodiscard]] std::string html_scroll(const std::string& label, const std::string& content,
                                      std::string_view look = "scroll");

/// A section under its heading, which is a link target.
[[nodiscard]] std::string html_section(std::string_view id, std::string_view title,
                                       const std::string& content);

/// A list of notes, which are HTML.
[[nodiscard]] std::string html_notes(const std::vector<std::string>& notes);

/// Links to figures and to the provenance.
[[nodiscard]] std::string html_contents(const std::vector<std::string_view>& figures);

/// Sketch of an impact with the names of its quantities, in place of the paper's Figures 1 and 2.
[[nodiscard]] std::string html_sketch();

/// A whole page: head with the strict content security policy, style and script.
[[nodiscard]] std::string html_page(const std::string& title, const std::string& body);

/// Whether a file is a page of ours, which may be replaced or removed.
[[nodiscard]] bool is_own_page(const std::filesystem::path& file);

/// An escaped text with the symbols in it set as such: "v_in", "e_n".
[[nodiscard]] std::string with_subscripts(std::string text);

/// A user's name in HTML.
[[nodiscard]] std::string html_name(std::string_view name);

}  // namespace ashimpact::report

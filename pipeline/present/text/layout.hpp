// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/text/text.hpp"

namespace ashimpact {

/// Columns of a text that goes to a file or to another program.
inline constexpr std::size_t piped_width = 80;

/// Columns that standard output takes: those of its terminal, else piped_width.
[[nodiscard]] std::size_t output_width();
/// The same for standard error.
[[nodiscard]] std::size_t message_width();

/// Breaks lines at blanks so that none exceeds @p width, unless a word does. @param hanging more blanks
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t width, std::size_t hanging = 0);

/// A command to be typed; beyond @p width it goes on behind a backslash, options with their values whole.
[[nodiscard]] std::string wrapped_command(const std::string& line, std::size_t width);

/// The text, or its beginning and "..." in exactly @p width characters.
[[nodiscard]] std::string cut_to(const std::string& text, std::size_t width);

/// Text in columns: those that name a row flush left, the others flush right, a rule under the heading.
class TextTable {
  public:
    /// @param keys columns that name a row, the first ones; a table that is too wide repeats them
    explicit TextTable(std::vector<std::string> heading, std::size_t keys = 1)
        : rows_{std::move(heading)}, keys_(keys) {}

    void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
    [[nodiscard]] bool empty() const { return rows_.size() == 1; }

    /// Drops the columns in which every row has "-" or nothing.
    void drop_empty_columns();

    /// Lines after @p indent blanks. A table wider than @p width is split into several with the same keys.
    [[nodiscard]] std::string text(std::size_t indent = 0, std::size_t width = output_width()) const;

  private:
    [[nodiscard]] std::vector<std::size_t> column_widths() const;
    [[nodiscard]] std::string block_text(const std::vector<std::size_t>& columns,
                                         const std::vector<std::size_t>& widths, std::size_t indent) const;

    std::vector<std::vector<std::string>> rows_;
    std::size_t keys_;
};

/// Names in the order in which they are first added, without empty ones.
class NameList {
  public:
    void add(const std::string& name) {
        if (!name.empty() && known_.insert(name).second) names_.push_back(name);
    }
    [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

  private:
    std::set<std::string> known_;
    std::vector<std::string> names_;
};

/// "name   value" lines with the values in one column.
class TextList {
  public:
    void add(const std::string& name, const std::string& value);
    /// Lines; the values are broken at @p width.
    [[nodiscard]] std::string text(std::size_t indent = 2, std::size_t width = output_width()) const;

  private:
    std::vector<std::pair<std::string, std::string>> rows_;
};

}  // namespace ashimpact

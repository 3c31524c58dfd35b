#pragma once

#include <string>
#include <vector>

namespace ashimpact {

/// Text in columns: the first flush left, the others flush right, a rule under the heading.
class TextTable {
  public:
    explicit TextTable(std::vector<std::string> heading) : rows_{std::move(heading)} {}

    void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
    [[nodiscard]] bool empty() const { return rows_.size() == 1; }

    /// Lines, each ending with a newline and beginning with @p indent blanks.
    [[nodiscard]] std::string text(std::size_t indent = 0) const;

  private:
    std::vector<std::vector<std::string>> rows_;
};

/// "name   value" lines with the values in one column.
class TextList {
  public:
    void add(const std::string& name, const std::string& value);
    [[nodiscard]] std::string text(std::size_t indent = 2) const;

  private:
    std::vector<std::pair<std::string, std::string>> rows_;
};

}  // namespace ashimpact

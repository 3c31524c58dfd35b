#include "pipeline/text/table.hpp"

#include <algorithm>

namespace ashimpact {

namespace {

constexpr std::size_t gap = 2;

/// Characters of a UTF-8 text: bytes that do not continue one.
std::size_t width(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string without_trailing_blanks(std::string line) {
    line.erase(line.find_last_not_of(' ') + 1);
    return line;
}

}  // namespace

std::string TextTable::text(std::size_t indent) const {
    std::vector<std::size_t> widths(rows_.front().size());
    for (const auto& row : rows_)
        for (std::size_t i = 0; i < std::min(row.size(), widths.size()); ++i)
            widths[i] = std::max(widths[i], width(row[i]));

    std::string out;
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        std::string line(indent, ' ');
        for (std::size_t i = 0; i < widths.size(); ++i) {
            const std::string cell = i < rows_[r].size() ? rows_[r][i] : std::string{};
            const std::string blanks(widths[i] - width(cell), ' ');
            if (i > 0) line += std::string(gap, ' ');
            line += i == 0 ? cell + blanks : blanks + cell;
        }
        const std::size_t length = width(line);
        out += without_trailing_blanks(std::move(line)) + "\n";
        if (r == 0) out += std::string(indent, ' ') + std::string(length - indent, '-') + "\n";
    }
    return out;
}

void TextList::add(const std::string& name, const std::string& value) {
    rows_.emplace_back(name, value);
}

std::string TextList::text(std::size_t indent) const {
    std::size_t longest = 0;
    for (const auto& [name, value] : rows_) longest = std::max(longest, width(name));
    std::string out;
    for (const auto& [name, value] : rows_) {
        std::string line(indent, ' ');
        line += name;
        line += std::string(longest - width(name) + gap, ' ');
        line += value;
        out += without_trailing_blanks(std::move(line));
        out += '\n';
    }
    return out;
}

}  // namespace ashimpact

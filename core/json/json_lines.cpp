// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/json/json_lines.hpp"

#include <algorithm>

#include "core/json/document.hpp"

namespace ashimpact {

namespace {

/// Levels whose lines are recorded: "/samples/0/phases/0/weight_fraction" has five.
constexpr std::size_t deepest_kept = 5;

}  // namespace

JsonLines::JsonLines(std::string_view text) : rest_(text) {
    read_value("", 0);
    rest_ = {};
}

void JsonLines::skip(std::size_t bytes) {
    const std::string_view skipped = rest_.substr(0, bytes);
    line_ += static_cast<std::size_t>(std::count(skipped.begin(), skipped.end(), '\n'));
    rest_.remove_prefix(skipped.size());
}

/// Skips blanks and comments, and returns the next character without consuming it; NUL at the end.
char JsonLines::next() {
    while (true) {
        skip(std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size()));
        if (rest_.starts_with("//"))
            skip(rest_.find('\n'));
        else if (rest_.starts_with("/*"))
            skip(rest_.find("*/", 2) + 2);
        else
            return rest_.empty() ? '\0' : rest_.front();
    }
}

/// Consumes a string and returns it as written, with its quotes.
std::string JsonLines::read_string() {
    std::size_t end = 1;
    while (end < rest_.size() && rest_[end] != '"') end += rest_[end] == '\\' ? 2 : 1;
    end = std::min(end + 1, rest_.size());
    std::string token(rest_.substr(0, end));
    rest_.remove_prefix(end);
    return token;
}

void JsonLines::read_members(const std::string& pointer, std::size_t depth, char close) {
    rest_.remove_prefix(1);
    for (std::size_t i = 0; next() != close && !rest_.empty(); ++i) {
        std::string child = depth < deepest_kept ? child_pointer(pointer, i) : std::string();
        if (close == '}') {
            const std::string key = read_string();
            if (depth < deepest_kept) child = child_pointer(pointer, Json::parse(key).get<std::string>());
            static_cast<void>(next());
            rest_.remove_prefix(1);  // the colon
        }
        read_value(child, depth + 1);
        if (next() == ',') rest_.remove_prefix(1);
    }
    if (!rest_.empty()) rest_.remove_prefix(1);
}

void JsonLines::read_value(const std::string& pointer, std::size_t depth) {
    const char first = next();
    if (depth <= deepest_kept) lines_.emplace(pointer, line_);
    if (first == '{' || first == '[')
        read_members(pointer, depth, first == '{' ? '}' : ']');
    else if (first == '"')
        static_cast<void>(read_string());
    else
        rest_.remove_prefix(std::min(rest_.find_first_of(",]}/ \t\r\n"), rest_.size()));
}

std::size_t JsonLines::line_of(std::string pointer) const {
    while (!pointer.empty()) {
        if (const auto found = lines_.find(pointer); found != lines_.end()) return found->second;
        pointer.resize(pointer.rfind('/'));
    }
    return lines_.at("");
}

}  // namespace ashimpact

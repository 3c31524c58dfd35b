#include "pipeline/json/document.hpp"

#include <algorithm>
#include <set>
#include <vector>

#include "materials/error.hpp"

namespace ashimpact {

namespace {

/// Follows the parser through the document, to know where it is and which keys were there before.
class Tracker {
  public:
    /// @throws InputError for a key that its object already has
    bool operator()(Json::parse_event_t event, const Json& parsed) {
        switch (event) {
            case Json::parse_event_t::object_start:
            case Json::parse_event_t::array_start: enter(event == Json::parse_event_t::array_start); break;
            case Json::parse_event_t::object_end:
            case Json::parse_event_t::array_end: levels_.pop_back(); break;
            case Json::parse_event_t::key: take_key(parsed.get<std::string>()); break;
            case Json::parse_event_t::value: next_element(); break;
        }
        return true;
    }

    [[nodiscard]] std::string pointer() const {
        std::string pointer;
        for (const Level& level : levels_)
            pointer = level.is_array ? child_pointer(pointer, level.elements - (level.elements > 0 ? 1 : 0))
                                     : child_pointer(pointer, level.key);
        return pointer;
    }

  private:
    struct Level {
        bool is_array = false;
        std::size_t elements = 0;
        std::string key{};
        std::set<std::string> keys{};
    };

    void next_element() {
        if (!levels_.empty() && levels_.back().is_array) ++levels_.back().elements;
    }

    void enter(bool is_array) {
        next_element();
        levels_.push_back({.is_array = is_array});
    }

    void take_key(std::string key) {
        Level& level = levels_.back();
        level.key = std::move(key);
        if (level.keys.insert(level.key).second || is_comment(level.key)) return;
        throw InputError("this key is there twice", "every key once").at(pointer());
    }

    std::vector<Level> levels_;
};

std::string line_and_column(std::string_view text, std::size_t position) {
    const std::string_view before = text.substr(0, std::min(position, text.size()));
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    const auto start = before.rfind('\n');
    const auto column = start == std::string_view::npos ? before.size() : before.size() - start - 1;
    return "line " + std::to_string(line) + ", column " + std::to_string(column + 1);
}

/// What the parser says, without its own name and place.
std::string parser_message(std::string message) {
    for (const std::string_view before : {"] ", "parse error", ": "}) {
        const auto found = message.find(before);
        if (found != std::string::npos) message.erase(0, found + before.size());
    }
    std::replace(message.begin(), message.end(), '\n', ' ');
    return message;
}

}  // namespace

bool is_comment(std::string_view key) { return key.starts_with("//"); }

std::string child_pointer(const std::string& pointer, std::string_view key) {
    std::string child = pointer + "/";
    for (const char c : key) {
        if (c == '~') child += "~0";
        else if (c == '/') child += "~1";
        else child += c;
    }
    return child;
}

std::string child_pointer(const std::string& pointer, std::size_t index) {
    return pointer + "/" + std::to_string(index);
}

Json parse_json(std::string_view text) {
    Tracker tracker;
    try {
        return Json::parse(text, [&](int, Json::parse_event_t event, const Json& parsed) {
            return tracker(event, parsed);
        });
    } catch (const Json::parse_error& error) {
        const std::size_t position = error.byte > 0 ? error.byte - 1 : 0;
        throw InputError(parser_message(error.what()), "JSON").at(line_and_column(text, position));
    } catch (const Json::out_of_range&) {
        throw InputError("a number here or next is too large", "finite numbers").at(tracker.pointer());
    }
}

Json without_comments(const Json& document) {
    if (document.is_array()) {
        Json plain = Json::array();
        for (const Json& element : document) plain.push_back(without_comments(element));
        return plain;
    }
    if (!document.is_object()) return document;
    Json plain = Json::object();
    for (const auto& [key, value] : document.items())
        if (!is_comment(key)) plain[key] = without_comments(value);
    return plain;
}

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/json/document.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <utility>
#include <vector>

#include "core/text/text.hpp"

namespace ashimpact {

namespace {

constexpr std::size_t deepest = 64;

/// Callback of the parser that refuses what the library would accept silently.
class Watcher {
  public:
    bool operator()(int /*depth*/, Json::parse_event_t event, const Json& parsed) {
        using Event = Json::parse_event_t;
        if (event == Event::object_start || event == Event::array_start) enter(event == Event::array_start);
        if (event == Event::object_end || event == Event::array_end) leave();
        if (event == Event::value) value(parsed);
        return event != Event::key || name(parsed.get<std::string>());
    }

    [[nodiscard]] std::string pointer() const {
        std::string pointer;
        for (const Level& level : levels_)
            pointer =
                level.is_array ? child_pointer(pointer, level.index) : child_pointer(pointer, level.key);
        return pointer.empty() ? "/" : pointer;
    }

  private:
    struct Level {
        bool is_array = false;
        std::size_t index = 0;
        std::string key{};
        std::set<std::string> keys{};
    };

    void enter(bool is_array) {
        if (levels_.size() >= deepest)
            throw InputError("nested too deeply", "64 levels or fewer").at(pointer());
        levels_.push_back({.is_array = is_array});
    }
    void leave() {
        levels_.pop_back();
        count();
    }
    void count() {
        if (!levels_.empty()) ++levels_.back().index;
    }
    void value(const Json& parsed) {
        if (parsed.is_string()) refuse_nul(parsed.get_ref<const std::string&>());
        count();
    }
    /// Refuses a NUL: a text after it would be lost if it becomes a file name.
    void refuse_nul(const std::string& text) const {
        if (text.find('\0') != std::string::npos)
            throw InputError("holds a NUL character", "a text without it").at(pointer());
    }
    /// @return false for the key of a comment, whose value the parser then drops
    bool name(const std::string& key) {
        Level& level = levels_.back();
        level.key = key.substr(0, key.find('\0'));
        refuse_nul(key);
        if (key.starts_with("//")) return false;
        if (!level.keys.insert(key).second)
            throw InputError("this key is there twice", "each key once").at(pointer());
        return true;
    }
    std::vector<Level> levels_;
};

/// "line N, column M" of a byte of the text; the library counts bytes from 1.
std::string place_of(std::string_view text, std::size_t byte) {
    const std::string_view before = text.substr(0, byte == 0 ? 0 : byte - 1);
    const auto line_start = before.rfind('\n') + 1;  // npos + 1 is 0
    return "line " + std::to_string(1 + std::count(before.begin(), before.end(), '\n')) + ", column " +
           std::to_string(1 + before.size() - line_start);
}

/// The library's message in one line, without its own name and place.
std::string reason_of(std::string message) {
    for (const std::string_view before : {"] ", "parse error", ": "}) {
        const auto found = message.find(before);
        if (found != std::string::npos) message.erase(0, found + before.size());
    }
    // It quotes the last piece that it read, which may be as long as the document.
    constexpr std::string_view quoted = "last read: '";
    if (auto start = message.find(quoted); start != std::string::npos) {
        start += quoted.size();
        const std::size_t length = message.rfind('\'') - start;
        if (message.find('\'', start) != std::string::npos && start + length <= message.size())
            message.replace(start, length, shortened(message.substr(start, length)));
    }
    return on_one_line(std::move(message));
}

}  // namespace

std::string child_pointer(const std::string& pointer, std::string_view key) {
    std::string child = pointer + "/";
    for (const char c : key) {
        if (c == '~')
            child += "~0";
        else if (c == '/')
            child += "~1";
        else
            child += c;
    }
    return child;
}

std::string child_pointer(const std::string& pointer, std::size_t index) {
    return pointer + "/" + std::to_string(index);
}

Json parse_json(std::string_view text) {
    Watcher watcher;
    try {
        return Json::parse(text.begin(), text.end(), std::ref(watcher), true, true);
    } catch (const Json::parse_error& error) {
        throw InputError("this is not valid JSON: " + reason_of(error.what()), "JSON (RFC 8259)")
            .at(place_of(text, error.byte));
    } catch (const Json::out_of_range&) {
        throw InputError("a number is out of the range of double precision", "finite numbers")
            .at(watcher.pointer());
    }
}

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/json/document.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/text/text.hpp"

namespace ashimpact {

namespace {

constexpr std::size_t most_levels = 64;

/// Callback of the parser that refuses what the library would accept silently.
class StrictChecks {
  public:
    bool operator()(int /*depth*/, Json::parse_event_t event, const Json& parsed) {
        using Event = Json::parse_event_t;
        if (event == Event::object_start || event == Event::array_start) enter(event == Event::array_start);
        if (event == Event::object_end || event == Event::array_end) leave();
        if (event == Event::value) check_value(parsed);
        return event != Event::key || check_key(parsed.get<std::string>());
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
        if (levels_.size() >= most_levels)
            throw InputError("nested too deeply", "64 levels or fewer").at(pointer());
        levels_.push_back({.is_array = is_array});
    }
    void leave() {
        levels_.pop_back();
        count_element();
    }
    void count_element() {
        if (!levels_.empty()) ++levels_.back().index;
    }
    void check_value(const Json& parsed) {
        if (parsed.is_string()) refuse_nul(parsed.get_ref<const std::string&>());
        count_element();
    }
    /// Refuses a NUL: a text after it would be lost if it becomes a file name.
    void refuse_nul(const std::string& text) const {
        if (text.find('\0') != std::string::npos)
            throw InputError("holds a NUL character", "a text without it").at(pointer());
    }
    /// @return false for the key of a comment, whose value the parser then drops
    bool check_key(const std::string& key) {
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

/// Levels whose lines are recorded: "/samples/0/phases/0/weight_fraction" has five.
constexpr std::size_t most_recorded_levels = 5;

constexpr std::size_t line_width = 110;
constexpr std::size_t indent_width = 2;

std::string json_number(double value, Digits digits) {
    if (!std::isfinite(value)) throw std::logic_error("a result holds a number that is not finite");
    value += 0.0;  // turns -0 into 0
    return digits == Digits::shortest ? shortest(value) : fmt::format("{:.17g}", value);
}

std::string json_string(const std::string& value) {
    const auto plain = [](char c) { return c >= ' ' && c < '\x7f' && c != '"' && c != '\\'; };
    if (std::ranges::all_of(value, plain)) return '"' + value + '"';
    return Json(value).dump(-1, ' ', false, Json::error_handler_t::replace);
}

class Writer {
  public:
    explicit Writer(Digits digits) : digits_(digits) {}

    /// Writes a value whose first line already holds @p used bytes.
    void write(const Json& value, std::size_t indent, std::size_t used) {
        const std::string line = one_line(value, line_width);
        if (!line.empty() && used + line.size() <= line_width)
            out_ += line;
        else if (value.is_object())
            write_object(value, indent);
        else if (value.is_array())
            write_array(value, indent);
        else
            out_ += one_line(value, std::string::npos);
    }

    [[nodiscard]] std::string&& take() && { return std::move(out_); }

  private:
    /// The value in one line, or nothing if that would be longer than @p limit.
    [[nodiscard]] std::string one_line(const Json& value, std::size_t limit) const {
        if (value.is_string()) return json_string(value.get_ref<const std::string&>());
        if (value.is_number_float()) return json_number(value.get<double>(), digits_);
        if (!value.is_structured()) return value.dump();
        if (value.size() > limit / 3) return {};  // an element takes three bytes or more, "1, "
        std::string line(1, value.is_object() ? '{' : '[');
        for (auto element = value.begin(); element != value.end(); ++element) {
            if (element != value.begin()) line += ", ";
            if (value.is_object()) line += json_string(element.key()) + ": ";
            if (line.size() > limit) return {};
            const std::string inner = one_line(*element, limit - line.size());
            if (inner.empty() || line.size() + inner.size() > limit) return {};
            line += inner;
        }
        return line + (value.is_object() ? '}' : ']');
    }

    void new_line(std::size_t indent) { out_ += "\n" + std::string(indent, ' '); }

    void write_object(const Json& object, std::size_t indent) {
        out_ += '{';
        for (auto member = object.begin(); member != object.end(); ++member) {
            if (member != object.begin()) out_ += ',';
            new_line(indent + indent_width);
            const std::string key = json_string(member.key()) + ": ";
            out_ += key;
            write(*member, indent + indent_width, indent + indent_width + key.size());
        }
        new_line(indent);
        out_ += '}';
    }

    void write_array(const Json& array, std::size_t indent) {
        out_ += '[';
        std::size_t used = line_width;  // the first element begins a line
        for (auto element = array.begin(); element != array.end(); ++element) {
            if (element != array.begin()) out_ += ',';
            const std::string line = element->is_structured() ? "" : one_line(*element, std::string::npos);
            if (line.empty() || used + line.size() + 2 > line_width) {
                new_line(indent + indent_width);
                used = indent + indent_width;
            } else {
                out_ += ' ';
                ++used;
            }
            if (line.empty())
                write(*element, indent + indent_width, used);
            else
                out_ += line;
            used = line.empty() ? line_width : used + line.size() + 1;
        }
        new_line(indent);
        out_ += ']';
    }

    Digits digits_;
    std::string out_;
};

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
    StrictChecks checks;
    try {
        return Json::parse(text.begin(), text.end(), std::ref(checks), true, true);
    } catch (const Json::parse_error& error) {
        throw InputError("this is not valid JSON: " + reason_of(error.what()), "JSON (RFC 8259)")
            .at(place_of(text, error.byte));
    } catch (const Json::out_of_range&) {
        throw InputError("a number is out of the range of double precision", "finite numbers")
            .at(checks.pointer());
    }
}

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
        std::string child = depth < most_recorded_levels ? child_pointer(pointer, i) : std::string();
        if (close == '}') {
            const std::string key = read_string();
            if (depth < most_recorded_levels)
                child = child_pointer(pointer, Json::parse(key).get<std::string>());
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
    if (depth <= most_recorded_levels) lines_.emplace(pointer, line_);
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

Json as_read_back(Json document) {
    if (document.is_structured())
        for (auto it = document.begin(); it != document.end(); ++it) {
            if (it->is_number_float() && !std::isfinite(it->get<double>()))
                throw std::logic_error("a result holds a number that is not finite" +
                                       (document.is_object() ? ", " + it.key() : std::string()));
            *it = as_read_back(std::move(*it));
        }
    if (!document.is_number_float()) return document;
    const double number = document.get<double>();
    if (number != std::trunc(number)) return document;
    const std::string text = json_number(number, Digits::shortest);
    return text.find_first_of(".e") == std::string::npos ? Json::parse(text) : document;
}

std::string write_json(const Json& document, Digits digits) {
    Writer writer(digits);
    writer.write(document, 0, 0);
    return std::move(writer).take() + "\n";
}

}  // namespace ashimpact

#include "materials/json_input.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "materials/text.hpp"

namespace ashimpact {

namespace {

constexpr std::size_t deepest = 64;

/// Follows the parser and refuses what the library would take silently.
class Watcher {
  public:
    bool operator()(int /*depth*/, Json::parse_event_t event, const Json& parsed) {
        using Event = Json::parse_event_t;
        if (event == Event::object_start || event == Event::array_start) enter(event == Event::array_start);
        if (event == Event::object_end || event == Event::array_end) leave();
        if (event == Event::key) name(parsed.get<std::string>());
        if (event == Event::value) count();
        return true;
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
    void name(const std::string& key) {
        Level& level = levels_.back();
        if (!level.keys.insert(key).second)
            throw InputError("the key " + in_quotes(key) + " is there twice", "each key once")
                .at(pointer_of_parent());
        level.key = key;
    }
    [[nodiscard]] std::string pointer_to(std::size_t levels) const {
        std::string pointer;
        for (std::size_t i = 0; i < levels; ++i)
            pointer += "/" + (levels_[i].is_array ? std::to_string(levels_[i].index) : levels_[i].key);
        return pointer.empty() ? "/" : pointer;
    }
    [[nodiscard]] std::string pointer() const { return pointer_to(levels_.size()); }
    [[nodiscard]] std::string pointer_of_parent() const { return pointer_to(levels_.size() - 1); }

    std::vector<Level> levels_;
};

/// "line N" of a byte of the text; the library counts bytes from 1.
std::string line_of(std::string_view text, std::size_t byte) {
    const auto end =
        text.begin() + static_cast<std::ptrdiff_t>(std::min(byte == 0 ? 0 : byte - 1, text.size()));
    return "line " + std::to_string(1 + std::count(text.begin(), end, '\n'));
}

std::string list(std::initializer_list<std::string_view> words) {
    std::string joined;
    for (const auto word : words) joined += (joined.empty() ? "" : ", ") + std::string(word);
    return joined;
}

}  // namespace

Json parse_json(std::string_view text) {
    try {
        return Json::parse(text.begin(), text.end(), Watcher{});
    } catch (const Json::parse_error& error) {
        throw InputError("this is not valid JSON", "JSON (RFC 8259)").at(line_of(text, error.byte));
    } catch (const Json::out_of_range&) {
        throw InputError("a number is out of the range of double precision", "finite numbers");
    }
}

void require_keys(const Json& node, std::initializer_list<std::string_view> allowed) {
    if (!node.is_object()) throw InputError("not an object", "an object with the keys " + list(allowed));
    for (const auto& [key, _] : node.items()) {
        if (std::find(allowed.begin(), allowed.end(), key) != allowed.end()) continue;
        const std::vector<std::string> candidates(allowed.begin(), allowed.end());
        const auto guess = nearest(key, candidates, 1);
        throw InputError("unknown key " + in_quotes(key) +
                             (guess.empty() ? "" : ", did you mean " + in_quotes(guess[0]) + "?"),
                         list(allowed))
            .at("/" + key);
    }
}

const Json& required(const Json& node, std::string_view key) {
    if (!node.is_object()) throw InputError("not an object", "an object with the key " + in_quotes(key));
    const auto member = node.find(std::string(key));
    if (member == node.end()) throw InputError("the key " + in_quotes(key) + " is missing");
    return *member;
}

std::string as_string(const Json& node) {
    if (!node.is_string()) throw InputError("not a string", "a string");
    return node.get<std::string>();
}

double as_number(const Json& node) {
    if (!node.is_number()) throw InputError("not a number", "a finite number");
    const auto value = node.get<double>();
    if (!std::isfinite(value)) throw InputError("not finite", "a finite number");
    return value;
}

const Json& as_array(const Json& node) {
    if (!node.is_array()) throw InputError("not a list", "a list [...]");
    return node;
}

std::vector<std::string> as_strings(const Json& node) {
    std::vector<std::string> strings;
    for (std::size_t i = 0; i < as_array(node).size(); ++i)
        strings.push_back(at_place("/" + std::to_string(i), [&] { return as_string(node[i]); }));
    return strings;
}

}  // namespace ashimpact

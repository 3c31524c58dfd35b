#include "materials/base/units/unit_database.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>

#include <pugixml.hpp>

namespace ashimpact {

namespace {

using Unit = UnitDatabase::Unit;

constexpr int largest_power = 255;           // as in UDUNITS-2
constexpr std::string_view base_mark = "#";  // "#2" is the third base unit, "#" one without dimension

bool is_ascii(char c) {
    return static_cast<unsigned char>(c) < 0x80;
}
bool is_letter(char c) {
    return !is_ascii(c) || std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}
bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

std::string lower(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

Unit power(const Unit& unit, int exponent) {
    Unit result{.factor = std::pow(unit.factor, exponent)};
    for (std::size_t i = 0; i < unit.powers.size(); ++i) result.powers[i] = exponent * unit.powers[i];
    return result;
}

Unit product(const Unit& one, const Unit& other) {
    Unit result{.factor = one.factor * other.factor,
                .proportional = one.proportional && other.proportional};
    for (std::size_t i = 0; i < one.powers.size(); ++i) result.powers[i] = one.powers[i] + other.powers[i];
    return result;
}

/// A unit in the grammar of UDUNITS-2, read by recursive descent; none where it is not one.
class Expression {
  public:
    Expression(const UnitDatabase& units, std::string_view text) : units_(units), rest_(text) {}

    std::optional<Unit> whole() {
        std::optional<Unit> unit = product_of_powers();
        if (unit && skip("@")) return Unit{.powers = unit->powers, .proportional = false};
        return rest_.empty() || rest_ == ")" ? unit : std::nullopt;  // as UDUNITS-2 takes a last bracket
    }

  private:
    std::optional<Unit> product_of_powers() {
        std::optional<Unit> left = power_of_one();
        while (left && !rest_.empty() && rest_.front() != ')' && !at_origin()) {
            const bool divides = division();
            if (!divides && !skip(".") && !skip("*") && !skip("-")) spaces();
            const std::optional<Unit> right = power_of_one();
            if (!right) return std::nullopt;
            left = product(*left, divides ? power(*right, -1) : *right);
        }
        return left;
    }

    std::optional<Unit> power_of_one() {
        const std::optional<Unit> unit = one();
        if (!unit || rest_.empty()) return unit;
        const bool raised = skip("^");
        const std::optional<int> exponent = integer();
        if (!exponent) return raised ? std::nullopt : unit;
        return std::abs(*exponent) <= largest_power ? std::optional(power(*unit, *exponent)) : std::nullopt;
    }

    std::optional<Unit> one() {
        if (rest_.empty()) return std::nullopt;
        if (skip("(")) {
            const std::optional<Unit> unit = product_of_powers();
            return unit && skip(")") ? unit : std::nullopt;
        }
        if (std::string_view("0123456789.-").find(rest_.front()) != std::string_view::npos) return number();
        const std::string_view name = identifier();
        if (name == "lg" && rest_.starts_with("(re")) {
            rest_ = {};
            return Unit{.proportional = false};
        }
        return name.empty() ? std::nullopt : units_.named(name);
    }

    std::optional<Unit> number() {
        const std::string text(rest_);
        char* end = nullptr;
        const double value = std::strtod(text.c_str(), &end);
        rest_.remove_prefix(static_cast<std::size_t>(end - text.c_str()));
        return end == text.c_str() ? std::nullopt : std::optional(Unit{.factor = value});
    }

    /// Letters and digits, of which a letter is the last.
    std::string_view identifier() {
        std::size_t size = std::string_view("%'\"").find(rest_.front()) == std::string_view::npos ? 0 : 1;
        if (size == 0 && is_letter(rest_.front()))
            for (std::size_t i = 0; i < rest_.size() && (is_letter(rest_[i]) || is_digit(rest_[i])); ++i)
                if (is_letter(rest_[i])) size = i + 1;
        const std::string_view name = rest_.substr(0, size);
        rest_.remove_prefix(size);
        const bool another_follows = !rest_.empty() && (rest_.front() == '%' || is_letter(rest_.front()));
        return another_follows ? std::string_view() : name;
    }

    std::optional<int> integer() {
        std::size_t end = !rest_.empty() && (rest_.front() == '-' || rest_.front() == '+') ? 1 : 0;
        const std::size_t first = end;
        while (end < rest_.size() && end < first + 9 && is_digit(rest_[end])) ++end;
        if (end == first) return std::nullopt;
        const int value = std::atoi(std::string(rest_.substr(0, end)).c_str());
        rest_.remove_prefix(end);
        return value;
    }

    /// "/" or "per", with spaces on either side.
    bool division() {
        const std::string_view before = rest_;
        spaces();
        const auto longer = [&] { return rest_.size() > 3 && (is_letter(rest_[3]) || is_digit(rest_[3])); };
        if (skip("/")) return spaces();
        if (lower(rest_.substr(0, 3)) == "per" && !longer()) {
            rest_.remove_prefix(3);
            return spaces();
        }
        rest_ = before;
        return false;
    }

    bool at_origin() const {
        const std::size_t place = rest_.find_first_not_of(' ');
        return place != std::string_view::npos && rest_[place] == '@';
    }
    bool spaces() {
        while (skip(" ")) {}
        return true;
    }
    bool skip(std::string_view text) {
        if (text == "@") spaces();
        const bool found = rest_.starts_with(text);
        if (found) rest_.remove_prefix(text.size());
        return found;
    }

    const UnitDatabase& units_;
    std::string_view rest_;
};

/// English, as UDUNITS-2 forms it.
std::string plural_of(const std::string& name) {
    const auto ends = [&](std::string_view end) { return name.ends_with(end); };
    if (ends("y") && name.size() > 1 &&
        std::string_view("aeiou").find(name[name.size() - 2]) == std::string_view::npos)
        return name.substr(0, name.size() - 1) + "ies";
    return name + (ends("s") || ends("x") || ends("z") || ends("ch") || ends("sh") ? "es" : "s");
}

/// The length of the longest prefix that a text begins with; zero if there is none.
template <class Prefixes>
std::size_t longest_prefix(const Prefixes& prefixes, std::string_view text) {
    std::size_t longest = 0;
    for (const auto& [prefix, factor] : prefixes)
        if (text.starts_with(prefix)) longest = std::max(longest, prefix.size());
    return longest;
}

}  // namespace

UnitDatabase::UnitDatabase(const std::string& folder) {
    for (const char* part : {"prefixes", "base", "derived", "accepted", "common"})
        read(folder + "/udunits2-" + part + ".xml");
}

void UnitDatabase::read(const std::string& file) {
    pugi::xml_document document;
    if (!document.load_file(file.c_str())) return;
    for (const pugi::xml_node& prefix : document.child("unit-system").children("prefix")) {
        const double value = prefix.child("value").text().as_double();
        for (const pugi::xml_node& name : prefix.children("name"))
            name_prefixes_.emplace(lower(name.text().get()), value);
        for (const pugi::xml_node& symbol : prefix.children("symbol"))
            symbol_prefixes_.emplace(symbol.text().get(), value);
    }
    for (const pugi::xml_node& unit : document.child("unit-system").children("unit")) {
        std::string definition = unit.child("def").text().get();
        if (unit.child("base")) definition = std::string(base_mark) + std::to_string(bases_++);
        if (unit.child("dimensionless")) definition = base_mark;
        for (const pugi::xml_node& owner : {unit, unit.child("aliases")}) {
            for (const pugi::xml_node& name : owner.children("name")) {
                const std::string singular = lower(name.child("singular").text().get());
                if (singular.empty()) continue;
                names_.emplace(singular, definition);
                const std::string plural = lower(name.child("plural").text().get());
                if (!name.child("noplural") && !owner.child("noplural"))
                    names_.emplace(plural.empty() ? plural_of(singular) : plural, definition);
            }
            for (const pugi::xml_node& symbol : owner.children("symbol"))
                symbols_.emplace(symbol.text().get(), definition);
        }
    }
}

const std::string* UnitDatabase::definition(std::string_view name) const {
    if (const auto found = names_.find(lower(name)); found != names_.end()) return &found->second;
    const auto found = symbols_.find(name);
    return found != symbols_.end() ? &found->second : nullptr;
}

std::optional<Unit> UnitDatabase::named(std::string_view name) const {
    double factor = 1;
    bool symbol_seen = false;
    const std::string* found = nullptr;
    while (!name.empty() && (found = definition(name)) == nullptr) {
        const std::string in_lower_case = lower(name);
        std::size_t size = longest_prefix(name_prefixes_, in_lower_case);
        if (size > 0) {
            factor *= name_prefixes_.at(in_lower_case.substr(0, size));
        } else {
            size = symbol_seen ? 0 : longest_prefix(symbol_prefixes_, name);
            if (size == 0) return std::nullopt;
            factor *= symbol_prefixes_.at(std::string(name.substr(0, size)));
            symbol_seen = true;
        }
        name.remove_prefix(size);
    }
    if (!found) return std::nullopt;
    if (!found->starts_with(base_mark)) {
        std::optional<Unit> unit = Expression(*this, *found).whole();
        if (unit) unit->factor *= factor;
        return unit;
    }
    Unit base{.factor = factor};
    if (found->size() > 1) base.powers.at(std::strtoul(found->c_str() + 1, nullptr, 10)) = 1;
    return base;
}

UnitScale UnitDatabase::scale(std::string_view unit, std::string_view target) const {
    const std::optional<Unit> from = Expression(*this, unit).whole();
    if (!from) return {.problem = UnitProblem::unknown};
    const std::optional<Unit> to = Expression(*this, target).whole();
    if (!to || !from->proportional || !to->proportional || from->powers != to->powers)
        return {.problem = UnitProblem::other_dimension};
    return {.scale = from->factor / to->factor};
}

std::vector<std::string> UnitDatabase::names() const {
    std::vector<std::string> all;
    for (const auto* table : {&names_, &symbols_})
        for (const auto& [name, unit] : *table)
            if (std::all_of(name.begin(), name.end(), is_ascii))
                all.push_back(name);
    return all;
}

}  // namespace ashimpact

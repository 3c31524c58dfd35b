// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/units/unit_expression.hpp"

#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>

namespace ashimpact {

namespace {

using Unit = UnitDatabase::Unit;

constexpr int largest_power = 255;  // as in UDUNITS-2

bool is_letter_of_name(char c) {
    const bool is_ascii = static_cast<unsigned char>(c) < 0x80;
    return !is_ascii || std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}
bool is_decimal_digit(char c) {
    return c >= '0' && c <= '9';
}

bool is_per(std::string_view text) {
    return text.size() == 3 && std::tolower(text[0]) == 'p' && std::tolower(text[1]) == 'e' &&
           std::tolower(text[2]) == 'r';
}

Unit power(const Unit& unit, int exponent) {
    Unit result{.factor = std::pow(unit.factor, exponent)};
    for (std::size_t i = 0; i < unit.powers.size(); ++i) result.powers[i] = exponent * unit.powers[i];
    return result;
}

Unit product(const Unit& one, const Unit& other) {
    Unit result{.factor = one.factor * other.factor, .proportional = one.proportional && other.proportional};
    for (std::size_t i = 0; i < one.powers.size(); ++i) result.powers[i] = one.powers[i] + other.powers[i];
    return result;
}

/// Reads a unit by recursive descent.
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
        if (size == 0 && is_letter_of_name(rest_.front()))
            for (std::size_t i = 0;
                 i < rest_.size() && (is_letter_of_name(rest_[i]) || is_decimal_digit(rest_[i])); ++i)
                if (is_letter_of_name(rest_[i])) size = i + 1;
        const std::string_view name = rest_.substr(0, size);
        rest_.remove_prefix(size);
        const bool another_follows =
            !rest_.empty() && (rest_.front() == '%' || is_letter_of_name(rest_.front()));
        return another_follows ? std::string_view() : name;
    }

    std::optional<int> integer() {
        std::size_t end = !rest_.empty() && (rest_.front() == '-' || rest_.front() == '+') ? 1 : 0;
        const std::size_t first = end;
        while (end < rest_.size() && end < first + 9 && is_decimal_digit(rest_[end])) ++end;
        if (end == first) return std::nullopt;
        int value = 0;
        std::from_chars(rest_.data() + (rest_.front() == '+' ? 1 : 0), rest_.data() + end, value);
        rest_.remove_prefix(end);
        return value;
    }

    /// "/" or "per", with spaces on either side. Without one before it, "per" may begin a longer name
    /// instead.
    bool division() {
        const std::string_view before = rest_;
        spaces();
        if (skip("/")) return spaces();
        const bool longer = rest_.size() > 3 && (is_letter_of_name(rest_[3]) || is_decimal_digit(rest_[3]));
        if (is_per(rest_.substr(0, 3)) && (!longer || rest_.size() < before.size())) {
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
        while (skip(" ")) {
        }
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

}  // namespace

std::optional<Unit> read_unit(const UnitDatabase& units, std::string_view text) {
    return Expression(units, text).whole();
}

}  // namespace ashimpact

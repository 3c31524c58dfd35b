// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/units/unit.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/text/text.hpp"
#include "core/text/utf8.hpp"

namespace ashimpact {

namespace {

constexpr std::size_t longest_unit = 200;  // bounds the depth of brackets

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '%';
}

Unit raised(Unit unit, int exponent) {
    unit.factor = std::pow(unit.factor, exponent);
    for (double& power : unit.powers) power *= exponent;
    return unit;
}

Unit product(Unit left, const Unit& right) {
    left.factor *= right.factor;
    for (std::size_t i = 0; i < left.powers.size(); ++i) left.powers[i] += right.powers[i];
    return left;
}

/// Reads a unit by recursive descent.
class UnitReader {
  public:
    explicit UnitReader(std::string_view text) : rest_(text) {}

    std::optional<Unit> whole() {
        const std::optional<Unit> unit = products();
        return rest_.empty() ? unit : std::nullopt;
    }

  private:
    std::optional<Unit> products() {
        std::optional<Unit> left = power();
        while (left) {
            const bool blank = skip_blanks();
            if (rest_.empty() || rest_.front() == ')') return left;
            const bool divides = skip("/") || (blank && skip_per());
            if (!divides) static_cast<void>(skip(".") || skip("*") || skip("-"));
            skip_blanks();
            const std::optional<Unit> right = power();
            if (!right) return std::nullopt;
            left = product(*left, divides ? raised(*right, -1) : *right);
        }
        return left;
    }

    std::optional<Unit> power() {
        const std::optional<Unit> unit = one();
        if (!unit) return unit;
        const bool needs_exponent = skip("^");
        const std::optional<int> exponent = integer();
        if (!exponent) return needs_exponent ? std::nullopt : unit;
        return raised(*unit, *exponent);
    }

    std::optional<Unit> one() {
        if (skip("(")) {
            const std::optional<Unit> unit = products();
            return unit && skip(")") ? unit : std::nullopt;
        }
        const std::string_view name = rest_.substr(0, length_of_name());
        rest_.remove_prefix(name.size());
        return name.empty() ? std::nullopt : unit_named(name);
    }

    /// Letters and digits, of which a letter is the last, as in "cmH2O".
    [[nodiscard]] std::size_t length_of_name() const {
        std::size_t length = 0;
        for (std::size_t i = 0; i < rest_.size() && (is_letter(rest_[i]) || is_digit(rest_[i])); ++i) {
            if (i == 0 && is_digit(rest_[i])) return 0;
            if (is_letter(rest_[i])) length = i + 1;
        }
        return length;
    }

    std::optional<int> integer() {
        const std::size_t sign = rest_.starts_with('-') || rest_.starts_with('+') ? 1 : 0;
        int value = 0;
        const auto* const first = rest_.data() + sign;
        const auto [end, status] = std::from_chars(first, rest_.data() + rest_.size(), value);
        if (status != std::errc{} || (sign == 1 && !is_digit(*first))) return std::nullopt;
        if (rest_.front() == '-') value = -value;
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return value;
    }

    bool skip(std::string_view text) {
        const bool found = rest_.starts_with(text);
        if (found) rest_.remove_prefix(text.size());
        return found;
    }
    bool skip_per() {
        const bool found = length_of_name() == 3 && lower_case(rest_.substr(0, 3)) == "per";
        if (found) rest_.remove_prefix(3);
        return found;
    }
    bool skip_blanks() {
        const std::size_t before = rest_.size();
        rest_ = rest_.substr(std::min(rest_.find_first_not_of(' '), rest_.size()));
        return rest_.size() < before;
    }

    std::string_view rest_;
};

}  // namespace

std::optional<Unit> read_unit(std::string_view text) {
    if (text == "1") return Unit{};
    if (text.size() > longest_unit) return std::nullopt;
    const std::optional<Unit> unit = UnitReader(text).whole();
    return unit && std::isfinite(unit->factor) && unit->factor > 0 ? unit : std::nullopt;
}

std::string ascii_unit(std::string_view text) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 23> spellings{{
        {"\u00b5", "u"},        {"\u03bc", "u"},        {"\u00b7", "."}, {"\u22c5", "."}, {"\u00d7", "."},
        {"\u2212", "-"},        {"\u207b", "-"},        {"\u2070", "0"}, {"\u00b9", "1"}, {"\u00b2", "2"},
        {"\u00b3", "3"},        {"\u2074", "4"},        {"\u2075", "5"}, {"\u2076", "6"}, {"\u2077", "7"},
        {"\u2078", "8"},        {"\u2079", "9"},        {"\u00a0", " "}, {"\u2009", " "}, {"\u202f", " "},
        {"\u00c5", "angstrom"}, {"\u212b", "angstrom"}, {"**", "^"},
    }};
    return replaced(text, spellings);
}

}  // namespace ashimpact

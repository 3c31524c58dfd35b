// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/number_marks.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"

namespace ashimpact {

namespace {

bool is_mark(char c) {
    return c == '.' || c == ',';
}

/// What the marks in a number are.
enum class Marks {
    none,
    decimal_point,  ///< the point separates decimals, the comma, if any, groups digits
    decimal_comma,
    point_may_group,  ///< "1.234"
    comma_may_group,  ///< "1,234"
};

/// Whether @p mark groups these digits by threes, or as in India all but the last three by twos.
bool groups(std::string_view digits, char mark) {
    const auto last = digits.rfind(mark);
    if (last == std::string_view::npos || digits.size() - last != 4) return false;
    std::size_t size = 0;  // of the group that is read, from the last but one
    std::size_t middle = 0;
    for (std::size_t at = last; at-- > 0;) {
        if (digits[at] != mark) {
            ++size;
            continue;
        }
        if ((size != 2 && size != 3) || (middle != 0 && size != middle)) return false;
        middle = size;
        size = 0;
    }
    return size > 0 && size <= (middle == 2 ? 2 : 3);
}

Marks marks_of(std::string_view number) {
    const auto last = number.find_last_of(".,");
    if (last == std::string_view::npos) return Marks::none;
    const char mark = number[last];
    const char other = mark == '.' ? ',' : '.';
    const Marks decimal = mark == '.' ? Marks::decimal_point : Marks::decimal_comma;
    if (number.find(other) != std::string_view::npos)
        return groups(number.substr(0, last), other) ? decimal : Marks::none;
    if (!groups(number, mark) || number.front() == '0') return decimal;
    if (std::ranges::count(number, mark) > 1)
        return mark == '.' ? Marks::decimal_comma : Marks::decimal_point;
    return mark == '.' ? Marks::point_may_group : Marks::comma_may_group;
}

std::size_t digits_from(std::string_view text, std::size_t at) {
    const auto end = std::find_if_not(text.begin() + static_cast<std::ptrdiff_t>(at), text.end(), is_digit);
    return static_cast<std::size_t>(end - text.begin()) - at;
}

/// Removes blanks and apostrophes that group digits: "1 234" and "1'234" are 1234.
/// @param changed holds the text if anything is removed
std::string_view without_blanks_in_numbers(std::string_view cell, std::string& changed) {
    const bool is_plain = std::ranges::all_of(cell, [](char c) { return c > ' ' && c < 0x7f && c != '\''; });
    if (is_plain) return cell;
    std::string& text = changed;
    text = cell;
    for (const auto& [mark, plain] :
         {std::pair{"\u00a0", " "}, std::pair{"\u202f", " "}, std::pair{"\u2009", " "},
          std::pair{"\u2019", "'"}, std::pair{"\u2212", "-"}, std::pair{"\u2013", "-"}})
        for (auto at = text.find(mark); at != std::string::npos; at = text.find(mark, at))
            text.replace(at, std::string_view(mark).size(), plain);
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t first = digits_from(text, at);
        at += std::max<std::size_t>(first, 1);
        const bool behind_mark = first > 0 && at > first && is_mark(text[at - first - 1]);
        if (first == 0 || first > 3 || behind_mark || at >= text.size()) continue;
        const char blank = text[at];
        if (blank != ' ' && blank != '\'') continue;
        for (; at < text.size() && text[at] == blank && digits_from(text, at + 1) == 3; at += 3)
            text.erase(at, 1);
    }
    return text;
}

/// Calls @p visitor(first, count) for every number in a text: digits with marks between or before them.
template <class Visitor>
void for_each_number(std::string_view text, const Visitor& visitor) {
    for (std::size_t at = 0; at < text.size();) {
        if (!is_digit(text[at])) {
            ++at;
            continue;
        }
        std::size_t end = at;
        while (end < text.size() && (is_digit(text[end]) || (is_mark(text[end]) && end + 1 < text.size() &&
                                                             is_digit(text[end + 1]))))
            ++end;
        visitor(at, end - at);
        at = end;
    }
}

/// The number in the bracket behind another one: "1.2" of "30.1 (1.2)"; empty without one.
std::string_view bracket_of(std::string_view cell) {
    const auto open = cell.find('(');
    const auto close = cell.find(')');
    if (open == std::string_view::npos || open == 0 || close == std::string_view::npos || close < open)
        return {};
    const std::string_view inside = trimmed(cell.substr(open + 1, close - open - 1));
    return inside.find_first_not_of("0123456789.,") == std::string_view::npos ? inside : std::string_view{};
}

/// Reads a number, also "(12.3 ± 0.4) %" and "12.3 (± 0.4)". @throws InputError for "12.3 ± 3 %",
/// "12.3 (± 3 %)" and "12.3 % ± 3 %"
std::optional<PrintedNumber> read_with_uncertainty(std::string_view text) {
    text = trimmed(text);
    if (text.starts_with('(')) {
        const auto close = text.rfind(')');
        if (close == std::string_view::npos) return std::nullopt;
        const std::string_view unit = trimmed(text.substr(close + 1));
        auto number = read_number(text.substr(1, close - 1));
        if (!number || number->per_cent || !number->standard_uncertainty || (!unit.empty() && unit != "%"))
            return std::nullopt;
        number->per_cent = !unit.empty();
        return number;
    }
    const auto open = text.find("(\u00b1");
    const bool in_bracket = open != std::string_view::npos && text.find(')') + 1 == text.size();
    const std::string plain(in_bracket ? std::string(text.substr(0, open)) +
                                             std::string(text.substr(open + 1, text.size() - open - 2))
                                       : text);
    const auto number = read_number(plain);
    if (!number || !number->per_cent || !number->standard_uncertainty) return number;
    const auto sign = plain.find('%');
    if (sign + 1 < plain.size() && plain.ends_with('%'))
        refuse_two_per_cents(text, number->value, *number->standard_uncertainty, "({} \u00b1 {}) %");
    if (sign + 1 < plain.size() || plain.find_first_of("+\xb1", 1) == std::string::npos) return number;
    const std::string uncertainty = shortest(*number->standard_uncertainty);
    throw InputError("in " + in_quotes(text) + " the uncertainty is " + uncertainty + " % of " +
                         shortest(number->value) + ", or " + uncertainty + " in the unit of the value",
                     "the uncertainty in the unit of the value: " + shortest(number->value) + " \u00b1 " +
                         readable_number(std::abs(number->value) * *number->standard_uncertainty / 100) +
                         ", or " + shortest(number->value) + " \u00b1 " + uncertainty);
}

}  // namespace

std::string_view without_unit(std::string_view cell, std::string_view unit) {
    const bool is_name = !unit.empty() && unit != "%" && unit != "-" && !is_digit(unit.front());
    return is_name && cell.ends_with(unit) ? trimmed(cell.substr(0, cell.size() - unit.size())) : cell;
}

void NumberMarks::see(std::string_view cell, std::size_t column) {
    bracket_in_units_ = bracket_in_units_ || bracket_of(cell).find_first_of(".,") != std::string_view::npos;
    if (cell.find_first_of(".,") == std::string_view::npos) {
        const auto found = columns_.find(column);
        if (found != columns_.end() && found->second.thousands &&
            read_number(cell).value_or(PrintedNumber{}).value != 0)
            ++found->second.whole;
        return;
    }
    std::string changed;
    const std::string_view text = without_blanks_in_numbers(cell, changed);
    for_each_number(text, [&](std::size_t first, std::size_t count) {
        const Marks marks = marks_of(text.substr(first, count));
        has_decimal_point_ = has_decimal_point_ || marks == Marks::decimal_point;
        has_decimal_comma_ = has_decimal_comma_ || marks == Marks::decimal_comma;
        if (marks == Marks::point_may_group) ++columns_[column].point_may_group;
        if (marks == Marks::comma_may_group) ++columns_[column].comma_may_group;
        if (marks == Marks::decimal_point || marks == Marks::decimal_comma) ++columns_[column].others;
    });
}

bool NumberMarks::is_decimal(char mark, std::string_view number, std::size_t column) const {
    const bool is_point = mark == '.';
    if (decimal_) return is_point == (*decimal_ == DecimalMark::point);
    const bool stated = is_point ? has_decimal_point_ : has_decimal_comma_;
    const bool contradicted = is_point ? has_decimal_comma_ : has_decimal_point_;
    const auto found = columns_.find(column);
    const bool thousands = found != columns_.end() && found->second.thousands;
    // "1.753" beside "540" may have a group, whatever other columns show.
    const bool beside_whole = thousands && found->second.whole > 0 && found->second.others == 0;
    // In a spreadsheet "1.050" is a text, for whose mark stored numbers decide nothing.
    const bool is_text = of_sheet_ && thousands && number.ends_with('0');
    if (stated && !contradicted && !beside_whole && !is_text) return true;
    if (is_point && !stated && !contradicted && !thousands) return true;  // the mark of most programs
    if (!contradicted && found != columns_.end() && found->second.below_thousand) return true;
    if (contradicted && !stated && found != columns_.end()) {
        const auto points = found->second.point_may_group;
        const auto commas = found->second.comma_may_group;
        if (found->second.others == 0 && (is_point ? points > 1 && commas == 0 : commas > 1 && points == 0)) {
            if (first_grouped_.empty()) first_grouped_ = number;
            return false;
        }
    }
    const std::string decimal = [&] {
        std::string text(number);
        std::ranges::replace(text, mark, '.');
        return text;
    }();
    std::string grouped(number);
    std::erase(grouped, mark);
    throw InputError(
        in_quotes(number) + " is " + decimal + " or " + grouped,
        grouped + ", or " + decimal +
            "0, with one decimal mark in all numbers of the table; or --decimal point or comma (in a "
            "case \"decimal\", beside an XRD file \"xrd_decimal\")");
}

std::vector<Finding> NumberMarks::findings(std::string_view code) const {
    if (first_grouped_.empty()) return {};
    std::string grouped = first_grouped_;
    std::erase_if(grouped, is_mark);
    return {{code, Severity::remark,
             fmt::format("{} is read as {}, as other columns have the other decimal mark (--decimal "
                         "states it)",
                         in_quotes(first_grouped_), grouped)}};
}

std::optional<PrintedNumber> NumberMarks::read(std::string_view cell, std::size_t column) const {
    std::string changed;
    std::string_view text = without_blanks_in_numbers(cell, changed);
    for (const std::string_view sign : {"\u00b1", "+/-", "+-"})
        if (text.starts_with(sign) && columns_.contains(column) && columns_.at(column).uncertainties)
            text = trimmed(text.substr(sign.size()));
    if (text.find_first_of(".,") == std::string_view::npos) return read_with_uncertainty(text);
    if (const std::string_view bracket = bracket_of(text);
        bracket_in_units_ && !bracket.empty() && bracket.find_first_of(".,") == std::string_view::npos)
        throw InputError(in_quotes(cell) + " has an uncertainty of " + std::string(bracket) +
                             " last places, or of " + std::string(bracket) +
                             " as other brackets of the table",
                         "one form in all cells: \"12.3 (1.0)\"");
    std::string plain;
    std::size_t done = 0;
    bool has_point = false;  // "1,091 ± 0,020": the one number decides for the other
    bool has_comma = false;
    for_each_number(text, [&](std::size_t first, std::size_t count) {
        const Marks marks = marks_of(text.substr(first, count));
        has_point = has_point || marks == Marks::decimal_point;
        has_comma = has_comma || marks == Marks::decimal_comma;
    });
    const auto separates = [&](char mark, const std::string& number) {
        if (has_point != has_comma && !decimal_) return (mark == '.') == has_point;
        return is_decimal(mark, number, column);
    };
    for_each_number(text, [&](std::size_t first, std::size_t count) {
        plain += text.substr(done, first - done);
        done = first + count;
        std::string number(text.substr(first, count));
        const Marks marks = marks_of(number);
        const bool is_point = marks == Marks::decimal_point ||
                              (marks == Marks::point_may_group && separates('.', number)) ||
                              (marks == Marks::comma_may_group && !separates(',', number));
        if (decimal_ && !of_sheet_ &&
            marks == (*decimal_ == DecimalMark::point ? Marks::decimal_comma : Marks::decimal_point))
            throw InputError(fmt::format("{} has no decimal {}, which is stated for the table",
                                         in_quotes(number), name_of(*decimal_)),
                             "the decimal mark of the table; without it the numbers themselves decide");
        if (marks != Marks::none) {
            std::erase(number, is_point ? ',' : '.');
            std::ranges::replace(number, ',', '.');
        }
        plain += number;
    });
    plain += text.substr(done);
    return read_with_uncertainty(plain);
}

}  // namespace ashimpact

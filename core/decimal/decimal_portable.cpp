// SPDX-License-Identifier: GPL-3.0-or-later
// decimal.hpp where the standard library has no std::from_chars() and std::to_chars() of floating-point
// numbers.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include "core/decimal/decimal.hpp"

namespace ashimpact::decimal {

namespace {

/// Whether a number that was read as infinite or zero is neither as it stands in the text.
bool is_out_of_range(const char* first, const char* last, double value) {
    const char* const end_of_mantissa =
        std::find_if(first, last, [](char c) { return c == 'e' || c == 'E'; });
    if (std::isinf(value)) return std::any_of(first, last, [](char c) { return c >= '0' && c <= '9'; });
    return value == 0 && std::any_of(first, end_of_mantissa, [](char c) { return c >= '1' && c <= '9'; });
}

/// A positive number: its fewest digits d.ddd and the power of ten behind them.
struct Digits {
    std::string digits;
    int exponent;
};

Digits fewest_digits(double value) {
    const std::string printed = fmt::format("{}", value);  // with the fewest digits, in one of two forms
    const auto mark = std::min(printed.find('e'), printed.size());
    const auto point = std::min(printed.find('.'), mark);
    std::string digits = printed.substr(0, point);
    if (point < mark) digits += printed.substr(point + 1, mark - point - 1);
    int exponent = static_cast<int>(point) - 1;
    if (mark < printed.size()) exponent += std::atoi(printed.c_str() + mark + 1);
    const auto first = digits.find_first_not_of('0');
    exponent -= static_cast<int>(first);
    digits = digits.substr(first, digits.find_last_not_of('0') + 1 - first);
    return {digits, exponent};
}

std::string with_exponent(const Digits& number) {
    const std::string rest = number.digits.size() > 1 ? "." + number.digits.substr(1) : "";
    return fmt::format("{}{}e{}{:02}", number.digits.front(), rest, number.exponent < 0 ? '-' : '+',
                       std::abs(number.exponent));
}

std::string without_exponent(const Digits& number, double value) {
    const int before_point = number.exponent + 1;
    if (before_point <= 0)
        return "0." + std::string(static_cast<std::size_t>(-before_point), '0') + number.digits;
    const auto whole = static_cast<std::size_t>(before_point);
    if (whole < number.digits.size())
        return number.digits.substr(0, whole) + "." + number.digits.substr(whole);
    return fmt::format("{:.0f}", value);  // a whole number has all of its digits
}

}  // namespace

std::from_chars_result read(const char* first, const char* last, double& value) {
    double number = 0;
    const auto [end, status] = fast_float::from_chars(first, last, number);
    if (status != std::errc{}) return {status == std::errc::result_out_of_range ? end : first, status};
    if (is_out_of_range(first, end, number)) return {end, std::errc::result_out_of_range};
    value = number;
    return {end, std::errc{}};
}

std::string shortest(double value) {
    if (!std::isfinite(value)) return fmt::format("{}", value);
    const std::string sign = std::signbit(value) ? "-" : "";
    const double size = std::abs(value);
    if (size == 0) return sign + "0";
    const Digits number = fewest_digits(size);
    const std::string exponential = with_exponent(number);
    const std::string plain = without_exponent(number, size);
    return sign + (plain.size() <= exponential.size() ? plain : exponential);
}

std::string general(double value, int digits) {
    return fmt::format("{:.{}g}", value, digits);
}

std::string scientific(double value, int decimals) {
    return fmt::format("{:.{}e}", value, decimals);
}

}  // namespace ashimpact::decimal

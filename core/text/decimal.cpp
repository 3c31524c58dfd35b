// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/decimal.hpp"

#include <algorithm>
#include <cmath>

#include <fast_float/fast_float.h>
#include <fmt/format.h>

namespace ashimpact::decimal {

namespace {

/// True if the text of a number that was read as infinite or zero holds a finite number other than zero.
bool is_out_of_range(const char* first, const char* last, double value) {
    const auto holds = [](const char* from, const char* to, char least) {
        return std::any_of(from, to, [&](char c) { return c >= least && c <= '9'; });
    };
    const char* const end_of_mantissa =
        std::find_if(first, last, [](char c) { return c == 'e' || c == 'E'; });
    return std::isinf(value) ? holds(first, last, '0') : value == 0 && holds(first, end_of_mantissa, '1');
}

/// Number of significant digits of a number in decimal notation.
std::size_t significant_digits(std::string text) {
    text.resize(std::min(text.find('e'), text.size()));
    std::erase_if(text, [](char c) { return c == '.' || c == '-'; });
    const auto first = text.find_first_not_of('0');
    return first == std::string::npos ? 1 : text.find_last_not_of('0') + 1 - first;
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
    std::string fixed = fmt::format("{}", value);  // in exponential notation below 1e-4 and from 1e16
    if (!std::isfinite(value)) return fixed;
    std::string exponential = scientific(value, static_cast<int>(significant_digits(fixed)) - 1);
    if (fixed.find('e') != std::string::npos) {
        if (std::abs(value) < 1 || std::abs(value) > 1e25) return exponential;
        fixed = fmt::format("{:.0f}", value);
    }
    return fixed.size() <= exponential.size() ? fixed : exponential;
}

std::string general(double value, int digits) {
    return fmt::format("{:.{}g}", value, digits);
}

std::string scientific(double value, int decimals) {
    return fmt::format("{:.{}e}", value, decimals);
}

}  // namespace ashimpact::decimal

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimal/decimal.hpp"

#include <array>

namespace ashimpact::decimal {

namespace {

template <class... Format>
std::string written(double value, Format... format) {
    std::array<char, 64> buffer{};  // for up to 40 digits
    const auto [end, _] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format...);
    return {buffer.data(), end};
}

}  // namespace

std::from_chars_result read(const char* first, const char* last, double& value) {
    return std::from_chars(first, last, value);
}

std::string shortest(double value) {
    return written(value);
}

std::string general(double value, int digits) {
    return written(value, std::chars_format::general, digits);
}

std::string scientific(double value, int decimals) {
    return written(value, std::chars_format::scientific, decimals);
}

}  // namespace ashimpact::decimal

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/counting.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace ashimpact {

std::string counted(std::size_t count, std::string_view noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string numbered(std::string_view word, const std::vector<std::size_t>& numbers) {
    constexpr std::size_t most = 6;
    std::string text = fmt::format("{}{} ", word, numbers.size() == 1 ? "" : "s");
    for (std::size_t i = 0; i < std::min(numbers.size(), most); ++i)
        text += fmt::format("{}{}", i == 0 ? "" : ", ", numbers[i]);
    return numbers.size() > most ? fmt::format("{} and {} more", text, numbers.size() - most) : text;
}

}  // namespace ashimpact

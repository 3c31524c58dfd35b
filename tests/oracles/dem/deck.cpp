// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/oracles/dem/deck.hpp"

#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace ashimpact::oracles {

std::string exact(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.17g", number);
    return text;
}

std::string deck_template(const std::string& file) {
    std::ifstream stream(std::string(ASHIMPACT_ORACLE_DECKS "/") + file);
    std::ostringstream text;
    if (!(text << stream.rdbuf())) throw std::runtime_error("cannot read the deck template " + file);
    return text.str();
}

std::string fill(const std::string& deck, const DeckValues& values) {
    std::string filled;
    std::size_t position = 0;
    for (std::size_t open = 0; (open = deck.find('@', position)) != std::string::npos;) {
        const std::size_t close = deck.find('@', open + 1);
        if (close == std::string::npos) throw std::runtime_error("deck template: unpaired @");
        const auto value = values.find(deck.substr(open + 1, close - open - 1));
        if (value == values.end())
            throw std::runtime_error("deck template: no value for " + deck.substr(open, close - open + 1));
        filled.append(deck, position, open - position).append(value->second);
        position = close + 1;
    }
    return filled.append(deck, position);
}

}  // namespace ashimpact::oracles

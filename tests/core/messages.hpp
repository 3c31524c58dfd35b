// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/text/error.hpp"

namespace ashimpact::test {

/// What an action says when it refuses its input; empty if it does not.
template <class Action>
std::string refusal(Action action) {
    try {
        static_cast<void>(action());
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

/// Whether a text holds a piece.
inline bool holds(const std::string& text, const std::string& piece) {
    return text.find(piece) != std::string::npos;
}

}  // namespace ashimpact::test

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/text/error.hpp"

namespace ashimpact::test {

/// The message of the InputError that @p action throws; "no InputError" if it throws none.
template <class Action>
[[nodiscard]] std::string input_error_of(Action&& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no InputError";
}

/// Whether @p text contains @p part.
[[nodiscard]] inline bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace ashimpact::test

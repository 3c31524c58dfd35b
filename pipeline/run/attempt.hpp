// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "core/error.hpp"

namespace ashimpact {

/// Returns the result of @p compute. If the data do not allow it or it does not converge, adds a note and
/// returns none.
template <class Compute>
[[nodiscard]] auto attempt(const std::string& what, std::vector<std::string>& notes, Compute&& compute)
    -> std::optional<std::invoke_result_t<Compute&>> {
    try {
        return compute();
    } catch (const InputError& error) {
        notes.push_back("no " + what + ": " + error.problem());
    } catch (const ConvergenceError& error) {
        notes.push_back("no " + what + ": " + error.what());
    }
    return std::nullopt;
}

}  // namespace ashimpact

#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "materials/base/error.hpp"

namespace ashimpact {

/// What @p compute gives; data that do not allow it, or a computation that does not converge, leave a note
/// instead.
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

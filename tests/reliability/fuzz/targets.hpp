// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace ashimpact::test {

/// What is fed with any bytes: it may refuse them with an InputError or a ConvergenceError, and nothing else.
/// What must hold of what it accepts is checked inside; a broken promise is any other exception.
using FuzzTarget = std::function<void(std::string_view)>;

/// The targets by name: case, xrd-bgmn, xrd-gsas2, xrd-table, xrd-json, xrd, impacts, artifact, sweep,
/// quantity, solver.
[[nodiscard]] const std::map<std::string, FuzzTarget>& fuzz_targets();

/// Feeds a target; refusals end here.
void feed(const FuzzTarget& target, std::string_view bytes);

}  // namespace ashimpact::test

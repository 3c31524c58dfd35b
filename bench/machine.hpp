// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace ashimpact::bench {

/// Keeps this process, and what it starts, on one core. @throws std::runtime_error
void pin_to_one_core();
/// Lets it go where it likes again.
void unpin();

/// "model name" of the processor.
[[nodiscard]] std::string processor();

/// Seconds of CPU time of the programs this process has started and waited for.
[[nodiscard]] double children_seconds();

/// Wall seconds of one run of a program, its output dropped; the median of several. @throws
/// std::runtime_error
[[nodiscard]] double start_up_seconds(const std::vector<std::string>& command, int repetitions);

}  // namespace ashimpact::bench

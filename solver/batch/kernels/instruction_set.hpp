// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

namespace ashimpact {

/// Instruction sets this program was built for and this processor has, the best first: "avx512", "avx2",
/// "baseline".
[[nodiscard]] std::vector<std::string_view> instruction_sets();

/// Makes every later batch use this instruction set, for measurements and tests. No other thread may be in a
/// batch meanwhile. @param name empty: the best one again @throws InputError naming the available ones
void use_instruction_set(std::string_view name);

}  // namespace ashimpact

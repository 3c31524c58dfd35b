#pragma once

#include <string_view>
#include <vector>

namespace ashimpact {

/// Instruction sets this program was built for and this processor has, the best first: "avx512", "avx2",
/// "baseline".
[[nodiscard]] std::vector<std::string_view> instruction_sets();

/// Has every batch from now on use this instruction set; for measurements and tests, and no other thread may
/// be in a batch. Empty: the best again. @throws InputError naming those there are
void use_instruction_set(std::string_view name);

/// Chooses the best instruction set if none has been chosen yet: from then on a law's kernels are the same
/// functions.
void settle_instruction_set();

}  // namespace ashimpact

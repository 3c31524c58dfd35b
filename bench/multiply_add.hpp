// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace ashimpact::bench {

/// Multiply-adds of doubles, in every lane of the widest registers in use, with nothing else in the way: the
/// peak of a core.
/// @return how many were done
std::int64_t multiply_adds(std::int64_t rounds);

}  // namespace ashimpact::bench

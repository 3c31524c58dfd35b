// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "solver/statistics/moments.hpp"

namespace ashimpact {

/// Moments of each group of values, several groups in each instruction. Value i belongs to group
/// (first + i) % groups; values that are not a number are left out.
[[nodiscard]] std::vector<Moments> moments_by_group(std::span<const double> values, std::uint32_t groups,
                                                    std::uint64_t first);

/// Moments by group of a number that is 1 where a value is zero and 0 where it is not.
[[nodiscard]] std::vector<Moments> moments_of_zeros_by_group(std::span<const double> values,
                                                             std::uint32_t groups, std::uint64_t first);

}  // namespace ashimpact

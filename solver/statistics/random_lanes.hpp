// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "solver/statistics/philox.hpp"

namespace ashimpact {

/// Numbers of the interval (0, 1) for consecutive samples of one axis, several in each instruction: those
/// that unit_interval() makes of random_bits(), bit for bit.
/// @param first number of the first sample
void fill_uniform(std::uint64_t seed, std::uint64_t first, std::uint32_t axis, RandomStream stream,
                  std::span<double> values);

}  // namespace ashimpact

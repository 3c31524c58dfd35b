// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "solver/statistics/histogram.hpp"

namespace ashimpact {

/// What a histogram has to know of values before it counts them.
struct PositiveRange {
    std::uint64_t zeros;
    std::uint64_t positive;
    double least;     ///< of the positive values; infinite if there are none
    double greatest;  ///< of all values, at least 0
};
[[nodiscard]] PositiveRange positive_range(std::span<const double> values);

/// Numbers of bins, several in each instruction, as bin_of() gives them; values that are not positive get the
/// bin of @p otherwise.
void find_bins(const Bins& bins, std::span<const double> values, double otherwise, std::uint32_t* numbers);

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/batch/kernels/order.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

namespace ashimpact::batch {

namespace {

constexpr unsigned damping_bins = 32;
constexpr unsigned adhesion_bins = 8;

/// Bin of the adhesion number: powers of two from 1/32 to 2, as impacts change little below and above.
unsigned adhesion_bin(double number) {
    const auto exponent = static_cast<int>(std::bit_cast<std::uint64_t>(number) >> 52U) - 1023;
    return static_cast<unsigned>(std::clamp(exponent + 6, 0, static_cast<int>(adhesion_bins) - 1));
}

unsigned damping_bin(double number) {
    constexpr double width = 1.2 / damping_bins;
    return static_cast<unsigned>(std::clamp(number / width, 0.0, damping_bins - 1.0));
}

/// Number of an impact's bin. Rows of bins are numbered in alternating directions, so that consecutive bins
/// are neighbours.
unsigned bin_of(double adhesion, double damping) {
    const unsigned row = damping_bin(damping);
    const unsigned column = adhesion_bin(adhesion);
    return row * adhesion_bins + (row % 2 == 0 ? column : adhesion_bins - 1 - column);
}

}  // namespace

void Order::sort(const NumberColumns& numbers, std::span<const std::uint16_t> impacts) {
    if (impacts.size() <= 1) {
        std::ranges::copy(impacts, place_.begin());
        return;
    }
    std::array<std::uint16_t, damping_bins * adhesion_bins + 1> start{};
    std::array<std::uint16_t, most_impacts> bin;  // by impact; filled only for those to be sorted
    for (const std::size_t i : impacts) {
        bin[i] = static_cast<std::uint16_t>(bin_of(numbers.adhesion[i], numbers.damping[i]));
        ++start[bin[i] + 1U];
    }
    std::partial_sum(start.begin(), start.end(), start.begin());
    for (const std::uint16_t i : impacts) place_[start[bin[i]]++] = i;
}

}  // namespace ashimpact::batch

#include "solver/batch/order.hpp"

#include <algorithm>
#include <bit>

namespace ashimpact::batch {

namespace {

constexpr unsigned damping_bins = 32;
constexpr unsigned adhesion_bins = 8;

/// The adhesion number by powers of two, from 1/32 to 2: below and above them little changes.
unsigned adhesion_bin(double number) {
    const auto exponent = static_cast<int>(std::bit_cast<std::uint64_t>(number) >> 52U) - 1023;
    return static_cast<unsigned>(std::clamp(exponent + 6, 0, static_cast<int>(adhesion_bins) - 1));
}

unsigned damping_bin(double number) {
    constexpr double width = 1.2 / damping_bins;
    return static_cast<unsigned>(std::clamp(number / width, 0.0, damping_bins - 1.0));
}

/// Position of an impact in a walk to and fro through the bins, so that neighbours in it are neighbours.
unsigned key(double adhesion, double damping) {
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
    std::array<std::uint16_t, most_impacts> keys;  // those of the impacts are filled here
    for (const std::size_t i : impacts) {
        keys[i] = static_cast<std::uint16_t>(key(numbers.adhesion[i], numbers.damping[i]));
        ++start[keys[i] + 1U];
    }
    for (std::size_t bin = 1; bin < start.size(); ++bin) {
        start[bin] = static_cast<std::uint16_t>(start[bin] + start[bin - 1]);
    }
    for (const std::uint16_t i : impacts) place_[start[keys[i]]++] = i;
}

}  // namespace ashimpact::batch

#pragma once

#include <array>
#include <cstddef>

namespace ashimpact {

/// Weights that extrapolate results of 2, 4, ..., 2k substeps, whose error is a series in the substep squared, to
/// substep zero (Richardson 1911; Bulirsch & Stoer 1966). Those of one substep count less give the error estimate.
template <int sequences>
struct Extrapolation {
    std::array<double, static_cast<std::size_t>(sequences)> weight{};
    std::array<double, static_cast<std::size_t>(sequences)> difference{};  ///< to the weights without the finest

    constexpr Extrapolation() {
        for (int i = 1; i <= sequences; ++i) {
            weight[static_cast<std::size_t>(i - 1)] = of(i, sequences);
            difference[static_cast<std::size_t>(i - 1)] =
                of(i, sequences) - (i < sequences ? of(i, sequences - 1) : 0.0);
        }
    }

  private:
    static constexpr double of(int i, int count) {
        double product = 1.0;
        for (int j = 1; j <= count; ++j) {
            if (j != i) product *= static_cast<double>(i * i) / static_cast<double>(i * i - j * j);
        }
        return product;
    }
};

/// Which substep of which sequence of which group of lanes is done where: the substeps of one sequence wait for each
/// other, so sequences are strung into chains of equal length that have nothing to do with one another.
template <int sequences, int groups>
struct Chains {
    static_assert(groups == 2);
    static constexpr int per_group = (sequences + 1) / 2;  ///< with an even count the last one is shared
    static constexpr bool shared = sequences % 2 == 0;
    static constexpr int count = shared ? sequences + 1 : groups * per_group;
    static constexpr int length = 2 * sequences;

    [[nodiscard]] static constexpr bool is_shared(int chain) { return shared && chain == sequences; }

    struct Place {
        int group;
        int sequence;  ///< 1 for the one of two substeps
        int substep;   ///< 0 ... 2 sequence - 1
    };
    [[nodiscard]] static constexpr Place place(int chain, int slot) {
        if (is_shared(chain)) {  // half the slots for each group
            return {slot / sequences, sequences / 2, slot % sequences};
        }
        const int pair = chain / groups;
        const int longer = sequences - pair;
        if (slot < 2 * longer) return {chain % groups, longer, slot};
        return {chain % groups, pair, slot - 2 * longer};
    }
};

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

namespace ashimpact {

/// Weights that extrapolate results of 2, 4, ..., 2k substeps, whose error is a series in the substep
/// squared, to substep zero (Richardson 1911; Bulirsch & Stoer 1966). Those of one substep count less give
/// the error estimate.
template <int sequences>
struct Extrapolation {
    std::array<double, static_cast<std::size_t>(sequences)> weight{};
    std::array<double, static_cast<std::size_t>(sequences)>
        difference{};  ///< to the weights without the finest

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

}  // namespace ashimpact

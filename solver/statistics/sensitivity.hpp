// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "solver/statistics/moments.hpp"

namespace ashimpact {

/// A function evaluated for Sobol indices: at points a, at independent points b, and for each variable i at
/// points a with variable i taken from b. All of one length.
struct SensitivityValues {
    std::span<const double> a;
    std::span<const double> b;
    std::vector<std::span<const double>> mixed;
};

/// First-order and total index of one variable, with standard errors where there is more than one group [1].
struct SobolIndices {
    double first;  ///< part of the variance the variable explains alone
    double total;  ///< part of the variance that would be left if all others were known
    std::optional<double> first_error{};
    std::optional<double> total_error{};
};

/// Sums from which Sobol indices are estimated, of a group of points.
struct SobolSums {
    Moments values;                  ///< of the function at a and b
    std::vector<double> first;       ///< of f(b) (f(mixed) - f(a)): Saltelli et al. 2010, table 2 (b)
    std::vector<double> difference;  ///< of f(mixed) - f(a), which centres the former
    std::vector<double> total;       ///< of (f(a) - f(mixed))^2: Jansen 1999

    [[nodiscard]] static SobolSums of(const SensitivityValues& values);
    void merge(const SobolSums& other);

    template <class Archive>
    void transfer(Archive& archive) {
        archive(values, first, difference, total);
    }
};

/// The indices of every variable from the sums of each group; errors by leaving out one group at a time
/// (jackknife). None where the function does not vary.
[[nodiscard]] std::vector<SobolIndices> sobol_indices(std::span<const SobolSums> groups);

}  // namespace ashimpact

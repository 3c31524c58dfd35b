// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "solver/statistics/distribution.hpp"
#include "solver/statistics/interval.hpp"
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

/// A distribution from a value and its standard uncertainty, such as normal_around().
using DistributionAround = Distribution (*)(double value, double standard_uncertainty);

/// An uncertain input of a model. Inputs of one factor are ranked together.
struct RandomInput {
    std::string name;
    double value;                       ///< [SI]
    double standard_uncertainty = 0.0;  ///< [SI]; 0: exactly known
    DistributionAround distribution = normal_around;
    std::string factor{};  ///< empty: the input is a factor of its own
};

struct PropagationOptions {
    int samples = 128;       ///< points of the Sobol sequence in each replicate; a power of two is best
    int replicates = 8;      ///< randomly shifted copies; their scatter is the error of the estimates
    std::uint64_t seed = 1;  ///< of the shifts
};

/// A sensitivity index with its standard error.
struct SensitivityIndex {
    double value;
    double standard_error;
};

struct Influence {
    std::string factor;
    SensitivityIndex first;  ///< share of the variance that this factor explains alone
    SensitivityIndex total;  ///< share that it explains together with others
};

/// A result with its distribution under uncertain inputs.
struct Propagation {
    Interval interval;  ///< value at the inputs' values; standard deviation and quantiles of the samples
    std::array<double, 2> end_errors;  ///< standard errors of both ends by Monte Carlo
    double mean;
    double median;
    std::vector<Influence> influences;  ///< largest total first
    std::size_t evaluations;
    std::size_t undefined;  ///< samples without a result, which no other number includes
};

/// A computation whose result may not exist.
using UncertainModel = std::function<std::optional<double>(std::span<const double> inputs)>;

/// Propagates distributions through a model by Monte Carlo on a Sobol sequence whose digits are shifted at
/// random (see Design). First-order indices: Saltelli et al. 2010 (Comput. Phys. Commun.
/// 181:259, table 2b); total: Jansen 1999 (Comput. Phys. Commun. 117:35). Cost: samples x replicates x
/// (factors + 2) evaluations.
/// @throws InputError without uncertain inputs, or if the model has no result at the inputs' values
[[nodiscard]] Propagation propagate(const std::vector<RandomInput>& inputs, const UncertainModel& model,
                                    const PropagationOptions& options = {});

}  // namespace ashimpact

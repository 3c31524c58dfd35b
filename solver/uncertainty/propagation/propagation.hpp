#pragma once

#include "solver/uncertainty/interval.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ashimpact {

enum class InputShape {
    normal,
    lognormal,  ///< never negative: value is the median, standard_uncertainty/value that of the logarithm
    uniform,    ///< of this standard uncertainty: half width sqrt(3) of it
};

/// An input with its distribution. Inputs of one factor are ranked together.
struct RandomInput {
    std::string name;
    double value;                       ///< [SI]
    double standard_uncertainty = 0.0;  ///< [SI]; 0: exactly known
    InputShape shape = InputShape::normal;
    std::string factor{};  ///< empty: its own

    /// The value below which it falls with this probability. [SI]
    [[nodiscard]] double quantile(double probability) const;
};

struct PropagationOptions {
    int samples = 128;       ///< points of the quasi-random sequence in each replicate
    int replicates = 8;      ///< randomly shifted sequences; their scatter is the error of the estimates
    unsigned long seed = 1;  ///< of the shifts
};

/// A sensitivity index with its standard error.
struct SensitivityIndex {
    double value;
    double standard_error;
};

struct Influence {
    std::string factor;
    SensitivityIndex first;  ///< share of the variance that this factor explains alone
    SensitivityIndex total;  ///< share that it has a part in
};

/// A result with its distribution under uncertain inputs.
struct Propagation {
    Interval interval;  ///< value at the inputs' values; standard deviation and quantiles of the samples
    double mean;
    double median;
    std::vector<Influence> influences;  ///< largest total first
    std::size_t evaluations;
    std::size_t undefined;  ///< samples without a result: they are in no other number here
    std::string sequence;   ///< name of the quasi-random sequence
};

/// A computation whose result may not exist.
using UncertainModel = std::function<std::optional<double>(std::span<const double> inputs)>;

/// Propagates distributions through a model by Monte Carlo on a quasi-random sequence (Sobol, randomly
/// shifted: Cranley & Patterson 1976). First-order indices: Saltelli et al. 2010 (Comput. Phys. Commun.
/// 181:259, table 2b); total: Jansen 1999 (Comput. Phys. Commun. 117:35). Cost: samples x replicates x
/// (factors + 2) evaluations.
/// @throws InputError without uncertain inputs, or if the model has no result at the inputs' values
[[nodiscard]] Propagation propagate(const std::vector<RandomInput>& inputs, const UncertainModel& model,
                                    const PropagationOptions& options = {});

}  // namespace ashimpact

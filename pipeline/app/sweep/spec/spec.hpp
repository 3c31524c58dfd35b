// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/json/document.hpp"
#include "pipeline/app/sweep/spec/inputs.hpp"
#include "pipeline/case/case.hpp"
#include "solver/statistics/design.hpp"
#include "solver/statistics/histogram.hpp"

namespace ashimpact {

struct SweepVariable {
    ImpactInput input;
    Distribution distribution;  ///< [SI]
};

/// Statistics of an observable.
struct ObservableStatistics {
    Observable observable;
    Bins bins;
    std::vector<double> quantiles;  ///< probabilities
};

/// What a sweep computes.
struct SweepSpec {
    std::vector<LawChoice> laws;
    DampingLaw damping_law = DampingLaw::constant;
    std::vector<std::optional<double>> fixed =
        std::vector<std::optional<double>>(impact_input_count());  ///< inputs that do not vary [SI]
    std::vector<SweepVariable> variables;
    Sampling sampling{};
    std::vector<ObservableStatistics> statistics;  ///< `captured` first, always there
    std::vector<Observable> sensitivity;           ///< whose Sobol indices are wanted
    std::vector<Observable> table;                 ///< columns of the full table; empty: no table
    std::vector<std::string> warnings;
};

/// Whether an input stands in the sweep, as a constant or as a variable.
[[nodiscard]] bool is_given(const SweepSpec& spec, ImpactInput input);

/// A spec with its canonical text, which identifies it whatever its comments and layout.
struct LoadedSpec {
    SweepSpec spec;
    std::string canonical;
};

/// Reads and checks a spec. @throws InputError with the JSON pointer
[[nodiscard]] LoadedSpec read_sweep_spec(const std::string& text);

}  // namespace ashimpact

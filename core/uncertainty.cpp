// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/uncertainty.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ashimpact {

namespace {

std::vector<double> nominal_values(const std::vector<UncertainInput>& inputs) {
    std::vector<double> values;
    values.reserve(inputs.size());
    for (const UncertainInput& input : inputs) values.push_back(input.value);
    return values;
}

}  // namespace

std::vector<PropagatedUncertainty> propagate_linearly(
    const std::function<std::vector<double>(const std::vector<double>&)>& function,
    const std::vector<UncertainInput>& inputs) {
    constexpr double step_factor = 6e-6;  // third root of the rounding error
    std::vector<double> x = nominal_values(inputs);
    std::vector<PropagatedUncertainty> results(function(x).size());
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const double u = inputs[i].standard_uncertainty;
        if (u == 0) continue;
        const double step = step_factor * std::max(std::abs(inputs[i].value), u);
        x[i] = inputs[i].value + step;
        const std::vector<double> above = function(x);
        x[i] = inputs[i].value - step;
        const std::vector<double> below = function(x);
        x[i] = inputs[i].value;
        for (std::size_t k = 0; k < results.size(); ++k) {
            const double change = (above[k] - below[k]) / (2 * step) * u;
            results[k].contributions.push_back({.what = inputs[i].what, .share = change * change});
        }
    }
    for (PropagatedUncertainty& result : results) {
        double variance = 0;
        for (const Contribution& c : result.contributions) variance += c.share;
        result.standard_uncertainty = std::sqrt(variance);
        for (Contribution& c : result.contributions) c.share = variance == 0 ? 0 : c.share / variance;
        std::erase_if(result.contributions, [](const Contribution& c) { return c.share == 0; });
        std::stable_sort(result.contributions.begin(), result.contributions.end(),
                         [](const Contribution& a, const Contribution& b) { return a.share > b.share; });
    }
    return results;
}

}  // namespace ashimpact

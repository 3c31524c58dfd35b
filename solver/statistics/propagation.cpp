// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/statistics/propagation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "solver/numeric/gsl/statistics.hpp"
#include "solver/statistics/design.hpp"

namespace ashimpact {

namespace {

void add(std::vector<double>& sums, const std::vector<double>& other) {
    if (sums.empty()) sums.resize(other.size(), 0.0);
    for (std::size_t i = 0; i < other.size(); ++i) sums[i] += other[i];
}

/// Estimates without errors. The mean of f(b) is subtracted from each product: that does not change the
/// expectation, and removes the noise that a mean far from zero adds.
std::vector<SobolIndices> estimates(const SobolSums& sums) {
    const auto values = static_cast<double>(sums.values.count);
    const double points = values / 2;
    const double variance = sums.values.second / values;
    std::vector<SobolIndices> indices;
    if (!(variance > 0)) return indices;
    for (std::size_t i = 0; i < sums.first.size(); ++i)
        indices.push_back(
            {.first = (sums.first[i] - sums.values.mean * sums.difference[i]) / (points * variance),
             .total = sums.total[i] / (2 * points * variance)});
    return indices;
}

SobolSums merged_without(std::span<const SobolSums> groups, std::size_t left_out) {
    SobolSums sums;
    for (std::size_t g = 0; g < groups.size(); ++g)
        if (g != left_out) sums.merge(groups[g]);
    return sums;
}

/// Standard error from estimates that each leave out one group: sqrt((g - 1)/g sum (x - mean)^2).
double jackknife_error(std::span<const double> values) {
    const Moments moments = Moments::of(values);
    return std::sqrt(moments.second * static_cast<double>(values.size() - 1) /
                     static_cast<double>(values.size()));
}

/// Errors of two quantiles of samples: the root mean square of two estimates, of which one leaves out one
/// replicate after the other and scatters, and the other, from the quantiles of the replicates by themselves,
/// is biased where the tails of these hold few samples.
/// @param begins where each replicate begins in the samples
std::array<double, 2> end_errors(const std::vector<double>& samples, const std::vector<std::size_t>& begins,
                                 const std::array<double, 2>& fractions) {
    std::vector<std::pair<double, std::size_t>> sorted;  // each with its replicate; sorted once for all
    for (std::size_t i = 0, replicate = 0; i < samples.size(); ++i) {
        if (replicate + 1 < begins.size() && i == begins[replicate + 1]) ++replicate;
        sorted.emplace_back(samples[i], replicate);
    }
    std::ranges::sort(sorted);
    std::array<std::vector<double>, 2> without_one;
    std::array<std::vector<double>, 2> alone;
    for (std::size_t number = 0; number < begins.size(); ++number) {
        std::vector<double> others;
        std::vector<double> own;
        for (const auto& [value, replicate] : sorted) (replicate == number ? own : others).push_back(value);
        const std::vector<double> of_others = gsl::quantiles(std::move(others), fractions);
        const std::vector<double> of_own = gsl::quantiles(std::move(own), fractions);
        for (std::size_t end = 0; end < 2; ++end) {
            without_one[end].push_back(of_others[end]);
            alone[end].push_back(of_own[end]);
        }
    }
    const auto error = [&](std::size_t end) {
        const double jackknife = jackknife_error(without_one[end]);
        const double of_mean =
            std::sqrt(Moments::of(alone[end]).variance() / static_cast<double>(begins.size()));
        return std::sqrt(0.5 * (jackknife * jackknife + of_mean * of_mean));
    };
    return {error(0), error(1)};
}

/// Inputs that vary together.
struct Factor {
    std::string name;
    std::vector<std::size_t> inputs;
};

std::vector<Factor> factors_of(const std::vector<RandomInput>& inputs) {
    std::vector<Factor> factors;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (inputs[i].standard_uncertainty == 0.0) continue;
        const std::string& name = inputs[i].factor.empty() ? inputs[i].name : inputs[i].factor;
        auto factor = std::ranges::find(factors, name, &Factor::name);
        if (factor == factors.end()) factor = factors.insert(factors.end(), {name, {}});
        factor->inputs.push_back(i);
    }
    return factors;
}

void validate(const std::vector<RandomInput>& inputs, const PropagationOptions& options) {
    for (const RandomInput& input : inputs) {
        const bool finite = std::isfinite(input.value) && std::isfinite(input.standard_uncertainty);
        if (!finite || input.standard_uncertainty < 0.0)
            throw InputError(
                "input " + in_quotes(input.name) + " is not finite or has a negative uncertainty",
                "finite numbers, uncertainty >= 0");
        if (input.distribution == &lognormal_around && !(input.value > 0.0))
            throw InputError("input " + in_quotes(input.name) + " is " + shortest(input.value),
                             "> 0 for a lognormal distribution");
    }
    if (options.samples < 2 || options.replicates < 2)
        throw InputError("propagation with fewer than 2 samples or replicates", "at least 2 of each");
}

/// Results of the model at points A and B, and at A with the inputs of one factor taken from B: a column each
/// of A, B, AB_1, AB_2, ...
struct Replicate {
    std::vector<std::vector<double>> columns;
    std::size_t undefined = 0;  ///< points left out, as at least one of their results does not exist
};

/// Evaluates the model at the points of a design.
class PropagationSampler {
  public:
    PropagationSampler(const std::vector<RandomInput>& inputs, const UncertainModel& model,
                       const PropagationOptions& options)
        : model_(model), factors_(factors_of(inputs)), replicates_(size_of(options.replicates)) {
        if (factors_.empty()) throw InputError("no input is uncertain", "at least one uncertainty > 0");
        for (const RandomInput& input : inputs) nominal_.push_back(input.value);
        draw(inputs, options);
    }

    [[nodiscard]] const std::vector<Factor>& factors() const { return factors_; }
    [[nodiscard]] const std::vector<double>& nominal() const { return nominal_; }

    [[nodiscard]] Replicate replicate(std::size_t number) const {
        Replicate result{.columns = std::vector<std::vector<double>>(factors_.size() + 2)};
        for (std::size_t point = number; point < columns_.front().a.size(); point += replicates_) {
            const auto row = results_at(point);
            if (!row) ++result.undefined;
            for (std::size_t i = 0; row && i < row->size(); ++i) result.columns[i].push_back((*row)[i]);
        }
        return result;
    }

  private:
    /// An uncertain input, and its values at the points of both samples.
    struct Column {
        std::size_t input;
        std::vector<double> a;
        std::vector<double> b;
    };

    static std::size_t size_of(int number) { return static_cast<std::size_t>(number); }

    void draw(const std::vector<RandomInput>& inputs, const PropagationOptions& options) {
        std::vector<Distribution> distributions;
        for (const Factor& factor : factors_) {
            for (const std::size_t i : factor.inputs) {
                distributions.push_back(
                    inputs[i].distribution(inputs[i].value, inputs[i].standard_uncertainty));
                columns_.push_back({.input = i, .a = {}, .b = {}});
            }
        }
        const std::size_t points = size_of(options.samples) * replicates_;
        const Design design(std::move(distributions),
                            {.method = SamplingMethod::quasi_random,
                             .points = points,
                             .seed = options.seed,
                             .shifts = static_cast<std::uint32_t>(replicates_)},
                            2);
        for (std::size_t variable = 0; variable < columns_.size(); ++variable) {
            Column& column = columns_[variable];
            column.a.resize(points);
            column.b.resize(points);
            design.fill(0, variable, 0, column.a);
            design.fill(1, variable, 0, column.b);
        }
    }

    /// Results at A, B, AB_1, ...; none unless all of them exist.
    [[nodiscard]] std::optional<std::vector<double>> results_at(std::size_t point) const {
        std::vector<double> a = nominal_;
        std::vector<double> b = nominal_;
        for (const Column& column : columns_) {
            a[column.input] = column.a[point];
            b[column.input] = column.b[point];
        }
        std::vector<double> results;
        const auto evaluate = [&](const std::vector<double>& values) {
            const std::optional<double> result = model_(values);
            if (result && std::isfinite(*result)) results.push_back(*result);
        };
        evaluate(a);
        evaluate(b);
        for (const Factor& factor : factors_) {
            std::vector<double> mixed = a;
            for (const std::size_t i : factor.inputs) mixed[i] = b[i];
            evaluate(mixed);
        }
        if (results.size() < factors_.size() + 2) return std::nullopt;
        return results;
    }

    const UncertainModel& model_;
    std::vector<Factor> factors_;
    std::size_t replicates_;
    std::vector<double> nominal_;
    std::vector<Column> columns_;
};

/// @param replicates at least two; where nothing varies no factor has an influence
std::vector<Influence> influences_of(const std::vector<Factor>& factors,
                                     const std::vector<SobolSums>& replicates) {
    const std::vector<SobolIndices> indices = sobol_indices(replicates);
    std::vector<Influence> influences;
    for (std::size_t i = 0; i < indices.size(); ++i)
        influences.push_back({factors[i].name,
                              {indices[i].first, indices[i].first_error.value_or(0.0)},
                              {indices[i].total, indices[i].total_error.value_or(0.0)}});
    // Shares that are rounding alone keep the order of the factors.
    const auto rank = [](const Influence& of) { return std::round(1e9 * of.total.value); };
    std::stable_sort(influences.begin(), influences.end(),
                     [&](const Influence& a, const Influence& b) { return rank(a) > rank(b); });
    return influences;
}

}  // namespace

SobolSums SobolSums::of(const SensitivityValues& values) {
    SobolSums sums;
    const std::span<const double> a = values.a;
    const std::span<const double> b = values.b;
    const std::size_t points = a.size();
    sums.values = Moments::of(a);
    sums.values.merge(Moments::of(b));
    for (const auto& ab : values.mixed) {
        const auto change = [&](std::size_t i) { return ab[i] - a[i]; };
        sums.first.push_back(pairwise_sum(0, points, [&](std::size_t i) { return b[i] * change(i); }));
        sums.difference.push_back(pairwise_sum(0, points, change));
        sums.total.push_back(pairwise_sum(0, points, [&](std::size_t i) { return change(i) * change(i); }));
    }
    return sums;
}

void SobolSums::merge(const SobolSums& other) {
    values.merge(other.values);
    add(first, other.first);
    add(difference, other.difference);
    add(total, other.total);
}

std::vector<SobolIndices> sobol_indices(std::span<const SobolSums> groups) {
    std::vector<SobolIndices> indices = estimates(merged_without(groups, groups.size()));
    if (groups.size() < 2) return indices;
    std::vector<std::vector<SobolIndices>> partial;
    for (std::size_t g = 0; g < groups.size(); ++g) {
        partial.push_back(estimates(merged_without(groups, g)));
        if (partial.back().empty()) return indices;
    }
    std::vector<double> values(partial.size());
    const auto error_of = [&](std::size_t variable, double SobolIndices::*index) {
        std::transform(partial.begin(), partial.end(), values.begin(),
                       [&](const auto& each) { return each[variable].*index; });
        return jackknife_error(values);
    };
    for (std::size_t i = 0; i < indices.size(); ++i) {
        indices[i].first_error = error_of(i, &SobolIndices::first);
        indices[i].total_error = error_of(i, &SobolIndices::total);
    }
    return indices;
}

Propagation propagate(const std::vector<RandomInput>& inputs, const UncertainModel& model,
                      const PropagationOptions& options) {
    validate(inputs, options);
    const PropagationSampler sampler(inputs, model, options);
    const std::optional<double> value = model(sampler.nominal());
    if (!value) throw InputError("the propagated result does not exist at the values of the inputs");

    Propagation result{};
    std::vector<SobolSums> replicates;
    std::vector<double> samples;
    std::vector<std::size_t> begins;  ///< of each replicate in the samples
    for (int i = 0; i < options.replicates; ++i) {
        const auto [columns, undefined] = sampler.replicate(static_cast<std::size_t>(i));
        const std::vector<double>& a = columns[0];
        const std::vector<double>& b = columns[1];
        result.undefined += undefined;
        result.evaluations += (a.size() + undefined) * columns.size();
        if (a.size() < 2) continue;
        begins.push_back(samples.size());
        replicates.push_back(SobolSums::of({a, b, {columns.begin() + 2, columns.end()}}));
        for (std::size_t point = 0; point < a.size(); ++point)
            samples.insert(samples.end(), {a[point], b[point]});
    }
    if (replicates.size() < 2) throw ConvergenceError("propagation: nearly every sample is without a result");

    constexpr std::array fractions{0.5 - 0.5 * confidence, 0.5, 0.5 + 0.5 * confidence};
    const Moments moments = Moments::of(samples);
    const std::vector<double> quantiles = gsl::quantiles(samples, fractions);
    result.interval = {*value, std::sqrt(moments.variance()), quantiles[0], quantiles[2]};
    result.end_errors = end_errors(samples, begins, {fractions[0], fractions[2]});
    result.mean = moments.mean;
    result.median = quantiles[1];
    result.influences = influences_of(sampler.factors(), replicates);
    return result;
}

}  // namespace ashimpact

#include "solver/uncertainty/propagation/propagation.hpp"

#include "materials/base/error.hpp"
#include "materials/base/text.hpp"
#include "solver/gsl/distribution.hpp"
#include "solver/gsl/quasi_random.hpp"
#include "solver/gsl/random.hpp"
#include "solver/gsl/statistics.hpp"
#include "solver/statistics/sensitivity.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace ashimpact {

namespace {

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
        const auto same = [&](const Factor& factor) { return factor.name == name; };
        auto factor = std::find_if(factors.begin(), factors.end(), same);
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
        if (input.shape == InputShape::lognormal && !(input.value > 0.0))
            throw InputError("input " + in_quotes(input.name) + " is " + shortest(input.value),
                             "> 0 for a lognormal distribution");
    }
    if (options.samples < 2 || options.replicates < 2)
        throw InputError("propagation with fewer than 2 samples or replicates", "at least 2 of each");
}

/// The model at rows A, B and at A with the columns of one factor from B (A, B, AB_1, AB_2, ...).
struct Row {
    std::vector<double> results;
    bool complete = true;
};

class Sampler {
  public:
    Sampler(const std::vector<RandomInput>& inputs, const UncertainModel& model, std::vector<Factor> factors)
        : inputs_(inputs), model_(model), factors_(std::move(factors)) {
        for (const Factor& factor : factors_) random_ += static_cast<int>(factor.inputs.size());
    }

    [[nodiscard]] int random_inputs() const { return random_; }
    [[nodiscard]] const std::vector<Factor>& factors() const { return factors_; }

    /// @param point 2 x random_inputs() numbers in (0, 1)
    [[nodiscard]] Row row(std::span<const double> point) const {
        std::vector<double> a = values_of(point.first(point.size() / 2));
        const std::vector<double> b = values_of(point.last(point.size() / 2));
        Row row;
        evaluate(a, row);
        evaluate(b, row);
        for (const Factor& factor : factors_) {
            std::vector<double> mixed = a;
            for (const std::size_t i : factor.inputs) mixed[i] = b[i];
            evaluate(mixed, row);
        }
        return row;
    }

  private:
    [[nodiscard]] std::vector<double> values_of(std::span<const double> probabilities) const {
        std::vector<double> values;
        for (const RandomInput& input : inputs_) values.push_back(input.value);
        auto next = probabilities.begin();
        for (const Factor& factor : factors_) {
            for (const std::size_t i : factor.inputs) values[i] = inputs_[i].quantile(*next++);
        }
        return values;
    }
    void evaluate(const std::vector<double>& values, Row& row) const {
        const std::optional<double> result = model_(values);
        row.complete = row.complete && result && std::isfinite(*result);
        row.results.push_back(result.value_or(0.0));
    }

    const std::vector<RandomInput>& inputs_;
    const UncertainModel& model_;
    std::vector<Factor> factors_;
    int random_ = 0;
};

SobolSums sums_of(const std::vector<Row>& rows, std::size_t factors) {
    std::vector<std::vector<double>> columns(factors + 2);
    for (const Row& row : rows)
        for (std::size_t i = 0; i < columns.size(); ++i) columns[i].push_back(row.results[i]);
    return SobolSums::of({columns[0], columns[1], {columns.begin() + 2, columns.end()}});
}

/// @param replicates at least two; where nothing varies no factor has an influence
std::vector<Influence> influences_of(const std::vector<Factor>& factors,
                                     const std::vector<SobolSums>& replicates) {
    const std::vector<SobolIndices> indices = sobol_indices(replicates);
    std::vector<Influence> influences;
    for (std::size_t i = 0; i < indices.size(); ++i) {
        influences.push_back({factors[i].name,
                              {indices[i].first, indices[i].first_error.value_or(0.0)},
                              {indices[i].total, indices[i].total_error.value_or(0.0)}});
    }
    std::stable_sort(influences.begin(), influences.end(),
                     [](const Influence& x, const Influence& y) { return x.total.value > y.total.value; });
    return influences;
}

/// One replicate: the sequence from its beginning, shifted around the unit cube.
std::vector<Row> replicate(const Sampler& sampler, int samples, gsl::Random& random) {
    const int dimensions = 2 * sampler.random_inputs();
    std::vector<double> shift;
    for (int i = 0; i < dimensions; ++i) shift.push_back(random.uniform(0.0, 1.0));
    gsl::QuasiRandom sequence(dimensions);
    std::vector<double> point(shift.size());
    std::vector<Row> rows;
    for (int i = 0; i < samples; ++i) {
        sequence.next(point);
        for (std::size_t j = 0; j < point.size(); ++j) {
            const double shifted = point[j] + shift[j];
            point[j] = std::clamp(shifted - std::floor(shifted), 1e-12, 1.0 - 1e-12);
        }
        rows.push_back(sampler.row(point));
    }
    return rows;
}

}  // namespace

double RandomInput::quantile(double probability) const {
    switch (shape) {
        case InputShape::normal:
            return value + standard_uncertainty * gsl::normal_quantile(probability);
        case InputShape::lognormal:
            return gsl::lognormal_quantile(probability, std::log(value), standard_uncertainty / value);
        case InputShape::uniform: {
            const double half = std::sqrt(3.0) * standard_uncertainty;
            return gsl::uniform_quantile(probability, value - half, value + half);
        }
    }
    return value;
}

Propagation propagate(const std::vector<RandomInput>& inputs, const UncertainModel& model,
                      const PropagationOptions& options) {
    validate(inputs, options);
    const Sampler sampler(inputs, model, factors_of(inputs));
    if (sampler.factors().empty()) throw InputError("no input is uncertain", "at least one uncertainty > 0");
    std::vector<double> nominal;
    for (const RandomInput& input : inputs) nominal.push_back(input.value);
    const std::optional<double> value = model(nominal);
    if (!value) throw InputError("the propagated result does not exist at the values of the inputs");

    Propagation result{};
    gsl::Random random(options.seed);
    std::vector<SobolSums> replicates;
    std::vector<double> samples;
    for (int i = 0; i < options.replicates; ++i) {
        std::vector<Row> rows = replicate(sampler, options.samples, random);
        const std::size_t all = rows.size();
        std::erase_if(rows, [](const Row& row) { return !row.complete; });
        result.undefined += all - rows.size();
        result.evaluations += all * (sampler.factors().size() + 2);
        if (rows.size() < 2) continue;
        replicates.push_back(sums_of(rows, sampler.factors().size()));
        for (const Row& row : rows) samples.insert(samples.end(), {row.results[0], row.results[1]});
    }
    if (replicates.size() < 2) throw ConvergenceError("propagation: nearly every sample is without a result");

    constexpr std::array fractions{0.5 - 0.5 * confidence, 0.5, 0.5 + 0.5 * confidence};
    const gsl::Moments moments = gsl::moments(samples);
    const std::vector<double> quantiles = gsl::quantiles(samples, fractions);
    result.interval = {*value, moments.deviation, quantiles[0], quantiles[2]};
    result.mean = moments.mean;
    result.median = quantiles[1];
    result.influences = influences_of(sampler.factors(), replicates);
    result.sequence = gsl::QuasiRandom(2 * sampler.random_inputs()).name();
    return result;
}

}  // namespace ashimpact

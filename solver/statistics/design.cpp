// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/statistics/design.hpp"

#include <bit>
#include <limits>

#include <boost/random/niederreiter_base2.hpp>
#include <boost/random/sobol.hpp>

#include "core/text/error.hpp"

namespace ashimpact {

namespace {

/// The direction numbers of each axis. Point 2^j has the Gray code 2^j + 2^(j-1), so it is the exclusive or
/// of the directions j and j - 1, which gives one from the other.
template <class Engine>
std::vector<std::vector<std::uint64_t>> directions_of(std::size_t dimension, std::size_t bits) {
    Engine engine(dimension);
    std::vector<std::vector<std::uint64_t>> directions(dimension, std::vector<std::uint64_t>(bits));
    for (std::size_t bit = 0; bit < bits; ++bit) {
        engine.seed((std::uint64_t{1} << bit) - 1);  // Boost leaves the origin out: its point 0 is our 1
        for (auto& axis : directions) axis[bit] = engine() ^ (bit == 0 ? 0 : axis[bit - 1]);
    }
    return directions;
}

/// Groups of random points, for estimates of errors.
constexpr std::uint32_t random_groups = 16;

const std::vector<double>& choices_of(const Distribution& variable) {
    const auto* choice = std::get_if<Choice>(&variable);
    if (choice == nullptr)
        throw InputError("a variable of a grid is a distribution",
                         "values or a grid, or another sampling method");
    return choice->values;
}

std::uint64_t grid_points(const std::vector<Distribution>& variables) {
    std::uint64_t points = 1;
    for (const Distribution& variable : variables) {
        const std::uint64_t count = choices_of(variable).size();
        if (points > std::numeric_limits<std::uint64_t>::max() / count)
            throw InputError("the grid has more points than can be counted", "fewer points");
        points *= count;
    }
    return points;
}

}  // namespace

std::size_t DigitalSequence::greatest_dimension(QuasiRandomSequence sequence) {
    return sequence == QuasiRandomSequence::sobol ? BOOST_RANDOM_SOBOL_MAX_DIMENSION
                                                  : BOOST_RANDOM_NIEDERREITER_BASE2_MAX_DIMENSION;
}

DigitalSequence::DigitalSequence(QuasiRandomSequence sequence, std::size_t dimension) {
    if (dimension < 1 || dimension > greatest_dimension(sequence))
        throw InputError("the quasi-random sequence has " + std::to_string(dimension) + " dimensions",
                         "1 to " + std::to_string(greatest_dimension(sequence)));
    directions_ = sequence == QuasiRandomSequence::sobol
                      ? directions_of<boost::random::sobol>(dimension, bits)
                      : directions_of<boost::random::niederreiter_base2>(dimension, bits);
}

void DigitalSequence::fill(std::size_t axis, std::uint64_t first, std::span<std::uint64_t> points) const {
    const auto& direction = directions_[axis];
    std::uint64_t point = 0;
    for (std::uint64_t gray = first ^ (first >> 1U); gray != 0; gray &= gray - 1)
        point ^= direction[static_cast<std::size_t>(std::countr_zero(gray))];
    for (std::uint64_t& each : points) {
        each = point;
        point ^= direction[static_cast<std::size_t>(
            std::countr_zero(++first))];  // the bit in which the codes differ
    }
}

Design::Design(std::vector<Distribution> variables, const Sampling& sampling, std::size_t samples)
    : variables_(std::move(variables)), sampling_(sampling), samples_(samples) {
    const std::size_t axes = samples_ * variables_.size();
    switch (sampling_.method) {
        case SamplingMethod::grid:
            sampling_.points = grid_points(variables_);
            return;
        case SamplingMethod::random:
            groups_ = random_groups;
            return;
        case SamplingMethod::quasi_random:
            break;
    }
    groups_ = sampling_.shifts;
    sequence_.emplace(sampling_.sequence, axes);
    shifts_.assign(axes, std::vector<std::uint64_t>(groups_));
    for (std::size_t axis = 0; axis < axes; ++axis)
        for (std::uint32_t copy = 0; copy < groups_; ++copy)
            shifts_[axis][copy] =
                random_bits(sampling_.seed, copy, static_cast<std::uint32_t>(axis), RandomStream::shifts)[0];
}

void Design::fill(std::size_t sample, std::size_t variable, std::uint64_t first,
                  std::span<double> values) const {
    const std::size_t axis = sample * variables_.size() + variable;
    switch (sampling_.method) {
        case SamplingMethod::grid:
            fill_grid(variable, first, values);
            return;
        case SamplingMethod::random:
            fill_uniform(sampling_.seed, first, static_cast<std::uint32_t>(axis), RandomStream::points,
                         values);
            break;
        case SamplingMethod::quasi_random:
            fill_quasi_random(axis, first, values);
            break;
    }
    to_quantiles(variables_[variable], values);
}

void Design::fill_grid(std::size_t variable, std::uint64_t first, std::span<double> values) const {
    std::uint64_t stride = 1;  // points between two values of this variable
    for (std::size_t later = variable + 1; later < variables_.size(); ++later)
        stride *= choices_of(variables_[later]).size();
    const auto& grid = choices_of(variables_[variable]);
    for (double& value : values) value = grid[first++ / stride % grid.size()];
}

void Design::fill_quasi_random(std::size_t axis, std::uint64_t first, std::span<double> values) const {
    std::vector<std::uint64_t> points((values.size() + groups_ - 1) / groups_);
    for (std::size_t start = 0; start < groups_ && start < values.size(); ++start) {
        const std::uint64_t number = first + start;
        const std::span<std::uint64_t> taken(points.data(), (values.size() - start + groups_ - 1) / groups_);
        sequence_->fill(axis, number / groups_, taken);
        const std::uint64_t shift = shifts_[axis][number % groups_];
        for (std::size_t i = 0; i < taken.size(); ++i)
            values[start + i * groups_] = unit_interval(taken[i] ^ shift);
    }
}

}  // namespace ashimpact

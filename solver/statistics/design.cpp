// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/statistics/design.hpp"

#include <bit>
#include <limits>
#include <type_traits>

#include <boost/random/niederreiter_base2.hpp>
#include <boost/random/sobol.hpp>

// This file once more for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solver/statistics/design.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "core/text/error.hpp"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Words = hn::ScalableTag<std::uint64_t>;
using Halves = hn::Repartition<std::uint32_t, Words>;
using Word = hn::Vec<Words>;

constexpr int rounds = 10;

/// The keys of the rounds of philox(), in the lower halves of words.
struct Keys {
    Word first[rounds];
    Word second[rounds];

    explicit Keys(std::uint64_t seed) {
        const Words d;
        auto key0 = static_cast<std::uint32_t>(seed);
        auto key1 = static_cast<std::uint32_t>(seed >> 32U);
        for (int round = 0; round < rounds; ++round) {
            first[round] = hn::Set(d, key0);
            second[round] = hn::Set(d, key1);
            key0 += 0x9E3779B9;
            key1 += 0xBB67AE85;
        }
    }
};

/// What philox() makes of one counter in each lane: its four parts, in the lower halves of words. The upper
/// halves of even and odd parts hold anything.
struct Counters {
    Word part[4];

    Counters() = default;
    HWY_INLINE Counters(Word pair, std::uint32_t axis, std::uint32_t stream) {
        const Words d;
        part[0] = pair;
        part[1] = hn::ShiftRight<32>(pair);
        part[2] = hn::Set(d, axis);
        part[3] = hn::Set(d, stream);
    }

    HWY_INLINE void round(Word key0, Word key1) {
        const Words d;
        const Halves halves;
        const auto product = [&](Word a, std::uint64_t factor) HWY_ATTR {
            return hn::MulEven(hn::BitCast(halves, a), hn::BitCast(halves, hn::Set(d, factor)));
        };
        const Word even = product(part[0], 0xD2511F53);
        const Word odd = product(part[2], 0xCD9E8D57);
        part[0] = hn::Xor3(hn::ShiftRight<32>(odd), part[1], key0);
        part[1] = odd;
        part[2] = hn::Xor3(hn::ShiftRight<32>(even), part[3], key1);
        part[3] = even;
    }
};

/// unit_interval() of the word of two parts.
HWY_INLINE hn::Vec<hn::ScalableTag<double>> unit_interval_of(Word lower, Word upper) {
    const Words d;
    const hn::ScalableTag<double> doubles;
    const Word word = hn::Or(hn::And(lower, hn::Set(d, 0xFFFFFFFF)), hn::ShiftLeft<32>(upper));
    // The upper 52 bits as digits of a number from 1 to 2: both operations that follow are exact.
    const Word digits = hn::Or(hn::ShiftRight<12>(word), hn::Set(d, 0x3FF0000000000000));
    const auto from_zero = hn::Sub(hn::BitCast(doubles, digits), hn::Set(doubles, 1.0));
    return hn::Add(from_zero, hn::Set(doubles, 0x1p-53));
}

/// Fills in the pairs of some registers of counters.
template <std::size_t registers>
HWY_INLINE void fill_registers(const Keys& keys, Word first, std::uint32_t axis, std::uint32_t stream,
                               double* values) {
    const Words d;
    Counters counters[registers];
#pragma GCC unroll 8
    for (std::size_t k = 0; k < registers; ++k)
        counters[k] = Counters(hn::Add(first, hn::Set(d, k * hn::Lanes(d))), axis, stream);
    for (int round = 0; round < rounds; ++round) {
#pragma GCC unroll 8
        for (std::size_t k = 0; k < registers; ++k) counters[k].round(keys.first[round], keys.second[round]);
    }
#pragma GCC unroll 8
    for (std::size_t k = 0; k < registers; ++k)  // the two samples of each counter, side by side
        hn::StoreInterleaved2(unit_interval_of(counters[k].part[0], counters[k].part[1]),
                              unit_interval_of(counters[k].part[2], counters[k].part[3]),
                              hn::ScalableTag<double>(), values + 2 * k * hn::Lanes(d));
}

}  // namespace

/// Fills in pairs of samples, as many as whole registers hold. @return how many values those are
std::size_t fill_pairs(std::uint64_t seed, std::uint64_t first_pair, std::uint32_t axis, std::uint32_t stream,
                       double* values, std::size_t count) {
    const Words d;
    const std::size_t lanes = hn::Lanes(d);
    const Keys keys(seed);
    const Word first_pairs = hn::Iota(d, first_pair);
    std::size_t done = 0;
    const auto fill = [&](auto registers) HWY_ATTR {
        const std::size_t together = 2 * lanes * registers();
        for (; done + together <= count; done += together)
            fill_registers<registers()>(keys, hn::Add(first_pairs, hn::Set(d, done / 2)), axis, stream,
                                        values + done);
    };
    // A round is a chain of operations: several at once hide each other's latency.
    fill(std::integral_constant<std::size_t, 4>{});
    fill(std::integral_constant<std::size_t, 1>{});
    return done;
}

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#else
namespace ashimpact::HWY_NAMESPACE {
std::size_t fill_pairs(std::uint64_t, std::uint64_t, std::uint32_t, std::uint32_t, double*, std::size_t) {
    return 0;
}
}  // namespace ashimpact::HWY_NAMESPACE
#endif

#if HWY_ONCE
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

HWY_EXPORT(fill_pairs);

void fill_uniform(std::uint64_t seed, std::uint64_t first, std::uint32_t axis, RandomStream stream,
                  std::span<double> values) {
    const auto bits_of = [&](std::size_t i) { return random_bits(seed, (first + i) / 2, axis, stream); };
    std::size_t i = 0;
    if (first % 2 == 1 && !values.empty()) values[i++] = unit_interval(bits_of(0)[1]);
    i += HWY_DYNAMIC_DISPATCH(fill_pairs)(seed, (first + i) / 2, axis, static_cast<std::uint32_t>(stream),
                                          values.data() + i, values.size() - i);
    for (; i < values.size(); i += 2) {
        const auto bits = bits_of(i);
        values[i] = unit_interval(bits[0]);
        if (i + 1 < values.size()) values[i + 1] = unit_interval(bits[1]);
    }
}

}  // namespace ashimpact
#endif

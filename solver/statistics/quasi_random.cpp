// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/statistics/quasi_random.hpp"

#include <bit>

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

}  // namespace ashimpact

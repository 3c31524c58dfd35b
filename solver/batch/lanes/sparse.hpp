// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>

#include "solver/batch/lanes/symbol.hpp"

namespace ashimpact {

/// A set of powers of one variable; bit k stands for x^k.
using PowerSet = std::uint64_t;

[[nodiscard]] constexpr PowerSet power_bit(int power) {
    return PowerSet{1} << power;
}
[[nodiscard]] constexpr bool contains(PowerSet set, int power) {
    return ((set >> power) & 1U) != 0;
}
[[nodiscard]] constexpr int highest(PowerSet set) {
    int power = 0;
    while ((set >> power) > 1) ++power;
    return power;
}

/// The smaller factor i of x^power = x^i x^(power-i) with both in the set, as balanced as possible; 0 if
/// none.
[[nodiscard]] constexpr int factor_of(PowerSet set, int power) {
    for (int i = power / 2; i >= 1; --i) {
        if (contains(set, i) && contains(set, power - i)) return i;
    }
    return 0;
}

/// The set, completed so that every member but x is the product of two lower members.
[[nodiscard]] constexpr PowerSet closed(PowerSet set) {
    set = (set | power_bit(1)) & ~power_bit(0);
    for (int power = highest(set); power > 1; --power) {
        if (contains(set, power) && factor_of(set, power) == 0) {
            set |= power_bit(power / 2) | power_bit(power - power / 2);
        }
    }
    return set;
}

/// The powers with which the state occurs in a polynomial, highest first.
struct Terms {
    std::array<int, Symbol::states> power{};
    int count = 0;

    /// Common distance of the powers; with one power alone that power.
    [[nodiscard]] constexpr int stride() const {
        int distance = count == 1 ? power[0] : 0;
        for (int i = 1; i < count; ++i) distance = std::gcd(distance, at(i - 1) - at(i));
        return distance;
    }
    [[nodiscard]] constexpr int at(int i) const { return power[static_cast<std::size_t>(i)]; }
    [[nodiscard]] constexpr int lowest() const { return at(count - 1); }
};

/// A polynomial of the state as lowest power times a monic polynomial in x^stride.
template <const Symbol& symbol, bool with_constant>
struct Sparse {
    static constexpr Terms terms = [] {
        Terms found;
        for (int i = symbol.degree(); i >= (with_constant ? 0 : 1); --i) {
            if (symbol.has(i)) found.power[static_cast<std::size_t>(found.count++)] = i;
        }
        return found;
    }();
    static_assert(terms.count > 0);
    /// Leading coefficient; no law has A in it.
    static constexpr double leading = symbol.at(terms.at(0), 0);
    static_assert(leading != 0.0);

    /// Powers of the state that evaluate() needs.
    static constexpr PowerSet powers = [] {
        if (terms.count == 1) {
            const int power = terms.at(0);
            return power == 0 ? PowerSet{0} : power_bit(power - power / 2) | power_bit(power / 2);
        }
        PowerSet set = terms.lowest() > 0 ? power_bit(terms.lowest()) : PowerSet{0};
        const int stride = terms.stride();
        if (terms.count > 2) return set | power_bit(stride);
        return contains(set, stride) ? set : set | power_bit(stride - stride / 2) | power_bit(stride / 2);
    }();
};

}  // namespace ashimpact

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "solver/motion/branches/motion_state.hpp"
#include "solver/numeric/series.hpp"

namespace ashimpact {

/// Terms of an expansion that need all the digits of a number type wider than double. A step of radius/e^2
/// takes less than a part in 10^6 from the others, of which double has digits beyond those of the whole.
inline constexpr std::size_t leading_terms = 8;

/// The first @p count terms, in another number type.
template <class From, class To>
void copy_terms(const From& from, To& to, std::size_t count) {
    using Number = typename To::value_type;
    for (std::size_t n = 0; n < count; ++n) to[n] = static_cast<Number>(from[n]);
}

/// Whether the terms, and products of some of them, are in the range of double.
template <std::size_t size>
[[nodiscard]] bool fits_double(const std::array<double, size>& terms) {
    return std::ranges::all_of(
        terms, [](double x) { return x == 0.0 || (std::abs(x) > 1e-200 && std::abs(x) < 1e200); });
}

/// The first @p count terms of @p leading and those of @p rest beyond.
template <class Goal, class Rest>
[[nodiscard]] MotionExpansion<Goal> joined(const MotionExpansion<Goal>& leading, std::size_t count,
                                           const Rest& rest) {
    MotionExpansion<Goal> all;
    const auto join = [count](const auto& first, const auto& others, auto& to) {
        copy_terms(others, to, others.size());
        copy_terms(first, to, count);
    };
    join(leading.position, rest.position, all.position);
    join(leading.velocity, rest.velocity, all.velocity);
    join(leading.time, rest.time, all.time);
    join(leading.dissipation, rest.dissipation, all.dissipation);
    all.step = static_cast<Goal>(rest.step);
    return all;
}

/// An expansion to the rounding of Goal, whose step is the radius of convergence: its leading terms in that
/// number type, the others in double if they are in its range, since that takes a third of the time.
/// @tparam Steps has an expansion x, and advance(from, to) for its terms from + 1..to; made from one of
/// another number type it takes the terms up to @c leading_terms
/// @param exact with the terms of the start alone
template <class Goal, template <class, class> class Steps>
[[nodiscard]] MotionExpansion<Goal> expansion_of(Steps<Goal, Goal>& exact) {
    constexpr std::size_t order = taylor_order<Goal>;
    std::size_t known = 0;
    if constexpr (!std::is_same_v<Goal, double>) {
        exact.advance(0, leading_terms);
        Steps<double, Goal> rest(exact);
        rest.advance(leading_terms, order);
        if (fits_double(rest.x.position) && fits_double(rest.x.velocity) && fits_double(rest.x.time)) {
            rest.x.step = rest.convergence();
            return joined(exact.x, leading_terms + 1, rest.x);
        }
        known = leading_terms;
    }
    exact.advance(known, order);
    exact.x.step = exact.convergence();
    return exact.x;
}

}  // namespace ashimpact

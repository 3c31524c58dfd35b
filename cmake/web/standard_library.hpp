// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the libc++ of emscripten 3.1.6 lacks of C++20: the algorithms of std::ranges that the sources use, for
// whole ranges, and std::bit_cast(). Included in front of every source where the standard library is that
// one; a newer one has them.
#include <algorithm>
#include <bit>
#include <functional>
#include <iterator>
#include <type_traits>
#include <utility>
#include <version>

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 15000

// NOLINTBEGIN(cert-dcl58-cpp)
#if !defined(__cpp_lib_bit_cast)
namespace std {
template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
    return __builtin_bit_cast(To, from);
}
}  // namespace std
#endif

namespace std::ranges {

namespace web {
template <class Compare, class Projection>
auto by(Compare& compare, Projection& projection) {
    return [&](auto&& a, auto&& b) {
        return std::invoke(compare, std::invoke(projection, a), std::invoke(projection, b));
    };
}
struct Less {
    template <class A, class B>
    constexpr bool operator()(A&& a, B&& b) const {
        return std::forward<A>(a) < std::forward<B>(b);
    }
};
struct Same {
    template <class A, class B>
    constexpr bool operator()(const A& a, const B& b) const {
        return a == b;
    }
};
struct Identity {
    template <class T>
    constexpr T&& operator()(T&& value) const {
        return std::forward<T>(value);
    }
};
}  // namespace web

template <class Range, class Test, class Projection = web::Identity>
constexpr bool any_of(Range&& range, Test test, Projection projection = {}) {
    for (auto&& each : range)
        if (std::invoke(test, std::invoke(projection, each))) return true;
    return false;
}
template <class Range, class Test, class Projection = web::Identity>
constexpr bool all_of(Range&& range, Test test, Projection projection = {}) {
    for (auto&& each : range)
        if (!std::invoke(test, std::invoke(projection, each))) return false;
    return true;
}
template <class Range, class Value, class Projection = web::Identity>
constexpr auto find(Range&& range, const Value& value, Projection projection = {}) {
    auto at = std::begin(range);
    while (at != std::end(range) && !(std::invoke(projection, *at) == value)) ++at;
    return at;
}
template <class Range, class Test, class Projection = web::Identity>
constexpr auto find_if(Range&& range, Test test, Projection projection = {}) {
    auto at = std::begin(range);
    while (at != std::end(range) && !std::invoke(test, std::invoke(projection, *at))) ++at;
    return at;
}
template <class Range, class Value, class Projection = web::Identity>
constexpr auto count(Range&& range, const Value& value, Projection projection = {}) {
    return std::count_if(std::begin(range), std::end(range),
                         [&](const auto& each) { return std::invoke(projection, each) == value; });
}
template <class Range, class Test>
constexpr auto count_if(Range&& range, Test test) {
    return std::count_if(std::begin(range), std::end(range),
                         [&](auto&& each) { return std::invoke(test, each); });
}
template <class Range, class Value, class Compare = web::Less, class Projection = web::Identity>
constexpr auto lower_bound(Range&& range, const Value& value, Compare compare = {},
                           Projection projection = {}) {
    return std::lower_bound(std::begin(range), std::end(range), value, [&](auto&& each, const Value& sought) {
        return std::invoke(compare, std::invoke(projection, each), sought);
    });
}
template <class Range, class Value, class Compare = web::Less, class Projection = web::Identity>
constexpr auto upper_bound(Range&& range, const Value& value, Compare compare = {},
                           Projection projection = {}) {
    return std::upper_bound(std::begin(range), std::end(range), value, [&](const Value& sought, auto&& each) {
        return std::invoke(compare, sought, std::invoke(projection, each));
    });
}
template <class Range, class Compare = web::Less, class Projection = web::Identity>
constexpr void sort(Range&& range, Compare compare = {}, Projection projection = {}) {
    std::sort(std::begin(range), std::end(range), web::by(compare, projection));
}
template <class Iterator>
struct Rest {  ///< what subrange is to unique()
    Iterator first, last;
    [[nodiscard]] Iterator begin() const { return first; }
    [[nodiscard]] Iterator end() const { return last; }
};
template <class Range>
constexpr auto unique(Range&& range) {
    return Rest<decltype(std::begin(range))>{std::unique(std::begin(range), std::end(range)),
                                             std::end(range)};
}
template <class Range, class Compare = web::Less, class Projection = web::Identity>
constexpr auto min_element(Range&& range, Compare compare = {}, Projection projection = {}) {
    return std::min_element(std::begin(range), std::end(range), web::by(compare, projection));
}
template <class Range, class Compare = web::Less, class Projection = web::Identity>
constexpr auto max_element(Range&& range, Compare compare = {}, Projection projection = {}) {
    return std::max_element(std::begin(range), std::end(range), web::by(compare, projection));
}
template <class Iterator>
struct MinMax {
    Iterator min, max;
};
template <class Range, class Compare = web::Less, class Projection = web::Identity>
constexpr auto minmax_element(Range&& range, Compare compare = {}, Projection projection = {}) {
    const auto [min, max] =
        std::minmax_element(std::begin(range), std::end(range), web::by(compare, projection));
    return MinMax<decltype(std::begin(range))>{min, max};
}
template <class Value>
struct Extremes {
    Value min, max;
};
template <class Range, class Compare = web::Less, class Projection = web::Identity>
constexpr auto minmax(Range&& range, Compare compare = {}, Projection projection = {}) {
    const auto found = ranges::minmax_element(range, compare, projection);
    return Extremes<std::decay_t<decltype(*found.min)>>{*found.min, *found.max};
}
template <class Range, class Same = web::Same, class Projection = web::Identity>
constexpr auto adjacent_find(Range&& range, Same same = {}, Projection projection = {}) {
    return std::adjacent_find(std::begin(range), std::end(range), web::by(same, projection));
}
template <class Range, class Output>
constexpr void move(Range&& range, Output output) {
    std::move(std::begin(range), std::end(range), output);
}
template <class Range, class Value>
constexpr void replace(Range&& range, const Value& before, const Value& after) {
    std::replace(std::begin(range), std::end(range), before, after);
}
template <class Range, class Value>
constexpr void fill(Range&& range, const Value& value) {
    std::fill(std::begin(range), std::end(range), value);
}
template <class Range, class Output>
constexpr void copy(Range&& range, Output output) {
    std::copy(std::begin(range), std::end(range), output);
}
template <class Range, class Output, class Test>
constexpr void copy_if(Range&& range, Output output, Test test) {
    std::copy_if(std::begin(range), std::end(range), output, test);
}
template <class One, class Other>
constexpr bool equal(One&& one, Other&& other) {
    return std::equal(std::begin(one), std::end(one), std::begin(other), std::end(other));
}
template <class One, class Other, class Same = web::Same>
constexpr bool is_permutation(One&& one, Other&& other, Same same = {}) {
    return std::is_permutation(std::begin(one), std::end(one), std::begin(other), std::end(other), same);
}

}  // namespace std::ranges
// NOLINTEND(cert-dcl58-cpp)

#endif

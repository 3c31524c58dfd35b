// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

namespace ashimpact {

/// Taylor order at which a step of radius/e^2 is exact to the rounding of Real (Jorba & Zou 2005).
template <class Real>
inline constexpr int taylor_order = std::numeric_limits<Real>::digits * 347 / 1000 + 2;

/// Truncated power series sum c[n] h^n, in number type Real, for sums to the rounding of Goal.
template <class Real, class Goal = Real>
using Series = std::array<Real, taylor_order<Goal> + 1>;

/// Copies the first @p count terms into a series of another number type.
template <class From, class To>
void copy_terms(const From& from, To& to, std::size_t count) {
    using Number = typename To::value_type;
    for (std::size_t n = 0; n < count; ++n) to[n] = static_cast<Number>(from[n]);
}

/// Value of the series at @p h.
template <class Real, std::size_t size>
[[nodiscard]] Real value(const std::array<Real, size>& c, Real h) {
    Real sum = c[size - 1];
    for (std::size_t n = size - 1; n-- > 0;) sum = sum * h + c[n];
    return sum;
}

/// Two numbers of a series in one register.
using Pair = double __attribute__((vector_size(2 * sizeof(double))));
[[nodiscard, gnu::always_inline]] inline Pair pair_at(const double* from) {
    Pair pair;
    std::memcpy(&pair, from, sizeof pair);
    return pair;
}

/// Sum of a[i] b[n - i] from i = 1 to before @p end. Series take most of the time of an impact: a call would
/// cost a tenth of that. Two chains of additions hide the latency of one.
template <class Real, std::size_t size>
[[nodiscard, gnu::always_inline]] inline Real inner_sum(const std::array<Real, size>& a,
                                                        const std::array<Real, size>& b, std::size_t n,
                                                        std::size_t end) {
    std::size_t i = 1;
    Real sum{};
    if constexpr (std::is_same_v<Real, double>) {
        const auto product = [&](std::size_t k) {
            const Pair last_first = pair_at(&b[n - k - 1]);
            return pair_at(&a[k]) * Pair{last_first[1], last_first[0]};
        };
        Pair even{};
        Pair odd{};
        for (; i + 3 < end; i += 4) {
            even += product(i);
            odd += product(i + 2);
        }
        if (i + 1 < end) {
            even += product(i);
            i += 2;
        }
        even += odd;
        sum = even[0] + even[1];
    } else {
        Real odd{};
        for (; i + 1 < end; i += 2) {
            sum += a[i] * b[n - i];
            odd += a[i + 1] * b[n - i - 1];
        }
        sum += odd;
    }
    if (i < end) sum += a[i] * b[n - i];
    return sum;
}

/// Coefficient n of the product of two series known up to n. The newest coefficients come last, so that the
/// rest need not wait for them.
template <class Real, std::size_t size>
[[nodiscard, gnu::always_inline]] inline Real product_coefficient(const std::array<Real, size>& a,
                                                                  const std::array<Real, size>& b,
                                                                  std::size_t n) {
    if (n == 0) return a[0] * b[0];
    return inner_sum(a, b, n, n) + (a[0] * b[n] + a[n] * b[0]);
}

/// product_coefficient() of a series with itself, in half the time.
template <class Real, std::size_t size>
[[nodiscard, gnu::always_inline]] inline Real square_coefficient(const std::array<Real, size>& a,
                                                                 std::size_t n) {
    if (n == 0) return a[0] * a[0];
    const Real middle = n % 2 == 0 ? a[n / 2] * a[n / 2] : Real(0);
    return 2 * inner_sum(a, a, n, (n + 1) / 2) + middle + 2 * (a[0] * a[n]);
}

/// Coefficient n of a quotient known up to n - 1.
template <class Real, std::size_t size>
[[nodiscard, gnu::always_inline]] inline Real quotient_coefficient(const std::array<Real, size>& numerator,
                                                                   const std::array<Real, size>& denominator,
                                                                   const std::array<Real, size>& quotient,
                                                                   std::size_t n) {
    if (n == 0) return numerator[0] / denominator[0];
    const Real before = inner_sum(quotient, denominator, n, n);
    return (numerator[n] - before - quotient[0] * denominator[n]) / denominator[0];
}

/// log2 |x| to 0.01; minus infinity for 0.
template <class Real>
[[nodiscard]] double nearly_log2(Real x) {
    int exponent = 0;
    double mantissa = 0;                           // in [1/2, 1)
    if constexpr (std::is_same_v<Real, double>) {  // a call of frexp() takes several times as long
        const auto bits = std::bit_cast<std::uint64_t>(std::abs(x));
        constexpr unsigned digits = std::numeric_limits<double>::digits - 1;
        constexpr std::uint64_t half = 1022;
        exponent = static_cast<int>(bits >> digits) - static_cast<int>(half);
        if (x != 0) mantissa = std::bit_cast<double>((bits & ((1ULL << digits) - 1)) | (half << digits));
    } else {
        mantissa = static_cast<double>(std::frexp(std::abs(x), &exponent));
    }
    if (!(mantissa > 0)) return -std::numeric_limits<double>::infinity();
    return (4 - 4.0 / 3 * mantissa) * mantissa - 8.0 / 3 + exponent;
}

/// nearly_log2() of pairs of numbers.
[[nodiscard, gnu::always_inline]] inline Pair nearly_log2_of(Pair x) {
    using Bits = std::uint64_t __attribute__((vector_size(sizeof(Pair))));
    constexpr int digits = std::numeric_limits<double>::digits - 1;
    constexpr std::uint64_t sign = 1ULL << 63U;
    constexpr std::uint64_t half = 1022ULL << digits;
    constexpr double two_to_digits = 1ULL << digits;  // with an integer below that as its last bits
    const Bits bits = std::bit_cast<Bits>(x) & ~sign;
    const Pair exponent =
        std::bit_cast<Pair>((bits >> digits) | std::bit_cast<std::uint64_t>(two_to_digits)) -
        (two_to_digits + 1022);
    const Pair mantissa = std::bit_cast<Pair>((bits & ((1ULL << digits) - 1)) | half);
    const Pair log = (4 - 4.0 / 3 * mantissa) * mantissa - 8.0 / 3 + exponent;
    const Pair infinite = Pair{} + std::numeric_limits<double>::infinity();
    return bits == 0 ? -infinite : log;
}

/// nearly_log2() of numbers that follow one another.
template <std::size_t count, class Real>
[[nodiscard]] std::array<double, count> nearly_log2_from(const Real* x) {
    std::array<double, count> logs;
    if constexpr (std::is_same_v<Real, double>) {
        static_assert(count % 2 == 0);
        for (std::size_t i = 0; i < count; i += 2) {
            const Pair pair = nearly_log2_of(pair_at(x + i));
            std::memcpy(&logs[i], &pair, sizeof pair);
        }
    } else {
        for (std::size_t i = 0; i < count; ++i) logs[i] = nearly_log2(x[i]);
    }
    return logs;
}

/// Radius within which the terms fall off geometrically from the leading ones, by the root test on the last
/// ten coefficients, since a symmetric start leaves gaps of up to nine zeros; infinite if all ten vanish.
template <class Real, std::size_t size>
[[nodiscard]] Real radius(const std::array<Real, size>& c) {
    constexpr std::size_t leading = 3;
    constexpr std::size_t last = 10;
    constexpr std::size_t begin = size - last;
    static_assert(size > leading + last);
    static constexpr auto inverse = [] {
        std::array<double, size> of{};
        for (std::size_t n = 1; n < size; ++n) of[n] = 1 / static_cast<double>(n);
        return of;
    }();
    // The decisive pair is sought by logarithms to 0.01: those of all would take a tenth of an impact.
    const std::array<double, leading + 1> first = nearly_log2_from<leading + 1>(c.data());
    const std::array<double, last> tail = nearly_log2_from<last>(&c[begin]);
    double smallest = std::numeric_limits<double>::infinity();
    std::size_t to = 0;
    for (std::size_t i = 0; i < last; i += 2) {
        const auto log_radius = [&](std::size_t m) {
            return (first[m] - pair_at(&tail[i])) * pair_at(&inverse[begin + i - m]);
        };
        Pair largest = log_radius(0);
        for (std::size_t m = 1; m < leading; ++m) {
            const Pair other = log_radius(m);
            largest = largest < other ? other : largest;
        }
        for (std::size_t k = 0; k < 2; ++k) {  // one that vanishes is infinite or no number, and never less
            const bool less = largest[k] < smallest;
            smallest = less ? largest[k] : smallest;
            to = less ? begin + i + k : to;
        }
    }
    if (std::isinf(smallest)) return static_cast<Real>(smallest < 0 ? 0 : smallest);
    std::size_t from = 0;
    while (from + 1 < leading && (first[from] - tail[to - begin]) * inverse[to - from] != smallest) ++from;
    const auto log2_of = [](Real x) { return static_cast<double>(std::log2(std::abs(x))); };
    return std::exp2(static_cast<Real>((log2_of(c[from]) - log2_of(c[to])) * inverse[to - from]));
}

}  // namespace ashimpact
